package dev.cairn.render.app;

import dev.cairn.physics.PhysicsWorld;
import java.nio.file.Path;

/** A program with a window. First form. */
public abstract class Application {
    /** An application with the defaults. */
    protected Application() {}

    /**
     * Makes the world that the scene is filled into; called once, on the simulation thread, before {@link #initScene}. Override to
     * choose gravity, workers, settings or systems.
     *
     * @return a new world; the application closes it
     */
    protected PhysicsWorld createPhysics() {
        return PhysicsWorld.builder().build();
    }

    /**
     * Fills the scene; called once, on the simulation thread.
     *
     * @param scene an empty scene with the default bindings
     */
    protected abstract void initScene(Scene scene);

    /**
     * Called before each tick of the physics, on the simulation thread; not while it is paused.
     *
     * @param seconds the step, s
     */
    protected void update(double seconds) {}

    /**
     * The scene.
     *
     * @return the scene; simulation thread
     */
    protected final Scene scene() {
        throw new UnsupportedOperationException();
    }

    /**
     * Size of the window or of the picture; before {@link #start}.
     *
     * @param width pixels, 16..16384
     * @param height pixels, 16..16384
     * @return this
     */
    public Application size(int width, int height) {
        return this;
    }

    /**
     * Length of a tick; before {@link #start}.
     *
     * @param seconds &gt; 0; 1/60 by default
     * @return this
     */
    public Application step(double seconds) {
        return this;
    }

    /**
     * Draws a picture instead of opening a window; before {@link #start}.
     *
     * @param picture where the .png goes
     * @param atTick after how many ticks
     * @return this
     */
    public Application headless(Path picture, long atTick) {
        return this;
    }

    /** Runs until the window is closed or the picture is drawn. Main thread. */
    public final void start() {
        throw new UnsupportedOperationException();
    }

    /** Ends the application after this frame; any thread. */
    public final void quit() {
        throw new UnsupportedOperationException();
    }

    /** Pauses the physics, or resumes it; drawing and bindings go on. */
    public final void togglePause() {
        throw new UnsupportedOperationException();
    }
}
