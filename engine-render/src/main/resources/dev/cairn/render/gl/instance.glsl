// Where a vertex of an instance is. Lengths are metres relative to the anchor (a point near the camera), world axes.
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshCoordinate;
// Per instance, written once per tick: position and orientation of the previous and of the current tick.
layout(location = 3) in vec4 previousPlace;
layout(location = 4) in vec4 previousTurn;
layout(location = 5) in vec4 currentPlace;
layout(location = 6) in vec4 currentTurn;
// Per instance, written when something appears or goes.
layout(location = 7) in vec3 instanceScale;
layout(location = 8) in vec3 instanceOrigin;
layout(location = 9) in vec3 instanceColour;

uniform float alpha; // 0 = previous tick, 1 = current tick

vec3 rotated(vec4 q, vec3 v) {
    vec3 t = 2.0 * cross(q.xyz, v);
    return v + q.w * t + cross(q.xyz, t);
}

// q and -q are the same turn: the nearer one is the short way round. Normalised linear interpolation between the two.
vec4 interpolatedTurn() {
    vec4 current = dot(previousTurn, currentTurn) < 0.0 ? -currentTurn : currentTurn;
    return normalize(mix(previousTurn, current, alpha));
}

vec3 interpolatedPlace() {
    return mix(previousPlace.xyz, currentPlace.xyz, alpha);
}

vec3 modelPosition() {
    return meshPosition * instanceScale - instanceOrigin;
}
