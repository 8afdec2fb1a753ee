package dev.cairn.physics.solver;

/**
 * Tunables of the contact solver; immutable. Every number is here once, with what it buys and what
 * it costs.
 *
 * @param substeps sub-steps per tick, 1 to 64. Cost grows linearly; stiffness, and with it sag,
 *     with the square.
 * @param hertzPerRate natural frequency of a soft contact times the sub-step, 0.001 to 0.5. 0.125
 *     is 30 Hz at 240 sub-steps per second; there is no cap, so sag falls with the square of the
 *     sub-step.
 * @param dampingRatio damping ratio of a soft contact, at least 0. 10 recovers overlap slowly and
 *     never pops.
 * @param staticHertzScale factor on the frequency of contacts with static bodies, at least 1: the
 *     ground is the last word.
 * @param staticDampingScale factor on the damping ratio of those contacts, above 0.
 * @param pushSpeed fastest speed at which overlap is pushed out, m/s, above 0; bounds the energy of
 *     bad starts.
 * @param restitutionThreshold slowest impact that bounces, m/s, at least 0; slower ones are
 *     inelastic, so that a bouncing body comes to rest instead of bouncing for ever smaller times.
 * @param innerSweeps sweeps over the points of one contact before the next contact, 1 to 16, after
 *     one common step of all its points. More sweeps solve the tilt of a face inside the contact.
 * @param coldSweeps sweeps over normals and friction of a contact in a sub-step that it begins
 *     without impulses, 1 to 32. Costs nothing where nothing lands; a landing or a slide starts
 *     with the right friction.
 * @param offsetGain share of a resting point's overlap that goes into its offset each tick, 0 (off)
 *     to 0.05. The sag of soft contacts fades within a second; above 0.02 tall stacks grow
 *     restless.
 * @param loadInertia inertia in the solver of a body at rest over the load on it, 0 (off) to 10.
 *     Stacks and heavy tops stand; disturbed bodies have their own inertia.
 * @param restAcceleration acceleration, in g, above which a body is not at rest, 0.001 to 10.
 * @param inertiaFloor share of the load's inertia that even a disturbed body keeps, 0 to 1. Without
 *     it a light stack under a very heavy top is lost when it is touched.
 * @param unloadSweeps extra sweeps over the island of a body at rest in the tick in which its load
 *     goes, 0 (off) to 64. Without them the old impulses throw the stack up.
 * @param startSweeps most sweeps over an island of new bodies at rest before it moves for the first
 *     time, 0 (off) to 65536: until its impulses agree, or {@code 2^17} visits of contacts are
 *     done. What is put up in balance stays in balance; other ticks pay nothing.
 * @param loneSweeps most sweeps in a sub-step over the contact of a body that moves and touches
 *     nothing but one that does not, 0 (off) to 4096: until its impulses agree. A slide, a stop, a
 *     tip follow their closed forms. What rests and what is stacked pays nothing.
 * @param effort how often the sub-steps of an island may be doubled while its bodies overlap by
 *     more than 1 % of their inner radius, 0 (never) to 4. Thin bodies, heavy landings and bad
 *     starts get what they need; the rest of the scene does not pay for it.
 * @param directFrom bodies from end to end of an island, at rest and slender, from which on its
 *     contacts are also solved together, by a block LDL^T, 2 to 1024; 0 for never. Tall columns
 *     stand; what is shorter, wide or in motion pays nothing.
 * @param lanes contacts that are solved at once: 1 (scalar), 4, 8 or 16, or 0 for what fits this
 *     machine. Speed only: the results are the same. Without the module {@code
 *     jdk.incubator.vector} it is always 1.
 * @param floatsFrom contacts from which on rows and changes of velocity of an island are floats:
 *     faster, with errors of some 1e-7 of what changes. 0 for all islands, {@link
 *     Integer#MAX_VALUE} for none. Bodies and their state are doubles in either case.
 */
public record SolverSettings(
        int substeps,
        double hertzPerRate,
        double dampingRatio,
        double staticHertzScale,
        double staticDampingScale,
        double pushSpeed,
        double restitutionThreshold,
        int innerSweeps,
        int coldSweeps,
        double offsetGain,
        double loadInertia,
        double restAcceleration,
        double inertiaFloor,
        int unloadSweeps,
        int startSweeps,
        int loneSweeps,
        int effort,
        int directFrom,
        int lanes,
        int floatsFrom) {
    /** Contacts from which on an island is large: it is cut into domains. */
    public static final int LARGE = 1025;

    /** Most doublings of sub-steps. */
    static final int MOST_EFFORT = 4;

    /** The measured defaults. */
    public static final SolverSettings DEFAULT =
            new SolverSettings(
                    4,
                    0.125,
                    10,
                    2,
                    0.5,
                    3,
                    0.1,
                    1,
                    8,
                    0.01,
                    2,
                    0.05,
                    0.05,
                    10,
                    4096,
                    32,
                    0,
                    24,
                    0,
                    Integer.MAX_VALUE);

    /**
     * Checks every bound.
     *
     * @throws IllegalArgumentException if a value is out of its range; the message names it
     */
    public SolverSettings {
        check("substeps", substeps, 1, 64);
        check("hertzPerRate", hertzPerRate, 1e-3, 0.5);
        check("dampingRatio", dampingRatio, 0, 1000);
        check("staticHertzScale", staticHertzScale, 1, 4);
        check("staticDampingScale", staticDampingScale, 0.01, 1);
        check("pushSpeed", pushSpeed, 1e-3, 1e3);
        check("restitutionThreshold", restitutionThreshold, 0, 1e3);
        check("innerSweeps", innerSweeps, 1, 16);
        check("coldSweeps", coldSweeps, 1, 32);
        check("offsetGain", offsetGain, 0, 0.05);
        check("loadInertia", loadInertia, 0, 10);
        check("restAcceleration", restAcceleration, 1e-3, 10);
        check("inertiaFloor", inertiaFloor, 0, 1);
        check("unloadSweeps", unloadSweeps, 0, 64);
        check("startSweeps", startSweeps, 0, 65536);
        check("loneSweeps", loneSweeps, 0, 4096);
        check("effort", effort, 0, MOST_EFFORT);
        check("directFrom", directFrom, 0, 1024);
        check("floatsFrom", floatsFrom, 0, Integer.MAX_VALUE);
        if (lanes != 0 && lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16) {
            throw new IllegalArgumentException(
                    "lanes must be 1, 4, 8 or 16, or 0 for what fits this machine, but is "
                            + lanes);
        }
    }

    private static void check(String name, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw new IllegalArgumentException(
                    name + " must be in [" + low + ", " + high + "], but is " + value);
        }
    }

    /**
     * These settings with another number of sub-steps.
     *
     * @param value 1 to 64
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withSubsteps(int value) {
        Draft d = new Draft(this);
        d.substeps = value;
        return d.settings();
    }

    /**
     * These settings with another restitution threshold.
     *
     * @param value m/s, at least 0
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withRestitutionThreshold(double value) {
        Draft d = new Draft(this);
        d.restitutionThreshold = value;
        return d.settings();
    }

    /**
     * These settings with another soft step.
     *
     * @param newHertzPerRate contact frequency times the sub-step
     * @param newDampingRatio damping ratio
     * @param newPushSpeed fastest push, m/s
     * @return new settings
     * @throws IllegalArgumentException if a value is out of its range
     */
    public SolverSettings withSoftness(
            double newHertzPerRate, double newDampingRatio, double newPushSpeed) {
        Draft d = new Draft(this);
        d.hertzPerRate = newHertzPerRate;
        d.dampingRatio = newDampingRatio;
        d.pushSpeed = newPushSpeed;
        return d.settings();
    }

    /**
     * These settings with other numbers of sweeps inside a contact.
     *
     * @param newInnerSweeps always
     * @param newColdSweeps in the sub-step in which the contact begins
     * @return new settings
     * @throws IllegalArgumentException if a value is out of its range
     */
    public SolverSettings withSweeps(int newInnerSweeps, int newColdSweeps) {
        Draft d = new Draft(this);
        d.innerSweeps = newInnerSweeps;
        d.coldSweeps = newColdSweeps;
        return d.settings();
    }

    /**
     * These settings with another gain of the offset that removes sag.
     *
     * @param value 0 (off) to 0.05
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withOffsetGain(double value) {
        Draft d = new Draft(this);
        d.offsetGain = value;
        return d.settings();
    }

    /**
     * These settings with another load-proportional inertia.
     *
     * @param value inertia over load, 0 (off) to 10
     * @param newRestAcceleration gate, in g
     * @param newInertiaFloor share that a disturbed body keeps
     * @return new settings
     * @throws IllegalArgumentException if a value is out of its range
     */
    public SolverSettings withLoadInertia(
            double value, double newRestAcceleration, double newInertiaFloor) {
        Draft d = new Draft(this);
        d.loadInertia = value;
        d.restAcceleration = newRestAcceleration;
        d.inertiaFloor = newInertiaFloor;
        return d.settings();
    }

    /**
     * These settings with another number of sweeps when a load goes.
     *
     * @param value 0 (off) to 64
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withUnloadSweeps(int value) {
        Draft d = new Draft(this);
        d.unloadSweeps = value;
        return d.settings();
    }

    /**
     * These settings with another number of sweeps over what is put up at rest.
     *
     * @param value 0 (off) to 65536
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withStartSweeps(int value) {
        Draft d = new Draft(this);
        d.startSweeps = value;
        return d.settings();
    }

    /**
     * These settings with other sweeps of lone contacts.
     *
     * @param value 0 (off) to 4096
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withLoneSweeps(int value) {
        Draft d = new Draft(this);
        d.loneSweeps = value;
        return d.settings();
    }

    /**
     * These settings with another effort.
     *
     * @param value 0 (never more) to 4
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withEffort(int value) {
        Draft d = new Draft(this);
        d.effort = value;
        return d.settings();
    }

    /**
     * These settings with direct solves from another length on.
     *
     * @param value bodies from end to end, 2 to 1024, or 0 for never
     * @return new settings
     * @throws IllegalArgumentException if the value is out of its range
     */
    public SolverSettings withDirectFrom(int value) {
        Draft d = new Draft(this);
        d.directFrom = value;
        return d.settings();
    }

    /**
     * These settings with another number of lanes.
     *
     * @param value 1, 4, 8 or 16, or 0 for what fits this machine
     * @return new settings
     * @throws IllegalArgumentException if the value is none of those
     */
    public SolverSettings withLanes(int value) {
        Draft d = new Draft(this);
        d.lanes = value;
        return d.settings();
    }

    /**
     * These settings in another precision.
     *
     * @param value contacts from which on those of an island are solved in floats, 0 for all
     *     islands
     * @return new settings
     * @throws IllegalArgumentException if the value is negative
     */
    public SolverSettings withFloatsFrom(int value) {
        Draft d = new Draft(this);
        d.floatsFrom = value;
        return d.settings();
    }

    /** The values on their way to other settings, so that each change names only its own. */
    private static final class Draft {
        int substeps;
        double hertzPerRate;
        double dampingRatio;
        double staticHertzScale;
        double staticDampingScale;
        double pushSpeed;
        double restitutionThreshold;
        int innerSweeps;
        int coldSweeps;
        double offsetGain;
        double loadInertia;
        double restAcceleration;
        double inertiaFloor;
        int unloadSweeps;
        int startSweeps;
        int loneSweeps;
        int effort;
        int directFrom;
        int lanes;
        int floatsFrom;

        Draft(SolverSettings s) {
            substeps = s.substeps;
            hertzPerRate = s.hertzPerRate;
            dampingRatio = s.dampingRatio;
            staticHertzScale = s.staticHertzScale;
            staticDampingScale = s.staticDampingScale;
            pushSpeed = s.pushSpeed;
            restitutionThreshold = s.restitutionThreshold;
            innerSweeps = s.innerSweeps;
            coldSweeps = s.coldSweeps;
            offsetGain = s.offsetGain;
            loadInertia = s.loadInertia;
            restAcceleration = s.restAcceleration;
            inertiaFloor = s.inertiaFloor;
            unloadSweeps = s.unloadSweeps;
            startSweeps = s.startSweeps;
            loneSweeps = s.loneSweeps;
            effort = s.effort;
            directFrom = s.directFrom;
            lanes = s.lanes;
            floatsFrom = s.floatsFrom;
        }

        SolverSettings settings() {
            return new SolverSettings(
                    substeps,
                    hertzPerRate,
                    dampingRatio,
                    staticHertzScale,
                    staticDampingScale,
                    pushSpeed,
                    restitutionThreshold,
                    innerSweeps,
                    coldSweeps,
                    offsetGain,
                    loadInertia,
                    restAcceleration,
                    inertiaFloor,
                    unloadSweeps,
                    startSweeps,
                    loneSweeps,
                    effort,
                    directFrom,
                    lanes,
                    floatsFrom);
        }
    }
}
