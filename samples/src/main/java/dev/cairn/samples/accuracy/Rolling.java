package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** The rest of group D of the table: dominoes, a disc that rolls on its rim, balls that spin. */
final class Rolling {
    private static final double G = Trial.GRAVITY;

    private Rolling() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "D4",
                        "dominoes",
                        "50 of 0.048 x 0.024 x 0.0075 m, pitch 0.02 m, mu 0.2, e 0; ticks of 1/60"
                                + " and 1/480 s; all lengths times 4",
                        "no closed form: the wave's speed is that of fine steps; lengths x 4 double"
                                + " it",
                        List.of(metric("speed", "", 0.01), metric("speed x 2", "", 0)),
                        "",
                        Effort.MEDIUM,
                        Rolling::dominoes),
                new AccuracyCase(
                        "D6",
                        "Euler's disc",
                        "disc of radius 0.0381 m, 2e-4 m thick, rolling on its rim at alpha 0.1,"
                                + " 0.05, 0.02 rad, mu 1, 0.2 s",
                        "W = sqrt(4 g/(a sin alpha)) of an infinitely thin disc; E does not rise",
                        List.of(metric("precession", "", 0.03), metric("rise of E", "", 1e-9)),
                        "",
                        Effort.MEDIUM,
                        Rolling::disc),
                new AccuracyCase(
                        "D8",
                        "tippe top",
                        "ball of r 0.02 m, centre of mass 0.004 m below its middle, I3/I1 1, spin"
                                + " 100 rad/s, tilt 0.1 rad, mu 0.3, 8 s",
                        "Jellett's L . r to the contact is constant; by ticks of 0.02 ms it slips"
                            + " for half a second, then rolls, and what rolls does not turn over",
                        List.of(
                                metric("slip at the end", "m/s", 1e-3),
                                metric("Jellett's constant", "", 1e-3)),
                        "",
                        Effort.MEDIUM,
                        Rolling::tippeTop),
                new AccuracyCase(
                        "D9",
                        "ball on a turntable",
                        "ball of r 0.1 m rolling on a table that turns at 3 rad/s, at 0.5 and 1 m,"
                                + " mu 1, 5 s",
                        "a circle at 2/7 of the table's rate",
                        List.of(
                                metric("rate", "", 1e-4),
                                metric("radius", "", Double.POSITIVE_INFINITY)),
                        "",
                        Effort.SHORT,
                        Rolling::turntable));
    }

    private static double[] dominoes(Trial trial) {
        double coarse = wave(trial, 1, Trial.TICK);
        double fine = wave(trial, 1, Trial.TICK / 8);
        // lengths x 4 and times x 2 with the same g
        double large = wave(trial, 4, 2 * Trial.TICK);
        return new double[] {Math.abs(coarse / fine - 1), Math.abs(large / (2 * coarse) - 1)};
    }

    /** Speed at which the fall passes from the 10th to the 45th, m/s. */
    private static double wave(Trial trial, double scale, double tick) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.2, 0);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(2 * scale, 0.1 * scale, 0.2 * scale))
                            .at(0.5 * scale, -0.1 * scale, 0)
                            .material(surface));
            List<BodyRef> stones = new ArrayList<>();
            for (int i = 0; i < 50; i++) {
                Body stone =
                        Body.dynamic()
                                .shape(
                                        Box.ofHalfExtents(
                                                0.00375 * scale, 0.024 * scale, 0.012 * scale))
                                .at(0.02 * i * scale, 0.024 * scale, 0)
                                .material(surface);
                if (i == 0) {
                    // about its lower edge
                    double w = 4 / StrictMath.sqrt(scale);
                    stone.angularVelocity(0, 0, -w)
                            .velocity(0.024 * scale * w, 0.00375 * scale * w, 0);
                }
                stones.add(world.add(stone));
            }
            double[] fell = new double[50];
            for (int n = 1; n * tick < 4 * StrictMath.sqrt(scale) && fell[45] == 0; n++) {
                trial.step(world, tick);
                for (int i = 0; i < 50; i++) {
                    // it has turned by a tenth of a radian; between two ticks on a straight line
                    Quaterniond q = stones.get(i).orientation();
                    double angle = -2 * StrictMath.atan2(q.z, q.w);
                    if (fell[i] == 0 && angle > 0.1) {
                        double speed = -stones.get(i).angularVelocity().z;
                        fell[i] = n * tick - (angle - 0.1) / Math.max(speed, 1e-9);
                    }
                }
            }
            return fell[45] > 0 ? 0.02 * scale * 35 / (fell[45] - fell[10]) : Double.NaN;
        }
    }

    private static double[] disc(Trial trial) {
        double a = 0.0381;
        double worst = 0;
        double rise = 0;
        for (double alpha : new double[] {0.1, 0.05, 0.02}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                Material surface = Trial.surface(1, 0);
                Trial.floor(world, surface);
                double half = 1e-4;
                double rate = StrictMath.sqrt(4 * G / (a * StrictMath.sin(alpha)));
                // the lowest point of the rim is at +x: w along the line from the centre to it
                double w = rate * StrictMath.sin(alpha);
                double down = -StrictMath.sin(alpha);
                double along = StrictMath.cos(alpha);
                double height = a * StrictMath.sin(alpha) + half * StrictMath.cos(alpha);
                BodyRef disc =
                        world.add(
                                Body.dynamic()
                                        .shape(Cylinder.of(a, half))
                                        .mass(0.4)
                                        .at(0, height, 0)
                                        .rotationAbout(0, 0, 1, -alpha)
                                        .angularVelocity(w * along, w * down, 0)
                                        .material(surface));
                double energy = world.kineticEnergy() + 0.4 * G * height;
                double least = energy;
                double turned = 0;
                Vector3d axis = new Vector3d();
                double last = 0;
                double truth = 0;
                for (int tick = 1; tick <= 12; tick++) {
                    for (int part = 0; part < 8; part++) {
                        trial.step(world, Trial.TICK / 8);
                        disc.orientation().transform(0, 1, 0, axis);
                        double now = StrictMath.atan2(axis.z, axis.x);
                        double step = now - last;
                        step -= 2 * Math.PI * StrictMath.rint(step / (2 * Math.PI));
                        turned += step;
                        last = now;
                        double tilt = StrictMath.hypot(axis.x, axis.z);
                        truth += StrictMath.sqrt(4 * G / (a * tilt)) * Trial.TICK / 8;
                        double e = world.kineticEnergy() + 0.4 * G * disc.position().y;
                        rise = Math.max(rise, (e - least) / energy);
                        least = Math.min(least, e);
                    }
                }
                worst = Math.max(worst, Math.abs(Math.abs(turned) / truth - 1));
            }
        }
        return new double[] {worst, rise};
    }

    private static double[] tippeTop(Trial trial) {
        double r = 0.02;
        double off = 0.2 * r;
        double mass = 0.02;
        double inertia = 0.4 * mass * r * r;
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.3, 0);
            Trial.floor(world, surface);
            double tilt = 0.1;
            BodyRef top =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(r))
                                    .mass(mass)
                                    .centreOfMass(0, -off, 0)
                                    .inertia(inertia, inertia, inertia)
                                    .at(0, r, 0)
                                    .rotationAbout(0, 0, 1, tilt)
                                    .angularVelocity(
                                            -100 * StrictMath.sin(tilt),
                                            100 * StrictMath.cos(tilt),
                                            0)
                                    .material(surface));
            Vector3d up = new Vector3d();
            double start = jellett(top, inertia, r, off, up);
            double drift = 0;
            for (int tick = 0; tick < 480; tick++) {
                trial.step(world);
                drift = Math.max(drift, Math.abs(jellett(top, inertia, r, off, up) / start - 1));
            }
            Vector3d contact = new Vector3d(up).mul(off).add(0, -r, 0);
            Vector3d slip = top.angularVelocity().cross(contact).add(top.velocity());
            return new double[] {Math.hypot(slip.x, slip.z), drift};
        }
    }

    /** L about the centre of mass, times the way from there to the contact. */
    private static double jellett(BodyRef top, double inertia, double r, double off, Vector3d up) {
        top.orientation().transform(0, 1, 0, up);
        Vector3d contact = new Vector3d(up).mul(off).add(0, -r, 0);
        return inertia * top.angularVelocity().dot(contact);
    }

    private static double[] turntable(Trial trial) {
        double r = 0.1;
        double table = 3;
        double rate = 2 * table / 7;
        double worst = 0;
        double radius = 0;
        for (double far : new double[] {0.5, 1}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                Material surface = Trial.surface(1, 0);
                world.add(
                        Body.kinematic()
                                .shape(Box.ofHalfExtents(3, 0.5, 3))
                                .at(0, -0.5, 0)
                                .angularVelocity(0, table, 0)
                                .material(surface));
                // v = rate y x p, and it rolls: v + w x (0, -r, 0) = table y x p
                double v = -far * rate;
                double slip = v + far * table;
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(r))
                                        .at(far, r, 0)
                                        .velocity(0, 0, v)
                                        .angularVelocity(slip / r, 0, 0)
                                        .material(surface));
                trial.run(world, 5);
                Vector3d p = ball.position();
                double angle = StrictMath.atan2(-p.z, p.x);
                double off = angle - rate * 5;
                off -= 2 * Math.PI * StrictMath.rint(off / (2 * Math.PI));
                worst = Math.max(worst, Math.abs(off) / (rate * 5));
                radius = Math.max(radius, Math.abs(StrictMath.hypot(p.x, p.z) / far - 1));
            }
        }
        return new double[] {worst, radius};
    }
}
