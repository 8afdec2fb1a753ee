package dev.cairn.samples.sandbox;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.query.Hit;
import dev.cairn.render.app.Scene;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Mouse;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.replay.Act.What;
import dev.cairn.samples.replay.Player;

import org.joml.Vector3d;

import java.util.List;

/**
 * Throws balls from where the camera is, along a ray, and blows things apart. Simulation thread.
 */
final class Thrower {
    private static final double FARTHEST = 1000;
    private static final double BLAST_METRES = 5;
    private static final double BLAST_SPEED = 12;

    private final Diary diary;
    private Ball ball = Ball.DEFAULT;
    private int thrown;

    /** Width of the picture by its height; the window's thread writes it. */
    private volatile double aspect = 1;

    /**
     * What is thrown.
     *
     * @param radius m
     * @param density kg/m³
     * @param speed m/s
     */
    record Ball(double radius, double density, double speed) {
        static final Ball DEFAULT = new Ball(0.25, 1000, 15);
    }

    Thrower(Diary diary) {
        this.diary = diary;
    }

    void aspect(double value) {
        aspect = value;
    }

    /** Another scene begins. */
    void begin() {
        thrown = 0;
    }

    Ball ball() {
        return ball;
    }

    void ball(Ball value) {
        ball = value;
    }

    /**
     * Throws one along the ray through the mouse.
     *
     * @param scene that is seen
     */
    void throwBall(Scene scene) {
        Camera camera = scene.camera();
        Vector3d ahead = new Vector3d();
        Vector3d eye = ray(scene, ahead);
        double start = ball.radius + camera.near() + 0.3;
        List<Double> thrownBall =
                List.of(
                        eye.x + start * ahead.x,
                        eye.y + start * ahead.y,
                        eye.z + start * ahead.z,
                        ball.speed * ahead.x,
                        ball.speed * ahead.y,
                        ball.speed * ahead.z,
                        ball.radius,
                        ball.density,
                        (double) ++thrown);
        Player.throwBall(scene.physics(), thrownBall);
        diary.add(What.THROW, thrownBall);
    }

    /** An explosion where the ray through the mouse meets a body; nothing where it meets none. */
    void explode(Scene scene) {
        Vector3d ahead = new Vector3d();
        Vector3d eye = ray(scene, ahead);
        Hit hit = new Hit();
        World ecs = scene.physics().ecs();
        WorldQueries queries = scene.physics().queries();
        // Through glass, as it is seen.
        queries.filter(body -> !isGlass(ecs, body.entity()));
        boolean met = queries.rayCast(eye, ahead, FARTHEST, hit) != null;
        queries.filter(null);
        if (met) {
            List<Double> blast =
                    List.of(hit.pointX(), hit.pointY(), hit.pointZ(), BLAST_METRES, BLAST_SPEED);
            Player.blast(scene.physics(), blast);
            diary.add(What.BLAST, blast);
        }
    }

    private static boolean isGlass(World ecs, long entity) {
        return ecs.has(entity, Visual.COMPONENT)
                && ecs.get(entity, Visual.COMPONENT).model() instanceof Model model
                && model.texture().opacity() < 1;
    }

    /** Where the ray through the mouse begins, and its direction. */
    private Vector3d ray(Scene scene, Vector3d ahead) {
        Camera camera = scene.camera();
        Mouse mouse = scene.bindings().mouse();
        camera.ray(2 * mouse.x() - 1, 1 - 2 * mouse.y(), aspect, ahead);
        return camera.position(new Vector3d());
    }
}
