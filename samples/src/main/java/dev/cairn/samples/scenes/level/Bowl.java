package dev.cairn.samples.scenes.level;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * Balls that slide to and fro in a bowl of triangles, without friction.
 *
 * <p>Truth: the centre of a ball of radius r in a bowl of radius R is a pendulum of length R - r,
 * whose period for the amplitude a is 2 pi sqrt(L/g) / agm(1, cos(a/2)) (C. F. Gauss).
 */
public final class Bowl {
    private static final double RADIUS = 2;
    private static final double BALL = 0.2;

    /** How far up the bowl goes, from the lowest point, radians. */
    private static final double EDGE = 1.3;

    private static final double GRAVITY = 9.81;

    private Bowl() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "bowl",
                "Bowl of triangles",
                "A ball slides in a bowl of triangles with the period of a pendulum.",
                "levels",
                List.of(
                        Parameter.count("facets", 200, 24, 400, "triangles around"),
                        Parameter.real("angle", 0.4, 0.05, 1, "where it starts, radians")),
                300,
                60,
                Bowl::build);
    }

    /** Corners on the sphere, in rings about the y axis; bodies are inside. */
    static TriangleMesh mesh(int facets) {
        Surfaces s = new Surfaces();
        int rings = (int) Math.ceil(EDGE * facets / (2 * Math.PI));
        int bottom = s.vertex(0, -RADIUS, 0);
        for (int ring = 1; ring <= rings; ring++) {
            double polar = EDGE * ring / rings;
            for (int i = 0; i < facets; i++) {
                double around = 2 * Math.PI * i / facets;
                double out = RADIUS * StrictMath.sin(polar);
                s.vertex(
                        out * StrictMath.cos(around),
                        -RADIUS * StrictMath.cos(polar),
                        out * StrictMath.sin(around));
            }
        }
        for (int ring = 0; ring < rings; ring++) {
            for (int i = 0; i < facets; i++) {
                int j = (i + 1) % facets;
                int a = ring == 0 ? bottom : 1 + (ring - 1) * facets + i;
                int b = ring == 0 ? bottom : 1 + (ring - 1) * facets + j;
                int c = 1 + ring * facets + i;
                int d = 1 + ring * facets + j;
                if (ring > 0) {
                    s.triangle(a, b, d);
                }
                s.triangle(a, d, c);
            }
        }
        return s.mesh();
    }

    /** The period of a pendulum of a length and an amplitude, s. */
    static double period(double length, double amplitude) {
        double a = 1;
        double b = StrictMath.cos(amplitude / 2);
        for (int i = 0; i < 8; i++) {
            double mean = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = mean;
        }
        return 2 * Math.PI * Math.sqrt(length / GRAVITY) / a;
    }

    private static void build(SceneBuilder scene) {
        double angle = scene.get("angle");
        scene.add(
                mesh(scene.count("facets")),
                Palette.STONE,
                Body.fixed().at(0, RADIUS, 0).material(Palette.material(0, 0)).name("bowl"));
        // between two corners of a ring, and turned against the rings
        double turn = 0.01;
        double length = RADIUS - BALL;
        double out = length * StrictMath.sin(angle);
        BodyRef ball =
                scene.add(
                        Sphere.of(BALL),
                        Palette.body(0),
                        Body.dynamic()
                                .at(
                                        out * StrictMath.cos(turn),
                                        RADIUS - length * StrictMath.cos(angle),
                                        out * StrictMath.sin(turn))
                                .material(Palette.material(0, 0)));
        double[] passed = {0, out, 0};
        scene.afterTick((tick, seconds) -> {
            double x = ball.position().x;
            // the first and the third passage through the middle are one period apart
            if ((x < 0) != (passed[1] < 0)) {
                double when = tick - x / (x - passed[1]);
                passed[0]++;
                if (passed[0] == 1) {
                    passed[2] = when;
                } else if (passed[0] == 3) {
                    passed[2] = (when - passed[2]) * SampleScene.STEP_SECONDS;
                }
            }
            passed[1] = x;
        });
        scene.view(new SceneView(2.5, 3.2, 3.5, 0, 0.6, 0));
        scene.error(
                "periodRelative",
                () -> passed[0] < 3 ? Double.NaN : Math.abs(passed[2] / period(length, angle) - 1));
    }
}
