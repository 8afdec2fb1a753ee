package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** Group B of the table: impacts with a closed form. */
final class Impact {
    private static final double[] BOUNCES = {0.3, 0.5, 0.7, 0.8, 0.9, 0.95};
    private static final double RADIUS = 0.1;

    private Impact() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "B2",
                        "bouncing ball",
                        "ball r 0.1 m from 1 m, e 0.3 to 0.95, bounces 1 to 6 that last 3 ticks or"
                                + " more",
                        "heights e^(2k), impacts at t0 (1 + 2 sum e^j)",
                        List.of(metric("height", "", 1e-4), metric("time", "s", 1e-4)),
                        "-9 % a bounce: end-of-step restitution at 240 Hz [catalogue, toy]; Box3D"
                                + " allows +5 cm in 10 m [catalogue]",
                        Effort.SHORT,
                        Impact::ball),
                new AccuracyCase(
                        "B4",
                        "Zeno's rest",
                        "the same ball, e 0.5, 10 s, default threshold",
                        "at rest after t0 (1 + e)/(1 - e) = 1.35457 s",
                        List.of(
                                metric("settles late or early by", "s", Trial.TICK),
                                metric("speed at the end", "m/s", 1e-9)),
                        "",
                        Effort.SHORT,
                        Impact::zeno),
                new AccuracyCase(
                        "B5",
                        "unequal elastic pair",
                        "balls, 1 kg at 1 m/s against 1, 10, 100, 1e3, 1e6 kg at rest, e 1",
                        "(1 - M)/(1 + M) and 2/(1 + M)",
                        List.of(metric("velocity", "", 1e-13)),
                        "",
                        Effort.SHORT,
                        Impact::pair),
                new AccuracyCase(
                        "B6",
                        "pi by collisions",
                        "wall, 1 kg at rest, 100^n kg coming at 1 m/s, e 1, n 0 to 3",
                        "3, 31, 314, 3141 collisions (Galperin 2003)",
                        List.of(metric("collisions off", "", 0), metric("energy", "", 1e-12)),
                        "never reported for a game engine [catalogue]",
                        Effort.SHORT,
                        Impact::pi),
                new AccuracyCase(
                        "B7",
                        "Newton's cradle",
                        "5 balls 0.1 mm apart, e 1; 1 and 2 come in at 1 m/s; and the same without"
                                + " gaps",
                        "as many leave at 1 m/s as came; energy constant",
                        List.of(
                                metric("velocity, with gaps", "m/s", 1e-10),
                                metric("energy, without gaps", "", 1e-12),
                                metric(
                                        "velocity against the sequential law, without gaps",
                                        "m/s",
                                        Double.POSITIVE_INFINITY)),
                        "\"rarely works nicely out of the box\" [PEEL]",
                        Effort.SHORT,
                        Impact::cradle),
                new AccuracyCase(
                        "B8",
                        "three-ball break",
                        "ball at 1 m/s into two that touch, e 1, frictionless",
                        "-1/5 and 2 sqrt(3)/5 at ±30°",
                        List.of(metric("velocity", "m/s", 1e-10), metric("asymmetry", "m/s", 0)),
                        "",
                        Effort.SHORT,
                        Impact::threeBalls),
                new AccuracyCase(
                        "B9",
                        "oblique impact",
                        "ball, vn -1 m/s, vt 0.1 to 5 m/s, mu 0.3, e 0.8",
                        "vt' = 5/7 vt, or vt - mu (1 + e) vn if that is more; w' = 5/2 (vt -"
                                + " vt')/r",
                        List.of(metric("velocity and spin", "", 1e-10)),
                        "",
                        Effort.SHORT,
                        Impact::oblique),
                new AccuracyCase(
                        "B10",
                        "rod's end on the floor",
                        "rod 1 m, 30°, 2 m/s, e 0, 0.5, 1, frictionless",
                        "J = (1 + e) v / (1/m + lever²/I)",
                        List.of(metric("velocity and spin", "", 1e-10)),
                        "1/(1/m): off by 3.25 times (the thesis that Cairn started from)"
                                + " [catalogue]",
                        Effort.SHORT,
                        Impact::rodEnd),
                new AccuracyCase(
                        "B14",
                        "audit of impulses",
                        "20 boxes and 20 balls fall on each other, frictionless, 2 s",
                        "sum of reported impulses = m dv - m g dt, of each body in each tick",
                        List.of(metric("momentum", "", 1e-12)),
                        "",
                        Effort.SHORT,
                        Impact::audit));
    }

    private static BodyRef ball(
            PhysicsWorld world, Material surface, double mass, double x, double z, double vx) {
        return world.add(
                Body.dynamic()
                        .shape(Sphere.of(RADIUS))
                        .mass(mass)
                        .at(x, 0, z)
                        .velocity(vx, 0, 0)
                        .material(surface));
    }

    private static double[] ball(Trial trial) {
        double height = 0;
        double time = 0;
        for (double e : BOUNCES) {
            double[] one = ball(trial, e);
            height = Math.max(height, one[0]);
            time = Math.max(time, one[1]);
        }
        return new double[] {height, time};
    }

    private static double[] ball(Trial trial, double e) {
        double g = Trial.GRAVITY;
        double first = StrictMath.sqrt(2 / g);
        try (PhysicsWorld world = trial.bouncy(-g)) {
            Material surface = Trial.surface(0, e);
            Trial.floor(world, surface);
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(RADIUS))
                                    .at(0, 1 + RADIUS, 0)
                                    .material(surface));
            double height = 0;
            double time = 0;
            int bounce = 0;
            double landed = first;
            double flight = 2 * first * e;
            for (int tick = 1; bounce <= 6 && (bounce == 0 || flight > 3 * Trial.TICK); tick++) {
                trial.step(world);
                double t = tick * Trial.TICK;
                while (t > landed + (bounce == 0 ? 0 : flight)) {
                    landed += bounce == 0 ? 0 : flight;
                    flight *= bounce == 0 ? 1 : e;
                    bounce++;
                    if (flight <= 3 * Trial.TICK) {
                        return new double[] {height, time};
                    }
                }
                if (bounce == 0 || bounce > 6 || t - landed < 1e-4) {
                    continue;
                }
                double y = ball.position().y - RADIUS;
                double v = ball.velocity().y;
                double expected = StrictMath.pow(e, 2 * bounce);
                height = Math.max(height, Math.abs((y + v * v / (2 * g)) / expected - 1));
                double start = StrictMath.sqrt(v * v + 2 * g * y);
                time = Math.max(time, Math.abs(t - (start - v) / g - landed));
            }
            return new double[] {height, time};
        }
    }

    private static double[] zeno(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -Trial.GRAVITY, 0)) {
            Material surface = Trial.surface(0, 0.5);
            Trial.floor(world, surface);
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(RADIUS))
                                    .at(0, 1 + RADIUS, 0)
                                    .material(surface));
            double settled = 0;
            for (int tick = 1; tick <= 600; tick++) {
                trial.step(world);
                if (ball.velocity().length() > 1e-9) {
                    settled = tick * Trial.TICK;
                }
            }
            // it came to rest between two ticks; which of the two does not count as an error
            double truth = 3 * StrictMath.sqrt(2 / Trial.GRAVITY);
            double off = Math.max(settled - truth, truth - settled - Trial.TICK);
            return new double[] {Math.max(0, off), ball.velocity().length()};
        }
    }

    private static double[] pair(Trial trial) {
        double worst = 0;
        for (double mass : new double[] {1, 10, 100, 1e3, 1e6}) {
            try (PhysicsWorld world = trial.bouncy(0)) {
                Material surface = Trial.surface(0, 1);
                BodyRef light = ball(world, surface, 1, -0.5, 0, 1);
                BodyRef heavy = ball(world, surface, mass, 0, 0, 0);
                trial.run(world, 1);
                double v = (1 - mass) / (1 + mass);
                double w = 2 / (1 + mass);
                worst =
                        Math.max(
                                worst, Math.abs(light.velocity().x - v) / Math.max(1, Math.abs(v)));
                worst = Math.max(worst, Math.abs(heavy.velocity().x - w) / w);
            }
        }
        return new double[] {worst};
    }

    /**
     * The velocities after each collision are known; the engine's count is the one whose velocities
     * are nearest to those it ends with.
     */
    private static double[] pi(Trial trial) {
        int[] truth = {3, 31, 314, 3141};
        double off = 0;
        double energy = 0;
        for (int n = 0; n < truth.length; n++) {
            double mass = StrictMath.pow(100, n);
            try (PhysicsWorld world = trial.bouncy(0)) {
                Material surface = Trial.surface(0, 1);
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(1, 10, 10))
                                .at(-1, 0, 0)
                                .material(surface));
                BodyRef light = ball(world, surface, 1, 0.5, 0, 0);
                BodyRef heavy = ball(world, surface, mass, 1, 0, -1);
                trial.run(world, 4);
                double u = heavy.velocity().x;
                double v = light.velocity().x;
                off = Math.max(off, Math.abs(count(mass, u, v, 2 * truth[n]) - truth[n]));
                energy = Math.max(energy, Math.abs((mass * u * u + v * v) / mass - 1));
            }
        }
        return new double[] {off, energy};
    }

    private static int count(double mass, double engineHeavy, double engineLight, int most) {
        double u = -1;
        double v = 0;
        int best = 0;
        double nearest = Double.POSITIVE_INFINITY;
        for (int n = 0; n <= most; n++) {
            double distance = mass * (u - engineHeavy) * (u - engineHeavy);
            distance += (v - engineLight) * (v - engineLight);
            if (distance < nearest) {
                nearest = distance;
                best = n;
            }
            if (n % 2 == 0) {
                double sum = 2 * (mass * u + v) / (mass + 1);
                u = sum - u;
                v = sum - v;
            } else {
                v = -v;
            }
        }
        return best;
    }

    private static double[] cradle(Trial trial) {
        double apart = Math.max(cradle(trial, 1, 1e-4)[0], cradle(trial, 2, 1e-4)[0]);
        double[] one = cradle(trial, 1, 0);
        double[] two = cradle(trial, 2, 0);
        return new double[] {apart, Math.max(one[1], two[1]), Math.max(one[0], two[0])};
    }

    private static double[] cradle(Trial trial, int coming, double gap) {
        try (PhysicsWorld world = trial.bouncy(0)) {
            Material surface = Trial.surface(0, 1);
            List<BodyRef> balls = new ArrayList<>();
            double pitch = 2 * RADIUS + gap;
            for (int i = 0; i < 5; i++) {
                boolean moves = i < coming;
                balls.add(ball(world, surface, 1, i * pitch - (moves ? 0.3 : 0), 0, moves ? 1 : 0));
            }
            trial.run(world, 1.5);
            double worst = 0;
            double energy = 0;
            for (int i = 0; i < 5; i++) {
                Vector3d v = balls.get(i).velocity();
                energy += v.lengthSquared();
                worst = Math.max(worst, v.distance(i >= 5 - coming ? 1 : 0, 0, 0));
            }
            return new double[] {worst, Math.abs(energy / coming - 1)};
        }
    }

    private static double[] threeBalls(Trial trial) {
        try (PhysicsWorld world = trial.bouncy(0)) {
            Material surface = Trial.surface(0, 1);
            BodyRef cue = ball(world, surface, 1, -1, 0, 1);
            BodyRef left = ball(world, surface, 1, 0, RADIUS, 0);
            BodyRef right = ball(world, surface, 1, 0, -RADIUS, 0);
            trial.run(world, 2);
            double v = 2 * StrictMath.sqrt(3) / 5;
            double vx = v * StrictMath.sqrt(3) / 2;
            Vector3d l = left.velocity();
            Vector3d r = right.velocity();
            double worst =
                    Math.max(
                            cue.velocity().distance(-0.2, 0, 0),
                            Math.max(l.distance(vx, 0, v / 2), r.distance(vx, 0, -v / 2)));
            return new double[] {
                worst, Math.abs(l.x - r.x) + Math.abs(l.z + r.z) + Math.abs(cue.velocity().z)
            };
        }
    }

    private static double[] oblique(Trial trial) {
        double mu = 0.3;
        double e = 0.8;
        double worst = 0;
        for (double vt : new double[] {0.1, 0.5, 1, 1.5, 1.8, 2, 3, 5}) {
            try (PhysicsWorld world = trial.bouncy(0)) {
                Material surface = Trial.surface(mu, e);
                Trial.floor(world, surface);
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(RADIUS))
                                        .at(0, 0.5, 0)
                                        .velocity(vt, -1, 0)
                                        .material(surface));
                trial.run(world, 0.7);
                double slip = Math.max(5.0 / 7 * vt, vt - mu * (1 + e));
                double spin = -2.5 * (vt - slip) / RADIUS;
                worst = Math.max(worst, ball.velocity().distance(slip, e, 0) / slip);
                worst =
                        Math.max(
                                worst,
                                ball.angularVelocity().distance(0, 0, spin) / Math.abs(spin));
            }
        }
        return new double[] {worst};
    }

    private static double[] rodEnd(Trial trial) {
        double angle = StrictMath.toRadians(30);
        double half = 0.005;
        double inertia = 1.0 / 12;
        double worst = 0;
        for (double e : new double[] {0, 0.5, 1}) {
            try (PhysicsWorld world = trial.bouncy(0)) {
                Material surface = Trial.surface(0, e);
                Trial.floor(world, surface);
                BodyRef rod =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.5, half, half))
                                        .mass(1)
                                        .inertia(1e-4, inertia, inertia)
                                        .at(0, 0.5, 0)
                                        .rotationAbout(0, 0, 1, angle)
                                        .velocity(0, -2, 0)
                                        .material(surface));
                while (rod.angularVelocity().lengthSquared() == 0) {
                    trial.step(world);
                }
                trial.step(world);
                // the corner (-0.5, -half) touched; the other end has not come down yet
                double lever = -0.5 * StrictMath.cos(angle) + half * StrictMath.sin(angle);
                double impulse = (1 + e) * 2 / (1 + lever * lever / inertia);
                double spin = lever * impulse / inertia;
                worst = Math.max(worst, rod.velocity().distance(0, impulse - 2, 0) / 2);
                worst =
                        Math.max(
                                worst, rod.angularVelocity().distance(0, 0, spin) / Math.abs(spin));
            }
        }
        return new double[] {worst};
    }

    private static double[] audit(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -Trial.GRAVITY, 0)) {
            Material surface = Trial.surface(0, 0.3);
            Trial.floor(world, surface);
            List<BodyRef> bodies = new ArrayList<>();
            for (int i = 0; i < 40; i++) {
                int layer = i / 3;
                Body body =
                        Body.dynamic()
                                .at(0.3 * (i % 3), 0.6 + 0.9 * layer, 0.25 * (i % 2))
                                .rotationAbout(1, 0.3 * i, 0.5, 0.7 * i)
                                .material(surface)
                                .mass(1 + i % 4);
                body.shape(i % 2 == 0 ? Box.ofHalfExtents(0.2, 0.3, 0.25) : Sphere.of(0.3));
                bodies.add(world.add(body));
            }
            Vector3d[] before = new Vector3d[bodies.size()];
            Vector3d[] impulse = new Vector3d[bodies.size()];
            double[] size = new double[bodies.size()];
            Vector3d n = new Vector3d();
            double worst = 0;
            for (int tick = 0; tick < 120; tick++) {
                for (int i = 0; i < before.length; i++) {
                    before[i] = bodies.get(i).velocity();
                    impulse[i] = new Vector3d();
                    size[i] = 0;
                }
                trial.step(world);
                var contacts = world.contacts();
                for (int c = 0; c < contacts.count(); c++) {
                    double sum = 0;
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        sum += contacts.normalImpulse(c, p);
                    }
                    contacts.normal(c, n);
                    int a = bodies.indexOf(contacts.bodyA(c));
                    int b = bodies.indexOf(contacts.bodyB(c));
                    if (a >= 0) {
                        impulse[a].fma(-sum, n);
                        size[a] += sum;
                    }
                    if (b >= 0) {
                        impulse[b].fma(sum, n);
                        size[b] += sum;
                    }
                }
                for (int i = 0; i < before.length; i++) {
                    double mass = bodies.get(i).mass();
                    Vector3d change = bodies.get(i).velocity().sub(before[i]);
                    change.y += Trial.GRAVITY * Trial.TICK;
                    change.mul(mass);
                    double scale = Math.max(size[i], mass * (1 + before[i].length()));
                    worst = Math.max(worst, change.distance(impulse[i]) / scale);
                }
            }
            return new double[] {worst};
        }
    }
}
