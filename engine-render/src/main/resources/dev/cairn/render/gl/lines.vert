// One instance is a line; its four corners are made here, so that a line has a width in pixels.
layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec4 tint;
layout(location = 3) in float width;

uniform mat4 clipFromAnchored;
uniform vec3 view;

out vec4 colour;

void main() {
    vec4 a = clipFromAnchored * vec4(start, 1.0);
    vec4 b = clipFromAnchored * vec4(end, 1.0);
    // The part behind the camera is cut off, or its projection would be upside down.
    float nearest = 1e-3;
    if (a.w < nearest && b.w > nearest) {
        a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    } else if (b.w < nearest && a.w > nearest) {
        b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    }
    vec2 along = (b.xy / b.w - a.xy / a.w) * view.xy;
    float length2 = dot(along, along);
    bool dot2 = length2 < 1e-6;
    along = dot2 ? vec2(1.0, 0.0) : along * inversesqrt(length2);
    vec2 across = vec2(-along.y, along.x);
    bool far = gl_VertexID >= 2;
    vec4 corner = far ? b : a;
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    vec2 pixels = across * side + (dot2 ? along * (far ? 1.0 : -1.0) : vec2(0.0));
    corner.xy += pixels * width / view.xy * corner.w;
    colour = tint;
    gl_Position = corner;
}
