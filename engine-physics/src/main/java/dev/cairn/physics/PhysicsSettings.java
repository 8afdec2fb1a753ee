package dev.cairn.physics;

import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.solver.SolverSettings;

import java.util.Objects;

/**
 * The tunables of the step, in one place. Every length rule is relative to the bodies' own size or
 * to how far they move in a tick: there is no absolute slop, so a scene of millimetres behaves as
 * one of kilometres. Immutable; any thread.
 *
 * @param substeps solver sub-steps of a tick, 1 to 64. More are more accurate and cost in
 *     proportion. Default 4
 * @param contactStiffness frequency of the soft contacts as a fraction of the sub-step's: {@code
 *     hertz = contactStiffness / h}, 0.001 to 0.5. Default 0.125
 * @param contactDampingRatio damping ratio of the soft contacts, 0 to 1000. Default 10: overlaps
 *     fade, they do not pop
 * @param pushSpeed the fastest that an overlap is pushed apart, m/s, 0.001 to 1000. Default 3
 * @param restitutionThreshold approach speed below which nothing bounces, m/s, 0 to 1000. Default
 *     0.1
 * @param offsetGain share of a resting contact's sag that is taken out each tick, 0 (off) to 0.05.
 *     Default 0.01
 * @param loadInertia inertia in the solver of a body at rest over the load that rests on it, 0
 *     (off) to 10. Tall stacks and heavy tops stand; bodies that move have their own inertia.
 *     Default 2
 * @param unloadSweeps extra sweeps where the load of a body at rest goes at once, 0 (off) to 64.
 *     Default 10
 * @param loneSweeps most sweeps in a sub-step over the contact of a body that moves and touches
 *     nothing but one that does not, 0 (off) to 4096: until its impulses agree. A slide, a stop, a
 *     tip follow their closed forms. What rests and what is stacked pays nothing. Default 32
 * @param effort how often the sub-steps of an island may be doubled while its bodies overlap by
 *     more than 1 % of their inner radius, 0 (never) to 4. Thin bodies, heavy landings and bad
 *     starts get what they need, and the rest of the scene does not pay for it. Default 0
 * @param directFrom bodies from end to end of a slender island at rest (a column, a chain, a
 *     bridge) from which on its contacts are solved together, by a block LDL^T, besides being swept
 *     one by one, 2 to 1024, or 0 for never. Columns of hundreds stand; what is shorter, wide or in
 *     motion pays nothing. Default 24
 * @param lanes contacts that the solver takes at once: 1 (scalar), 4, 8 or 16 (two vectors of 8),
 *     or 0 for what fits this machine. Speed only: the results are the same. What is asked for by
 *     number is warmed up when the world is made, which takes a second; 0 does so beside a scene
 *     that is large enough. Needs {@code --add-modules=jdk.incubator.vector}; without it the solver
 *     is scalar. Default 0
 * @param precision of the numbers that contacts are solved in: floats for large islands, which is
 *     faster, doubles for small ones, which is exact, see {@link Precision}. Default auto
 * @param speculativeTime contacts are made for pairs that could meet within so many ticks at their
 *     present relative speed (turning included), 0 to 16. Default 1
 * @param speculativeFraction and, besides, for pairs that are closer than this fraction of the
 *     smaller body's inner radius, so that resting points persist, 0 to 1. Default 0.02
 * @param boundsMargin fat bounds extend the needed ones by this fraction of the body's outer
 *     radius, 0 to 1. Default 0.1
 * @param boundsTime and by the distance of so many ticks along the body's velocity, 0 to 64.
 *     Default 4
 * @param sleeping whether bodies that have come to rest fall asleep, and then cost nothing until
 *     something wakes them. Default true; measurements of accuracy want false
 * @param sleepSeconds how long all bodies that touch must have been quiet before they fall asleep,
 *     s, 0.01 to 1000. Default 0.5
 */
public record PhysicsSettings(
        int substeps,
        double contactStiffness,
        double contactDampingRatio,
        double pushSpeed,
        double restitutionThreshold,
        double offsetGain,
        double loadInertia,
        int unloadSweeps,
        int loneSweeps,
        int effort,
        int directFrom,
        int lanes,
        Precision precision,
        double speculativeTime,
        double speculativeFraction,
        double boundsMargin,
        double boundsTime,
        boolean sleeping,
        double sleepSeconds) {
    /** The default values. */
    public static final PhysicsSettings DEFAULT =
            new PhysicsSettings(
                    SolverSettings.DEFAULT.substeps(),
                    SolverSettings.DEFAULT.hertzPerRate(),
                    SolverSettings.DEFAULT.dampingRatio(),
                    SolverSettings.DEFAULT.pushSpeed(),
                    SolverSettings.DEFAULT.restitutionThreshold(),
                    SolverSettings.DEFAULT.offsetGain(),
                    SolverSettings.DEFAULT.loadInertia(),
                    SolverSettings.DEFAULT.unloadSweeps(),
                    SolverSettings.DEFAULT.loneSweeps(),
                    SolverSettings.DEFAULT.effort(),
                    SolverSettings.DEFAULT.directFrom(),
                    SolverSettings.DEFAULT.lanes(),
                    Precision.AUTO,
                    1,
                    0.02,
                    0.1,
                    4,
                    true,
                    0.5);

    /**
     * Checks the values.
     *
     * @throws IllegalArgumentException if a value is out of its range; the message names value and
     *     range
     */
    public PhysicsSettings {
        Checks.between("substeps", substeps, 1, 64);
        Checks.between("contactStiffness", contactStiffness, 0.001, 0.5);
        Checks.between("contactDampingRatio", contactDampingRatio, 0, 1000);
        Checks.between("pushSpeed", pushSpeed, 0.001, 1000);
        Checks.between("restitutionThreshold", restitutionThreshold, 0, 1000);
        Checks.between("offsetGain", offsetGain, 0, 0.05);
        Checks.between("loadInertia", loadInertia, 0, 10);
        Checks.between("unloadSweeps", unloadSweeps, 0, 64);
        Checks.between("loneSweeps", loneSweeps, 0, 4096);
        Checks.between("effort", effort, 0, 4);
        Checks.between("directFrom", directFrom, 0, 1024);
        if (lanes != 0 && lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16) {
            throw new IllegalArgumentException(
                    "lanes must be 1, 4, 8 or 16, or 0 for what fits this machine, but is "
                            + lanes);
        }
        Objects.requireNonNull(precision, "precision");
        Checks.between("speculativeTime", speculativeTime, 0, 16);
        Checks.between("speculativeFraction", speculativeFraction, 0, 1);
        Checks.between("boundsMargin", boundsMargin, 0, 1);
        Checks.between("boundsTime", boundsTime, 0, 64);
        Checks.between("sleepSeconds", sleepSeconds, 0.01, 1000);
    }

    /**
     * These settings with another number of sub-steps.
     *
     * @param value 1 to 64
     * @return new settings
     */
    public PhysicsSettings withSubsteps(int value) {
        Draft d = new Draft(this);
        d.substeps = value;
        return d.settings();
    }

    /**
     * These settings with another restitution threshold.
     *
     * @param value m/s, at least 0
     * @return new settings
     */
    public PhysicsSettings withRestitutionThreshold(double value) {
        Draft d = new Draft(this);
        d.restitutionThreshold = value;
        return d.settings();
    }

    /**
     * These settings with another push speed.
     *
     * @param value m/s, 0.001 to 1000
     * @return new settings
     */
    public PhysicsSettings withPushSpeed(double value) {
        Draft d = new Draft(this);
        d.pushSpeed = value;
        return d.settings();
    }

    /**
     * These settings with another gain of the offset that removes sag.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withOffsetGain(double value) {
        Draft d = new Draft(this);
        d.offsetGain = value;
        return d.settings();
    }

    /**
     * These settings with another load-proportional inertia.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withLoadInertia(double value) {
        Draft d = new Draft(this);
        d.loadInertia = value;
        return d.settings();
    }

    /**
     * These settings with other sweeps where a load goes.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withUnloadSweeps(int value) {
        Draft d = new Draft(this);
        d.unloadSweeps = value;
        return d.settings();
    }

    /**
     * These settings with other sweeps of lone contacts.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withLoneSweeps(int value) {
        Draft d = new Draft(this);
        d.loneSweeps = value;
        return d.settings();
    }

    /**
     * These settings with another effort.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withEffort(int value) {
        Draft d = new Draft(this);
        d.effort = value;
        return d.settings();
    }

    /**
     * These settings with direct solves from another length on.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withDirectFrom(int value) {
        Draft d = new Draft(this);
        d.directFrom = value;
        return d.settings();
    }

    /**
     * These settings with another number of lanes.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withLanes(int value) {
        Draft d = new Draft(this);
        d.lanes = value;
        return d.settings();
    }

    /**
     * These settings with sleep or without.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withSleeping(boolean value) {
        Draft d = new Draft(this);
        d.sleeping = value;
        return d.settings();
    }

    /**
     * These settings with another time of quiet before sleep.
     *
     * @param value s, 0.01 to 1000
     * @return new settings
     */
    public PhysicsSettings withSleepSeconds(double value) {
        Draft d = new Draft(this);
        d.sleepSeconds = value;
        return d.settings();
    }

    /**
     * These settings with contacts solved in another precision.
     *
     * @param value see the component
     * @return new settings
     */
    public PhysicsSettings withPrecision(Precision value) {
        Draft d = new Draft(this);
        d.precision = value;
        return d.settings();
    }

    SolverSettings solver() {
        return SolverSettings.DEFAULT
                .withSubsteps(substeps)
                .withSoftness(contactStiffness, contactDampingRatio, pushSpeed)
                .withRestitutionThreshold(restitutionThreshold)
                .withOffsetGain(offsetGain)
                .withLoadInertia(
                        loadInertia,
                        SolverSettings.DEFAULT.restAcceleration(),
                        SolverSettings.DEFAULT.inertiaFloor())
                .withUnloadSweeps(unloadSweeps)
                .withLoneSweeps(loneSweeps)
                .withEffort(effort)
                .withDirectFrom(directFrom)
                .withLanes(lanes)
                .withFloatsFrom(precision.floatsFrom);
    }

    /** The values on their way to other settings, so that each change names only its own. */
    private static final class Draft {
        int substeps;
        double contactStiffness;
        double contactDampingRatio;
        double pushSpeed;
        double restitutionThreshold;
        double offsetGain;
        double loadInertia;
        int unloadSweeps;
        int loneSweeps;
        int effort;
        int directFrom;
        int lanes;
        Precision precision;
        double speculativeTime;
        double speculativeFraction;
        double boundsMargin;
        double boundsTime;
        boolean sleeping;
        double sleepSeconds;

        Draft(PhysicsSettings s) {
            substeps = s.substeps;
            contactStiffness = s.contactStiffness;
            contactDampingRatio = s.contactDampingRatio;
            pushSpeed = s.pushSpeed;
            restitutionThreshold = s.restitutionThreshold;
            offsetGain = s.offsetGain;
            loadInertia = s.loadInertia;
            unloadSweeps = s.unloadSweeps;
            loneSweeps = s.loneSweeps;
            effort = s.effort;
            directFrom = s.directFrom;
            lanes = s.lanes;
            precision = s.precision;
            speculativeTime = s.speculativeTime;
            speculativeFraction = s.speculativeFraction;
            boundsMargin = s.boundsMargin;
            boundsTime = s.boundsTime;
            sleeping = s.sleeping;
            sleepSeconds = s.sleepSeconds;
        }

        PhysicsSettings settings() {
            return new PhysicsSettings(
                    substeps,
                    contactStiffness,
                    contactDampingRatio,
                    pushSpeed,
                    restitutionThreshold,
                    offsetGain,
                    loadInertia,
                    unloadSweeps,
                    loneSweeps,
                    effort,
                    directFrom,
                    lanes,
                    precision,
                    speculativeTime,
                    speculativeFraction,
                    boundsMargin,
                    boundsTime,
                    sleeping,
                    sleepSeconds);
        }
    }
}
