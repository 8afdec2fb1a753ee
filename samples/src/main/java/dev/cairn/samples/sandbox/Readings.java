package dev.cairn.samples.sandbox;

import org.joml.Vector3d;

/**
 * The numbers and plots that run with the scene, as the panels show them: new ones ten times a
 * second, since nobody reads faster, and since panels that say the same as in the frame before are
 * not made anew. Where the scene stands, goes back or is another one, at once. Window thread.
 */
final class Readings {
    static final long PERIOD_NANOS = 100_000_000;

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
    private long readNanos;

    /**
     * Takes the numbers of now if it is time to.
     *
     * @param stands whether the scene is paused
     * @param nowNanos a clock's
     */
    void read(SandboxState state, double fps, boolean stands, long nowNanos) {
        boolean isOther = state.scene != scene || state.tick < tick || !state.held.equals(held);
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
