package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;

/**
 * SimBenchmark's {@code rolling} (Leggedrobotics 2018): a plate of 10 kg is pulled over the ground,
 * 5 x 5 balls of 1 kg roll on it.
 *
 * <p>Truth, with mu between plate and ground, balls of number n, mass m: each ball pushes the plate
 * back with {@code f = (F - mu g (M + n m)) / M / (3.5 / m + n / M)}; the balls accelerate with
 * {@code f / m}, the plate with 3.5 times that. The error is the time mean of the squared velocity
 * errors of the plate and of the middle ball, m²/s². A plate that does not move has 3.15.
 */
public final class RollingLoad {
    private static final double PLATE_MASS = 10;
    private static final double BALL_MASS = 1;
    private static final int SIDE = 5;
    private static final double PITCH = 2;
    private static final double HALF = 0.5;
    private static final double GROUND_FRICTION = 0.4;
    private static final double BALL_FRICTION = 0.8;
    private static final double OVERLAP = 2e-5;

    private RollingLoad() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "rolling",
                "Balls on a plate",
                "A plate is pulled sideways; 25 balls roll on it. A scene of SimBenchmark.",
                "motion",
                List.of(
                        Parameter.real("force", 150, 0, 1e4, "pull on the plate, N"),
                        Parameter.real("heading", 60, -180, 180, "its direction, degrees from x")),
                240,
                120,
                RollingLoad::build);
    }

    private static void build(SceneBuilder scene) {
        double force = scene.get("force");
        double heading = Math.toRadians(scene.get("heading"));
        double dx = StrictMath.cos(heading);
        double dz = StrictMath.sin(heading);
        // The friction of a pair is the square root of the product.
        scene.floor(60, 60, GROUND_FRICTION, 0);
        Box slab = Box.ofHalfExtents(10, HALF, 10);
        BodyRef plate =
                scene.add(
                        slab,
                        Model.ground(slab).color(Palette.STONE),
                        Body.dynamic()
                                .at(0, HALF - OVERLAP, 0)
                                .mass(PLATE_MASS)
                                .material(Palette.material(GROUND_FRICTION, 0))
                                .name("plate"));
        double ballFriction = BALL_FRICTION * BALL_FRICTION / GROUND_FRICTION;
        Sphere sphere = Sphere.of(HALF);
        BodyRef middle = plate;
        for (int i = 0; i < SIDE * SIDE; i++) {
            int line = i / SIDE;
            BodyRef ball =
                    scene.add(
                            sphere,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(
                                            PITCH * (i % SIDE - (SIDE - 1) / 2.0),
                                            3 * HALF - 2 * OVERLAP,
                                            PITCH * (line - (SIDE - 1) / 2.0))
                                    .mass(BALL_MASS)
                                    .material(Palette.material(ballFriction, 0)));
            if (i == SIDE * SIDE / 2) {
                middle = ball;
            }
        }
        scene.constantForce(plate, force * dx, 0, force * dz);
        scene.view(new SceneView(8, 12, 22, 0, 0, 0));

        int n = SIDE * SIDE;
        double pull = force - GROUND_FRICTION * SampleScene.GRAVITY * (PLATE_MASS + n * BALL_MASS);
        double ballAcceleration =
                pull / PLATE_MASS / (3.5 / BALL_MASS + n / PLATE_MASS) / BALL_MASS;
        double[] sums = new double[2];
        BodyRef ball = middle;
        Vector3d v = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            double truth = ballAcceleration * seconds;
            double off = ball.velocity(v).sub(truth * dx, 0, truth * dz).lengthSquared();
            truth *= 3.5;
            off += plate.velocity(v).sub(truth * dx, 0, truth * dz).lengthSquared();
            sums[0] += off;
            sums[1]++;
        });
        scene.error(
                "velocitySquared",
                () -> sums[1] == 0 || pull <= 0 ? Double.NaN : sums[0] / sums[1]);
    }
}
