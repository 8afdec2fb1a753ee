in vec2 where;
in vec4 colour;

uniform sampler2D letters;

out vec4 pixel;

void main() {
    pixel = colour * texture(letters, where);
}
