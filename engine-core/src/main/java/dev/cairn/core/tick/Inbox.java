package dev.cairn.core.tick;

import org.jctools.queues.varhandle.MpscChunkedVarHandleArrayQueue;

import java.util.Objects;

/**
 * Actions that any thread hands to the simulation thread, which runs them between two ticks.
 *
 * <p>Order: the actions of one thread run in the order in which it posted them, and so do actions
 * of two threads if the one's {@link #post} returned before the other's began. Memory: what a
 * thread wrote before it posted is visible to its action. Nothing is ever dropped: a full inbox
 * refuses with an exception.
 *
 * <p>Posting is lock-free. It allocates nothing but the action, and a chunk of the queue when the
 * number of waiting actions outgrows what it has reached before; draining does not allocate.
 *
 * <p>The queue is JCTools' multi-producer single-consumer linked-chunk queue.
 */
public final class Inbox {

    /** Capacity of an inbox that is made without a number: actions that may wait. */
    public static final int DEFAULT_CAPACITY = 1 << 16;

    /** Largest capacity. */
    public static final int MAX_CAPACITY = 1 << 24;

    private static final int CHUNK = 64;

    private final int capacity;
    private final MpscChunkedVarHandleArrayQueue<Runnable> queue;

    /** Creates an inbox of {@link #DEFAULT_CAPACITY}. */
    public Inbox() {
        this(DEFAULT_CAPACITY);
    }

    /**
     * Creates an inbox.
     *
     * @param capacity number of actions that may wait, in {@code [1, MAX_CAPACITY]}; rounded up to
     *     a power of two of at least 128
     * @throws IllegalArgumentException if {@code capacity} is out of its range
     */
    public Inbox(int capacity) {
        if (capacity < 1 || capacity > MAX_CAPACITY) {
            throw new IllegalArgumentException(
                    "capacity is " + capacity + ", but must be in [1, " + MAX_CAPACITY + "]");
        }
        int atLeast = Math.max(capacity, 2 * CHUNK);
        this.capacity = Integer.highestOneBit(atLeast - 1) << 1;
        queue = new MpscChunkedVarHandleArrayQueue<>(CHUNK, this.capacity);
    }

    /**
     * Number of actions that may wait. Any thread.
     *
     * @return the capacity, after rounding
     */
    public int capacity() {
        return capacity;
    }

    /**
     * Hands an action to the simulation thread. Any thread; does not block.
     *
     * @param action what to do; runs once, on the simulation thread, at the next {@link #drain}
     * @throws IllegalStateException if {@link #capacity} actions wait already; the action is then
     *     not taken
     */
    public void post(Runnable action) {
        Objects.requireNonNull(action, "action");
        if (!queue.offer(action)) {
            throw new IllegalStateException(
                    "the inbox is full: "
                            + capacity
                            + " actions wait; post fewer, make it larger, or let the simulation"
                            + " thread drain it");
        }
    }

    /**
     * Runs the actions that wait, in order. Simulation thread. An action that is posted meanwhile,
     * also by an action, waits for the next drain.
     *
     * <p>If an action throws, its exception leaves this method; the action counts as run, those
     * behind it stay in order for the next drain.
     *
     * @return number of actions run
     */
    public int drain() {
        int waiting = queue.size();
        for (int ran = 0; ran < waiting; ran++) {
            Runnable action = queue.poll();
            if (action == null) {
                return ran;
            }
            action.run();
        }
        return waiting;
    }

    /**
     * Whether no action waits. Any thread; a snapshot that may be old when it is read.
     *
     * @return whether no action waits
     */
    public boolean isEmpty() {
        return queue.isEmpty();
    }
}
