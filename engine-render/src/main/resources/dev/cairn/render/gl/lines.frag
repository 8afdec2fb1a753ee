in vec4 colour;

uniform float fade;

out vec4 pixel;

void main() {
    pixel = vec4(colour.rgb, colour.a * fade);
}
