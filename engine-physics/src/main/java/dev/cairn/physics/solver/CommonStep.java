package dev.cairn.physics.solver;

/** The step of all points of a contact at once, before they are swept one by one. */
final class CommonStep {
    /** No common step. */
    static final int NONE = 0;

    /** That of the bias pass. */
    static final int SOFT = 1;

    /** That of the relax pass. */
    static final int HARD = 2;

    private CommonStep() {}
}
