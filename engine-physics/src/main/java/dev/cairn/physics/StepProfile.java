package dev.cairn.physics;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * How long each stage of the physics step took. Off until {@link #enable} is called; then a step
 * reads the clock once per stage, some 20 ns each. While a recording of the JDK Flight Recorder has
 * the event {@code dev.cairn.PhysicsStep} switched on, each step writes one, whether enabled here
 * or not.
 *
 * <p>Times are wall time of the simulation thread, so they include waiting for the other workers.
 * Simulation thread only; allocates nothing.
 */
public final class StepProfile {
    private static final StepStage[] STAGES = StepStage.values();

    private final long[] lastNanos = new long[STAGES.length];
    private final long[] totalNanos = new long[STAGES.length];
    private final @Nullable StepEvent event = StepEvent.create();
    private boolean enabled;
    private boolean timing;
    private long steps;
    private long mark;

    StepProfile() {}

    /** Times the steps that follow. */
    public void enable() {
        enabled = true;
    }

    /** Stops; what was measured stays readable. */
    public void disable() {
        enabled = false;
    }

    /** Forgets what was measured. */
    public void reset() {
        Arrays.fill(lastNanos, 0);
        Arrays.fill(totalNanos, 0);
        steps = 0;
    }

    /**
     * The steps that were timed.
     *
     * @return count since the last reset
     */
    public long steps() {
        return steps;
    }

    /**
     * Duration of a stage in the last timed step.
     *
     * @param stage which
     * @return ns; 0 if no step was timed
     */
    public long lastNanos(StepStage stage) {
        return lastNanos[index(stage)];
    }

    /**
     * Mean duration of a stage.
     *
     * @param stage which
     * @return s per timed step; 0 if no step was timed
     */
    public double meanSeconds(StepStage stage) {
        return steps == 0 ? 0 : totalNanos[index(stage)] * 1e-9 / steps;
    }

    @SuppressWarnings("EnumOrdinal") // an EnumMap would box the times
    private static int index(StepStage stage) {
        return stage.ordinal();
    }

    /** A step starts. */
    void begin() {
        timing = enabled || (event != null && event.isEnabled());
        if (timing) {
            if (event != null) {
                event.begin();
            }
            mark = System.nanoTime();
        }
    }

    /** A stage has ended; the next one starts now. */
    void end(StepStage stage) {
        if (timing) {
            long now = System.nanoTime();
            lastNanos[index(stage)] = now - mark;
            mark = now;
        }
    }

    /** The step has ended. */
    void end(int bodies, int contacts) {
        if (!timing) {
            return;
        }
        steps++;
        for (int i = 0; i < STAGES.length; i++) {
            totalNanos[i] += lastNanos[i];
        }
        if (event != null) {
            event.write(this, bodies, contacts);
        }
    }
}
