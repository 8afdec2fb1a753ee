uniform vec3 sunDirection; // unit, to the sun
uniform vec3 sunLight;     // linear
uniform vec3 skyLight;
uniform vec3 groundLight;
// The finest map first; where a texel's size is 0 there is none.
uniform sampler2DShadow shadowMap0;
uniform sampler2DShadow shadowMap1;
uniform sampler2DShadow shadowMap2;
uniform mat4 shadowFromAnchored[SHADOW_MAPS];
uniform float shadowTexelMetres[SHADOW_MAPS];
uniform float shadowBias[SHADOW_MAPS];

#if SOFT_SHADOWS
uniform sampler2D shadowDepth0; // the same maps, as numbers
uniform sampler2D shadowDepth1;
uniform sampler2D shadowDepth2;
const int SEARCH_TAPS = 16;
const int SOFT_TAPS = 32;
const float SUN_RADIUS = 0.03; // tangent of half the angle that the sun fills; the real one has 0.005
const float STEEPEST = 8.0;

// Edges widen with the distance to what casts them: first the mean distance of the casters is looked for, then the map
// is averaged over a disc as wide as the sun's image at that distance (Fernando, "Percentage-closer soft shadows",
// 2005). Over such a disc the surface itself has other depths; its plane is followed.
float sunVisibleThrough(sampler2DShadow map, sampler2D depths, mat4 light, float texel, vec3 p, vec3 normal, float bias) {
    float size = float(textureSize(map, 0).x);
    float metres = texel * size; // the map is as wide as this, and twice as deep
    vec3 right = 0.5 * metres * vec3(light[0].x, light[1].x, light[2].x);
    vec3 up = 0.5 * metres * vec3(light[0].y, light[1].y, light[2].y);
    // n . (a right + b up + c sun) = 0 with steps a, b on the map in its widths, and depth = -c / (2 widths).
    float towards = max(dot(normal, sunDirection), 1.0 / STEEPEST);
    vec2 slope = 0.5 * vec2(dot(normal, right), dot(normal, up)) / towards;
    float turn = grain();
    float widest = clamp(SUN_RADIUS * 0.25, 2.0 / size, 24.0 / size);
    float casters = 0.0;
    float depth = 0.0;
    for (int i = 0; i < SEARCH_TAPS; i++) {
        vec2 shift = widest * spiral(i, SEARCH_TAPS, turn);
        float there = texture(depths, p.xy + shift).r;
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
        sum += texture(map, vec3(p.xy + shift, p.z + dot(slope, shift) - bias));
    }
    return sum / float(SOFT_TAPS);
}
#endif

#if !SOFT_SHADOWS
// The mean of SHADOW_TAPS^2 comparisons, each bilinear over four texels.
float sunVisibleThrough(sampler2DShadow map, vec3 p, float bias) {
    float step = 1.0 / float(textureSize(map, 0).x);
    float sum = 0.0;
    const float middle = 0.5 * float(SHADOW_TAPS - 1);
    for (int i = 0; i < SHADOW_TAPS; i++) {
        for (int j = 0; j < SHADOW_TAPS; j++) {
            vec2 shift = (vec2(float(i), float(j)) - middle) * step;
            sum += texture(map, vec3(p.xy + shift, p.z - bias));
        }
    }
    return sum / float(SHADOW_TAPS * SHADOW_TAPS);
}
#endif

// The place in a map of a point moved off the surface by more than a texel, so that a face does not shade itself.
vec3 inMap(int i, vec3 anchored, vec3 normal) {
    return (shadowFromAnchored[i] * vec4(anchored + normal * (1.5 * shadowTexelMetres[i]), 1.0)).xyz * 0.5 + 0.5;
}

// Whether a finer map answers for a point: it lies inside, and so does the disc that is looked at around it.
bool answers(int i, vec3 p) {
    vec3 edge = abs(p - 0.5);
    return shadowTexelMetres[i] > 0.0 && max(edge.x, edge.y) < 0.47 && edge.z < 0.5;
}

#if SOFT_SHADOWS
#define SHADE(i, map, depths) sunVisibleThrough(map, depths, shadowFromAnchored[i], shadowTexelMetres[i], p, normal, shadowBias[i])
#else
#define SHADE(i, map, depths) sunVisibleThrough(map, p, shadowBias[i])
#endif

// Part of the sun that reaches the surface, by the finest map that knows of it.
float sunVisible(vec3 anchored, vec3 normal) {
    vec3 p;
#if SHADOW_MAPS == 3
    if (shadowTexelMetres[2] > 0.0) {
        p = inMap(0, anchored, normal);
        if (answers(0, p)) {
            return SHADE(0, shadowMap0, shadowDepth0);
        }
        p = inMap(1, anchored, normal);
        if (answers(1, p)) {
            return SHADE(1, shadowMap1, shadowDepth1);
        }
        p = inMap(2, anchored, normal);
        return p.z >= 1.0 ? 1.0 : SHADE(2, shadowMap2, shadowDepth2);
    }
    if (shadowTexelMetres[1] > 0.0) {
        p = inMap(0, anchored, normal);
        if (answers(0, p)) {
            return SHADE(0, shadowMap0, shadowDepth0);
        }
        p = inMap(1, anchored, normal);
        return p.z >= 1.0 ? 1.0 : SHADE(1, shadowMap1, shadowDepth1);
    }
#endif
    if (shadowTexelMetres[0] == 0.0) {
        return 1.0;
    }
    p = inMap(0, anchored, normal);
    return p.z >= 1.0 ? 1.0 : SHADE(0, shadowMap0, shadowDepth0);
}
