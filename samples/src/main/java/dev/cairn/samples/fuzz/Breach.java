package dev.cairn.samples.fuzz;

/**
 * A law that a world broke.
 *
 * @param law which one
 * @param value of {@link Law#measure}, above {@link Law#bound}
 * @param tick when it was broken first, from 1
 * @param note in words; may be empty
 */
public record Breach(Law law, double value, int tick, String note) {
    @Override
    public String toString() {
        return "%s: %s %.3g (bound %.1g) at tick %d%s"
                .formatted(
                        law,
                        law.measure(),
                        value,
                        law.bound(),
                        tick,
                        note.isEmpty() ? "" : ", " + note);
    }
}
