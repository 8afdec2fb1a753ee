// Part of the sky that the neighbourhood of a pixel leaves open, from the picture's depths: a near point q hides the more
// the higher it stands over the surface, sum of (q - p) . n / (q - p)^2 (McGuire and others, "Scalable ambient
// obscurance", 2012).
uniform sampler2D sceneDepth;
uniform mat4 anchoredFromClip;
uniform vec3 eye;            // anchored
uniform vec2 occlusionReach; // of the neighbourhood, in pictures' widths and heights

out float open;

const int OCCLUSION_TAPS = 20;

vec3 pointAt(vec2 at, float depth) {
    vec4 q = anchoredFromClip * vec4(vec3(at, depth) * 2.0 - 1.0, 1.0);
    return q.xyz / q.w;
}

// Along the picture's rows or columns, to the neighbour that lies on the same surface: the one nearer in depth.
vec3 tangent(vec2 at, vec2 step, float depth, vec3 p) {
    float before = texture(sceneDepth, at - step).r;
    float after = texture(sceneDepth, at + step).r;
    return abs(after - depth) <= abs(before - depth) ? pointAt(at + step, after) - p : p - pointAt(at - step, before);
}

void main() {
    vec2 perPixel = 1.0 / vec2(textureSize(sceneDepth, 0));
    vec2 at = gl_FragCoord.xy * perPixel;
    float depth = texture(sceneDepth, at).r;
    if (depth == 1.0) {
        open = 1.0; // the sky itself
        return;
    }
    vec3 p = pointAt(at, depth);
    vec3 right = tangent(at, vec2(perPixel.x, 0.0), depth, p);
    vec3 up = tangent(at, vec2(0.0, perPixel.y), depth, p);
    vec3 normal = normalize(cross(right, up));
    float radius = OCCLUSION_SHARE * length(p - eye);
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = float(4 * cell.y + cell.x) / 16.0; // each once in any 4 x 4 pixels
    float sum = 0.0;
    for (int i = 0; i < OCCLUSION_TAPS; i++) {
        vec2 there = at + occlusionReach * spiral(i, OCCLUSION_TAPS, turn);
        vec3 v = pointAt(there, texture(sceneDepth, there).r) - p;
        float square = dot(v, v) / (radius * radius);
        float near = max(1.0 - square, 0.0);
        sum += near * near * max(dot(v, normal) / radius - 0.03, 0.0) / (square + 0.01);
    }
    open = 1.0 / (1.0 + 6.0 * sum / float(OCCLUSION_TAPS));
}
