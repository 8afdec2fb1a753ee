package dev.cairn.core.tick;

import java.util.Objects;
import java.util.function.DoubleConsumer;

/** Fixed-step loop. First form. */
public final class TickLoop {

    /** Default of the largest real time that one {@link #advance} takes into account, seconds. */
    public static final double DEFAULT_MAX_ELAPSED_SECONDS = 0.25;

    private final double stepSeconds;
    private final DoubleConsumer stepAction;
    private double accumulator;
    private volatile boolean paused;
    private volatile boolean single;
    private volatile double timeScale = 1.0;

    /**
     * Creates a loop.
     *
     * @param stepSeconds step, seconds, finite and above 0
     * @param stepAction what a step does
     */
    public TickLoop(double stepSeconds, Runnable stepAction) {
        this(stepSeconds, seconds -> stepAction.run());
    }

    /**
     * Creates a loop.
     *
     * @param stepSeconds step, seconds, finite and above 0
     * @param stepAction what a step does; gets the step in seconds
     */
    public TickLoop(double stepSeconds, DoubleConsumer stepAction) {
        if (!(stepSeconds > 0.0) || Double.isInfinite(stepSeconds)) {
            throw new IllegalArgumentException(
                    "stepSeconds is " + stepSeconds + ", but must be finite and above 0");
        }
        this.stepSeconds = stepSeconds;
        this.stepAction = Objects.requireNonNull(stepAction, "stepAction");
    }

    /**
     * Runs the steps that are due.
     *
     * @param elapsedRealSeconds real time since the last call, seconds
     * @return number of steps run
     */
    public int advance(double elapsedRealSeconds) {
        int steps = 0;
        if (paused) {
            if (single) {
                single = false;
                stepAction.accept(stepSeconds);
                steps++;
            }
            return steps;
        }
        accumulator += Math.min(elapsedRealSeconds, DEFAULT_MAX_ELAPSED_SECONDS) * timeScale;
        while (accumulator >= stepSeconds) {
            accumulator -= stepSeconds;
            stepAction.accept(stepSeconds);
            steps++;
        }
        return steps;
    }

    /** Stops stepping. Any thread. */
    public void pause() {
        paused = true;
    }

    /** Steps again. Any thread. */
    public void resume() {
        paused = false;
    }

    /**
     * Whether the loop is paused. Any thread.
     *
     * @return whether the loop is paused
     */
    public boolean isPaused() {
        return paused;
    }

    /** Asks for one step while paused. Any thread. */
    public void singleStep() {
        single = true;
    }

    /**
     * Sets slow or fast motion. Any thread.
     *
     * @param timeScale simulated seconds per real second
     */
    public void setTimeScale(double timeScale) {
        this.timeScale = timeScale;
    }

    /**
     * Where between the last two steps real time is.
     *
     * @return accumulated time over step, in [0, 1)
     */
    public double alpha() {
        return accumulator / stepSeconds;
    }
}
