in vec4 colour;

uniform float front; // 1 = the part that nothing hides; the share of the rest is the line's alpha

out vec4 pixel;

void main() {
    pixel = vec4(colour.rgb, mix(colour.a, 1.0, front));
}
