package dev.cairn.physics.solver.kernel;

/** The step of all points of a contact at once, before they are swept one by one. */
public final class CommonStep {
    /** No common step. */
    public static final int NONE = 0;

    /** That of the bias pass. */
    public static final int SOFT = 1;

    /** That of the relax pass. */
    public static final int HARD = 2;

    private CommonStep() {}
}
