package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Vector3d;

import java.util.List;
import java.util.SplittableRandom;

/** Group I of the table: energy and momentum. */
final class Conservation {
    private static final double G = Trial.GRAVITY;

    private Conservation() {}

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "I1",
                        "gas",
                        "1000 balls, e 1, frictionless, no gravity: in a box for 60 s, and a free"
                                + " blob for 10 s",
                        "E constant; of the blob p and L too",
                        List.of(
                                metric("E in the box", "", 1e-10),
                                metric("p of the blob", "", 1e-13),
                                metric("L of the blob", "", 1e-13)),
                        "",
                        Effort.HEAVY,
                        Conservation::gas),
                new AccuracyCase(
                        "I2",
                        "cluster",
                        "200 boxes fly together, e 0, mu 0.5, no gravity, 4 s",
                        "p and L constant, E never rises",
                        List.of(
                                metric("p", "", 1e-12),
                                metric("L", "", 1e-12),
                                metric("rise of E in a tick", "", 1e-9)),
                        "",
                        Effort.MEDIUM,
                        Conservation::cluster),
                new AccuracyCase(
                        "I3",
                        "passivity",
                        "60 boxes and balls fall in a heap, e 0, mu 0.6, 10 s",
                        "E never above what it was before",
                        List.of(metric("rise of E over its least", "", 1e-9)),
                        "",
                        Effort.MEDIUM,
                        Conservation::passivity));
    }

    private static double[] gas(Trial trial) {
        double box;
        try (PhysicsWorld world = trial.bouncy(0)) {
            Material surface = Trial.surface(0, 1);
            for (int i = 0; i < 6; i++) {
                double side = (i % 2 == 0 ? -1 : 1) * 7;
                world.add(
                        Body.fixed()
                                .shape(
                                        Box.ofHalfExtents(
                                                i / 2 == 0 ? 1 : 8,
                                                i / 2 == 1 ? 1 : 8,
                                                i / 2 == 2 ? 1 : 8))
                                .at(
                                        i / 2 == 0 ? side : 0,
                                        i / 2 == 1 ? side : 0,
                                        i / 2 == 2 ? side : 0)
                                .material(surface));
            }
            balls(world, surface, 1.1);
            double start = world.kineticEnergy();
            trial.run(world, 60);
            box = Math.abs(world.kineticEnergy() / start - 1);
        }
        try (PhysicsWorld world = trial.bouncy(0)) {
            balls(world, Trial.surface(0, 1), 0.5);
            Kinetics start = world.kinetics();
            trial.run(world, 10);
            Kinetics end = world.kinetics();
            // sizes: 1000 balls of 1 kg at some m/s, 5 m from the centre
            return new double[] {
                box,
                momentum(start).distance(momentum(end)) / 2000,
                spin(start).distance(spin(end)) / 10000
            };
        }
    }

    private static void balls(PhysicsWorld world, Material surface, double pitch) {
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < 1000; i++) {
            int layer = i / 100;
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(0.2))
                            .mass(1)
                            .at(
                                    pitch * (i % 10 - 4.5),
                                    pitch * (i / 10 % 10 - 4.5),
                                    pitch * (layer - 4.5))
                            .velocity(
                                    4 * random.nextDouble() - 2,
                                    4 * random.nextDouble() - 2,
                                    4 * random.nextDouble() - 2)
                            .material(surface));
        }
    }

    private static Vector3d momentum(Kinetics k) {
        return new Vector3d(k.momentumX(), k.momentumY(), k.momentumZ());
    }

    private static Vector3d spin(Kinetics k) {
        return new Vector3d(k.angularMomentumX(), k.angularMomentumY(), k.angularMomentumZ());
    }

    private static double[] cluster(Trial trial) {
        try (PhysicsWorld world = trial.world(0, 0, 0)) {
            Material surface = Trial.surface(0.5, 0);
            SplittableRandom random = new SplittableRandom(12);
            double size = 0;
            double turn = 0;
            for (int i = 0; i < 200; i++) {
                int layer = i / 36;
                Vector3d at =
                        new Vector3d(i % 6 - 2.5, i / 6 % 6 - 2.5, layer - 2.5)
                                .mul(1.2)
                                .add(0.1 * random.nextDouble(), 0.1 * random.nextDouble(), 0);
                Vector3d v = new Vector3d(at).mul(-1);
                BodyRef body =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.3, 0.25, 0.2))
                                        .mass(1 + i % 3)
                                        .at(at.x, at.y, at.z)
                                        .rotationAbout(1, 0.5, random.nextDouble(), i)
                                        .velocity(v.x, v.y, v.z)
                                        .angularVelocity(
                                                random.nextDouble(),
                                                random.nextDouble(),
                                                random.nextDouble())
                                        .material(surface));
                size += body.mass() * v.length();
                turn += body.mass() * v.length() * at.length();
            }
            Kinetics start = world.kinetics();
            double energy = start.kineticEnergy();
            double rise = 0;
            for (int tick = 0; tick < 240; tick++) {
                trial.step(world);
                double now = world.kineticEnergy();
                rise = Math.max(rise, now - energy);
                energy = now;
            }
            Kinetics end = world.kinetics();
            return new double[] {
                momentum(start).distance(momentum(end)) / size,
                spin(start).distance(spin(end)) / turn,
                rise / start.kineticEnergy()
            };
        }
    }

    private static double[] passivity(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.6, 0);
            Trial.floor(world, surface);
            for (int i = 0; i < 60; i++) {
                Body body =
                        Body.dynamic()
                                .at(0.4 * (i % 3), 1 + 0.7 * i, 0.35 * (i % 2))
                                .rotationAbout(1, 0.3, 0.1 * i, i)
                                .material(surface);
                body.shape(i % 3 == 2 ? Sphere.of(0.3) : Box.ofHalfExtents(0.4, 0.3, 0.25));
                world.add(body);
            }
            double start = energy(world);
            double least = start;
            double rise = 0;
            for (int tick = 0; tick < 600; tick++) {
                trial.step(world);
                double now = energy(world);
                rise = Math.max(rise, now - least);
                least = Math.min(least, now);
            }
            return new double[] {rise / start};
        }
    }

    /** Kinetic and potential energy, J. */
    private static double energy(PhysicsWorld world) {
        double sum = world.kineticEnergy();
        for (BodyRef body : world.bodies()) {
            sum += body.isFixed() ? 0 : body.mass() * G * body.centreOfMass(new Vector3d()).y;
        }
        return sum;
    }
}
