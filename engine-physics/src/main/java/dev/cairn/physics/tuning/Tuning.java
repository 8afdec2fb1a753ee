package dev.cairn.physics.tuning;

import java.util.EnumMap;
import java.util.Objects;

/** A value for each {@link Tunable}. Immutable; any thread. Reading one does not allocate. */
public final class Tuning {
    private static final Tunable[] ALL = Tunable.values();

    /** The measured defaults. */
    public static final Tuning DEFAULT = new Tuning();

    private final EnumMap<Tunable, Double> values;

    private Tuning() {
        values = new EnumMap<>(Tunable.class);
        for (Tunable tunable : ALL) {
            values.put(tunable, tunable.initial());
        }
    }

    private Tuning(Tuning from, Tunable tunable, double value) {
        values = new EnumMap<>(from.values);
        values.put(tunable, value);
    }

    /**
     * These values with another one.
     *
     * @param tunable which
     * @param value in the tunable's unit and range
     * @return new values
     * @throws IllegalArgumentException if the value is out of range; the message names the tunable,
     *     the value and the bounds
     */
    public Tuning with(Tunable tunable, double value) {
        tunable.check(value);
        return new Tuning(this, tunable, value + 0.0);
    }

    /**
     * The value of a tunable.
     *
     * @param tunable which
     * @return in the tunable's unit
     */
    public double get(Tunable tunable) {
        return Objects.requireNonNull(values.get(tunable));
    }

    /**
     * The value of a tunable that counts something.
     *
     * @param tunable one that is whole
     * @return its value
     */
    public int count(Tunable tunable) {
        return (int) get(tunable);
    }

    /**
     * Whether all values but two are the same. Allocates nothing.
     *
     * @param other values to compare with
     * @param one that may differ
     * @param another that may differ
     * @return true if so
     */
    public boolean equalsBut(Tuning other, Tunable one, Tunable another) {
        for (Tunable tunable : ALL) {
            boolean counts = tunable != one && tunable != another;
            // as equals compares them: NaN is in no range, and 0 has one sign
            if (counts && get(tunable) != other.get(tunable)) {
                return false;
            }
        }
        return true;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Tuning tuning && values.equals(tuning.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    /** Tells what differs from the defaults. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("Tuning");
        for (Tunable tunable : ALL) {
            if (get(tunable) != tunable.initial()) {
                text.append(' ').append(tunable).append('=').append(get(tunable));
            }
        }
        return text.toString();
    }
}
