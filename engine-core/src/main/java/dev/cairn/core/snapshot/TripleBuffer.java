package dev.cairn.core.snapshot;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * Hands whole values from one writer thread to one reader thread without locks, waiting or
 * allocation. Of three slots the writer owns one, the reader owns one, and one is spare; publishing
 * and fetching each exchange the own slot for the spare one by a single atomic swap. So the reader
 * sees only complete values, never an older one after a newer one, and may miss some.
 *
 * <pre>
 *   writer fills [a]        spare [b] fresh?        reader uses [c]
 *        publish: [a] &lt;-&gt; spare, fresh
 *                                   latest: if fresh, [c] &lt;-&gt; spare
 * </pre>
 *
 * @param <T> what a slot holds; mutable, and reused
 */
public final class TripleBuffer<T> {
    private static final VarHandle SPARE;

    static {
        try {
            SPARE = MethodHandles.lookup().findVarHandle(TripleBuffer.class, "spare", int.class);
        } catch (ReflectiveOperationException failure) {
            throw new ExceptionInInitializerError(failure);
        }
    }

    /** Set in the spare index when the reader has not seen that slot yet. */
    private static final int FRESH = 4;

    private final T first;
    private final T second;
    private final T third;

    /** Writer thread only. */
    private int writing;

    @SuppressWarnings("unused") // through SPARE
    private volatile int spare = 1;

    /** Reader thread only. */
    private int reading = 2;

    /**
     * Makes the three slots.
     *
     * @param slots makes one slot; called three times
     * @throws NullPointerException if {@code slots}, or what it makes, is null
     */
    public TripleBuffer(Supplier<? extends T> slots) {
        Objects.requireNonNull(slots, "slots must not be null: it makes the three values");
        first = Objects.requireNonNull(slots.get(), "a slot must not be null");
        second = Objects.requireNonNull(slots.get(), "a slot must not be null");
        third = Objects.requireNonNull(slots.get(), "a slot must not be null");
    }

    /**
     * The slot to fill. Holds what it held some publications ago. Writer thread.
     *
     * @return the writer's own slot, until {@link #publish}
     */
    public T writing() {
        return slot(writing);
    }

    /** Hands the filled slot over. Writer thread. */
    public void publish() {
        writing = (int) SPARE.getAndSet(this, writing | FRESH) & ~FRESH;
    }

    /**
     * The newest published slot, or the same one again; one of the slots as they were made before
     * the first publication. Reader thread.
     *
     * @return the reader's own slot, until the next call
     */
    public T latest() {
        if ((spare & FRESH) != 0) {
            reading = (int) SPARE.getAndSet(this, reading) & ~FRESH;
        }
        return slot(reading);
    }

    private T slot(int index) {
        return index == 0 ? first : index == 1 ? second : third;
    }
}
