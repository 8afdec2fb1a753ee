package dev.cairn.samples.sandbox;

import dev.cairn.render.app.Scene;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Mouse;
import dev.cairn.samples.replay.Act.What;
import dev.cairn.samples.replay.Player;

import org.joml.Vector3d;

import java.util.List;

/** Throws balls from where the camera is, along a ray. Simulation thread. */
final class Thrower {
    private final Diary diary;
    private Ball ball = Ball.DEFAULT;
    private int thrown;

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
     * @param aspect width of the picture by its height
     */
    void throwBall(Scene scene, double aspect) {
        Camera camera = scene.camera();
        Mouse mouse = scene.bindings().mouse();
        Vector3d ahead = new Vector3d();
        camera.ray(2 * mouse.x() - 1, 1 - 2 * mouse.y(), aspect, ahead);
        Vector3d eye = camera.position(new Vector3d());
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
}
