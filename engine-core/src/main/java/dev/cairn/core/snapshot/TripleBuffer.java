package dev.cairn.core.snapshot;

import java.util.function.Supplier;

/**
 * Three slots exchanged by one atomic int.
 *
 * @param <T> slot
 */
public final class TripleBuffer<T> {
    /** @param slots makes a slot, called three times */
    public TripleBuffer(Supplier<T> slots) {}

    /** @return slot to fill */
    public T writing() { throw new UnsupportedOperationException(); }
    /** Hands the slot over. */
    public void publish() { throw new UnsupportedOperationException(); }
    /** @return newest published slot */
    public T latest() { throw new UnsupportedOperationException(); }
}
