package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * The three scenes of SimBenchmark (Leggedrobotics 2018) that are made of frictionless spheres of
 * 0.1 m and 10 kg: {@code bouncing} (7 x 7 balls far apart), {@code 666} (6 x 6 x 6, inelastic) and
 * {@code elastic 666}.
 *
 * <p>Truths. Nothing overlaps: the error of 666 is the time mean of the sum of squared overlaps,
 * m². Elastic impacts without friction keep the energy: the error of the other two is the time mean
 * of the squared energy error, J². Random offsets of the start are uniform in 0.1 mm; they are not
 * SimBenchmark's. Its ground has no end: the floor here is wide enough that no ball leaves it
 * (Cairn's fastest gets 67 m far), and what a ball beyond its edge sinks below it is no overlap.
 */
public final class SphereGrid {
    private static final double RADIUS = 0.1;
    private static final double MASS = 10;
    private static final double SHAKE = 1e-4;
    private static final double NARROW = 20;
    private static final double WIDE = 100;

    private SphereGrid() {}

    /**
     * SimBenchmark's bouncing balls, 20 s.
     *
     * @return its entry for the registry
     */
    public static SampleScene bouncing() {
        return scene("bouncing", "Bouncing balls", 7, 1, 2, 5, 1, 0, 1200);
    }

    /**
     * SimBenchmark's 666, 10 s.
     *
     * @return its entry for the registry
     */
    public static SampleScene inelastic() {
        return scene("spheres-666", "666 spheres", 6, 6, 0.21, 0.101, 0, SHAKE, 600);
    }

    /**
     * SimBenchmark's elastic 666, 10 s.
     *
     * @return its entry for the registry
     */
    public static SampleScene elastic() {
        return scene("elastic-666", "666 elastic spheres", 6, 6, 0.21, 1.101, 1, SHAKE, 600);
    }

    private static SampleScene scene(
            String id,
            String title,
            int side,
            int layers,
            double pitch,
            double height,
            double restitution,
            double shake,
            int ticks) {
        return new SampleScene(
                id,
                title,
                "Frictionless spheres fall; a scene of SimBenchmark.",
                "motion",
                List.of(
                        Parameter.count("side", side, 1, 100, "spheres along x and along z"),
                        Parameter.count("layers", layers, 1, 100, "layers"),
                        Parameter.real("pitch", pitch, 0.2, 10, "distance of centres, m"),
                        Parameter.real("height", height, 0.1, 100, "height of the lowest, m"),
                        Parameter.real("restitution", restitution, 0, 1, "of the impacts")),
                ticks,
                60,
                builder -> build(builder, shake));
    }

    private static void build(SceneBuilder scene, double shake) {
        int side = scene.count("side");
        double pitch = scene.get("pitch");
        double e = scene.get("restitution");
        double floor = shake > 0 ? WIDE : NARROW;
        scene.floor(floor, floor, 0, e);
        Sphere ball = Sphere.of(RADIUS);
        List<BodyRef> balls = new ArrayList<>();
        for (int i = 0; i < side * side * scene.count("layers"); i++) {
            double x = pitch * (i % side - (side - 1) / 2.0);
            double z = pitch * (i / side % side - (side - 1) / 2.0);
            int layer = i / (side * side);
            double y = scene.get("height") + pitch * layer;
            if (shake > 0) {
                x += scene.random(0, shake);
                y += scene.random(0, shake);
                z += scene.random(0, shake);
            }
            balls.add(
                    scene.add(
                            ball,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(x, y, z)
                                    .mass(MASS)
                                    .material(Palette.material(0, e))));
        }
        double reach = side * pitch;
        scene.view(new SceneView(0.6 * reach, 2 + 0.4 * reach, 1.2 * reach + 4, 0, 0.5, 0));
        if (e == 1) {
            Energy energy = new Energy(balls);
            scene.afterTick(energy::note);
            scene.error("energySquaredJoules2", energy::mean);
        } else if (e == 0) {
            Overlaps overlaps = new Overlaps(balls, floor);
            scene.afterTick(overlaps::note);
            scene.error("overlapSquaredMetres2", overlaps::mean);
        }
    }

    /** Mean of (E - E0)²; E is m g y + m v² / 2, for balls that do not spin. */
    private static final class Energy {
        private final List<BodyRef> balls;
        private final double start;
        private final Vector3d scratch = new Vector3d();
        private double sum;
        private long count;

        Energy(List<BodyRef> balls) {
            this.balls = balls;
            this.start = now();
        }

        private double now() {
            double energy = 0;
            for (int i = 0; i < balls.size(); i++) {
                double y = balls.get(i).centreOfMass(scratch).y;
                double v2 = balls.get(i).velocity(scratch).lengthSquared();
                energy += MASS * (SampleScene.GRAVITY * y + v2 / 2);
            }
            return energy;
        }

        void note(long tick, double seconds) {
            double off = now() - start;
            sum += off * off;
            count++;
        }

        double mean() {
            return count == 0 ? Double.NaN : sum / count;
        }
    }

    /** Mean of the sum of squared overlaps of spheres with each other and with the floor. */
    private static final class Overlaps {
        private final List<BodyRef> balls;
        private final double floor;
        private final double[] at;
        private final Vector3d scratch = new Vector3d();
        private double sum;
        private long count;

        Overlaps(List<BodyRef> balls, double floor) {
            this.balls = balls;
            this.floor = floor;
            this.at = new double[3 * balls.size()];
        }

        void note(long tick, double seconds) {
            int n = balls.size();
            for (int i = 0; i < n; i++) {
                balls.get(i).centreOfMass(scratch);
                at[3 * i] = scratch.x;
                at[3 * i + 1] = scratch.y;
                at[3 * i + 2] = scratch.z;
            }
            double squares = 0;
            for (int i = 0; i < n; i++) {
                if (Math.abs(at[3 * i]) <= floor && Math.abs(at[3 * i + 2]) <= floor) {
                    double low = Math.max(0, RADIUS - at[3 * i + 1]);
                    squares += low * low;
                }
                for (int k = 0; k < i; k++) {
                    double x = at[3 * i] - at[3 * k];
                    double y = at[3 * i + 1] - at[3 * k + 1];
                    double z = at[3 * i + 2] - at[3 * k + 2];
                    double apart2 = x * x + y * y + z * z;
                    if (apart2 < 4 * RADIUS * RADIUS) {
                        double deep = 2 * RADIUS - StrictMath.sqrt(apart2);
                        squares += deep * deep;
                    }
                }
            }
            sum += squares;
            count++;
        }

        double mean() {
            return count == 0 ? Double.NaN : sum / count;
        }
    }
}
