package dev.cairn.core.snapshot;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.Objects;

/**
 * The visible entities of one tick: those that have a {@link Pose} and a {@link Visual}, each with
 * its pose at this tick and at the one before, so that a renderer can interpolate between them. An
 * entity that is new, or that was teleported, has the same pose twice.
 *
 * <p>The reader that got it from {@link SnapshotExchange#latest} owns it until its next call. The
 * arrays belong to the snapshot; read them only.
 */
public final class PoseSnapshot {
    /** Doubles per row: x, y, z in metres, then qx, qy, qz, qw. */
    public static final int STRIDE = 7;

    private static final int FIRST_CAPACITY = 64;

    private long tick = -1;
    private double stepSeconds;
    private long publishedNanos;
    private int size;
    private long[] entities = new long[FIRST_CAPACITY];
    private @Nullable Object[] models = new Object[FIRST_CAPACITY];
    private double[] previous = new double[FIRST_CAPACITY * STRIDE];
    private double[] current = new double[FIRST_CAPACITY * STRIDE];
    private @Nullable Object extra;
    private @Nullable Object spareExtra;

    PoseSnapshot() {}

    /** Empties the snapshot for a new tick. */
    void begin(long newTick, double newStepSeconds, int rows) {
        tick = newTick;
        stepSeconds = newStepSeconds;
        if (rows > entities.length) {
            int capacity = Math.max(rows, entities.length * 2);
            entities = new long[capacity];
            models = Arrays.copyOf(models, capacity);
            previous = new double[capacity * STRIDE];
            current = new double[capacity * STRIDE];
        }
        for (int row = rows; row < size; row++) {
            models[row] = null;
        }
        size = rows;
    }

    void put(int row, long entity, Object model) {
        entities[row] = entity;
        models[row] = model;
    }

    void end(long nanos) {
        publishedNanos = nanos;
    }

    /** Has the extra data filled, into the object that this slot used before if there is one. */
    void attach(@Nullable SnapshotExtra source) {
        Object filled = source == null ? null : source.fill(spareExtra);
        extra = filled;
        if (filled != null) {
            spareExtra = filled;
        }
    }

    /**
     * The tick that this is the state after.
     *
     * @return the tick's number, or -1 if nothing was published yet
     */
    public long tick() {
        return tick;
    }

    /**
     * The time between the two poses.
     *
     * @return length of the tick, s; 0 before the first step
     */
    public double stepSeconds() {
        return stepSeconds;
    }

    /**
     * When this was published.
     *
     * @return {@link System#nanoTime()} of that moment
     */
    public long publishedNanos() {
        return publishedNanos;
    }

    /**
     * What a {@link SnapshotExtra} added to this tick, such as data for debug drawing.
     *
     * @return the reader's own like the snapshot itself, or null if nothing was added
     */
    public @Nullable Object extra() {
        return extra;
    }

    /**
     * Number of visible entities.
     *
     * @return rows
     */
    public int size() {
        return size;
    }

    /**
     * The entity of a row.
     *
     * @param row the row, in {@code [0, size())}
     * @return the entity
     * @throws IndexOutOfBoundsException if there is no such row
     */
    public long entity(int row) {
        return entities[Objects.checkIndex(row, size)];
    }

    /**
     * What to draw at a row.
     *
     * @param row the row, in {@code [0, size())}
     * @return the model of the entity's {@link Visual}
     * @throws IndexOutOfBoundsException if there is no such row
     */
    public Object model(int row) {
        return Objects.requireNonNull(models[Objects.checkIndex(row, size)], "model");
    }

    /**
     * Poses one tick before, {@link #STRIDE} per row; world frame, metres, unit quaternions.
     *
     * @return an array of at least {@code size() * STRIDE}
     */
    public double[] previous() {
        return previous;
    }

    /**
     * Poses at this tick, {@link #STRIDE} per row; world frame, metres, unit quaternions.
     *
     * @return an array of at least {@code size() * STRIDE}
     */
    public double[] current() {
        return current;
    }
}
