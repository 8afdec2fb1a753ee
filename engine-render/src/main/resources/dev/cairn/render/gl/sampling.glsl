// Places to look at around a pixel or a point of a map.

// A number in 0..1 that differs from pixel to pixel and has few low frequencies (Jimenez, "Next generation post
// processing in Call of Duty: Advanced Warfare", 2014).
float grain() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// The i-th of n places spread evenly over the unit disc, turned by the grain: Vogel's spiral (1979).
vec2 spiral(int i, int n, float turn) {
    float angle = 2.39996323 * float(i) + 6.2831853 * turn;
    return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(angle), sin(angle));
}
