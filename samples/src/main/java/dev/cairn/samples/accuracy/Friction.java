package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Vector3d;

import java.util.List;

/** Group C of the table: Coulomb friction. Slopes are flat floors under inclined gravity. */
final class Friction {
    private static final double G = Trial.GRAVITY;
    private static final Shape BLOCK = Box.ofHalfExtents(0.2, 0.05, 0.2);
    private static final double RADIUS = 0.1;
    private static final int SIDES = 24;

    private Friction() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "C1",
                        "stick or slip",
                        "block 0.4 x 0.1 x 0.4 m, mu 0.1 to 1, slope atan(mu) ± 2, 0.5, 0.1, 0.01°,"
                                + " 3 s; creep in the 21st second",
                        "held below, slides above",
                        List.of(
                                metric("smallest margin told apart", "°", 0.01),
                                metric("creep along the slope below", "m/s", 1e-9)),
                        "Newton's own test: 2° [catalogue]",
                        Effort.SHORT,
                        Friction::threshold),
                new AccuracyCase(
                        "C2",
                        "sliding distance",
                        "20°, mu 0.2, 3 s from rest",
                        "s = g (sin - mu cos) t²/2",
                        List.of(metric("distance", "", 1e-10)),
                        "first order in h: ODE, Bullet, Jolt [catalogue]",
                        Effort.SHORT,
                        Friction::slide),
                new AccuracyCase(
                        "C3",
                        "stopping distance",
                        "5 m/s, mu 0.1, 0.3, 0.5, 0.8",
                        "v0²/(2 mu g)",
                        List.of(metric("distance", "", 1e-6)),
                        "first order in h [catalogue]",
                        Effort.SHORT,
                        Friction::stop),
                new AccuracyCase(
                        "C4",
                        "isotropy",
                        "the same with mu 0.5 in the directions 0°, 1°, ..., 90°; pushes of 0.99"
                                + " and 1.01 mu N",
                        "same distance, straight; held, moves",
                        List.of(
                                metric("spread of distances", "", 1e-9),
                                metric("heading", "rad", 1e-9),
                                metric("pushes told wrongly", "", 0)),
                        "pyramids: ±41 %; ODE, DART never move [SimBenchmark]",
                        Effort.MEDIUM,
                        Friction::isotropy),
                new AccuracyCase(
                        "C6",
                        "slip to roll",
                        "ball r 0.1 m, mu 0.2, 5 m/s without spin, and with backspin 100 rad/s",
                        "v = (5 v0 + 2 r w0)/7 from t = 2 (v0 - r w0)/(7 mu g)",
                        List.of(metric("speed", "", 1e-9), metric("time", "s", 1e-4)),
                        "",
                        Effort.SHORT,
                        Friction::slipToRoll),
                new AccuracyCase(
                        "C7",
                        "roll down a slope",
                        "20°, 2 s: I/(m r²) 0.4, 0.5, 2/3, 1 with mu 0.6; and 0.4 with mu 0.05",
                        "a = g sin/(1 + I/(m r²)); slipping g (sin - mu cos)",
                        List.of(metric("acceleration", "", 1e-8)),
                        "",
                        Effort.SHORT,
                        Friction::roll),
                new AccuracyCase(
                        "C8",
                        "sliding, spinning disc",
                        "prism of 24 sides r 0.1 m, mu 0.3; (v0, r w0) (1, 1), (1, 0.1), (0.1, 1)"
                                + " m/s",
                        "evenly pressed disc by quadrature; both stop together with v/(r w) = 0.653"
                                + " (Weidman 2007)",
                        List.of(
                                metric("v/(r w) near the stop", "", 0.02),
                                metric("stops apart", "s", Trial.TICK)),
                        "points on the rim: spin dies first, no common stop [catalogue]",
                        Effort.SHORT,
                        Friction::disc),
                new AccuracyCase(
                        "C9",
                        "pure spin",
                        "the same, 20 rad/s",
                        "angular deceleration 4/3 mu g/r",
                        List.of(metric("deceleration", "", 0.01)),
                        "",
                        Effort.SHORT,
                        Friction::spin),
                new AccuracyCase(
                        "C12",
                        "eternal slope",
                        "20°, mu 0.5, 3600 s",
                        "no motion",
                        List.of(
                                metric("moved along the slope in the last 3540 s", "m", 1e-9),
                                metric(
                                        "moved along the slope in all",
                                        "m",
                                        Double.POSITIVE_INFINITY)),
                        "",
                        Effort.MEDIUM,
                        Friction::eternal),
                new AccuracyCase(
                        "C13",
                        "rolling resistance",
                        "r 0.1 m, arm b 2 mm, 1 m/s: I/(m r²) 0.4, 0.5 (cylinder), 2/3, 1; and at"
                                + " rest with b/r 0.1 on slopes of tan 0.099 and 0.101",
                        "a = (b/r) g/(1 + I/(m r²)), stops after v²/(2 a); held up to tan = b/r,"
                                + " rolls beyond with g (sin - b/r cos)/(1 + I/(m r²))",
                        List.of(
                                metric("speed", "m/s", 1e-9),
                                metric("distance", "", 1e-9),
                                metric("moved in 60 s below", "m", 1e-12),
                                metric("acceleration above", "", 1e-9)),
                        "",
                        Effort.SHORT,
                        Friction::resistance));
    }

    /** A block on the floor, gravity inclined towards +x. */
    private static BodyRef block(PhysicsWorld world, Material surface) {
        Trial.floor(world, surface);
        return world.add(Body.dynamic().shape(BLOCK).at(0, 0.05, 0).material(surface));
    }

    private static PhysicsWorld slope(Trial trial, double radians) {
        return trial.world(G * StrictMath.sin(radians), -G * StrictMath.cos(radians), 0);
    }

    private static double[] threshold(Trial trial) {
        double[] margins = {2, 0.5, 0.1, 0.01};
        double creep = 0;
        double smallest = 0;
        for (int m = margins.length - 1; m >= 0; m--) {
            for (double mu : new double[] {0.1, 0.3, 0.5, 0.7, 1}) {
                double below = slopeSpeed(trial, mu, StrictMath.atan(mu), -margins[m], 20);
                double angle = StrictMath.atan(mu) + StrictMath.toRadians(margins[m]);
                double expected = 2.5 * G * (StrictMath.sin(angle) - mu * StrictMath.cos(angle));
                double above = slopeSpeed(trial, mu, StrictMath.atan(mu), margins[m], 2);
                creep = Math.max(creep, below);
                if (below > 0.5 * expected || above < 0.5 * expected) {
                    smallest = Math.max(smallest, m == 0 ? 90 : margins[m - 1]);
                }
            }
        }
        return new double[] {smallest == 0 ? 0.01 : smallest, creep};
    }

    /** Mean speed of a block along the slope in the second after some. */
    private static double slopeSpeed(
            Trial trial, double mu, double radians, double degreesMore, int after) {
        try (PhysicsWorld world = slope(trial, radians + StrictMath.toRadians(degreesMore))) {
            BodyRef block = block(world, Trial.surface(mu, 0));
            trial.run(world, after);
            Vector3d before = block.position();
            trial.run(world, 1);
            Vector3d end = block.position();
            return StrictMath.hypot(end.x - before.x, end.z - before.z);
        }
    }

    private static double[] slide(Trial trial) {
        double angle = StrictMath.toRadians(20);
        double a = G * (StrictMath.sin(angle) - 0.2 * StrictMath.cos(angle));
        try (PhysicsWorld world = slope(trial, angle)) {
            BodyRef block = block(world, Trial.surface(0.2, 0));
            trial.run(world, 3);
            double t = 180 * Trial.TICK;
            return new double[] {Math.abs(block.position().x / (0.5 * a * t * t) - 1)};
        }
    }

    private static double[] stop(Trial trial) {
        double worst = 0;
        for (double mu : new double[] {0.1, 0.3, 0.5, 0.8}) {
            Vector3d end = stopped(trial, mu, 0);
            worst = Math.max(worst, Math.abs(end.x / (25 / (2 * mu * G)) - 1));
        }
        return new double[] {worst};
    }

    /** Where a block at 5 m/s stops. */
    private static Vector3d stopped(Trial trial, double mu, double radians) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            BodyRef block = block(world, Trial.surface(mu, 0));
            block.setVelocity(5 * StrictMath.cos(radians), 0, 5 * StrictMath.sin(radians));
            trial.run(world, 5 / (mu * G) + 0.2);
            return block.position();
        }
    }

    private static double[] isotropy(Trial trial) {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        double heading = 0;
        int wrong = 0;
        for (int degrees = 0; degrees <= 90; degrees++) {
            double radians = StrictMath.toRadians(degrees);
            Vector3d end = stopped(trial, 0.5, radians);
            double distance = StrictMath.sqrt(end.x * end.x + end.z * end.z);
            least = Math.min(least, distance);
            most = Math.max(most, distance);
            double aside = end.z * StrictMath.cos(radians) - end.x * StrictMath.sin(radians);
            heading = Math.max(heading, Math.abs(aside) / distance);
            wrong += pushed(trial, radians, 0.99) > 1e-6 ? 1 : 0;
            wrong += pushed(trial, radians, 1.01) < 0.4 * 0.005 * G ? 1 : 0;
        }
        return new double[] {most / least - 1, heading, wrong};
    }

    /** How far a push of {@code share} of mu N moves a block in a second. */
    private static double pushed(Trial trial, double radians, double share) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            BodyRef block = block(world, Trial.surface(0.5, 0));
            double force = share * 0.5 * block.mass() * G;
            for (int tick = 0; tick < 60; tick++) {
                block.applyForce(
                        force * StrictMath.cos(radians), 0, force * StrictMath.sin(radians));
                trial.step(world);
            }
            Vector3d end = block.position();
            return StrictMath.sqrt(end.x * end.x + end.z * end.z);
        }
    }

    private static double[] slipToRoll(Trial trial) {
        double mu = 0.2;
        double speed = 0;
        double time = 0;
        for (double spin : new double[] {0, -100}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                Material surface = Trial.surface(mu, 0);
                Trial.floor(world, surface);
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(RADIUS))
                                        .at(0, RADIUS, 0)
                                        .velocity(5, 0, 0)
                                        .angularVelocity(0, 0, -spin)
                                        .material(surface));
                trial.run(world, 4);
                double rolling = (25 + 2 * RADIUS * spin) / 7;
                double slips = 2 * (5 - RADIUS * spin) / (7 * mu * G);
                speed = Math.max(speed, Math.abs(ball.velocity().x / rolling - 1));
                // x = v0 t - mu g t²/2 + v (T - t), so x - v T = mu g t²/2
                double rest = ball.position().x - rolling * 240 * Trial.TICK;
                time = Math.max(time, Math.abs(StrictMath.sqrt(2 * rest / (mu * G)) - slips));
            }
        }
        return new double[] {speed, time};
    }

    private static double[] roll(Trial trial) {
        double angle = StrictMath.toRadians(20);
        double sin = StrictMath.sin(angle);
        double worst = 0;
        for (double k : new double[] {0.4, 0.5, 2.0 / 3, 1}) {
            worst = Math.max(worst, rolled(trial, angle, k, 0.6, G * sin / (1 + k)));
        }
        double slips = G * (sin - 0.05 * StrictMath.cos(angle));
        return new double[] {Math.max(worst, rolled(trial, angle, 0.4, 0.05, slips))};
    }

    private static double rolled(Trial trial, double angle, double k, double mu, double a) {
        try (PhysicsWorld world = slope(trial, angle)) {
            Material surface = Trial.surface(mu, 0);
            Trial.floor(world, surface);
            double inertia = k * RADIUS * RADIUS;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(RADIUS))
                                    .mass(1)
                                    .inertia(inertia, inertia, inertia)
                                    .at(0, RADIUS, 0)
                                    .material(surface));
            trial.run(world, 2);
            double t = 120 * Trial.TICK;
            return Math.abs(ball.position().x / (0.5 * a * t * t) - 1);
        }
    }

    private static double[] resistance(Trial trial) {
        double speed = 0;
        double distance = 0;
        double moved = 0;
        double rolls = 0;
        for (double k : new double[] {0.4, 0.5, 2.0 / 3, 1}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                BodyRef body = roller(world, k, 0.002, 1);
                double loss = 0.002 / RADIUS * G / (1 + k);
                for (int tick = 1; tick * Trial.TICK < 1 / loss; tick++) {
                    trial.step(world);
                    double off = body.velocity().x - (1 - loss * tick * Trial.TICK);
                    speed = Math.max(speed, Math.abs(off));
                }
                trial.run(world, 0.2);
                distance = Math.max(distance, Math.abs(body.position().x * 2 * loss - 1));
            }
            try (PhysicsWorld world = slope(trial, StrictMath.atan(0.099))) {
                BodyRef body = roller(world, k, 0.1 * RADIUS, 0);
                trial.run(world, 60);
                moved = Math.max(moved, Math.abs(body.position().x));
            }
            double angle = StrictMath.atan(0.101);
            try (PhysicsWorld world = slope(trial, angle)) {
                BodyRef body = roller(world, k, 0.1 * RADIUS, 0);
                trial.run(world, 2);
                double a = G * (StrictMath.sin(angle) - 0.1 * StrictMath.cos(angle)) / (1 + k);
                double t = 120 * Trial.TICK;
                rolls = Math.max(rolls, Math.abs(body.position().x / (0.5 * a * t * t) - 1));
            }
        }
        return new double[] {speed, distance, moved, rolls};
    }

    /** A ball of that inertia, or the cylinder that has it, rolling on a floor. */
    private static BodyRef roller(PhysicsWorld world, double k, double arm, double speed) {
        Material surface = Trial.surface(0.6, 0);
        Trial.floor(world, surface);
        double inertia = k * RADIUS * RADIUS;
        Body body =
                Body.dynamic()
                        .mass(1)
                        .at(0, RADIUS, 0)
                        .velocity(speed, 0, 0)
                        .angularVelocity(0, 0, -speed / RADIUS)
                        .material(surface.withRollingArm(arm));
        return world.add(
                k == 0.5
                        ? body.shape(Cylinder.of(RADIUS, 0.2))
                                .rotationAbout(1, 0, 0, StrictMath.PI / 2)
                        : body.shape(Sphere.of(RADIUS)).inertia(inertia, inertia, inertia));
    }

    private static BodyRef disc(PhysicsWorld world, Material surface) {
        Trial.floor(world, surface);
        double[] corners = new double[6 * SIDES];
        for (int i = 0; i < 2 * SIDES; i++) {
            int side = i / 2;
            double a = 2 * StrictMath.PI * (side + 0.5) / SIDES;
            corners[3 * i] = RADIUS * StrictMath.cos(a);
            corners[3 * i + 1] = i % 2 == 0 ? -0.01 : 0.01;
            corners[3 * i + 2] = RADIUS * StrictMath.sin(a);
        }
        double m = 1;
        double flat = m * RADIUS * RADIUS / 2;
        double edge = m * (3 * RADIUS * RADIUS + 4e-4) / 12;
        return world.add(
                Body.dynamic()
                        .shape(ConvexHull.of(corners))
                        .mass(m)
                        .inertia(edge, flat, edge)
                        .at(0, 0.01, 0)
                        .material(surface));
    }

    private static double[] disc(Trial trial) {
        double mu = 0.3;
        double ratio = 0;
        double apart = 0;
        for (double[] start : new double[][] {{1, 1}, {1, 0.1}, {0.1, 1}}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                BodyRef disc = disc(world, Trial.surface(mu, 0));
                disc.setVelocity(start[0], 0, 0);
                disc.setAngularVelocity(0, start[1] / RADIUS, 0);
                DiscReference truth = new DiscReference(start[0], start[1], mu * G);
                double stopSlide = 0;
                double stopSpin = 0;
                double off = Double.NaN;
                for (int tick = 1; tick <= 60; tick++) {
                    trial.step(world);
                    truth.advance(Trial.TICK);
                    double v = disc.velocity().length();
                    double u = RADIUS * Math.abs(disc.angularVelocity().y);
                    stopSlide = v > 1e-3 ? tick * Trial.TICK : stopSlide;
                    stopSpin = u > 1e-3 ? tick * Trial.TICK : stopSpin;
                    if (truth.slide() > 0.03) {
                        off = Math.abs(v / u - truth.slide() / truth.rim());
                    }
                }
                ratio = Math.max(ratio, off);
                apart = Math.max(apart, Math.abs(stopSlide - stopSpin));
            }
        }
        return new double[] {ratio, apart};
    }

    private static double[] spin(Trial trial) {
        double mu = 0.3;
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            BodyRef disc = disc(world, Trial.surface(mu, 0));
            disc.setAngularVelocity(0, 20, 0);
            trial.run(world, 0.2);
            double lost = (20 - disc.angularVelocity().y) / (12 * Trial.TICK);
            return new double[] {Math.abs(lost / (4.0 / 3 * mu * G / RADIUS) - 1)};
        }
    }

    private static double[] eternal(Trial trial) {
        try (PhysicsWorld world = slope(trial, StrictMath.toRadians(20))) {
            BodyRef block = block(world, Trial.surface(0.5, 0));
            trial.run(world, 60);
            Vector3d start = block.position();
            trial.run(world, 3540);
            Vector3d end = block.position();
            return new double[] {
                StrictMath.hypot(end.x - start.x, end.z - start.z), StrictMath.hypot(end.x, end.z)
            };
        }
    }
}
