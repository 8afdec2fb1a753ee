package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.SplittableRandom;

/** Slender things that turn by several radians a tick and are struck: energy and momenta. */
final class WhirlingTest {
    private static final long SEED = 20261126;

    /** Three moments, and two equal ones. */
    private static final Shape[] STICKS = {
        Box.ofHalfExtents(0.03, 0.0012, 0.0009), Cylinder.of(0.0012, 0.03)
    };

    private static PhysicsWorld space(int substeps) {
        return PhysicsWorld.builder()
                .gravity(0, 0, 0)
                .workers(1)
                .settings(PhysicsSettings.DEFAULT.withSubsteps(substeps).withSleeping(false))
                .build();
    }

    private static Vector3d direction(SplittableRandom random) {
        Vector3d v = new Vector3d();
        do {
            v.set(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        } while (!(v.lengthSquared() < 1 && v.lengthSquared() > 0.01));
        return v.normalize();
    }

    /**
     * A stick that tumbles by up to 10 rad a tick is struck by a ball, until the end of that tick:
     * momenta are kept to rounding, with and without friction, however often they meet; energy does
     * not rise, and where they bounce without loss it is what it was. Who does not bounce stays in
     * touch in one round of fifteen, and is the solver's, with a point on each body.
     */
    @ParameterizedTest(name = "bounce {0}, friction {1}, {2} sub-steps")
    @CsvSource({"1, 0, 4, 1e-12", "1, 0, 1, 1e-12", "0.6, 0.5, 4, 1e-12", "0, 0.5, 4, 0.05"})
    void aStickThatIsStruckKeepsMomenta(double bounce, double friction, int substeps, double most) {
        System.out.println("seed " + SEED);
        SplittableRandom random = new SplittableRandom(SEED);
        Material material = Material.DEFAULT.withRestitution(bounce).withFriction(friction);
        double linear = 0;
        double angular = 0;
        double gain = -1;
        double loss = 0;
        int struck = 0;
        for (int round = 0; round < 100; round++) {
            try (PhysicsWorld world = space(substeps)) {
                Quaterniond turn =
                        new Quaterniond().rotateAxis(3 * random.nextDouble(), direction(random));
                Vector3d spin = direction(random).mul(600 * random.nextDouble());
                BodyRef stick =
                        world.add(
                                Body.dynamic()
                                        .shape(STICKS[round % 2])
                                        .rotation(turn)
                                        .angularVelocity(spin.x, spin.y, spin.z)
                                        .material(material)
                                        .mass(1));
                Vector3d at = direction(random).mul(0.06);
                Vector3d to = at.negate(new Vector3d()).mul(10 + 20 * random.nextDouble());
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.01))
                                        .at(at.x, at.y, at.z)
                                        .velocity(to.x, to.y, to.z)
                                        .material(material)
                                        .mass(0.001 + random.nextDouble()));
                Vector3d momentum = momentum(world);
                Vector3d turning = angularMomentum(world);
                double size = size(stick) + size(ball);
                double energy = world.kineticEnergy();
                for (int tick = 0; tick < 20 && !(ball.velocity().distance(to) > 1e-9); tick++) {
                    world.step(1.0 / 60);
                }
                struck += ball.velocity().distance(to) > 1e-9 ? 1 : 0;
                linear = Math.max(linear, momentum(world).distance(momentum) / momentum.length());
                angular = Math.max(angular, angularMomentum(world).distance(turning) / size);
                gain = Math.max(gain, world.kineticEnergy() / energy - 1);
                loss = Math.max(loss, 1 - world.kineticEnergy() / energy);
            }
        }
        String is =
                "struck %d, momentum %s, angular %s, energy +%s -%s"
                        .formatted(struck, linear, angular, gain, loss);
        System.out.println(is);
        assertTrue(struck > 50, is);
        assertTrue(linear < 1e-12, is);
        assertTrue(angular < most, is);
        assertTrue(gain < 1e-12, is);
        assertTrue(bounce < 1 || loss < 1e-12, is);
    }

    private static double size(BodyRef body) {
        Vector3d spin =
                body.inverseInertia(new Matrix3d()).invert().transform(body.angularVelocity());
        return spin.length() + body.mass() * body.velocity().length() * 0.06;
    }

    private static Vector3d momentum(PhysicsWorld world) {
        Kinetics k = world.kinetics();
        return new Vector3d(k.momentumX(), k.momentumY(), k.momentumZ());
    }

    private static Vector3d angularMomentum(PhysicsWorld world) {
        Kinetics k = world.kinetics();
        return new Vector3d(k.angularMomentumX(), k.angularMomentumY(), k.angularMomentumZ());
    }
}
