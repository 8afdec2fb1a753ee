// Pixels from the upper left corner; colours are sRGB already and stay so.
layout(location = 0) in vec2 pixel;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 tint;

uniform vec3 clipPerPixel;

out vec2 where;
out vec4 colour;

void main() {
    where = texel;
    colour = tint;
    gl_Position = vec4(pixel * clipPerPixel.xy + vec2(-1.0, 1.0), 0.0, 1.0);
}
