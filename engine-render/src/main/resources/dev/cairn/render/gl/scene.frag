in vec3 anchored;
in vec3 worldNormal;
in vec2 coordinate;
in vec3 tilePosition;
in vec3 tileNormal;
in vec3 colour;
#if HORIZON
flat in vec3 middle;      // of the entity, anchored
flat in float fadeMetres; // radius at which a wide floor ends; 0 = it is none
#endif

out vec4 pixel;

uniform sampler2D surface;
uniform float tileMetres;      // 0 = the mesh's own coordinates
uniform vec2 finish;           // roughness, share of metal
uniform float opacity;         // 1 = nothing is seen through it
uniform vec3 eye;              // anchored
uniform float hazeMetres;      // 0 = none

// A face takes the two axes that it lies in.
vec2 surfaceCoordinate() {
    if (tileMetres == 0.0) {
        return coordinate;
    }
    vec3 n = abs(tileNormal);
    vec2 metres = n.y >= n.x && n.y >= n.z ? vec2(tilePosition.x, -tilePosition.z)
            : n.x >= n.z ? tilePosition.zy : tilePosition.xy;
    return metres / tileMetres;
}

// The mean over the pixel's footprint, which is long and narrow on a floor seen at a low angle: up to SURFACE_TAPS
// lookups along its longer side, each with the mipmap of a square part of it. 1 = the graphics processor does it itself.
vec3 surfaceColour(vec2 at) {
#if SURFACE_TAPS == 1
    return texture(surface, at).rgb;
#else
    vec2 along = dFdx(at);
    vec2 across = dFdy(at);
    if (dot(along, along) < dot(across, across)) {
        vec2 swap = along;
        along = across;
        across = swap;
    }
    float ratio = sqrt(dot(along, along) / max(dot(across, across), 1e-20));
    int taps = int(clamp(ceil(ratio), 1.0, float(SURFACE_TAPS)));
    along /= float(taps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < taps; i++) {
        sum += textureGrad(surface, at + (float(i) + 0.5 - 0.5 * float(taps)) * along, along, across).rgb;
    }
    return sum / float(taps);
#endif
}

void main() {
    vec3 normal = normalize(worldNormal);
    vec3 albedo = surfaceColour(surfaceCoordinate()) * colour;
    float facing = max(dot(normal, sunDirection), 0.0);
    float visible = facing > 0.0 ? sunVisible(anchored, normal) : 0.0;
#if SKY_LIGHT
    vec3 ambient = skyAt(normal.y, SKY_SIZE.y - 1.0);
#else
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * normal.y);
#endif
#if OCCLUSION
    float open = openSky();
#else
    const float open = 1.0;
#endif
    vec3 light = albedo * (ambient * open + sunLight * (facing * visible));
#if REFLECTIONS
    vec3 view = normalize(eye - anchored);
    float roughness = finish.x;
    vec3 mirror = mix(vec3(0.04), albedo, finish.y);
    light *= 1.0 - finish.y;
    light += sunLight * (facing * visible) * glint(normal, view, sunDirection, roughness, mirror);
    light += mirrored(normal, view, roughness, mirror, groundLight) * open;
#endif
    light = exposed(light);
    if (hazeMetres > 0.0) {
        float far = length(anchored - eye) / hazeMetres;
        light = mix(horizonColour, light, exp(-far * far));
    }
#if HORIZON
    // A wide floor dissolves into the ground behind it instead of ending in an edge.
    if (fadeMetres > 0.0) {
        vec3 from = anchored - middle;
        light = mix(light, backdrop(anchored - eye), smoothstep(0.6, 1.0, length(from.xz) / fadeMetres));
    }
#endif
    pixel = vec4(encoded(light), opacity);
}
