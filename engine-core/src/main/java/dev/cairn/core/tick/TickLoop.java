package dev.cairn.core.tick;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Objects;
import java.util.function.DoubleConsumer;

/**
 * Turns real time, as it elapses, into simulation steps of one fixed size.
 *
 * <p>{@link #advance} adds the elapsed time to an accumulator and runs as many steps as fit; {@link
 * #alpha} is the rest, as a fraction of a step, for drawing between the last two steps. The loop
 * has no clock: who calls it measures time, so a test or a recording can feed any.
 *
 * <p><b>Threads.</b> {@link #advance} and {@link #alpha} belong to the simulation thread. {@link
 * #pause}, {@link #resume}, {@link #singleStep}, {@link #setTimeScale}, {@link #post} and the
 * getters may be called by any thread, also by a step; they act on the next step that begins.
 * <b>Memory.</b> {@code advance} does not allocate.
 *
 * <p>The accumulator is the one of Fiedler, "Fix your timestep!" (2004).
 */
public final class TickLoop {

    /** Default of the largest real time that one {@link #advance} takes in, seconds. */
    public static final double DEFAULT_MAX_ELAPSED_SECONDS = 0.25;

    /** Largest time scale: an {@link #advance} must end. */
    public static final double MAX_TIME_SCALE = 64.0;

    private static final VarHandle SINGLE_STEPS;

    static {
        try {
            SINGLE_STEPS =
                    MethodHandles.lookup().findVarHandle(TickLoop.class, "singleSteps", int.class);
        } catch (ReflectiveOperationException missing) {
            throw new ExceptionInInitializerError(missing);
        }
    }

    private final double stepSeconds;
    private final double maxElapsedSeconds;
    private final DoubleConsumer stepAction;
    private final Inbox inbox = new Inbox();

    private volatile boolean paused;
    private volatile double timeScale = 1.0;

    @SuppressWarnings("unused") // through SINGLE_STEPS
    private volatile int singleSteps;

    // The simulation thread's own.
    private double accumulatedSeconds;
    private double droppedSeconds;
    private long stepCount;

    /**
     * Creates a loop with the default bound on elapsed time.
     *
     * @param stepSeconds size of a step, simulated seconds, finite and above 0
     * @param stepAction what a step does
     * @throws IllegalArgumentException if {@code stepSeconds} is out of its range
     */
    public TickLoop(double stepSeconds, Runnable stepAction) {
        this(stepSeconds, ignoringSize(Objects.requireNonNull(stepAction, "stepAction")));
    }

    /**
     * Creates a loop with the default bound on elapsed time.
     *
     * @param stepSeconds size of a step, simulated seconds, finite and above 0
     * @param stepAction what a step does; gets {@code stepSeconds}
     * @throws IllegalArgumentException if {@code stepSeconds} is out of its range
     */
    public TickLoop(double stepSeconds, DoubleConsumer stepAction) {
        this(stepSeconds, stepAction, DEFAULT_MAX_ELAPSED_SECONDS);
    }

    /**
     * Creates a loop.
     *
     * @param stepSeconds size of a step, simulated seconds, finite and above 0
     * @param stepAction what a step does; gets {@code stepSeconds}
     * @param maxElapsedSeconds the largest real time that one {@link #advance} takes in, seconds,
     *     finite and above 0; what is beyond is dropped, so that a stall (a debugger, a suspended
     *     machine) is followed by slow motion instead of a burst that never ends
     * @throws IllegalArgumentException if a time is out of its range
     */
    public TickLoop(double stepSeconds, DoubleConsumer stepAction, double maxElapsedSeconds) {
        this.stepSeconds = checkPositive("stepSeconds", stepSeconds);
        this.stepAction = Objects.requireNonNull(stepAction, "stepAction");
        this.maxElapsedSeconds = checkPositive("maxElapsedSeconds", maxElapsedSeconds);
    }

    private static DoubleConsumer ignoringSize(Runnable action) {
        return seconds -> action.run();
    }

    private static double checkPositive(String name, double seconds) {
        if (!(seconds > 0.0) || seconds == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name + " is " + seconds + ", but must be finite and above 0");
        }
        return seconds;
    }

    /**
     * Takes in elapsed real time and runs the steps that are due. First runs what was {@linkplain
     * #post posted}, then again before each further step. While paused, time is not taken in and
     * only asked-for {@linkplain #singleStep single steps} run. Simulation thread.
     *
     * <p>If the step or a posted action throws, its exception leaves this method; the step counts
     * as run, the steps still due stay due.
     *
     * @param elapsedRealSeconds real time since the last call, seconds, finite and at least 0
     * @return number of steps run
     * @throws IllegalArgumentException if {@code elapsedRealSeconds} is out of its range
     */
    public int advance(double elapsedRealSeconds) {
        if (!(elapsedRealSeconds >= 0.0) || elapsedRealSeconds == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "elapsedRealSeconds is "
                            + elapsedRealSeconds
                            + ", but must be finite and at least 0");
        }
        inbox.drain();
        if (!paused) {
            double taken = Math.min(elapsedRealSeconds, maxElapsedSeconds);
            droppedSeconds += elapsedRealSeconds - taken;
            accumulatedSeconds += taken * timeScale;
        }
        int steps = 0;
        while (takeStep()) {
            steps++;
            stepCount++;
            stepAction.accept(stepSeconds);
            inbox.drain();
        }
        return steps;
    }

    /** Whether a step is due; takes it from the accumulator or from the single steps. */
    private boolean takeStep() {
        if (paused) {
            int asked = singleSteps;
            while (asked > 0 && !SINGLE_STEPS.compareAndSet(this, asked, asked - 1)) {
                asked = singleSteps; // another thread asked, or resumed, just now
            }
            return asked > 0;
        }
        if (accumulatedSeconds >= stepSeconds) {
            accumulatedSeconds -= stepSeconds;
            return true;
        }
        return false;
    }

    /**
     * Hands an action to the simulation thread, which runs it before the next step, also while
     * paused. Any thread; see {@link Inbox#post} for order and failure.
     *
     * @param action what to do
     * @throws IllegalStateException if {@link Inbox#DEFAULT_CAPACITY} actions wait already
     */
    public void post(Runnable action) {
        inbox.post(action);
    }

    /** Stops stepping after the current step. Time that elapses while paused is not made up. */
    public void pause() {
        paused = true;
    }

    /** Steps with elapsed time again. Single steps that were asked for and did not run are void. */
    public void resume() {
        singleSteps = 0;
        paused = false;
    }

    /**
     * Whether the loop is paused.
     *
     * @return whether the loop is paused
     */
    public boolean isPaused() {
        return paused;
    }

    /**
     * Asks for one step at the next {@link #advance}; each call is one step. Pauses the loop if it
     * is not paused.
     */
    public void singleStep() {
        if (!paused) {
            paused = true;
        }
        SINGLE_STEPS.getAndAdd(this, 1);
    }

    /**
     * Sets slow or fast motion: simulated seconds per real second. The step stays as it is, so the
     * simulation goes through the same states; only their number per real second changes.
     *
     * @param timeScale the scale, in {@code [0, MAX_TIME_SCALE]}; 1 is real time, 0.25 slow motion
     * @throws IllegalArgumentException if {@code timeScale} is out of its range
     */
    public void setTimeScale(double timeScale) {
        if (!(timeScale >= 0.0 && timeScale <= MAX_TIME_SCALE)) {
            throw new IllegalArgumentException(
                    "timeScale is " + timeScale + ", but must be in [0, " + MAX_TIME_SCALE + "]");
        }
        this.timeScale = timeScale;
    }

    /**
     * The time scale.
     *
     * @return simulated seconds per real second
     */
    public double timeScale() {
        return timeScale;
    }

    /**
     * The size of a step.
     *
     * @return simulated seconds per step
     */
    public double stepSeconds() {
        return stepSeconds;
    }

    /**
     * How far real time is past the last step: 0 at the last step, towards 1 at the next. Draw at
     * {@code previous + alpha * (current - previous)}. Stays as it is while paused. Simulation
     * thread.
     *
     * @return the fraction of a step, in {@code [0, 1)} after a whole {@link #advance}
     */
    public double alpha() {
        return Math.min(accumulatedSeconds / stepSeconds, Math.nextDown(1.0));
    }

    /**
     * Number of steps since the loop was made. Simulation thread.
     *
     * @return the number of steps
     */
    public long stepCount() {
        return stepCount;
    }

    /**
     * Real time that {@link #advance} dropped because it was above the bound. Simulation thread.
     *
     * @return dropped real time since the loop was made, seconds
     */
    public double droppedSeconds() {
        return droppedSeconds;
    }
}
