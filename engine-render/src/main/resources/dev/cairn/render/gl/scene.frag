in vec3 anchored;
in vec3 worldNormal;
in vec2 coordinate;
in vec3 tilePosition;
in vec3 tileNormal;
in vec3 colour;

out vec4 pixel;

uniform sampler2D surface;
uniform sampler2DShadow shadowMap;
uniform float tileMetres;      // 0 = the mesh's own coordinates
uniform vec3 eye;              // anchored
uniform vec3 sunDirection;     // unit, to the sun
uniform vec3 sunLight;         // linear
uniform vec3 skyLight;
uniform vec3 groundLight;
uniform vec3 horizonColour;    // linear
uniform float hazeMetres;      // 0 = none
uniform mat4 shadowFromAnchored;
uniform float shadowTexelMetres; // 0 = no shadows
uniform float shadowBias;

// Part of the sun that reaches the surface: the mean of SHADOW_TAPS^2 comparisons, each bilinear over four texels.
float sunVisible(vec3 normal) {
    if (shadowTexelMetres == 0.0) {
        return 1.0;
    }
    // Moved off the surface by more than a texel, so that a face does not shade itself.
    vec3 p = (shadowFromAnchored * vec4(anchored + normal * (1.5 * shadowTexelMetres), 1.0)).xyz * 0.5 + 0.5;
    if (p.z >= 1.0) {
        return 1.0;
    }
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
}

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
    float visible = facing > 0.0 ? sunVisible(normal) : 0.0;
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * normal.y);
    vec3 light = albedo * (ambient + sunLight * (facing * visible));
    if (hazeMetres > 0.0) {
        float far = length(anchored - eye) / hazeMetres;
        light = mix(horizonColour, light, exp(-far * far));
    }
    pixel = vec4(encoded(light), 1.0);
}
