package dev.cairn.physics.narrowphase.axis;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * Ascent of the separation from an axis that {@link AxisRefinement} found to a better one near it,
 * where {@link OptimalityTest} fails: from axis n with separation s towards |s| n + w, where w is
 * the supergradient across n, from the support feature of A to that of B.
 */
public final class AxisAscent {
    /** How often what is nearer is looked for. */
    private static final int STEPS = 4;

    private final AxisRefinement refine;
    private double axisX, axisY, axisZ, separation;
    private int kindA, kindB;

    public AxisAscent(AxisRefinement refine) {
        this.refine = refine;
    }

    /**
     * Goes on from what was refined last, and leaves the best there; whether it is known to be the
     * best of all near ones.
     */
    public boolean climb(Pair p) {
        for (int i = 0; i < STEPS; i++) {
            if (refine.isOptimal()) {
                return true;
            }
            keep();
            double away = Math.abs(separation);
            double x = away * axisX + refine.optimality.missX;
            double y = away * axisY + refine.optimality.missY;
            double z = away * axisZ + refine.optimality.missZ;
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length > 0) {
                refine.run(p, x / length, y / length, z / length, true);
            }
            if (!(refine.separation > separation)) {
                refine.run(p, axisX, axisY, axisZ, true);
            }
            if (!(refine.separation > separation)) {
                restore();
                return false;
            }
        }
        return false;
    }

    private void keep() {
        axisX = refine.axisX;
        axisY = refine.axisY;
        axisZ = refine.axisZ;
        separation = refine.separation;
        kindA = refine.kindA;
        kindB = refine.kindB;
    }

    private void restore() {
        refine.axisX = axisX;
        refine.axisY = axisY;
        refine.axisZ = axisZ;
        refine.separation = separation;
        refine.kindA = kindA;
        refine.kindB = kindB;
    }
}
