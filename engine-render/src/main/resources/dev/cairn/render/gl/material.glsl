#if OCCLUSION
uniform sampler2D sceneDepth;
uniform sampler2D openShare; // by occlusion.frag, each pixel with one of 16 turns
uniform float depthTolerance; // of the surface itself, at 1 m from the camera

// Part of the sky that the neighbourhood leaves open: the mean over 4 x 4 pixels, and so over all turns, of those that
// lie on this surface. Depths of a plane are linear on the picture.
float openSky() {
    ivec2 last = textureSize(sceneDepth, 0) - 1;
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
    float tolerance = depthTolerance * gl_FragCoord.w;
    float weight = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 16; i++) {
        ivec2 shift = ivec2(i & 3, i >> 2) - 2;
        ivec2 at = clamp(ivec2(gl_FragCoord.xy) + shift, ivec2(0), last);
        float expected = gl_FragCoord.z + dot(slope, vec2(shift));
        float same = abs(texelFetch(sceneDepth, at, 0).r - expected) < tolerance ? 1.0 : 0.0;
        weight += same;
        sum += same * texelFetch(openShare, at, 0).r;
    }
    return weight > 0.0 ? sum / weight : 1.0;
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
