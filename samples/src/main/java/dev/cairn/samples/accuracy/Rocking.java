package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.List;

/** Groups B1 and D of the table: a box at rest, and bodies that rock, tip and spin on an edge. */
final class Rocking {
    private static final double G = Trial.GRAVITY;

    private Rocking() {}

    static List<AccuracyCase> rest() {
        return List.of(
                new AccuracyCase(
                        "B1",
                        "box at rest",
                        "1 m cube of 1e-3, 1, 1e6 kg, 600 s",
                        "y = 0.5, v = 0, mg/4 on each corner",
                        List.of(
                                metric("overlap", "m", 1e-6),
                                metric("speed, rms of the last minute", "m/s", 1e-9),
                                metric("creep after the first second", "m", 1e-9),
                                metric("force of a corner", "", 1e-6)),
                        "30 Hz soft contacts: 7e-5 m [closed form]",
                        Effort.MEDIUM,
                        Rocking::still));
    }

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "D1",
                        "Housner's block",
                        "0.2 x 0.6 x 0.2 m, released at half of its tipping angle",
                        "time to upright by quadrature of th'' = -(3g/4R) sin(alpha - th); speed"
                                + " after an impact 1 - 1.5 sin² alpha = 0.85 of before (Housner"
                                + " 1963)",
                        List.of(
                                metric("time to the first impact", "", 0.005),
                                metric("speed kept, 1st impact", "", 0.01),
                                metric("speed kept, 2nd impact", "", 0.01)),
                        "none for game engines [catalogue]",
                        Effort.SHORT,
                        Rocking::housner),
                new AccuracyCase(
                        "D2",
                        "static tip",
                        "block 0.2 x 0.4 x 0.2 m, mu 1, gravity inclined by atan(0.5) ± 1, 0.3,"
                                + " 0.1, 0.02°, 6 s",
                        "tips above 26.565°, stands below",
                        List.of(metric("smallest margin told apart", "°", 0.02)),
                        "",
                        Effort.SHORT,
                        Rocking::tip),
                new AccuracyCase(
                        "D5",
                        "heavy top",
                        "1 kg cone of 16 sides on its tip, centre 0.1 m up, I 0.0025 kg m², tilt"
                                + " 30°, spin 300 rad/s, mu 1, 5 s",
                        "steady precession, slow root 1.333673 rad/s",
                        List.of(metric("precession", "", 0.002), metric("tilt", "rad", 0.01)),
                        "Box3D needs a hack against drift [catalogue]",
                        Effort.SHORT,
                        Rocking::top));
    }

    private static double[] still(Trial trial) {
        double overlap = 0;
        double rms = 0;
        double creep = 0;
        double force = 0;
        for (double mass : new double[] {1e-3, 1, 1e6}) {
            try (PhysicsWorld world = trial.world(0, -G, 0)) {
                Material surface = Trial.surface(0.6, 0);
                Trial.floor(world, surface);
                BodyRef box =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.5))
                                        .mass(mass)
                                        .at(0, 0.5, 0)
                                        .material(surface));
                trial.run(world, 1);
                Vector3d start = box.position();
                trial.run(world, 539);
                double square = 0;
                Vector3d v = new Vector3d();
                for (int tick = 0; tick < 3600; tick++) {
                    trial.step(world);
                    square += box.velocity(v).lengthSquared() / 3600;
                }
                Vector3d end = box.position();
                rms = Math.max(rms, StrictMath.sqrt(square));
                overlap = Math.max(overlap, Math.abs(end.y - 0.5));
                creep = Math.max(creep, StrictMath.hypot(end.x - start.x, end.z - start.z));
                double corner = mass * G * Trial.TICK / 4;
                for (int p = 0; p < 4; p++) {
                    double impulse =
                            world.contacts().count() == 1 && world.contacts().pointCount(0) == 4
                                    ? world.contacts().normalImpulse(0, p)
                                    : Double.POSITIVE_INFINITY;
                    force = Math.max(force, Math.abs(impulse / corner - 1));
                }
            }
        }
        return new double[] {overlap, rms, creep, force};
    }

    private static double[] housner(Trial trial) {
        double half = 0.1;
        double tall = 0.3;
        double radius = StrictMath.hypot(half, tall);
        double alpha = StrictMath.atan2(half, tall);
        double start = 0.5 * alpha;
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(5, 0);
            Trial.floor(world, surface);
            // turned by start about the edge at x = half, y = 0, clockwise
            double lean = alpha - start;
            BodyRef block =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(half, tall, half))
                                    .at(
                                            half - radius * StrictMath.sin(lean),
                                            radius * StrictMath.cos(lean),
                                            0)
                                    .rotationAbout(0, 0, 1, -start)
                                    .material(surface));
            double first = Double.NaN;
            double[] peaks = new double[3];
            int crossings = 0;
            double last = -start;
            double rate = 0;
            for (int tick = 1; tick <= 180 && crossings < 3; tick++) {
                trial.step(world);
                double angle = lean(block);
                if (angle * last < 0) {
                    if (crossings == 0) {
                        first =
                                (tick - 1) * Trial.TICK
                                        + quarter(radius, alpha, Math.abs(last), Math.abs(rate));
                    }
                    crossings++;
                }
                if (crossings > 0 && crossings < 3) {
                    peaks[crossings] = Math.max(peaks[crossings], Math.abs(angle));
                }
                last = angle;
                rate = block.angularVelocity().z;
            }
            double truth = quarter(radius, alpha, start, 0);
            double[] kept = new double[2];
            double from = start;
            for (int i = 0; i < 2; i++) {
                // ½ I w² = m g R (cos(alpha - peak) - cos alpha)
                double before = StrictMath.cos(alpha - from) - StrictMath.cos(alpha);
                double after = StrictMath.cos(alpha - peaks[i + 1]) - StrictMath.cos(alpha);
                kept[i] = StrictMath.sqrt(after / before);
                from = peaks[i + 1];
            }
            double ratio = 1 - 1.5 * StrictMath.sin(alpha) * StrictMath.sin(alpha);
            return new double[] {
                Math.abs(first / truth - 1),
                Math.abs(kept[0] / ratio - 1),
                Math.abs(kept[1] / ratio - 1)
            };
        }
    }

    /** Turn about z. */
    private static double lean(BodyRef body) {
        Quaterniond q = body.orientation();
        return 2 * StrictMath.atan2(q.z, q.w);
    }

    /** Time until upright of a block that leans by an angle and rights itself, by small steps. */
    private static double quarter(double radius, double alpha, double start, double rate) {
        double k = 3 * G / (4 * radius);
        double angle = start;
        double speed = -rate;
        double h = 1e-6;
        int n = 0;
        while (angle > 0) {
            double middle = angle + 0.5 * h * speed;
            speed -= h * k * StrictMath.sin(alpha - middle);
            angle += h * speed;
            n++;
        }
        return n * h - angle / speed;
    }

    private static double[] tip(Trial trial) {
        double[] margins = {1, 0.3, 0.1, 0.02};
        double smallest = 90;
        for (double margin : margins) {
            if (tips(trial, -margin) || !tips(trial, margin)) {
                break;
            }
            smallest = margin;
        }
        return new double[] {smallest};
    }

    private static boolean tips(Trial trial, double degreesMore) {
        double a = StrictMath.atan(0.5) + StrictMath.toRadians(degreesMore);
        try (PhysicsWorld world = trial.world(G * StrictMath.sin(a), -G * StrictMath.cos(a), 0)) {
            Material surface = Trial.surface(1, 0);
            Trial.floor(world, surface);
            BodyRef block =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.1, 0.2, 0.1))
                                    .at(0, 0.2, 0)
                                    .material(surface));
            trial.run(world, 6);
            return Math.abs(lean(block)) > 0.1;
        }
    }

    private static double[] top(Trial trial) {
        double tilt = StrictMath.toRadians(30);
        double length = 0.1;
        double inertia = 0.0025;
        double spin = 300;
        // I1 cos W² - I3 w3 W + m g l = 0, I1 about the tip, w3 along the axis: the slow root
        double a = (inertia + length * length) * StrictMath.cos(tilt);
        double b = inertia * spin;
        double c = G * length;
        double rate = 2 * c / (b + StrictMath.sqrt(b * b - 4 * a * c));
        double[] corners = new double[3 * 17];
        double height = length / 0.75;
        for (int i = 0; i < 16; i++) {
            double angle = 2 * StrictMath.PI * i / 16;
            corners[3 * i] = 0.05 * StrictMath.cos(angle);
            corners[3 * i + 1] = height;
            corners[3 * i + 2] = 0.05 * StrictMath.sin(angle);
        }
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(1, 0);
            Trial.floor(world, surface);
            Vector3d axis = new Vector3d(StrictMath.sin(tilt), StrictMath.cos(tilt), 0);
            // w = w3 e3 + W (up - cos e3): the axis circles the vertical at W
            Vector3d w = new Vector3d(0, rate, 0).fma(spin - rate * StrictMath.cos(tilt), axis);
            Vector3d v = w.cross(new Vector3d(axis).mul(length), new Vector3d());
            BodyRef top =
                    world.add(
                            Body.dynamic()
                                    .shape(ConvexHull.of(corners))
                                    .mass(1)
                                    .inertia(inertia, inertia, inertia)
                                    .rotationAbout(0, 0, 1, -tilt)
                                    .angularVelocity(w.x, w.y, w.z)
                                    .velocity(v.x, v.y, v.z)
                                    .material(surface));
            double turned = 0;
            double last = 0;
            double off = 0;
            for (int tick = 1; tick <= 300; tick++) {
                trial.step(world);
                Vector3d now = top.orientation().transform(new Vector3d(0, 1, 0));
                double angle = StrictMath.atan2(-now.z, now.x);
                turned += StrictMath.IEEEremainder(angle - last, 2 * StrictMath.PI);
                last = angle;
                off = Math.max(off, Math.abs(StrictMath.acos(now.y) - tilt));
            }
            return new double[] {Math.abs(turned / (300 * Trial.TICK) / rate - 1), off};
        }
    }
}
