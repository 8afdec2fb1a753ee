package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/**
 * Two bodies in space that meet in the middle of a tick, while they turn by up to a radian: they
 * press at one point. Theirs were apart when the tick began, by what they pass each other until
 * they meet, and an impulse at each made up to a quarter of their angular momentum.
 */
class MeetingsTest {
    private static final int PAIRS = 600;
    private static final double STEP = 1.0 / 60;

    /** Pairs that met, of these those that made angular momentum, and how much. */
    private int met, made;

    private double worst;

    private static Shape shape(SplittableRandom random) {
        double a = 0.05 + 0.1 * random.nextDouble();
        double b = 0.05 + 0.1 * random.nextDouble();
        return switch (random.nextInt(4)) {
            case 0 -> Sphere.of(a);
            case 1 -> Capsule.of(a, b);
            case 2 -> Cylinder.of(a, b);
            default -> Box.ofHalfExtents(a, b, 0.05 + 0.1 * random.nextDouble());
        };
    }

    private static Vector3d vector(SplittableRandom random, double size) {
        double x = random.nextDouble() - 0.5;
        double y = random.nextDouble() - 0.5;
        double z = random.nextDouble() - 0.5;
        return new Vector3d(x, y, z).normalize(size * random.nextDouble());
    }

    private static void add(
            PhysicsWorld world,
            SplittableRandom random,
            Vector3d at,
            Vector3d velocity,
            double restitution) {
        Vector3d spin = vector(random, 60);
        world.add(
                Body.dynamic()
                        .shape(shape(random))
                        .material(new Material(random.nextDouble(), restitution, 1000))
                        .at(at.x, at.y, at.z)
                        .rotation(new Quaterniond().rotateXYZ(spin.x, spin.y, spin.z))
                        .velocity(velocity.x, velocity.y, velocity.z)
                        .angularVelocity(spin.x, spin.y, spin.z));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void bodiesThatMeetWithinATickMakeNoAngularMomentum(int substeps) {
        run(substeps, 0);
        assertTrue(met > PAIRS / 2, "met: " + met);
        // the bound of energy takes of the common turn where nothing else is left to take
        assertTrue(made <= met / 50, "made: " + made);
        assertTrue(worst < 0.1, "worst: " + worst);
    }

    /** Each impact has the levers of its own time. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void bouncesMakeNone(double restitution) {
        run(4, restitution);
        assertTrue(met > PAIRS / 2, "met: " + met);
        assertTrue(made <= met / 20, "made: " + made);
        assertTrue(worst < 0.02, "worst: " + worst);
    }

    private void run(int substeps, double restitution) {
        SplittableRandom random = new SplittableRandom(20261201);
        for (int pair = 0; pair < PAIRS; pair++) {
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .workers(1)
                            .gravity(0, 0, 0)
                            .substeps(substeps)
                            .sleeping(false)
                            .build()) {
                Vector3d at = vector(random, 0.2).add(0.4, 0, 0);
                Vector3d velocity = vector(random, 6).add(-20 * random.nextDouble(), 0, 0);
                add(world, random, new Vector3d(), new Vector3d(), restitution);
                add(world, random, at, velocity, restitution);
                Kinetics before = world.kinetics();
                double energy = world.kineticEnergy();
                for (int tick = 0; tick < 3; tick++) {
                    world.step(STEP);
                }
                met += world.kineticEnergy() < 0.999 * energy ? 1 : 0;
                Kinetics now = world.kinetics();
                double change =
                        new Vector3d(
                                        now.angularMomentumX() - before.angularMomentumX(),
                                        now.angularMomentumY() - before.angularMomentumY(),
                                        now.angularMomentumZ() - before.angularMomentumZ())
                                .length();
                double size =
                        new Vector3d(before.momentumX(), before.momentumY(), before.momentumZ())
                                        .length()
                                * 0.4;
                worst = Math.max(worst, change / size);
                made += change > 1e-9 * size ? 1 : 0;
            }
        }
        System.out.printf(
                "%d sub-steps: of %d that met %d made angular momentum, worst %.3g%n",
                substeps, met, made, worst);
    }
}
