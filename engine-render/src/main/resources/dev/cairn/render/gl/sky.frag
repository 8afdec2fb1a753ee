in vec3 ray;

out vec4 pixel;

uniform vec3 zenithColour;  // linear
uniform vec3 horizonColour; // linear

void main() {
    float up = max(normalize(ray).y, 0.0);
    pixel = vec4(encoded(mix(horizonColour, zenithColour, 1.0 - exp(-3.0 * up))), 1.0);
}
