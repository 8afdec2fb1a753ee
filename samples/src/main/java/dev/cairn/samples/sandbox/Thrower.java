package dev.cairn.samples.sandbox;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.camera.Camera;
import dev.cairn.samples.replay.Act.What;
import dev.cairn.samples.replay.Player;

import org.joml.Vector3d;

import java.util.List;

/** Throws balls from where the camera is. Simulation thread. */
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

    void throwBall(PhysicsWorld world, Camera camera) {
        Vector3d eye = camera.position(new Vector3d());
        Vector3d ahead = camera.forward(new Vector3d());
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
        Player.throwBall(world, thrownBall);
        diary.add(What.THROW, thrownBall);
    }
}
