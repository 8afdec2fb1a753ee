package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** Group H of the table: the same scene larger, heavier, elsewhere, mirrored, turned. */
final class Invariance {
    private static final double G = Trial.GRAVITY;

    private Invariance() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "H1",
                        "similarity",
                        "a heap of 30, lengths x 4^k, times x 2^k, k -3 to 3, 3 s",
                        "the same motion, bit by bit",
                        List.of(metric("numbers that differ", "", 0)),
                        "engines with slop in metres fail [catalogue]",
                        Effort.SHORT,
                        trial -> {
                            double[] one = heap(trial, new Frame());
                            int differ = 0;
                            for (int k = -3; k <= 3; k++) {
                                Frame frame = new Frame();
                                frame.length = StrictMath.pow(4, k);
                                frame.time = StrictMath.pow(2, k);
                                differ += differing(one, heap(trial, frame));
                            }
                            return new double[] {differ};
                        }),
                new AccuracyCase(
                        "H2",
                        "density",
                        "the same heap, masses x 2^-10, 2^10, 2^20",
                        "the same motion, bit by bit",
                        List.of(metric("numbers that differ", "", 0)),
                        "AVBD's demo breaks at 1000 [catalogue]",
                        Effort.SHORT,
                        trial -> {
                            double[] one = heap(trial, new Frame());
                            int differ = 0;
                            for (int k : new int[] {-10, 10, 20}) {
                                Frame frame = new Frame();
                                frame.mass = StrictMath.pow(2, k);
                                differ += differing(one, heap(trial, frame));
                            }
                            return new double[] {differ};
                        }),
                new AccuracyCase(
                        "H3",
                        "far from the origin",
                        "stack of 10 for 5 s and pyramid of 10 rows for 3 s at 1e7 m",
                        "as at the origin",
                        List.of(metric("distance", "m", 1e-9)),
                        "float: 1 m; Box3D in double \"same at 1e7\" [catalogue]",
                        Effort.SHORT,
                        trial -> {
                            Frame far = new Frame();
                            // multiples of 2^-20 m, so that the set-up itself is exact
                            far.shift.set(1e7, -8e4, 3e6);
                            double stack = distance(stack(trial, new Frame()), stack(trial, far));
                            double pyramid =
                                    distance(pyramid(trial, new Frame()), pyramid(trial, far));
                            return new double[] {Math.max(stack, pyramid)};
                        }),
                new AccuracyCase(
                        "H4",
                        "mirror and rotation",
                        "the heap for 3 s with x negated; for 1 s turned about y by 90° and 37°",
                        "mirrored bit by bit; turned",
                        List.of(
                                metric("mirrored numbers that differ", "", 0),
                                metric("turned by 90°, distance", "m", 1e-9),
                                metric("turned by 37°, distance", "m", 1e-9)),
                        "",
                        Effort.SHORT,
                        trial -> {
                            Frame mirrored = new Frame();
                            mirrored.mirror = -1;
                            int differ = differing(heap(trial, new Frame()), heap(trial, mirrored));
                            return new double[] {differ, turned(trial, 90), turned(trial, 37)};
                        }));
    }

    /** How a scene is placed in the world; what comes out is told in the scene's own frame. */
    private static final class Frame {
        double length = 1;
        double time = 1;
        double mass = 1;
        double mirror = 1;
        double ticks = 180;
        final Vector3d shift = new Vector3d();
        final Quaterniond turn = new Quaterniond();
    }

    private static double turned(Trial trial, double degrees) {
        Frame still = new Frame();
        still.ticks = 60;
        Frame turned = new Frame();
        turned.ticks = 60;
        turned.turn.rotationY(StrictMath.toRadians(degrees));
        return distance(heap(trial, still), heap(trial, turned));
    }

    private static int differing(double[] a, double[] b) {
        int differ = 0;
        for (int i = 0; i < a.length; i++) {
            differ += a[i] == b[i] ? 0 : 1;
        }
        return differ;
    }

    private static double distance(double[] a, double[] b) {
        double worst = 0;
        for (int i = 0; i < a.length; i++) {
            worst = Math.max(worst, Math.abs(a[i] - b[i]));
        }
        return worst;
    }

    /** A frame's world under construction. */
    private static final class Place implements AutoCloseable {
        final PhysicsWorld world;
        final List<BodyRef> bodies = new ArrayList<>();
        private final Frame frame;
        private final Trial trial;

        Place(Trial trial, Frame frame) {
            this.trial = trial;
            this.frame = frame;
            double speed = frame.length / frame.time;
            world =
                    trial.world(
                            scaled(trial.settings(), speed),
                            0,
                            -G * frame.length / (frame.time * frame.time),
                            0);
            double l = frame.length;
            Vector3d floor = frame.turn.transform(new Vector3d(0, -l, 0)).add(frame.shift);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(64 * l, l, 64 * l))
                            .at(frame.mirror * floor.x, floor.y, floor.z)
                            .rotation(frame.turn)
                            .material(surface()));
        }

        /** The two settings that are speeds. */
        private static PhysicsSettings scaled(PhysicsSettings s, double speed) {
            return s.withRestitutionThreshold(s.restitutionThreshold() * speed)
                    .with(Tunable.PUSH_SPEED, s.tuning().get(Tunable.PUSH_SPEED) * speed);
        }

        private static Material surface() {
            return Trial.surface(0.5, 0.25);
        }

        void box(double hx, double hy, double hz, double x, double y, double z, double angle) {
            double l = frame.length;
            body(
                    Body.dynamic().shape(Box.ofHalfExtents(hx * l, hy * l, hz * l)),
                    hx * hy,
                    x,
                    y,
                    z,
                    angle);
        }

        void ball(double r, double x, double y, double z) {
            body(Body.dynamic().shape(Sphere.of(r * frame.length)), r * r, x, y, z, 0);
        }

        private void body(Body body, double mass, double x, double y, double z, double angle) {
            double l = frame.length;
            Vector3d at = frame.turn.transform(new Vector3d(x * l, y * l, z * l)).add(frame.shift);
            Quaterniond q =
                    new Quaterniond(frame.turn)
                            .mul(Truths.turned(new Vector3d(0.6, 0.64, 0.48), angle));
            // mirrored in x, a turn keeps its x axis and turns the other way about y and z
            q.y *= frame.mirror;
            q.z *= frame.mirror;
            bodies.add(
                    world.add(
                            body.at(frame.mirror * at.x, at.y, at.z)
                                    .rotation(q)
                                    .mass(64 * mass * frame.mass)
                                    .material(surface())));
        }

        /** Positions in the scene's own frame after some ticks. */
        double[] run(double ticks) {
            for (int tick = 0; tick < ticks; tick++) {
                trial.step(world, Trial.TICK * frame.time);
            }
            double[] out = new double[3 * bodies.size()];
            for (int i = 0; i < bodies.size(); i++) {
                Vector3d p = bodies.get(i).position();
                p.x *= frame.mirror;
                p.sub(frame.shift);
                frame.turn.transformInverse(p);
                out[3 * i] = p.x / frame.length;
                out[3 * i + 1] = p.y / frame.length;
                out[3 * i + 2] = p.z / frame.length;
            }
            return out;
        }

        @Override
        public void close() {
            world.close();
        }
    }

    private static double[] heap(Trial trial, Frame frame) {
        try (Place place = new Place(trial, frame)) {
            for (int i = 0; i < 30; i++) {
                double x = 0.375 * (i % 3 - 1) + 0.0625;
                double z = 0.4375 * (i % 2) - 0.125;
                double y = 1 + 0.625 * i;
                if (i % 3 == 2) {
                    place.ball(0.375, x, y, z);
                } else {
                    place.box(0.25, 0.375, 0.5, x, y, z, 0.3 * i);
                }
            }
            return place.run(frame.ticks);
        }
    }

    private static double[] stack(Trial trial, Frame frame) {
        try (Place place = new Place(trial, frame)) {
            for (int i = 0; i < 10; i++) {
                place.box(0.5, 0.5, 0.5, 0.0078125 * (i % 3), 0.5 + i, 0.00390625 * (i % 2), 0);
            }
            return place.run(300);
        }
    }

    private static double[] pyramid(Trial trial, Frame frame) {
        try (Place place = new Place(trial, frame)) {
            for (int row = 0; row < 10; row++) {
                for (int i = 0; i < 10 - row; i++) {
                    place.box(0.5, 0.5, 0.5, i + 0.5 * row - 4.5, 0.5 + row, 0, 0);
                }
            }
            return place.run(180);
        }
    }
}
