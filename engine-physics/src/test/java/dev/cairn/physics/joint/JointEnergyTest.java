package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/**
 * Nothing comes from nothing: mechanisms without motors, of masses from 1 to 1000 kg, never have
 * more energy than they were made with. No joint of chains, rings and bridges is open by 1e-3 of
 * its link; nets of such masses open more, see the limits in docs/joints.md.
 */
final class JointEnergyTest {
    private static final double STEP = 1 / 60.0;

    /** What a symplectic step may swing about its value, of the largest energy of motion. */
    private static final double SWING = 2e-4;

    /** Mass of all links, kg. */
    private double total;

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    private BodyRef link(PhysicsWorld world, Random random, double x, double y, double z) {
        double mass = Math.pow(1000, random.nextDouble());
        total += mass;
        return world.add(
                Body.dynamic()
                        .shape(Box.ofHalfExtents(0.2, 0.1, 0.15))
                        .mass(mass)
                        .filter(Filter.NOTHING)
                        .at(x, y, z));
    }

    private static BodyRef peg(PhysicsWorld world, double x, double y, double z) {
        return world.add(Body.fixed().shape(Sphere.of(0.05)).filter(Filter.NOTHING).at(x, y, z));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void chainsGainNothing(long seed) {
        try (PhysicsWorld world = world()) {
            Random random = new Random(seed);
            BodyRef last = peg(world, 0, 0, 0);
            for (int k = 1; k <= 6; k++) {
                BodyRef next = link(world, random, k, 0, 0);
                if (random.nextBoolean()) {
                    world.add(Joint.ball(last, next).at(k - 0.5, 0, 0));
                } else {
                    double turn = random.nextDouble();
                    world.add(Joint.hinge(last, next).at(k - 0.5, 0, 0).axis(0, turn, 1));
                }
                last = next;
            }
            gainsNothing(world, 1800, true, "chain, seed " + seed);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1})
    void netsGainNothing(long seed) {
        try (PhysicsWorld world = world()) {
            Random random = new Random(seed);
            int n = 4;
            BodyRef[] before = new BodyRef[n];
            for (int row = 0; row < n; row++) {
                BodyRef left = null;
                for (int k = 0; k < n; k++) {
                    BodyRef knot = row == 0 ? peg(world, k, 0, 0) : link(world, random, k, 0, row);
                    if (row > 0) {
                        world.add(Joint.ball(before[k], knot).at(k, 0, row - 0.5));
                    }
                    if (row > 0 && left != null) {
                        world.add(Joint.ball(left, knot).at(k - 0.5, 0, row));
                    }
                    before[k] = knot;
                    left = knot;
                }
            }
            gainsNothing(world, 420, false, "net, seed " + seed);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void ringsGainNothing(long seed) {
        try (PhysicsWorld world = world()) {
            Random random = new Random(seed);
            ring(world, random, peg(world, 2, 0, 0));
            gainsNothing(world, 600, true, "ring, seed " + seed);
        }
    }

    /** A ring of eight at a peg, or of nine if there is none. */
    private void ring(PhysicsWorld world, Random random, BodyRef first) {
        int n = 9;
        BodyRef last = first;
        double[] at = {2, 0};
        for (int k = 1; k <= n; k++) {
            double angle = 2 * Math.PI * k / n;
            double x = 2 * StrictMath.cos(angle);
            double z = 2 * StrictMath.sin(angle);
            BodyRef next = k == n ? first : link(world, random, x, 0, z);
            world.add(Joint.ball(last, next).at(0.5 * (x + at[0]), 0, 0.5 * (z + at[1])));
            at[0] = x;
            at[1] = z;
            last = next;
        }
    }

    /** A ring that tumbles through space, its links thrown about: momenta stay. */
    @ParameterizedTest
    @ValueSource(longs = {1})
    void freeRingsKeepTheirMomenta(long seed) {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            Random random = new Random(seed);
            BodyRef first = link(world, random, 2, 0, 0);
            first.setVelocity(1, 2, -1);
            ring(world, random, first);
            world.step(STEP);
            Kinetics before = world.kinetics();
            double energy = gainsNothing(world, 600, true, "free ring, seed " + seed);
            Kinetics after = world.kinetics();
            double size = Math.sqrt(2 * energy * total);
            assertEquals(before.momentumX(), after.momentumX(), 1e-12 * size);
            assertEquals(before.momentumY(), after.momentumY(), 1e-12 * size);
            assertEquals(before.momentumZ(), after.momentumZ(), 1e-12 * size);
            assertEquals(before.angularMomentumX(), after.angularMomentumX(), 1e-10 * size);
            assertEquals(before.angularMomentumY(), after.angularMomentumY(), 1e-10 * size);
            assertEquals(before.angularMomentumZ(), after.angularMomentumZ(), 1e-10 * size);
        }
    }

    /** A slack cable of planks that ends level: what has come to rest stays at rest. */
    @Test
    void straightBridgesDoNotRise() {
        try (PhysicsWorld world = world()) {
            BodyRef last = peg(world, 0, 0, 0);
            for (int k = 1; k <= 6; k++) {
                BodyRef next =
                        k == 6
                                ? peg(world, k, 0, 0)
                                : world.add(
                                        Body.dynamic()
                                                .shape(Box.ofHalfExtents(0.45, 0.05, 1))
                                                .filter(Filter.NOTHING)
                                                .mass(5)
                                                .at(k, 0, 0));
                world.add(Joint.hinge(last, next).at(k - 0.5, 0, 0).axis(0, 0, 1));
                last = next;
            }
            gainsNothing(world, 600, true, "straight bridge");
        }
    }

    /** The largest energy of motion. */
    private static double gainsNothing(
            PhysicsWorld world, int ticks, boolean isClosed, String what) {
        double start = world.kineticEnergy() + world.potentialEnergy();
        double most = world.kineticEnergy();
        Vector3d a = new Vector3d();
        Vector3d b = new Vector3d();
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
            double kinetic = world.kineticEnergy();
            most = Math.max(most, kinetic);
            double gain = kinetic + world.potentialEnergy() - start;
            assertTrue(
                    gain <= SWING * most + 1e-9,
                    what + ", tick " + tick + ": gained " + gain + " J, of motion " + most);
            for (JointRef j : world.joints().all()) {
                double gap = j.anchorA(a).distance(j.anchorB(b));
                assertTrue(!isClosed || gap < 1e-3, what + ", tick " + tick + ": gap " + gap);
            }
        }
        return most;
    }
}
