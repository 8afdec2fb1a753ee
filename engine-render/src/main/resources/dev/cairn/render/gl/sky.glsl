// What is behind everything, by direction; linear. The sky goes from the horizon to the zenith; below the horizon is
// the same haze, or a ground that fades into it.
uniform vec3 zenithColour;
uniform vec3 horizonColour;

vec3 backdrop(vec3 direction) {
    float up = normalize(direction).y;
    vec3 sky = mix(horizonColour, zenithColour, 1.0 - exp(-3.0 * max(up, 0.0)));
#if HORIZON
    const vec3 GROUND = vec3(0.56, 0.56, 0.57); // of the light at the horizon
    sky *= mix(vec3(1.0), GROUND, 1.0 - exp(-5.0 * max(-up, 0.0)));
#endif
    return sky;
}
