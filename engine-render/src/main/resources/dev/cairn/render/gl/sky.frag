in vec3 ray;

out vec4 pixel;

void main() {
    pixel = vec4(encoded(backdrop(ray)), 1.0);
}
