package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/** Slender things that turn by several rounds a tick and strike others: energy and momenta. */
final class WhirlingTest {
    private static final long SEED = 20261126;

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
     * A stick of unlike sides tumbles by up to 10 rad a tick, and strikes balls and sticks. Angular
     * momentum is not kept, see {@code docs/laws.md}.
     */
    @ParameterizedTest(name = "{0} sub-steps")
    @ValueSource(ints = {1, 4})
    void aTumblingStickGainsNothing(int substeps) {
        System.out.println("seed " + SEED);
        SplittableRandom random = new SplittableRandom(SEED);
        double worst = 0;
        double gain = 0;
        int struck = 0;
        for (int round = 0; round < 100; round++) {
            try (PhysicsWorld world = space(substeps)) {
                Material material = Material.DEFAULT.withRestitution(round % 2 == 0 ? 0 : 0.6);
                Vector3d axis = direction(random);
                Quaterniond turn = new Quaterniond().rotateAxis(3 * random.nextDouble(), axis);
                Vector3d spin = direction(random).mul(600 * random.nextDouble());
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(0.03, 0.0012, 0.0009))
                                .rotation(turn)
                                .angularVelocity(spin.x, spin.y, spin.z)
                                .material(material)
                                .mass(1));
                Vector3d at = direction(random).mul(0.06);
                Body other = Body.dynamic().at(at.x, at.y, at.z).material(material);
                Vector3d to = at.negate(new Vector3d()).mul(10 + 20 * random.nextDouble());
                other.velocity(to.x, to.y, to.z).mass(0.001 + random.nextDouble());
                BodyRef second =
                        world.add(
                                round % 4 < 2
                                        ? other.shape(Sphere.of(0.01))
                                        : other.shape(Box.ofHalfExtents(0.001, 0.001, 0.02)));
                Vector3d before = momentum(world);
                double size = before.length() + second.mass() * to.length();
                double energy = world.kineticEnergy();
                for (int tick = 0; tick < 30; tick++) {
                    world.step(1.0 / 60);
                }
                struck += second.velocity().distance(to) > 1e-9 ? 1 : 0;
                worst = Math.max(worst, momentum(world).distance(before) / size);
                gain = Math.max(gain, world.kineticEnergy() / energy - 1);
            }
        }
        System.out.println("struck " + struck + ", momentum " + worst + ", gain " + gain);
        assertTrue(struck > 50, "struck " + struck);
        assertTrue(worst < 1e-12, "momentum " + worst);
        assertTrue(gain < 1e-4, "energy " + gain);
    }

    private static Vector3d momentum(PhysicsWorld world) {
        Kinetics k = world.kinetics();
        return new Vector3d(k.momentumX(), k.momentumY(), k.momentumZ());
    }
}
