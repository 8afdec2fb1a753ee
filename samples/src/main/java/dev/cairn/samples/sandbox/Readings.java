package dev.cairn.samples.sandbox;

import org.joml.Vector3d;

/**
 * The numbers and plots that run with the scene, as the panels show them: new ones ten times a
 * second, since nobody reads faster, and since panels that say the same as in the frame before are
 * not made anew. Where the scene stands, goes back or is another one, at once. Window thread.
 */
final class Readings {
    /** A little less than panels stay by {@code Ui.keep}, so that each making has new ones. */
    static final long PERIOD_NANOS = 90_000_000;

    long tick;
    long oldestTick;
    long newestTick;
    double seconds;
    double framesPerSecond;
    int bodies;
    double heldSpeed;
    final Vector3d heldAt = new Vector3d();
    final PlotHistory history = new PlotHistory();

    private int scene = -1;
    private String held = "";
    private boolean stood;
    private long readNanos;

    /** Whether panels must be made anew in this frame, whenever they were made last. */
    boolean mustShow(SandboxState state, boolean stands) {
        return isOther(state) || stands != stood || (stands && state.tick != tick);
    }

    private boolean isOther(SandboxState state) {
        return state.scene != scene || state.tick < tick || !state.held.equals(held);
    }

    /**
     * Takes the numbers of now if it is time to.
     *
     * @param stands whether the scene is paused
     * @param nowNanos a clock's
     */
    void read(SandboxState state, double fps, boolean stands, long nowNanos) {
        boolean isOther = isOther(state);
        stood = stands;
        if (!stands && !isOther && nowNanos - readNanos < PERIOD_NANOS) {
            return;
        }
        readNanos = nowNanos;
        scene = state.scene;
        held = state.held;
        tick = state.tick;
        oldestTick = state.oldestTick;
        newestTick = state.newestTick;
        seconds = state.seconds;
        framesPerSecond = fps;
        bodies = state.bodies;
        heldSpeed = state.heldSpeed;
        heldAt.set(state.heldAt);
        history.copy(state.history);
    }
}
