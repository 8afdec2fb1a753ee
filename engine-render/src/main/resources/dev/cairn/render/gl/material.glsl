#if OCCLUSION
uniform sampler2D sceneDepth;
uniform mat4 anchoredFromClip;
uniform vec2 occlusionReach; // of the neighbourhood, in pictures' widths and heights
const int OCCLUSION_TAPS = 20;

// Part of the sky that the neighbourhood leaves open, from the picture's depths: a near point q hides the more the
// higher it stands over the surface, sum of (q - p) . n / (q - p)^2 (McGuire and others, "Scalable ambient obscurance",
// 2012).
float openSky(vec3 p, vec3 normal, vec3 eye) {
    float far = length(p - eye);
    float radius = OCCLUSION_SHARE * far;
    vec2 perPixel = 1.0 / vec2(textureSize(sceneDepth, 0));
    float turn = grain();
    float sum = 0.0;
    for (int i = 0; i < OCCLUSION_TAPS; i++) {
        vec2 at = gl_FragCoord.xy * perPixel + occlusionReach * spiral(i, OCCLUSION_TAPS, turn);
        vec4 clip = vec4(vec3(at, texture(sceneDepth, at).r) * 2.0 - 1.0, 1.0);
        vec4 q = anchoredFromClip * clip;
        vec3 v = q.xyz / q.w - p;
        float square = dot(v, v) / (radius * radius);
        float near = max(1.0 - square, 0.0);
        sum += near * near * max(dot(v, normal) / radius - 0.03, 0.0) / (square + 0.01);
    }
    return 1.0 / (1.0 + 6.0 * sum / float(OCCLUSION_TAPS));
}
#endif

#if SKY_LIGHT
uniform sampler2D skyTable; // across: height of a direction, -1..1; upwards: roughness, and last the light on a surface
const vec2 SKY_SIZE = vec2(64.0, 8.0);

vec3 skyAt(float height, float row) {
    return texture(skyTable, (vec2((0.5 + 0.5 * height) * (SKY_SIZE.x - 1.0), row) + 0.5) / SKY_SIZE).rgb;
}
#endif

#if REFLECTIONS
// What a smooth surface sends back of the sun, for a white sun that fills no angle: distribution of Trowbridge and
// Reitz (GGX), visibility by Smith in the form of Hammon (2017), Fresnel by Schlick. Without the 1 / pi, as all light.
vec3 glint(vec3 normal, vec3 view, vec3 sun, float roughness, vec3 facing) {
    vec3 between = normalize(view + sun);
    float nh = max(dot(normal, between), 0.0);
    float nv = max(dot(normal, view), 1e-3);
    float nl = max(dot(normal, sun), 0.0);
    float a = roughness * roughness;
    float d = nh * nh * (a * a - 1.0) + 1.0;
    float visibility = 0.5 / mix(2.0 * nl * nv, nl + nv, a);
    vec3 fresnel = facing + (1.0 - facing) * pow(1.0 - max(dot(view, between), 0.0), 5.0);
    return a * a / (d * d) * visibility * fresnel;
}

// The sky in a mirror of that roughness: the backdrop by direction, blurred over the horizon; how much of it by the fit
// of Karis ("Physically based shading on mobile", 2014).
vec3 mirrored(vec3 normal, vec3 view, float roughness, vec3 facing, vec3 below) {
    vec3 r = reflect(-view, normal);
#if SKY_LIGHT
    vec3 light = skyAt(r.y, roughness * (SKY_SIZE.y - 2.0));
#else
    vec3 sky = backdrop(vec3(r.x, max(r.y, 0.0) + 1e-3, r.z));
    float blur = 0.1 + roughness;
    vec3 light = mix(below, sky, smoothstep(-blur, blur, r.y));
#endif
    float nv = max(dot(normal, view), 0.0);
    vec4 c = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float x = min(c.x * c.x, exp2(-9.28 * nv)) * c.x + c.y;
    return light * (facing * (-1.04 * x + c.z) + (1.04 * x + c.w));
}
#endif

#if FILMIC
// Light to what a picture can show: a shoulder for what is bright, a toe for what is dark (fit of Narkowicz, 2016, to
// the Academy's curve).
vec3 exposed(vec3 light) {
    vec3 x = 0.8 * light;
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}
#else
vec3 exposed(vec3 light) {
    return light;
}
#endif
