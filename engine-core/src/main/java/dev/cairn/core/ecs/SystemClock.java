package dev.cairn.core.ecs;

import dev.cairn.core.profile.SystemProfile;

import java.util.Arrays;

/**
 * The clock behind {@link SystemProfile}: each worker adds what its blocks took in a row of its
 * own.
 */
final class SystemClock implements SystemProfile {
    private final String[] names;

    /** Work of this tick, by worker and system. */
    private final long[][] nanos;

    private final long[] lastNanos;
    private final long[] totalNanos;
    private boolean enabled;
    private long ticks;

    /** Whether this tick is timed; the same for all its blocks. */
    private boolean timing;

    SystemClock(String[] names, int workers) {
        this.names = names;
        this.nanos = new long[workers][names.length];
        this.lastNanos = new long[names.length];
        this.totalNanos = new long[names.length];
    }

    @Override
    public void enable() {
        enabled = true;
    }

    @Override
    public void disable() {
        enabled = false;
    }

    @Override
    public void reset() {
        Arrays.fill(lastNanos, 0);
        Arrays.fill(totalNanos, 0);
        ticks = 0;
    }

    @Override
    public long ticks() {
        return ticks;
    }

    @Override
    public int count() {
        return names.length;
    }

    @Override
    public String name(int system) {
        return names[system];
    }

    @Override
    public long lastNanos(int system) {
        return lastNanos[system];
    }

    @Override
    public double meanSeconds(int system) {
        return ticks == 0 ? 0 : totalNanos[system] * 1e-9 / ticks;
    }

    void begin() {
        timing = enabled;
        if (timing) {
            for (long[] row : nanos) {
                Arrays.fill(row, 0);
            }
        }
    }

    /** The time before a block; 0 where nobody asks. Any worker. */
    long now() {
        return timing ? System.nanoTime() : 0;
    }

    /** A block has ended. Any worker. */
    void add(int system, int worker, long start) {
        if (timing) {
            nanos[worker][system] += System.nanoTime() - start;
        }
    }

    /** The tick is complete. */
    void end() {
        if (!timing) {
            return;
        }
        ticks++;
        for (int system = 0; system < names.length; system++) {
            long sum = 0;
            for (long[] row : nanos) {
                sum += row[system];
            }
            lastNanos[system] = sum;
            totalNanos[system] += sum;
        }
    }
}
