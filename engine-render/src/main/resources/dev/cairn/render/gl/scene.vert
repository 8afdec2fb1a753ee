uniform mat4 clipFromAnchored;

out vec3 anchored;
out vec3 worldNormal;
out vec2 coordinate;
out vec3 tilePosition;
out vec3 tileNormal;
out vec3 colour;
#if HORIZON
flat out vec3 middle;
flat out float fadeMetres;
#endif

void main() {
    vec4 turn = interpolatedTurn();
    anchored = interpolatedPlace() + rotated(turn, modelPosition());
    worldNormal = rotated(turn, normalize(meshNormal / instanceScale()));
    coordinate = meshCoordinate;
    tilePosition = meshPosition * instanceScale();
    tileNormal = meshNormal;
    colour = tinted(texelFetch(look, 3 * int(slot) + 2).rgb);
#if HORIZON
    middle = interpolatedPlace();
    fadeMetres = texelFetch(look, 3 * int(slot) + 1).w;
#endif
    gl_Position = clipFromAnchored * vec4(anchored, 1.0);
}
