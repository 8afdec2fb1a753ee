package dev.cairn.render.gl;

/** The sRGB transfer function (IEC 61966-2-1), from a screen's number to linear light. */
final class Srgb {
    private Srgb() {}

    /** Linear light of the lowest 8 bits, 0..1. */
    static double linear(int value) {
        double c = (value & 255) / 255.0;
        return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
    }
}
