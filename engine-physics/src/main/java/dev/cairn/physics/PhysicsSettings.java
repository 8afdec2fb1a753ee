package dev.cairn.physics;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import java.util.Objects;

/**
 * What a scene decides about its step: sub-steps, precision, sleep. Immutable; any thread. The
 * numbers that make the step work as it does are nested, for experts, see {@link #tuning} and
 * {@link Tunable}.
 */
public final class PhysicsSettings {
    /** The default values. */
    public static final PhysicsSettings DEFAULT = new PhysicsSettings(Tuning.DEFAULT, true);

    private final Tuning tuning;
    private final boolean sleeping;

    private PhysicsSettings(Tuning tuning, boolean sleeping) {
        this.tuning = tuning;
        this.sleeping = sleeping;
    }

    /**
     * Solver sub-steps of a tick.
     *
     * @return 1 to 64; 4 by default
     */
    public int substeps() {
        return tuning.count(Tunable.SUBSTEPS);
    }

    /**
     * These settings with another number of sub-steps: more are more accurate and cost in
     * proportion.
     *
     * @param value 1 to 64
     * @return new settings
     */
    public PhysicsSettings withSubsteps(int value) {
        return with(Tunable.SUBSTEPS, value);
    }

    /**
     * Approach speed below which nothing bounces.
     *
     * @return m/s; 0.1 by default
     */
    public double restitutionThreshold() {
        return tuning.get(Tunable.RESTITUTION_THRESHOLD);
    }

    /**
     * These settings with another restitution threshold.
     *
     * @param value m/s, 0 to 1000
     * @return new settings
     */
    public PhysicsSettings withRestitutionThreshold(double value) {
        return with(Tunable.RESTITUTION_THRESHOLD, value);
    }

    /**
     * Contacts that the solver takes at once, see {@link Tunable#LANES}.
     *
     * @return 1 (scalar), 4, 8 or 16, or 0 for what fits this machine, the default
     */
    public int lanes() {
        return tuning.count(Tunable.LANES);
    }

    /**
     * These settings with another number of lanes: speed only, the results are the same.
     *
     * @param value 1, 4, 8 or 16, or 0 for what fits this machine
     * @return new settings
     */
    public PhysicsSettings withLanes(int value) {
        return with(Tunable.LANES, value);
    }

    /**
     * The numbers that contacts are solved in.
     *
     * @return {@link Precision#AUTO} by default, also where {@link Tunable#FLOATS_FROM} was set to
     *     something between
     */
    public Precision precision() {
        return Precision.of(tuning.count(Tunable.FLOATS_FROM));
    }

    /**
     * These settings with contacts solved in another precision.
     *
     * @param value floats for large islands, for all or for none
     * @return new settings
     */
    public PhysicsSettings withPrecision(Precision value) {
        Objects.requireNonNull(value, "precision");
        return with(Tunable.FLOATS_FROM, value.floatsFrom());
    }

    /**
     * Whether bodies that have come to rest fall asleep, and then cost nothing until something
     * wakes them.
     *
     * @return true by default
     */
    public boolean sleeping() {
        return sleeping;
    }

    /**
     * These settings with sleep or without.
     *
     * @param value whether bodies at rest fall asleep; measurements of accuracy want false
     * @return new settings
     */
    public PhysicsSettings withSleeping(boolean value) {
        return new PhysicsSettings(tuning, value);
    }

    /**
     * How long all bodies that touch must have been quiet before they fall asleep.
     *
     * @return s; 0.5 by default
     */
    public double sleepSeconds() {
        return tuning.get(Tunable.SLEEP_SECONDS);
    }

    /**
     * These settings with another time of quiet before sleep.
     *
     * @param value s, 0.01 to 1000
     * @return new settings
     */
    public PhysicsSettings withSleepSeconds(double value) {
        return with(Tunable.SLEEP_SECONDS, value);
    }

    /**
     * The values of all tunables.
     *
     * @return those of these settings
     */
    public Tuning tuning() {
        return tuning;
    }

    /**
     * These settings with another value of a tunable.
     *
     * @param tunable which; its documentation tells unit and reason
     * @param value in its range
     * @return new settings
     * @throws IllegalArgumentException if the value is out of range; the message names the tunable,
     *     the value and the bounds
     */
    public PhysicsSettings with(Tunable tunable, double value) {
        return new PhysicsSettings(tuning.with(tunable, value), sleeping);
    }

    /** In bytes: all values by name, since defaults may change. */
    static final StateCodec<PhysicsSettings> CODEC =
            StateCodec.of(
                    PhysicsSettings.class,
                    "settings",
                    PhysicsSettings::write,
                    PhysicsSettings::read);

    private void write(StateOutput out) {
        out.writeBoolean(sleeping);
        Tunable[] all = Tunable.values();
        out.writeInt(all.length);
        for (Tunable tunable : all) {
            out.writeString(tunable.name());
            out.writeDouble(tuning.get(tunable));
        }
    }

    private static PhysicsSettings read(StateInput in) {
        PhysicsSettings settings = DEFAULT.withSleeping(in.readBoolean());
        for (int left = in.readInt(); left > 0; left--) {
            settings = settings.with(Tunable.valueOf(in.readString()), in.readDouble());
        }
        return settings;
    }

    /** Whether they lead to the same bits: lanes do not count, nor sub-steps, which may change. */
    boolean isLike(PhysicsSettings other) {
        return sleeping == other.sleeping
                && tuning.equalsBut(other.tuning, Tunable.SUBSTEPS, Tunable.LANES);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PhysicsSettings settings
                && sleeping == settings.sleeping
                && tuning.equals(settings.tuning);
    }

    @Override
    public int hashCode() {
        return 31 * tuning.hashCode() + Boolean.hashCode(sleeping);
    }

    /** Tells what differs from the defaults. */
    @Override
    public String toString() {
        return "PhysicsSettings[" + (sleeping ? "" : "sleeping=false ") + tuning + "]";
    }
}
