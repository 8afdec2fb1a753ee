package dev.cairn.physics.solver.joint;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.joint.net.PointNet;

import java.util.Arrays;

/**
 * Bodies that hang together by joints, whatever they touch: what is solved as a whole.
 *
 * <p>Made by {@link Assemblies} when joints come, go, sleep or wake.
 */
public final class Assembly {
    /** The linear system: bodies and joints are its nodes, in this order. */
    interface Matrix {
        /** First unknown of a node. */
        int unknown(int node);

        /** Right-hand side, then the solution. */
        double[] x();
    }

    /** A wait, in sub-steps, beyond which Newton's method is taken to fail always. */
    private static final int LONG_BACK_OFF = 16;

    /** Most ticks for which a net is solved by factors before gradients are tried again. */
    private static final int CAUTIOUS = 128;

    /** Points of a contact, of which each has a number in {@link #impactImpulses}. */
    static final int POINTS = 4;

    /** Contacts for which there is room at first. */
    private static final int ROOM = 16;

    /** Numbers to a body of {@link #kept}: velocity, movement, mark, orientation. */
    static final int KEPT = 22;

    /** Numbers to a body of {@link #carried}: state, mark, warm start, root, turn. */
    static final int CARRIED = 44;

    /** Numbers to a body of {@link #first}: velocity and mark. */
    static final int FIRST = 12;

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

    /** Whether it can be solved by factors. */
    final boolean hasFactors;

    /** Whether it is, in this tick; else by conjugate gradients. */
    boolean isDirect;

    final BlockFactors factors;
    final ConjugateGradients gradients;

    /** The numbers of a net of balls, if it can be one; whether it is one in this tick. */
    final PointNet net;

    boolean isNet;

    /** Ticks for which a net is solved by factors, as a few rounds of gradients left it open. */
    private int opened;

    /** For how many it will be if that happens again. */
    private int caution = 1;

    /** Of that: inner radius of its smallest body, m. */
    double size;

    /** That of the two which is used. */
    final Matrix system;

    /** By row: its derivatives, {@link JointMath#JACOBIAN} each, in world axes. */
    final double[] derivative;

    /** By joint: B's origin from B's centre in the poses of these, m. */
    final double[] arm;

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

    /** Room to take a movement back: numbers of {@link #KEPT} to a body. */
    final double[] kept;

    /** By body: its frequency under tension, rad/s. Steps that this wants of a sub-step. */
    final double[] quick;

    int parts = 1;

    /** Sub-steps that it is still solved by one projection, as Newton's method has failed. */
    int approximateSteps;

    /** For how many it will be if Newton's method fails again. */
    int backOff = 1;

    /** Whether a motor or a spring acts in it. */
    boolean isDriven;

    /** Energy that motors and springs may give in the sub-step, J. */
    public double given;

    /** Time since the tick's begin that its poses are of, s: kinematic partners move by it. */
    double time;

    /**
     * Root of the energy of motion that its bodies would have if they moved as one with a kinematic
     * partner, J^(1/2); the sum over all of these that move.
     */
    double carriedRoot;

    /** Whether it has an account; that, and what it is measured by, J; see {@link JointEnergy}. */
    boolean keeps;

    double account;
    double level;

    /** Energy at the sub-step's begin, and what contacts have added in it, J. */
    double energy;

    double pushed;

    /** By body: what contacts have given to it before it was moved, {@link SolverBodies#HALF}. */
    final double[] press;

    /** Where bodies are at the end of a sub-step that was cut, and room beside it. */
    final double[] carried;

    /** By body: what tension turns it back with, see {@link Tension}; 9 to a body. */
    final double[] taut;

    /** Whether {@link #derivative} is that of the present poses. */
    boolean isFresh;

    /** Whether all rows are locks: which rows hold never changes. */
    boolean isRigid = true;

    /** Whether joints close loops, by static bodies too: rows may depend on each other. */
    final boolean isLooped;

    /** Whether a joint ties it to a static body. */
    final boolean isGrounded;

    /** Velocities and marks, and impulses, before a half: impulses that are none leave rounding. */
    final double[] first;

    final double[] firstImpulse;

    /** By row: impulse in work. */
    final double[] impulse;

    /** By row: impulses of both halves of the sub-step before. */
    final double[] load;

    /** By row: what it measured when the sub-step began, before it was moved. */
    final double[] begun;

    /** By row: the speed that a motor or a spring keeps while locks are solved anew. */
    final double[] driven;

    /**
     * Edges of its contacts by the list of the tick: first those with static bodies, then those
     * with bodies that no joint holds and that touch no other assembly. How many there are of the
     * first, and of both.
     */
    int[] stand = new int[ROOM];

    int standCount;
    int touchCount;

    /** Whether a contact of it is with static bodies, in rows of whichever precision. */
    boolean touchesFixed;

    /**
     * By point of these: impulse that {@code ContactCoupling} gave in the sub-step; whether any.
     */
    double[] impactImpulses = new double[POINTS * ROOM];

    /** The same before a solve that may be taken back. */
    double[] firstImpacts = new double[POINTS * ROOM];

    boolean gives;

    /** Notes a contact with static bodies; those come first. */
    void stand(int edge) {
        touch(edge);
        standCount++;
    }

    /** Notes a contact with a body that moves. */
    void touch(int edge) {
        if (touchCount == stand.length) {
            stand = Arrays.copyOf(stand, 2 * touchCount + 4);
            impactImpulses = new double[POINTS * stand.length];
            firstImpacts = new double[POINTS * stand.length];
        }
        stand[touchCount++] = edge;
    }

    /** Whether Newton's method fails again and again. */
    boolean keepsFailing() {
        return approximateSteps > 0 && backOff > LONG_BACK_OFF;
    }

    /** A step begins. */
    void calm() {
        approximateSteps = Math.max(0, approximateSteps - 1);
        backOff = approximateSteps == 0 ? Math.max(1, backOff / 2) : backOff;
    }

    /** A tick begins: whether conjugate gradients may be tried, if it is a net. */
    boolean mayBeNet() {
        opened = Math.max(0, opened - 1);
        return net.isPoints && (!hasFactors || opened == 0);
    }

    /**
     * It was solved as a net.
     *
     * @param isOpen whether that has left it open
     */
    void judge(boolean isOpen) {
        if (isOpen) {
            opened = caution + 1;
            caution = Math.min(2 * caution, CAUTIOUS);
        } else {
            caution = Math.max(1, caution / 2);
        }
    }

    /** How many numbers it remembers from tick to tick. */
    int memories() {
        return quick.length + 6;
    }

    /** Writes them: what is known of frequencies under tension fades, see {@link Tension}. */
    void remember(double[] into, int at) {
        into[at] = approximateSteps;
        into[at + 1] = account;
        into[at + 2] = level;
        into[at + 3] = backOff;
        into[at + 4] = opened;
        into[at + 5] = caution;
        System.arraycopy(quick, 0, into, at + 6, quick.length);
    }

    /** Reads them. */
    void recall(double[] from, int at) {
        approximateSteps = (int) from[at];
        account = from[at + 1];
        level = from[at + 2];
        backOff = (int) from[at + 3];
        opened = (int) from[at + 4];
        caution = (int) from[at + 5];
        System.arraycopy(from, at + 6, quick, 0, quick.length);
    }

    /** Whether its sub-steps are cut into more. */
    public boolean isTaut() {
        return parts > 1;
    }

    Assembly(
            int[] body,
            int[] joint,
            int[] end,
            int[] rows,
            boolean isPoints,
            double[] arms,
            double[] axes) {
        this.body = body;
        this.joint = joint;
        this.end = end;
        firstRow = new int[joint.length + 1];
        for (int k = 0; k < joint.length; k++) {
            firstRow[k + 1] = firstRow[k] + rows[k];
        }
        int n = firstRow[joint.length];
        boolean grounded = false;
        for (int i : end) {
            grounded |= i < 0;
        }
        isGrounded = grounded;
        // a tree has as many edges as nodes less one; all static bodies are one node
        isLooped = joint.length > body.length - (isGrounded ? 0 : 1);
        Elimination order = new Elimination(body.length, rows, end);
        hasFactors = order.isSparse;
        isDirect = hasFactors;
        factors = new BlockFactors(hasFactors ? order : new Elimination(0, new int[0], new int[0]));
        gradients =
                hasFactors
                        ? ConjugateGradients.none()
                        : new ConjugateGradients(body.length, end, firstRow, arms);
        boolean isNetlike = isPoints && (!hasFactors || order.isFilled);
        net = new PointNet(isNetlike, body, end, arms, axes);
        system = hasFactors ? factors : gradients;
        derivative = new double[JointMath.JACOBIAN * n];
        arm = new double[3 * joint.length];
        scaled = new double[JointMath.JACOBIAN * n];
        pivot = new double[n];
        start = new double[n];
        now = new double[n];
        isActive = new boolean[n];
        compliance = new double[n];
        load = new double[2 * n];
        impulse = new double[n];
        first = new double[FIRST * body.length];
        firstImpulse = new double[n];
        quick = new double[body.length];
        carried = new double[CARRIED * body.length];
        taut = new double[9 * body.length];
        kept = new double[KEPT * body.length];
        begun = new double[n];
        driven = new double[n];
        press = new double[SolverBodies.HALF * body.length];
    }
}
