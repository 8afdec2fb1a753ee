package dev.cairn.physics.state;

import dev.cairn.core.profile.SystemProfile;
import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.profile.StepStage;

import jdk.jfr.FlightRecorder;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.Objects;

/** The clock behind {@link StepProfile}: the step tells it when each stage has ended. */
public final class StepClock implements StepProfile {
    private static final StepStage[] STAGES = StepStage.values();

    private final long[] lastNanos = new long[STAGES.length];
    private final long[] totalNanos = new long[STAGES.length];

    /** Made once somebody records: its class starts the flight recorder, which takes long. */
    private @Nullable StepEvent event;

    /** Until it is known that the run-time image is without it. */
    private boolean hasRecorder = true;

    private boolean enabled;
    private boolean timing;
    private long steps;
    private long mark;

    /** Set once, before the first step. */
    private @Nullable SystemProfile systems;

    /** A clock that is off. */
    public StepClock() {}

    @Override
    public void enable() {
        enabled = true;
        systems().enable();
    }

    @Override
    public void disable() {
        enabled = false;
        systems().disable();
    }

    @Override
    public void reset() {
        Arrays.fill(lastNanos, 0);
        Arrays.fill(totalNanos, 0);
        steps = 0;
        systems().reset();
    }

    @Override
    public SystemProfile systems() {
        return Objects.requireNonNull(systems, "the clock of a world knows its systems");
    }

    /** The world of the step has these systems. */
    public void watch(SystemProfile all) {
        systems = all;
    }

    @Override
    public long steps() {
        return steps;
    }

    @Override
    public long lastNanos(StepStage stage) {
        return lastNanos[index(stage)];
    }

    @Override
    public double meanSeconds(StepStage stage) {
        return steps == 0 ? 0 : totalNanos[index(stage)] * 1e-9 / steps;
    }

    @SuppressWarnings("EnumOrdinal") // an EnumMap would box the times
    private static int index(StepStage stage) {
        return stage.ordinal();
    }

    private boolean isRecorded() {
        if (event == null && hasRecorder) {
            try {
                event = FlightRecorder.isInitialized() ? StepEvent.create() : null;
            } catch (NoClassDefFoundError absent) {
                hasRecorder = false;
            }
        }
        return event != null && event.isEnabled();
    }

    /** A step starts. */
    public void begin() {
        timing = isRecorded() || enabled;
        if (timing) {
            if (event != null) {
                event.begin();
            }
            mark = System.nanoTime();
        }
    }

    /** A stage has ended; the next one starts now. */
    public void end(StepStage stage) {
        if (timing) {
            long now = System.nanoTime();
            lastNanos[index(stage)] = now - mark;
            mark = now;
        }
    }

    /** The step has ended. */
    public void end(int bodies, int contacts) {
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
