package dev.cairn.render.input;

/**
 * Whole steps out of parts of one: fine wheels tell parts, and the mouse goes by points. What is no
 * whole step yet waits for the next part the same way.
 */
final class Steps {
    private double rest;

    /** Adds a part, whose sign is its way; how many whole steps are done by it. */
    int add(double part) {
        rest = part * rest < 0 ? part : rest + part;
        int whole = (int) rest;
        rest -= whole;
        return Math.abs(whole);
    }
}
