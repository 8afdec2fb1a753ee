package dev.cairn.samples.film;

import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.samples.SceneBuilder;

import java.nio.file.Path;

/** Shoots an animation of a run. The thread of the run; one at a time, since GL is. */
public final class Film implements AutoCloseable {
    private static final int WIDTH = 480;
    private static final int HEIGHT = 270;
    private static final int TICKS = 3;

    private final int ticksPerFrame;

    private final SceneBuilder scene;
    private final Camera camera;
    private final SnapshotExchange exchange = new SnapshotExchange();
    private final Offscreen screen;
    private final AnimatedPng animation;

    /**
     * Opens the camera.
     *
     * @param built a scene at tick 0
     */
    public Film(SceneBuilder built) {
        this(built, WIDTH, HEIGHT, TICKS);
    }

    /**
     * Opens the camera.
     *
     * @param built a scene at tick 0
     * @param width pixels
     * @param height pixels
     * @param ticksPerFrame how many ticks a frame is shown
     */
    public Film(SceneBuilder built, int width, int height, int ticksPerFrame) {
        this.ticksPerFrame = ticksPerFrame;
        screen = Offscreen.open(width, height);
        scene = built;
        camera = built.view().place(new Camera());
        CameraMount.attach(built.world().ecs(), camera);
        animation =
                new AnimatedPng(
                        width, height, (int) Math.rint(1000 * ticksPerFrame * built.stepSeconds()));
    }

    /**
     * Takes a picture if it is time.
     *
     * @param world of the scene
     * @param tick that was done last
     */
    public void shoot(PhysicsWorld world, int tick) {
        if (tick % ticksPerFrame == 1) {
            exchange.publish(world.ecs());
            screen.draw(exchange.latest(), 1, camera, scene.light());
            animation.add(screen.picture().argb());
        }
    }

    /**
     * Writes what was shot.
     *
     * @param file where the .png goes
     */
    public void save(Path file) {
        animation.write(file);
    }

    @Override
    public void close() {
        screen.close();
    }
}
