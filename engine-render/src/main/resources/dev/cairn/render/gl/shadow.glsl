uniform vec3 sunDirection; // unit, to the sun
uniform vec3 sunLight;     // linear
uniform vec3 skyLight;
uniform vec3 groundLight;
uniform sampler2DShadow shadowMap;
uniform mat4 shadowFromAnchored;
uniform float shadowTexelMetres; // 0 = no shadows
uniform float shadowBias;

#if SOFT_SHADOWS
uniform sampler2D shadowDepth; // the same map, as numbers
const int SEARCH_TAPS = 16;
const int SOFT_TAPS = 32;
const float SUN_RADIUS = 0.03; // tangent of half the angle that the sun fills; the real one has 0.005
const float STEEPEST = 8.0;

// Edges widen with the distance to what casts them: first the mean distance of the casters is looked for, then the map
// is averaged over a disc as wide as the sun's image at that distance (Fernando, "Percentage-closer soft shadows",
// 2005). Over such a disc the surface itself has other depths; its plane is followed.
float sunVisibleThrough(vec3 p, vec3 normal, float bias) {
    float size = float(textureSize(shadowMap, 0).x);
    float metres = shadowTexelMetres * size; // the map is as wide as this, and twice as deep
    vec3 right = 0.5 * metres * vec3(shadowFromAnchored[0].x, shadowFromAnchored[1].x, shadowFromAnchored[2].x);
    vec3 up = 0.5 * metres * vec3(shadowFromAnchored[0].y, shadowFromAnchored[1].y, shadowFromAnchored[2].y);
    // n . (a right + b up + c sun) = 0 with steps a, b on the map in its widths, and depth = -c / (2 widths).
    float towards = max(dot(normal, sunDirection), 1.0 / STEEPEST);
    vec2 slope = 0.5 * vec2(dot(normal, right), dot(normal, up)) / towards;
    float turn = grain();
    float widest = clamp(SUN_RADIUS * 0.25, 2.0 / size, 24.0 / size);
    float casters = 0.0;
    float depth = 0.0;
    for (int i = 0; i < SEARCH_TAPS; i++) {
        vec2 shift = widest * spiral(i, SEARCH_TAPS, turn);
        float there = texture(shadowDepth, p.xy + shift).r;
        if (there < p.z + dot(slope, shift) - 2.0 * bias) {
            casters += 1.0;
            depth += there;
        }
    }
    if (casters == 0.0) {
        return 1.0;
    }
    float radius = clamp(SUN_RADIUS * 2.0 * (p.z - depth / casters), 1.5 / size, widest);
    float sum = 0.0;
    for (int i = 0; i < SOFT_TAPS; i++) {
        vec2 shift = radius * spiral(i, SOFT_TAPS, turn);
        sum += texture(shadowMap, vec3(p.xy + shift, p.z + dot(slope, shift) - bias));
    }
    return sum / float(SOFT_TAPS);
}
#endif

// Part of the sun that reaches the surface: the mean of SHADOW_TAPS^2 comparisons, each bilinear over four texels.
float sunVisible(vec3 anchored, vec3 normal) {
    if (shadowTexelMetres == 0.0) {
        return 1.0;
    }
    // Moved off the surface by more than a texel, so that a face does not shade itself.
    vec3 p = (shadowFromAnchored * vec4(anchored + normal * (1.5 * shadowTexelMetres), 1.0)).xyz * 0.5 + 0.5;
    if (p.z >= 1.0) {
        return 1.0;
    }
#if SOFT_SHADOWS
    return sunVisibleThrough(p, normal, shadowBias);
#else
    float step = 1.0 / float(textureSize(shadowMap, 0).x);
    float sum = 0.0;
    const float middle = 0.5 * float(SHADOW_TAPS - 1);
    for (int i = 0; i < SHADOW_TAPS; i++) {
        for (int j = 0; j < SHADOW_TAPS; j++) {
            vec2 shift = (vec2(float(i), float(j)) - middle) * step;
            sum += texture(shadowMap, vec3(p.xy + shift, p.z - shadowBias));
        }
    }
    return sum / float(SHADOW_TAPS * SHADOW_TAPS);
#endif
}
