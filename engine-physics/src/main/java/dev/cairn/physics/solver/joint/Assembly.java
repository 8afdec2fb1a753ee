package dev.cairn.physics.solver.joint;

/**
 * Bodies that hang together by joints, whatever they touch: what is solved as a whole.
 *
 * <p>Made by {@link Assemblies} when joints come, go, sleep or wake.
 */
public final class Assembly {
    /** Slots of its bodies that move, ascending. */
    public final int[] body;

    /** Its joints, in the order of their edges. */
    final int[] joint;

    /**
     * Body A and body B of each joint as indices in {@link #body}, -1 for one that does not move.
     */
    final int[] end;

    /** First row of each joint among those of the assembly; one more for the end. */
    final int[] firstRow;

    /** Whether it is solved directly; else its joints are swept. */
    public final boolean isDirect;

    final BlockFactors factors;

    /** By row: its derivatives, {@link JointMath#JACOBIAN} each, in world axes. */
    final double[] derivative;

    /**
     * The same for scaled velocities: {@code e/sqrt(m), L^T t} of A, then of B. What it measured
     * with them, and after the movement.
     */
    final double[] scaled;

    final double[] start;
    final double[] now;

    /** By row: whether it is an equation at present. */
    final boolean[] isActive;

    /** By row: the entry of the matrix' diagonal that the factors were made with. */
    final double[] pivot;

    /** Whether the factors are those of {@link #scaled}. */
    boolean isFactored;

    /** By row: effective inverse mass of the row alone, 1/kg or 1/(kg m²). */
    final double[] compliance;

    /** Room to take a movement back: numbers of {@link JointSolve#KEPT} to a body. */
    final double[] kept;

    /** By body: its frequency under tension, rad/s. Steps that this wants of a sub-step. */
    final double[] quick;

    int parts = 1;

    /** Where bodies are at the end of a sub-step that was cut, and room beside it. */
    final double[] carried;

    /** By body: what tension turns it back with, see {@link Tension}; 9 to a body. */
    final double[] taut;

    /** Whether {@link #derivative} is that of the present poses. */
    boolean isFresh;

    /** Whether all rows are locks: who holds never changes. */
    boolean isRigid = true;

    /** Whether joints close loops, by what does not move too: rows may depend on each other. */
    final boolean isLooped;

    /** By row: impulse in work. */
    final double[] impulse;

    /** By row, of motors and springs: speed and impulse before the bodies were moved. */
    final double[] speed;

    final double[] noted;

    /** Whether its sub-steps are cut into more. */
    public boolean isTaut() {
        return parts > 1;
    }

    Assembly(int[] body, int[] joint, int[] end, int[] rows) {
        this.body = body;
        this.joint = joint;
        this.end = end;
        firstRow = new int[joint.length + 1];
        for (int k = 0; k < joint.length; k++) {
            firstRow[k + 1] = firstRow[k] + rows[k];
        }
        int n = firstRow[joint.length];
        boolean isGrounded = false;
        for (int i : end) {
            isGrounded |= i < 0;
        }
        // a tree has as many edges as nodes less one; what does not move is one node
        isLooped = joint.length > body.length - (isGrounded ? 0 : 1);
        Elimination order = new Elimination(body.length, rows, end);
        isDirect = order.isSparse;
        factors = new BlockFactors(isDirect ? order : new Elimination(0, new int[0], new int[0]));
        derivative = new double[JointMath.JACOBIAN * n];
        scaled = new double[JointMath.JACOBIAN * n];
        pivot = new double[n];
        start = new double[n];
        now = new double[n];
        isActive = new boolean[n];
        compliance = new double[n];
        impulse = new double[n];
        speed = new double[n];
        noted = new double[n];
        quick = new double[body.length];
        carried = new double[Swing.CARRIED * body.length];
        taut = new double[9 * body.length];
        kept = new double[JointSolve.KEPT * body.length];
    }
}
