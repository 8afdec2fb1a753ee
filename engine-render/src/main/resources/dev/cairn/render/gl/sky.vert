// One triangle that covers the picture, at the far end of the depth range.
uniform vec3 rayForward;
uniform vec3 rayRight; // half the picture's width at distance 1
uniform vec3 rayUp;

out vec3 ray;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    ray = rayForward + corner.x * rayRight + corner.y * rayUp;
    gl_Position = vec4(corner, 1.0, 1.0);
}
