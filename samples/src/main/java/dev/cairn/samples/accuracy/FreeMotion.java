package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.List;

/** Group A of the table: bodies that touch nothing. */
final class FreeMotion {
    /** The box of the Gazebo benchmark, 0.1 x 0.4 x 0.9 m and 10 kg. */
    private static final double[] GAZEBO = {
        10 / 12.0 * (0.16 + 0.81), 10 / 12.0 * (0.01 + 0.81), 10 / 12.0 * (0.01 + 0.16)
    };

    private static final double[] TUMBLE = {0.1, 5, 0.1};
    private static final double[] RACKET = {1, 2, 3};
    private static final double[] RACKET_SPIN = {0.01, 10, 0.01};
    private static final double[] MILD = {1, 1.5, 2};
    private static final double[] MILD_SPIN = {1, 2, 3};
    private static final double[] NO_TORQUE = new double[3];
    private static final double[] DRIVE = {1, 0.5, 0.2};
    private static final int REFERENCE_STEPS = 200_000;

    /** Errors below this are rounding, the reference's too. */
    private static final double ROUNDING = 1e-11;

    private FreeMotion() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "A1",
                        "parabola",
                        "10 kg, v0 (-2, 2, 8) m/s, g 9.8, 10 s",
                        "x0 + v0 t + g t²/2",
                        List.of(metric("largest distance", "m", 1e-11)),
                        "ODE, Bullet 4.9e-2, Simbody 2.5e-2, all at 1 ms [Gazebo boxes]",
                        Effort.SHORT,
                        FreeMotion::parabola),
                new AccuracyCase(
                        "A2",
                        "stable-axis spin",
                        "box 0.1 x 0.4 x 0.9 m, w (0.5, 0, 0) rad/s, 10 s",
                        "angle 0.5 t",
                        List.of(metric("attitude", "rad", 1e-13)),
                        "Bullet 1e-13, Simbody 2.6e-8, ODE 1.0e-7, all at 1 ms [Gazebo boxes]",
                        Effort.SHORT,
                        FreeMotion::spin),
                new AccuracyCase(
                        "A3",
                        "Gazebo tumble",
                        "the same box, w (0.1, 5, 0.1) rad/s, 10 s",
                        "Runge-Kutta reference (period by elliptic integral 6.0568442 s); L and E"
                                + " constant",
                        List.of(
                                metric("attitude", "rad", 4e-3),
                                metric("L", "", 1e-12),
                                metric("E", "", 2e-5)),
                        "L 6.4e-3 Simbody, 1.3e-2 ODE at 1 ms [Gazebo boxes]; attitude 1.3 Box3D's"
                                + " scheme at 240 Hz [catalogue 4.4]",
                        Effort.SHORT,
                        FreeMotion::tumble),
                new AccuracyCase(
                        "A4",
                        "Dzhanibekov",
                        "I (1, 2, 3) kg m², w (0.01, 10, 0.01) rad/s, 10 s",
                        "turns over every 2.7530840554 s (2 K(k)/p)",
                        List.of(
                                metric("flip times", "s", 1e-3),
                                metric("L", "", Double.POSITIVE_INFINITY)),
                        "first-order schemes: off by more than 1 rad [catalogue 4.4]",
                        Effort.SHORT,
                        trial -> flips(trial, 10)),
                new AccuracyCase(
                        "A4-60",
                        "Dzhanibekov, a minute",
                        "the same, 60 s",
                        "the same",
                        List.of(
                                metric("flip times", "s", 1e-3),
                                metric("L", "", Double.POSITIVE_INFINITY)),
                        "",
                        Effort.SHORT,
                        trial -> flips(trial, 60)),
                new AccuracyCase(
                        "A5",
                        "fast thin rod",
                        "I (1, 1, 0.01) kg m², w (1, 0, 50) rad/s, 10 s",
                        "symmetric top: axis circles L at L/I1 = 1.1180 rad/s",
                        List.of(
                                metric("axis", "rad", 1e-3),
                                metric("L", "", Double.POSITIVE_INFINITY)),
                        "implicit gyro (Box3D's scheme): L 0.9; explicit: NaN [catalogue 4.4]",
                        Effort.SHORT,
                        FreeMotion::rod),
                new AccuracyCase(
                        "A6",
                        "order",
                        "I (1, 1.5, 2) kg m², w (1, 2, 3) rad/s, 10 s, this number of sub-steps"
                                + " and twice as many",
                        "Runge-Kutta reference; the error falls with h² or faster",
                        List.of(metric("attitude", "rad", 1e-4), metric("2 - slope", "", 0.02)),
                        "slope 1.0: ODE, Bullet, Simbody, DART [Gazebo boxes]",
                        Effort.SHORT,
                        FreeMotion::order),
                new AccuracyCase(
                        "A7",
                        "exponential map",
                        "ball, 50 rad/s about (1, 2, -2), 1 s",
                        "angle 50",
                        List.of(metric("attitude", "rad", 1e-12)),
                        "linear update: 0.18 at 240 Hz [catalogue]",
                        Effort.SHORT,
                        FreeMotion::ball),
                new AccuracyCase(
                        "A8",
                        "driven spin",
                        "torque (1, 0.5, 0.2) N m on I (1, 2, 3) kg m² from rest, 5 s",
                        "L = torque t; energy and attitude by Runge-Kutta reference, errors falling"
                                + " with h² or faster",
                        List.of(
                                metric("L", "", 1e-13),
                                metric("E", "", Double.POSITIVE_INFINITY),
                                metric("2 - slope of E", "", 0.02),
                                metric("attitude", "rad", Double.POSITIVE_INFINITY),
                                metric("2 - slope of attitude", "", 0.02)),
                        "",
                        Effort.SHORT,
                        FreeMotion::driven),
                new AccuracyCase(
                        "A9",
                        "long haul",
                        "the body of A6, 1e7 ticks",
                        "energy does not drift; unit quaternion",
                        List.of(
                                metric("slope of E by tick", "", 1e-15),
                                metric("quaternion's norm", "ulp", 4)),
                        "",
                        Effort.LONG,
                        FreeMotion::haul),
                new AccuracyCase(
                        "A10",
                        "offset dumbbell",
                        "balls of 1 and 9 kg, r 0.1 m, 1 m apart, as one body with its origin in"
                                + " the light one; 10 rad/s about the origin, 10 s",
                        "the centre of mass goes straight on at 9 m/s, the origin circles it",
                        List.of(
                                metric("centre of mass", "m", 1e-12),
                                metric("origin", "m", Double.POSITIVE_INFINITY)),
                        "",
                        Effort.SHORT,
                        FreeMotion::dumbbell));
    }

    private static BodyRef body(PhysicsWorld world, double[] inertia, double[] spin) {
        return world.add(
                Body.dynamic()
                        .shape(Box.ofHalfExtents(0.05, 0.2, 0.45))
                        .mass(10)
                        .inertia(inertia[0], inertia[1], inertia[2])
                        .angularVelocity(spin[0], spin[1], spin[2]));
    }

    private static double[] parabola(Trial trial) {
        try (PhysicsWorld world = trial.world(0, 0, -9.8)) {
            BodyRef body =
                    world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(10).velocity(-2, 2, 8));
            Vector3d p = new Vector3d();
            double worst = 0;
            for (int tick = 1; tick <= 600; tick++) {
                trial.step(world);
                double t = tick * Trial.TICK;
                body.centreOfMass(p);
                worst = Math.max(worst, p.distance(-2 * t, 2 * t, 8 * t - 4.9 * t * t));
            }
            return new double[] {worst};
        }
    }

    private static double[] spin(Trial trial) {
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, GAZEBO, new double[] {0.5, 0, 0});
            trial.run(world, 10);
            Quaterniond truth = Truths.turned(new Vector3d(1, 0, 0), 0.5 * 600 * Trial.TICK);
            return new double[] {Truths.angle(truth, body.orientation())};
        }
    }

    private static double[] tumble(Trial trial) {
        Quaterniond truth =
                new RigidReference(GAZEBO, NO_TORQUE, TUMBLE)
                        .advance(600 * Trial.TICK, REFERENCE_STEPS)
                        .orientation();
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, GAZEBO, TUMBLE);
            Watch watch = new Watch(body, GAZEBO);
            for (int tick = 0; tick < 600; tick++) {
                trial.step(world);
                watch.look();
            }
            return new double[] {
                Truths.angle(truth, body.orientation()), watch.worstMomentum, watch.worstEnergy
            };
        }
    }

    private static double[] flips(Trial trial, int seconds) {
        double half = 0.5 * Truths.period(RACKET, RACKET_SPIN);
        double first =
                new RigidReference(RACKET, NO_TORQUE, RACKET_SPIN)
                        .advance(3, REFERENCE_STEPS)
                        .flips()
                        .get(0);
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, RACKET, RACKET_SPIN);
            Watch watch = new Watch(body, RACKET);
            double worst = 0;
            int seen = 0;
            double last = RACKET_SPIN[1];
            double lastSlope = 0;
            for (int tick = 1; tick <= 60 * seconds; tick++) {
                trial.step(world);
                watch.look();
                Vector3d w = watch.bodySpin();
                // I2 w2' = (I3 - I1) w3 w1
                double slope = (RACKET[2] - RACKET[0]) * w.z * w.x / RACKET[1];
                if ((last < 0) != (w.y < 0)) {
                    double t =
                            Trial.TICK
                                    * (tick
                                            - 1
                                            + hermiteRoot(
                                                    last,
                                                    w.y,
                                                    lastSlope * Trial.TICK,
                                                    slope * Trial.TICK));
                    worst = Math.max(worst, Math.abs(t - first - half * seen));
                    seen++;
                }
                last = w.y;
                lastSlope = slope;
            }
            int expected = 1 + (int) ((seconds - first) / half);
            return new double[] {
                seen == expected ? worst : Double.POSITIVE_INFINITY, watch.worstMomentum
            };
        }
    }

    /** Where in [0, 1] the cubic through two values with two slopes is zero, by bisection. */
    private static double hermiteRoot(double a, double b, double da, double db) {
        double low = 0;
        double high = 1;
        for (int n = 0; n < 60; n++) {
            double s = 0.5 * (low + high);
            double r = 1 - s;
            double value = r * r * ((1 + 2 * s) * a + s * da) + s * s * ((1 + 2 * r) * b - r * db);
            if ((value < 0) == (a < 0)) {
                low = s;
            } else {
                high = s;
            }
        }
        return 0.5 * (low + high);
    }

    private static double[] rod(Trial trial) {
        double[] inertia = {1, 1, 0.01};
        double[] spin = {1, 0, 50};
        Vector3d momentum = new Vector3d(1, 0, 0.5);
        double rate = momentum.length();
        Vector3d direction = momentum.normalize(new Vector3d());
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, inertia, spin);
            Watch watch = new Watch(body, inertia);
            double worst = 0;
            for (int tick = 1; tick <= 600; tick++) {
                trial.step(world);
                watch.look();
                Vector3d truth =
                        Truths.turned(direction, rate * tick * Trial.TICK)
                                .transform(new Vector3d(0, 0, 1));
                Vector3d axis = body.orientation().transform(new Vector3d(0, 0, 1));
                worst =
                        Math.max(
                                worst,
                                StrictMath.atan2(
                                        truth.cross(axis, new Vector3d()).length(),
                                        truth.dot(axis)));
            }
            return new double[] {worst, watch.worstMomentum};
        }
    }

    private static double[] order(Trial trial) {
        Quaterniond truth =
                new RigidReference(MILD, NO_TORQUE, MILD_SPIN)
                        .advance(600 * Trial.TICK, REFERENCE_STEPS)
                        .orientation();
        double coarse = mild(trial, truth);
        double fine = mild(trial.finer(), truth);
        return new double[] {coarse, missingOrder(coarse, fine)};
    }

    /**
     * What the order of an error lacks of two; 0 where the error is rounding, of which no order can
     * be read.
     */
    private static double missingOrder(double coarse, double fine) {
        return coarse < ROUNDING ? 0 : 2 - StrictMath.log(coarse / fine) / StrictMath.log(2);
    }

    private static double mild(Trial trial, Quaterniond truth) {
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, MILD, MILD_SPIN);
            trial.run(world, 10);
            return Truths.angle(truth, body.orientation());
        }
    }

    /** The mass properties are those of the two balls; the shape in which they are is a box. */
    private static double[] dumbbell(Trial trial) {
        double arm = 0.9;
        double volume = 4 * Math.PI / 3 * 0.1 * 0.1 * 0.1;
        Material light = Material.DEFAULT.withDensity(1 / volume);
        Material heavy = Material.DEFAULT.withDensity(9 / volume);
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .collider(Collider.of(Sphere.of(0.1)).material(light))
                                    .collider(
                                            Collider.of(Sphere.of(0.1)).at(1, 0, 0).material(heavy))
                                    .velocity(0, 10 * arm, 0)
                                    .angularVelocity(0, 0, 10));
            double centre = 0;
            double origin = 0;
            for (int tick = 1; tick <= 600; tick++) {
                trial.step(world);
                double t = tick * Trial.TICK;
                Vector3d truth = new Vector3d(arm, 10 * arm * t, 0);
                centre = Math.max(centre, truth.distance(body.centreOfMass(new Vector3d())));
                truth.sub(
                        Truths.turned(new Vector3d(0, 0, 1), 10 * t)
                                .transform(new Vector3d(arm, 0, 0)));
                origin = Math.max(origin, truth.distance(body.position()));
            }
            return new double[] {centre, origin};
        }
    }

    private static double[] ball(Trial trial) {
        Vector3d axis = new Vector3d(1, 2, -2).normalize();
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .angularVelocity(50 * axis.x, 50 * axis.y, 50 * axis.z));
            trial.run(world, 1);
            return new double[] {
                Truths.angle(Truths.turned(axis, 50 * 60 * Trial.TICK), body.orientation())
            };
        }
    }

    private static double[] driven(Trial trial) {
        RigidReference truth =
                new RigidReference(RACKET, DRIVE, NO_TORQUE)
                        .advance(300 * Trial.TICK, REFERENCE_STEPS);
        double[] coarse = driven(trial, truth);
        double[] fine = driven(trial.finer(), truth);
        return new double[] {
            coarse[0],
            coarse[1],
            missingOrder(coarse[1], fine[1]),
            coarse[2],
            missingOrder(coarse[2], fine[2])
        };
    }

    private static double[] driven(Trial trial, RigidReference truth) {
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, RACKET, NO_TORQUE);
            double worst = 0;
            for (int tick = 1; tick <= 300; tick++) {
                body.applyTorque(DRIVE[0], DRIVE[1], DRIVE[2]);
                trial.step(world);
                Vector3d l = Truths.momentum(RACKET, body.orientation(), body.angularVelocity());
                Vector3d expected = new Vector3d(DRIVE).mul(tick * Trial.TICK);
                worst = Math.max(worst, l.distance(expected) / expected.length());
            }
            double energy = Truths.energy(RACKET, body.orientation(), body.angularVelocity());
            return new double[] {
                worst,
                Math.abs(energy / truth.energy() - 1),
                Truths.angle(truth.orientation(), body.orientation())
            };
        }
    }

    private static double[] haul(Trial trial) {
        int ticks = 10_000_000;
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            BodyRef body = body(world, MILD, MILD_SPIN);
            double start = Truths.energy(MILD, body.orientation(), body.angularVelocity());
            double sumT = 0.5 * (ticks + 1.0);
            double product = 0;
            double square = 0;
            double norm = 0;
            Quaterniond q = new Quaterniond();
            Vector3d w = new Vector3d();
            for (int tick = 1; tick <= ticks; tick++) {
                trial.step(world);
                body.orientation(q);
                double energy = Truths.energy(MILD, q, body.angularVelocity(w)) / start - 1;
                // slope of the least-squares line: sum (t - mean) E / sum (t - mean)²
                product += (tick - sumT) * energy;
                square += (tick - sumT) * (tick - sumT);
                norm = Math.max(norm, Math.abs(q.lengthSquared() - 1));
            }
            return new double[] {Math.abs(product / square), norm / 2 / Math.ulp(1.0)};
        }
    }

    /** Momentum and energy of one spinning body against those at the start. */
    private static final class Watch {
        private final BodyRef body;
        private final double[] inertia;
        private final Vector3d start;
        private final double startEnergy;
        private double worstMomentum;
        private double worstEnergy;

        Watch(BodyRef body, double[] inertia) {
            this.body = body;
            this.inertia = inertia;
            start = Truths.momentum(inertia, body.orientation(), body.angularVelocity());
            startEnergy = Truths.energy(inertia, body.orientation(), body.angularVelocity());
        }

        void look() {
            Vector3d l = Truths.momentum(inertia, body.orientation(), body.angularVelocity());
            worstMomentum = Math.max(worstMomentum, l.distance(start) / start.length());
            double e = Truths.energy(inertia, body.orientation(), body.angularVelocity());
            worstEnergy = Math.max(worstEnergy, Math.abs(e / startEnergy - 1));
        }

        Vector3d bodySpin() {
            return body.orientation().transformInverse(body.angularVelocity());
        }
    }
}
