package dev.cairn.physics.solver.direct;

/**
 * The factors of an island's matrix in one kind of pass: they serve all sub-steps of a tick in
 * which the same points press and the same contacts stick, since levers are those of the tick's
 * start.
 *
 * <p>One thread at a time. Allocates only to grow.
 */
final class DirectFactors {
    final SkylineLdlt matrix = new SkylineLdlt();

    /** What the matrix was made of. */
    private double[] stiffness = {};

    private boolean isCurrent;

    /** Levers change with the tick. */
    void forget() {
        isCurrent = false;
    }

    /** Whether the factors are those of these stiffnesses; else they are remembered. */
    boolean matches(double[] of, int count) {
        boolean same = isCurrent;
        for (int k = 0; k < count && same; k++) {
            same = of[k] == stiffness[k];
        }
        if (!same) {
            if (stiffness.length < count) {
                stiffness = new double[2 * count];
            }
            System.arraycopy(of, 0, stiffness, 0, count);
        }
        isCurrent = true;
        return same;
    }
}
