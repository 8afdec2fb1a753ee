// Where a vertex of an instance is. Lengths are metres relative to the anchor (a point near the camera), world axes.
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshCoordinate;
// Which of the looks below; per instance, only those that may be seen.
layout(location = 3) in uint slot;

// Four texels per entity, written once per tick: place and turn at the previous and at the current tick.
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

vec3 instanceScale() {
    return texelFetch(look, 3 * int(slot)).xyz;
}

vec3 modelPosition() {
    return meshPosition * instanceScale() - texelFetch(look, 3 * int(slot) + 1).xyz;
}
