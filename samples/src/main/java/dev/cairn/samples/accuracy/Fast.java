package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Motion;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;
import dev.cairn.samples.accuracy.AccuracyCase.Metric;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Group F of the table: what is fast or spins, and floors of pieces. */
final class Fast {
    private static final double G = Trial.GRAVITY;
    private static final double[] BULLET_SPEEDS = {10, 100, 1e3, 1e4, 1e5};

    private static final List<Metric> BULLETS =
            List.of(
                    metric("passed", "", 0),
                    metric("passed the free wall", "", 0),
                    metric("p of ball and free wall", "", 1e-12));

    private Fast() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "F1",
                        "bullet and wall",
                        "balls of r 0.01 m at 10 to 1e5 m/s against a fixed wall of 1 mm, 1000 of"
                                + " random offsets; one against a wall of 1 kg that is free, e 1",
                        "none passes; p constant",
                        BULLETS,
                        "Box3D sweeps against what is fixed only, by default [catalogue]",
                        Effort.MEDIUM,
                        trial -> bullets(trial, 1)),
                new AccuracyCase(
                        "F1-1e6",
                        "a million bullets",
                        "the same 1000 times: 1e6 balls against the fixed wall, 5e4 against one"
                                + " that is free",
                        "none passes; p constant",
                        BULLETS,
                        "",
                        Effort.LONG,
                        trial -> bullets(trial, 1000)),
                new AccuracyCase(
                        "F2",
                        "time of impact",
                        "a falling ball, e 1, on a plane, and on a ball; queries of a ball and of a"
                                + " tumbling box's corner under gravity",
                        "roots of a quadratic; of the corner by halving",
                        List.of(
                                metric("time, ball on a plane", "s", 1e-10),
                                metric("time, ball on a ball", "s", 1e-10),
                                metric("time by query", "s", 1e-10)),
                        "",
                        Effort.SHORT,
                        Fast::times),
                new AccuracyCase(
                        "F3",
                        "spinning rod",
                        "rod 4 x 0.04 x 0.04 m, 10 kg, about its middle at 120 rad/s; a ball of r"
                                + " 0.1 m, 1 kg, at rest in its way, 200 places; e 1",
                        "J = 2 w x/(1/m + 1/M + x²/I), x the lever, for each blow of the tick: a"
                                + " ball near the middle is struck twice",
                        List.of(metric("missed", "", 0), metric("J", "", 0.01)),
                        "",
                        Effort.MEDIUM,
                        trial -> rod(trial, 200)),
                new AccuracyCase(
                        "F3-1e4",
                        "ten thousand blows",
                        "the same at 1e4 places",
                        "the same",
                        List.of(metric("missed", "", 0), metric("J", "", 0.01)),
                        "",
                        Effort.LONG,
                        trial -> rod(trial, 10_000)),
                new AccuracyCase(
                        "F4",
                        "gas in a box",
                        "1000 balls of r 0.2 m, e 1, 50 m/s rms, no gravity, 60 s, walls of 0.1 m",
                        "none leaves; E constant",
                        List.of(metric("leaks", "", 0), metric("E", "", 1e-9)),
                        "",
                        Effort.HEAVY,
                        Fast::gas),
                new AccuracyCase(
                        "F5",
                        "box on tiles",
                        "box 0.5 m at 5 m/s over 100 flush tiles of 0.25 m, mu 0.1",
                        "v = v0 - mu g t, straight",
                        List.of(
                                metric("vertical kick", "m/s", 1e-6),
                                metric("speed", "", 1e-6),
                                metric("aside", "m/s", 1e-6)),
                        "",
                        Effort.SHORT,
                        Fast::tiles),
                new AccuracyCase(
                        "F6",
                        "bullet into a stack",
                        "ball of r 0.05 m, 0.1 kg, at 300 m/s into five boxes of 0.3 m and 1 kg"
                                + " beside each other, e 0, no gravity, 0.5 s",
                        "p constant; the centre of all goes on at p/M, no time is lost",
                        List.of(
                                metric("lag, in ways of a sub-step", "", 1),
                                metric("p", "", 1e-12)),
                        "",
                        Effort.SHORT,
                        Fast::stack),
                new AccuracyCase(
                        "F7",
                        "near miss",
                        "ball and cube pass an edge at clearances of 1e-9 to 1e-2 of their size, 2"
                                + " to 1000 m/s",
                        "not deflected",
                        List.of(metric("deflection", "m/s", 0)),
                        "",
                        Effort.SHORT,
                        Fast::misses));
    }

    /** Rounds of 1000 balls against what is fixed, and of 50 against what is free. */
    private static double[] bullets(Trial trial, int rounds) {
        SplittableRandom random = new SplittableRandom(21);
        double[] found = new double[3];
        for (int round = 0; round < rounds; round++) {
            for (double speed : BULLET_SPEEDS) {
                found[0] += volley(trial, random, speed);
            }
            for (double speed : BULLET_SPEEDS) {
                for (int i = 0; i < 10; i++) {
                    strikeFreeWall(trial, random, speed, found);
                }
            }
        }
        return found;
    }

    /** Of 200 balls, how many pass a fixed wall. */
    private static int volley(Trial trial, SplittableRandom random, double speed) {
        int passed = 0;
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.0005, 10, 10)));
            List<BodyRef> balls = new ArrayList<>();
            for (int i = 0; i < 200; i++) {
                double far = 0.02 + random.nextDouble() * speed / 60;
                balls.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.01))
                                        .at(-far, 0.2 * (i % 20 - 10), 0.2 * (i / 20 - 5))
                                        .velocity(speed, 0, 0)));
            }
            trial.run(world, 4 * Trial.TICK);
            for (BodyRef ball : balls) {
                passed += ball.position().x > 0 ? 1 : 0;
            }
        }
        return passed;
    }

    /** Counts who passes a free wall, and keeps the worst momentum, in places 1 and 2. */
    private static void strikeFreeWall(
            Trial trial, SplittableRandom random, double speed, double[] found) {
        try (PhysicsWorld world = trial.bouncy(0)) {
            Material surface = Trial.surface(0, 1);
            BodyRef wall =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.0005, 1, 1))
                                    .mass(1)
                                    .material(surface));
            double far = 0.02 + random.nextDouble() * speed / 60;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.01))
                                    .mass(0.01)
                                    .at(-far, 0, 0)
                                    .velocity(speed, 0, 0)
                                    .material(surface));
            trial.run(world, 4 * Trial.TICK);
            double p = 0.01 * ball.velocity().x + wall.velocity().x;
            found[1] += ball.position().x > wall.position().x ? 1 : 0;
            found[2] = Math.max(found[2], Math.abs(p / (0.01 * speed) - 1));
        }
    }

    private static double[] times(Trial trial) {
        double plane = 0;
        double balls = 0;
        for (int i = 0; i < 20; i++) {
            double height = 0.3 + 0.137 * i;
            plane = Math.max(plane, Math.abs(bounce(trial, height, false)));
            balls = Math.max(balls, Math.abs(bounce(trial, height, true)));
        }
        return new double[] {plane, balls, queries()};
    }

    /**
     * How late a ball bounces, by its flight afterwards: with v at height y above the bounce, it
     * left with u = sqrt(v² + 2 g y), (u - v)/g ago.
     */
    private static double bounce(Trial trial, double height, boolean onBall) {
        try (PhysicsWorld world = trial.bouncy(-G)) {
            Material surface = Trial.surface(0, 1);
            Body ground = Body.fixed().material(surface);
            world.add(
                    onBall
                            ? ground.shape(Sphere.of(0.5)).at(0, -0.5, 0)
                            : ground.shape(HalfSpace.of()));
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.1))
                                    .at(0, 0.1 + height, 0)
                                    .material(surface));
            double truth = StrictMath.sqrt(2 * height / G);
            double t = 0;
            while (t <= truth) {
                trial.step(world);
                t += Trial.TICK;
            }
            double y = ball.position().y - 0.1;
            double v = ball.velocity().y;
            return t - (StrictMath.sqrt(v * v + 2 * G * y) - v) / G - truth;
        }
    }

    private static double queries() {
        ShapeQueries queries = new ShapeQueries();
        Placement mover = new Placement();
        Placement ground = new Placement().set(HalfSpace.of(), 0, 0, 0);
        Motion fall = new Motion().acceleration(0, -G, 0);
        Hit hit = new Hit();
        double worst = 0;
        for (int i = 0; i < 20; i++) {
            double height = 0.3 + 0.137 * i;
            mover.set(Sphere.of(0.1), 0.3, 0.1 + height, 0.2);
            fall.velocity(1, 0, 2).angularVelocity(0, 0, 0);
            double truth = StrictMath.sqrt(2 * height / G);
            double found = queries.turningCast(mover, fall, 9, ground, hit) ? hit.seconds() : 9;
            worst = Math.max(worst, Math.abs(found - truth));
            double spin = 3 + i;
            mover.set(Box.ofHalfExtents(0.3, 0.2, 0.25), 0, 0.5 + height, 0);
            fall.angularVelocity(0, 0, spin);
            found = queries.turningCast(mover, fall, 9, ground, hit) ? hit.seconds() : 9;
            worst = Math.max(worst, Math.abs(found - corner(0.5 + height, spin)));
        }
        return worst;
    }

    /** When the lowest corner of a box that turns about z reaches 0, by steps and halving. */
    private static double corner(double height, double spin) {
        double low = 0;
        double step = 1e-4;
        while (corner(height, spin, low + step) > 0) {
            low += step;
        }
        double high = low + step;
        for (int k = 0; k < 60; k++) {
            double mid = (low + high) / 2;
            if (corner(height, spin, mid) > 0) {
                low = mid;
            } else {
                high = mid;
            }
        }
        return high;
    }

    private static double corner(double height, double spin, double t) {
        return height
                - G * t * t / 2
                - 0.3 * Math.abs(StrictMath.sin(spin * t))
                - 0.2 * Math.abs(StrictMath.cos(spin * t));
    }

    private static double[] rod(Trial trial, int places) {
        SplittableRandom random = new SplittableRandom(23);
        double missed = 0;
        double worst = 0;
        RodReference truth = new RodReference();
        for (int i = 0; i < places; i++) {
            double x = 0.5 + 1.4 * random.nextDouble();
            // the rod meets the ball, whose side reaches this far ahead, not at once
            double ahead = StrictMath.asin(0.12 / x);
            double angle = ahead + 0.05 + (Math.PI - 2 * ahead - 0.1) * random.nextDouble();
            try (PhysicsWorld world = trial.bouncy(0)) {
                Material surface = Trial.surface(0, 1);
                BodyRef rod =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(2, 0.02, 0.02))
                                        .mass(10)
                                        .angularVelocity(0, 0, 120)
                                        .material(surface));
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.1))
                                        .mass(1)
                                        .at(x * StrictMath.cos(angle), x * StrictMath.sin(angle), 0)
                                        .material(surface));
                truth.begin(120, x * StrictMath.cos(angle), x * StrictMath.sin(angle));
                for (int tick = 0; tick < 4 && ball.velocity().lengthSquared() == 0; tick++) {
                    trial.step(world);
                    truth.run(Trial.TICK);
                }
                if (ball.velocity().length() == 0) {
                    missed++;
                }
                worst = Math.max(worst, truth.error(ball.velocity(), rod.angularVelocity().z));
            }
        }
        return new double[] {missed, worst};
    }

    private static double[] gas(Trial trial) {
        try (PhysicsWorld world = trial.bouncy(0)) {
            Material surface = Trial.surface(0, 1);
            for (int i = 0; i < 6; i++) {
                double side = (i % 2 == 0 ? -1 : 1) * 6.05;
                int axis = i / 2;
                world.add(
                        Body.fixed()
                                .shape(
                                        Box.ofHalfExtents(
                                                axis == 0 ? 0.05 : 6.1,
                                                axis == 1 ? 0.05 : 6.1,
                                                axis == 2 ? 0.05 : 6.1))
                                .at(
                                        axis == 0 ? side : 0,
                                        axis == 1 ? side : 0,
                                        axis == 2 ? side : 0)
                                .material(surface));
            }
            SplittableRandom random = new SplittableRandom(24);
            List<BodyRef> balls = new ArrayList<>();
            // uniform in -a to a along three axes has the rms a
            for (int i = 0; i < 1000; i++) {
                int layer = i / 100;
                balls.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.2))
                                        .mass(1)
                                        .at(
                                                1.1 * (i % 10 - 4.5),
                                                1.1 * (i / 10 % 10 - 4.5),
                                                1.1 * (layer - 4.5))
                                        .velocity(
                                                50 * (2 * random.nextDouble() - 1),
                                                50 * (2 * random.nextDouble() - 1),
                                                50 * (2 * random.nextDouble() - 1))
                                        .material(surface)));
            }
            double start = world.kineticEnergy();
            trial.run(world, 60);
            double leaks = 0;
            Vector3d p = new Vector3d();
            for (BodyRef ball : balls) {
                ball.position(p);
                double out = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
                leaks += out < 6 ? 0 : 1;
            }
            return new double[] {leaks, Math.abs(world.kineticEnergy() / start - 1)};
        }
    }

    private static double[] tiles(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.1, 0);
            for (int i = 0; i < 100; i++) {
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(0.125, 0.25, 2))
                                .at(0.25 * i - 1, -0.25, 0)
                                .material(surface));
            }
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.25))
                                    .at(0, 0.25, 0)
                                    .velocity(5, 0, 0)
                                    .material(surface));
            double kick = 0;
            double speed = 0;
            double aside = 0;
            for (int tick = 1; tick <= 240; tick++) {
                trial.step(world);
                Vector3d v = box.velocity();
                kick = Math.max(kick, Math.abs(v.y));
                double truth = 5 - 0.1 * G * tick * Trial.TICK;
                speed = Math.max(speed, Math.abs(v.x / truth - 1));
                aside = Math.max(aside, Math.abs(v.z));
            }
            return new double[] {kick, speed, aside};
        }
    }

    private static double[] stack(Trial trial) {
        double lag = 0;
        double momentum = 0;
        double speed = 300;
        for (int i = 0; i < 10; i++) {
            try (PhysicsWorld world = trial.world(0, 0, 0)) {
                Material surface = Trial.surface(0, 0);
                List<BodyRef> bodies = new ArrayList<>();
                double start = -0.3 - 0.05 - (0.5 + 0.1 * i) * speed * Trial.TICK;
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.05))
                                        .mass(0.1)
                                        .at(start, 0, 0)
                                        .velocity(speed, 0, 0)
                                        .material(surface)));
                double sum = 0.1 * start;
                for (int k = 0; k < 5; k++) {
                    bodies.add(
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.cubeOfHalfExtent(0.15))
                                            .mass(1)
                                            .at(0.3 * k, 0, 0)
                                            .material(surface)));
                    sum += 0.3 * k;
                }
                double t = 0;
                double way = speed * Trial.TICK / trial.substeps();
                for (int tick = 1; tick <= 30; tick++) {
                    trial.step(world);
                    t += Trial.TICK;
                    double p = 0;
                    double x = 0;
                    for (int k = 0; k < bodies.size(); k++) {
                        p += (k == 0 ? 0.1 : 1) * bodies.get(k).velocity().x;
                        x += (k == 0 ? 0.1 : 1) * bodies.get(k).position().x;
                    }
                    momentum = Math.max(momentum, Math.abs(p / (0.1 * speed) - 1));
                    // as a way that the bullet lost
                    double lost = (sum + 0.1 * speed * t - x) / 0.1;
                    lag = Math.max(lag, Math.abs(lost) / way);
                }
            }
        }
        return new double[] {lag, momentum};
    }

    private static double[] misses(Trial trial) {
        double size = 0.1;
        double worst = 0;
        for (double clearance : new double[] {1e-9, 1e-7, 1e-5, 1e-3, 1e-2}) {
            for (double speed : new double[] {2, 20, 100, 1000}) {
                for (int kind = 0; kind < 2; kind++) {
                    try (PhysicsWorld world = trial.world(0, 0, 0)) {
                        world.add(
                                Body.fixed()
                                        .shape(Box.ofHalfExtents(0.5, 0.5, 0.5))
                                        .at(0, -0.5, 0));
                        BodyRef body =
                                world.add(
                                        Body.dynamic()
                                                .shape(
                                                        kind == 0
                                                                ? Sphere.of(size)
                                                                : Box.cubeOfHalfExtent(size))
                                                .at(
                                                        -0.5 - 0.31 * speed / 60,
                                                        size + clearance * size,
                                                        0.1)
                                                .velocity(speed, 0, 0.1 * speed));
                        trial.run(world, 1);
                        worst = Math.max(worst, body.velocity().distance(speed, 0, 0.1 * speed));
                    }
                }
            }
        }
        return new double[] {worst};
    }
}
