uniform mat4 shadowFromAnchored;

void main() {
    vec3 anchored = interpolatedPlace() + rotated(interpolatedTurn(), modelPosition());
    gl_Position = shadowFromAnchored * vec4(anchored, 1.0);
}
