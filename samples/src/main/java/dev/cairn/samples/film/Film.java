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

    private final SceneBuilder scene;
    private final Camera camera;
    private final SnapshotExchange exchange = new SnapshotExchange();
    private final Offscreen screen = Offscreen.open(WIDTH, HEIGHT);
    private final AnimatedPng animation;

    /**
     * Opens the camera.
     *
     * @param built a scene at tick 0
     */
    public Film(SceneBuilder built) {
        scene = built;
        camera = built.view().place(new Camera());
        CameraMount.attach(built.world().ecs(), camera);
        animation =
                new AnimatedPng(WIDTH, HEIGHT, (int) Math.rint(1000 * TICKS * built.stepSeconds()));
    }

    /**
     * Takes a picture if it is time.
     *
     * @param world of the scene
     * @param tick that was done last
     */
    public void shoot(PhysicsWorld world, int tick) {
        if (tick % TICKS == 1) {
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
