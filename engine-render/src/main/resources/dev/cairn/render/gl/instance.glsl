// Where a vertex of an instance is. Lengths are metres relative to the anchor (a point near the camera), world axes.
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshCoordinate;
// Which of the looks below; per instance, only those that may be seen.
layout(location = 3) in uint slot;

// Four texels per entity, written once per tick: place and turn at the previous and at the current tick. Beside the
// first place: 0xRRGGBB + 1 in sRGB of what is tinted, else 0.
uniform samplerBuffer motion;
// Three texels per slot, written when something appears or goes: scale and entity, origin, colour.
uniform samplerBuffer look;
uniform float alpha; // 0 = previous tick, 1 = current tick

vec3 rotated(vec4 q, vec3 v) {
    vec3 t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}

int motionTexel() {
    return 4 * int(texelFetch(look, 3 * int(slot)).w);
}

// q and -q are the same turn: the nearer one is the short way round. Normalised linear interpolation between the two.
vec4 interpolatedTurn() {
    vec4 previous = texelFetch(motion, motionTexel() + 1);
    vec4 current = texelFetch(motion, motionTexel() + 3);
    return normalize(mix(previous, dot(previous, current) < 0.0 ? -current : current, alpha));
}

vec3 interpolatedPlace() {
    return mix(texelFetch(motion, motionTexel()).xyz, texelFetch(motion, motionTexel() + 2).xyz, alpha);
}

// The colour that an instance is tinted with, linear, or its own.
vec3 tinted(vec3 own) {
    int code = int(texelFetch(motion, motionTexel()).w);
    if (code == 0) {
        return own;
    }
    code -= 1;
    vec3 c = vec3(float(code >> 16), float(code >> 8 & 255), float(code & 255)) / 255.0;
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThan(c, vec3(0.04045))));
}

vec3 instanceScale() {
    return texelFetch(look, 3 * int(slot)).xyz;
}

vec3 modelPosition() {
    return meshPosition * instanceScale() - texelFetch(look, 3 * int(slot) + 1).xyz;
}
