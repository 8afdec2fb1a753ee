package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.shape.Box;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Random trees and loops of all kinds of joints, with limits that are hit and motors, of masses
 * from 1 to 30 kg, floating, some of them loops that their motors want to tear apart: nothing
 * explodes. Of the sum of what the bodies have, each by itself, momentum stays to 1e-13 and angular
 * momentum to 1e-12, but to 1e-10 where loops cannot do what is wanted and forces are large.
 */
final class RandomMechanismsTest {
    private static final double STEP = 1 / 60.0;

    @Test
    void momentaStay() {
        int exact = 0;
        for (long seed = 1; seed <= 40; seed++) {
            exact += run(seed, 240) ? 1 : 0;
        }
        assertTrue(exact >= 30, "only " + exact + " of 40 to 1e-13 and 1e-12");
    }

    private static Joint joint(Random random, BodyRef a, BodyRef b, Vector3d at) {
        Vector3d axis = new Vector3d(random.nextGaussian(), random.nextGaussian(), 0.3);
        double x = axis.x;
        double y = axis.y;
        double z = axis.z;
        return switch (random.nextInt(9)) {
            case 0 -> Joint.ball(a, b).at(at.x, at.y, at.z).axis(x, y, z).limits(0, 0.5);
            case 1 -> Joint.hinge(a, b).at(at.x, at.y, at.z).axis(x, y, z).limits(-0.4, 0.6);
            case 2 -> Joint.hinge(a, b).at(at.x, at.y, at.z).axis(x, y, z).motor(2, 20);
            case 3 -> Joint.slider(a, b).at(at.x, at.y, at.z).axis(x, y, z).limits(-0.2, 0.3);
            case 4 ->
                    Joint.slider(a, b)
                            .at(at.x, at.y, at.z)
                            .axis(x, y, z)
                            .limits(-0.2, 0.3)
                            .motor(1, Double.POSITIVE_INFINITY);
            case 5 -> Joint.cylindrical(a, b).at(at.x, at.y, at.z).axis(x, y, z).limits(-1, 1);
            case 6 -> Joint.universal(a, b).at(at.x, at.y, at.z).axis(x, y, z);
            case 7 -> Joint.rod(a, b);
            default -> Joint.hinge(a, b).at(at.x, at.y, at.z).axis(x, y, z).spring(0.2, 2, 0.1);
        };
    }

    /** Whether it keeps both to the last digits. */
    private static boolean run(long seed, int ticks) {
        Random random = new Random(seed);
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).sleeping(false).gravity(0, 0, 0).build()) {
            List<BodyRef> bodies = new ArrayList<>();
            int n = 3 + random.nextInt(7);
            for (int k = 0; k < n; k++) {
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.4, 0.15, 0.25))
                                        .mass(Math.pow(30, random.nextDouble()))
                                        .filter(Filter.NOTHING)
                                        .at(k, random.nextDouble(), random.nextDouble())
                                        .velocity(random.nextGaussian(), random.nextGaussian(), 0)
                                        .angularVelocity(random.nextGaussian(), 0.5, 1)));
                if (k > 0) {
                    tie(world, random, bodies.get(random.nextInt(k)), bodies.get(k));
                }
            }
            if (random.nextBoolean()) {
                tie(world, random, bodies.getFirst(), bodies.getLast());
            }
            Kinetics then = world.kinetics();
            double most = 0;
            double linear = 0;
            double angular = 0;
            for (int tick = 0; tick < ticks; tick++) {
                world.step(STEP);
                most = Math.max(most, world.kineticEnergy());
                double size = 0;
                double reach = 1;
                for (BodyRef body : bodies) {
                    double speed = body.velocity().length() + body.angularVelocity().length();
                    size += body.mass() * speed;
                    reach = Math.max(reach, body.position().length());
                }
                Kinetics now = world.kinetics();
                double p =
                        new Vector3d(now.momentumX(), now.momentumY(), now.momentumZ())
                                .distance(then.momentumX(), then.momentumY(), then.momentumZ());
                double l =
                        new Vector3d(
                                        now.angularMomentumX(),
                                        now.angularMomentumY(),
                                        now.angularMomentumZ())
                                .distance(
                                        then.angularMomentumX(),
                                        then.angularMomentumY(),
                                        then.angularMomentumZ());
                linear = Math.max(linear, p / size);
                angular = Math.max(angular, l / (size * reach));
            }
            String text = "seed " + seed + ": momentum " + linear + ", angular " + angular;
            System.out.println(text);
            assertTrue(linear < 1e-10, text);
            assertTrue(angular < 1e-10, text);
            assertTrue(most < 2000, text + ": energy of motion " + most);
            return linear < 1e-13 && angular < 1e-12;
        }
    }

    private static void tie(PhysicsWorld world, Random random, BodyRef a, BodyRef b) {
        Vector3d at = a.position().add(b.position(), new Vector3d()).mul(0.5);
        world.add(joint(random, a, b, at));
    }
}
