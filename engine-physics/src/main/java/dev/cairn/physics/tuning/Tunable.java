package dev.cairn.physics.tuning;

/**
 * What may be tuned: its unit, its reason, its range and its default. Every length rule is relative
 * to the bodies' own size or to how far they move in a tick: there is no absolute slop.
 */
public enum Tunable {
    /** Solver sub-steps of a tick. More are more accurate and cost in proportion. */
    SUBSTEPS(true, 4, 1, 64),

    /**
     * Natural frequency of a soft contact times the sub-step. 0.125 is 30 Hz at 240 sub-steps per
     * second; there is no cap, so sag falls with the square of the sub-step.
     */
    CONTACT_STIFFNESS(false, 0.125, 1e-3, 0.5),

    /** Damping ratio of a soft contact; 10 recovers overlap slowly and never pops. */
    CONTACT_DAMPING_RATIO(false, 10, 0, 1000),

    /** Factor on the frequency of contacts with static bodies: the ground is the last word. */
    STATIC_STIFFNESS_SCALE(false, 2, 1, 4),

    /** Factor on the damping ratio of those contacts. */
    STATIC_DAMPING_SCALE(false, 0.5, 0.01, 1),

    /** Fastest speed at which overlap is pushed out, m/s; bounds the energy of bad starts. */
    PUSH_SPEED(false, 3, 1e-3, 1e3),

    /**
     * Slowest impact that bounces, m/s; slower ones are inelastic, so that a bouncing body comes to
     * rest instead of bouncing for ever smaller times.
     */
    RESTITUTION_THRESHOLD(false, 0.1, 0, 1e3),

    /**
     * Sweeps over the points of one contact before the next contact, after one common step of all
     * its points. More sweeps solve the tilt of a face inside the contact.
     */
    INNER_SWEEPS(true, 1, 1, 16),

    /**
     * Sweeps over normals and friction of a contact in a sub-step that it begins without impulses.
     * Costs nothing where nothing lands; a landing or a slide starts with the right friction.
     */
    COLD_SWEEPS(true, 8, 1, 32),

    /**
     * Share of a resting point's overlap that goes into its offset each tick; 0 is off. The sag of
     * soft contacts fades within seconds, half of it where they are inclined; above 0.02 tall
     * stacks grow restless.
     */
    OFFSET_GAIN(false, 0.01, 0, 0.05),

    /**
     * Inertia in the solver of a body at rest over the load that rests on it; 0 is off. Tall stacks
     * and heavy tops stand; bodies that move have their own inertia.
     */
    LOAD_INERTIA(false, 2, 0, 10),

    /** Acceleration, in g, above which a body is not at rest. */
    REST_ACCELERATION(false, 0.05, 1e-3, 10),

    /**
     * Share of the load's inertia that even a disturbed body keeps. Without it a light stack under
     * a very heavy top is lost when it is touched.
     */
    INERTIA_FLOOR(false, 0.05, 0, 1),

    /**
     * Extra sweeps over the island of a body at rest in the tick in which its load goes; 0 is off.
     * Without them the old impulses throw the stack up.
     */
    UNLOAD_SWEEPS(true, 10, 0, 64),

    /**
     * Most sweeps over an island of new bodies at rest before it moves for the first time: until
     * its impulses agree, or {@code 2^17} visits of contacts are done; 0 is off. What is put up in
     * balance stays in balance; other ticks pay nothing.
     */
    START_SWEEPS(true, 4096, 0, 65536),

    /**
     * Most sweeps in a sub-step over the contact of a body that moves and touches nothing but one
     * that does not, until its impulses agree. A slide, a stop, a tip follow their closed forms;
     * what rests and what is stacked pays nothing. 0 turns all help of such bodies off: also the
     * inelastic impact, the trapezoidal correction and the pinned corner.
     */
    LONE_SWEEPS(true, 32, 0, 4096),

    /**
     * Bodies from end to end of a slender island at rest (a column, a chain, a bridge) from which
     * on its contacts are solved together, by a block LDL^T, besides being swept; 0 is never.
     * Columns of hundreds stand; what is shorter, wide or in motion pays nothing. Where the inner
     * radius of a body is less than 3000 {@code g h²} of a sub-step (0.5 m at 1/240 s), from fewer
     * on, as the root of the radius: cubes of 1 cm from 3 on.
     */
    DIRECT_FROM(true, 24, 0, 1024),

    /**
     * Contacts that the solver takes at once: 1 (scalar), 4, 8 or 16 (two vectors of 8), or 0 for
     * what fits this machine. Speed only: the results are the same. What is asked for by number is
     * warmed up when the world is made, which takes a second; 0 does so beside a scene that is
     * large enough. Needs {@code --add-modules=jdk.incubator.vector}; without it the solver is
     * scalar.
     */
    LANES(true, 0, 0, 16) {
        @Override
        void check(double value) {
            if (value != 0 && value != 1 && value != 4 && value != 8 && value != 16) {
                throw new IllegalArgumentException(
                        "lanes is "
                                + (int) value
                                + "; it must be 1, 4, 8 or 16, or 0 for what fits this machine");
            }
        }
    },

    /**
     * Contacts from which on rows and changes of velocity of an island are floats: faster, with
     * errors of some 1e-7 of what changes. 0 for all islands, {@link Integer#MAX_VALUE} for none.
     * Bodies and their state are doubles in either case.
     */
    FLOATS_FROM(true, Tunable.LARGE_ISLAND, 0, Integer.MAX_VALUE),

    /**
     * Contacts are made for pairs that could meet within so many ticks at their present relative
     * speed, turning included.
     */
    SPECULATIVE_TICKS(false, 1, 0, 16),

    /**
     * And, besides, for pairs that are closer than this fraction of the smaller body's inner
     * radius, so that resting points persist.
     */
    SPECULATIVE_FRACTION(false, 0.02, 0, 1),

    /** Fat bounds extend the needed ones by this fraction of the body's outer radius. */
    BOUNDS_MARGIN(false, 0.1, 0, 1),

    /** And by the distance of so many ticks along the body's velocity. */
    BOUNDS_TICKS(false, 4, 0, 64),

    /** How long all bodies that touch must have been quiet before they fall asleep, s. */
    SLEEP_SECONDS(false, 0.5, 0.01, 1000);

    /** Contacts from which on an island is large: it is cut into domains. */
    public static final int LARGE_ISLAND = 1025;

    private final boolean isWhole;
    private final double initial;
    private final double low;
    private final double high;

    Tunable(boolean isWhole, double initial, double low, double high) {
        this.isWhole = isWhole;
        this.initial = initial;
        this.low = low;
        this.high = high;
    }

    /**
     * The measured default.
     *
     * @return in the tunable's unit
     */
    public double initial() {
        return initial;
    }

    void check(double value) {
        if (!(value >= low && value <= high) || (isWhole && value != (int) value)) {
            throw new IllegalArgumentException(
                    this
                            + " is "
                            + text(value)
                            + "; it must be "
                            + (isWhole ? "a whole number " : "")
                            + "from "
                            + text(low)
                            + " to "
                            + text(high));
        }
    }

    private String text(double value) {
        return isWhole && value == (long) value ? Long.toString((long) value) : "" + value;
    }

    /** The name as a Java method would have it: {@code offsetGain}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(name().length());
        boolean upper = false;
        for (char letter : name().toCharArray()) {
            if (letter != '_') {
                text.append(upper ? letter : Character.toLowerCase(letter));
            }
            upper = letter == '_';
        }
        return text.toString();
    }
}
