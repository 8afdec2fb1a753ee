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

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Nets that are too dense for factors: whatever their masses and whatever falls on them, they gain
 * nothing and have the same bits for any number of workers. Those of like masses keep together; how
 * far others open is told in docs/joints.md.
 */
final class NetTest {
    private static final double STEP = 1 / 60.0;
    private static final int SIDE = 24;

    /** A symplectic step swings about its value, and gaps are closed aside: of motion. */
    private static final double SWING = 2e-4;

    private final Vector3d a = new Vector3d();
    private final Vector3d b = new Vector3d();

    private static PhysicsWorld world(int workers) {
        return PhysicsWorld.builder().workers(workers).sleeping(false).build();
    }

    /** A level net, a metre to a link, hung up by its first row if it is held. */
    private static List<BodyRef> net(
            PhysicsWorld world, boolean isHeld, double decades, boolean touches) {
        Random random = new Random(7);
        List<BodyRef> knots = new ArrayList<>();
        for (int row = 0; row < SIDE; row++) {
            for (int k = 0; k < SIDE; k++) {
                boolean isPeg = isHeld && row == 0;
                double mass = Math.pow(10, decades * random.nextDouble());
                Body body = isPeg ? Body.fixed() : Body.dynamic().mass(mass);
                body.shape(Sphere.of(0.4)).at(k, 0, row);
                knots.add(world.add(touches ? body : body.filter(Filter.NOTHING)));
                BodyRef knot = knots.getLast();
                if (k > 0 && !isPeg) {
                    BodyRef left = knots.get(knots.size() - 2);
                    world.add(Joint.ball(left, knot).at(k - 0.5, 0, row));
                }
                if (row > 0) {
                    BodyRef above = knots.get(knots.size() - 1 - SIDE);
                    world.add(Joint.ball(above, knot).at(k, 0, row - 0.5));
                }
            }
        }
        return knots;
    }

    private double gap(PhysicsWorld world) {
        double most = 0;
        for (JointRef joint : world.joints().all()) {
            most = Math.max(most, joint.anchorA(a).distance(joint.anchorB(b)));
        }
        return most;
    }

    private void gainsNothing(PhysicsWorld world, int ticks, double gap, String what) {
        double start = world.kineticEnergy() + world.potentialEnergy();
        double most = world.kineticEnergy();
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
            double kinetic = world.kineticEnergy();
            most = Math.max(most, kinetic);
            double gain = kinetic + world.potentialEnergy() - start;
            String when = what + ", tick " + tick;
            assertTrue(gain <= SWING * most + 1e-9, when + ": gained " + gain + " of " + most);
            assertTrue(gap(world) < gap, when + ": gap " + gap(world));
        }
    }

    /** It falls freely about its edge until it is upright, and whips there. */
    @Test
    void swingingNetsGainNothing() {
        try (PhysicsWorld world = world(1)) {
            net(world, true, 0, true);
            gainsNothing(world, 75, 1e-3, "falling net");
            gainsNothing(world, 105, 1e-3, "net");
        }
    }

    /** Threads bear what hangs on them from the first tick on: weight of all below, over g. */
    @Test
    void hangingNetsAreInBalance() {
        try (PhysicsWorld world = world(1)) {
            List<BodyRef> knots = new ArrayList<>();
            List<JointRef> upper = new ArrayList<>();
            for (int n = 0; n < SIDE * SIDE; n++) {
                int row = n / SIDE;
                int k = n % SIDE;
                Body body = row == 0 ? Body.fixed() : Body.dynamic().mass(2);
                body.shape(Sphere.of(0.4)).at(k, -row, 0).filter(Filter.NOTHING);
                knots.add(world.add(body));
                if (k > 0 && row > 0) {
                    world.add(Joint.ball(knots.get(n - 1), knots.get(n)).at(k - 0.5, -row, 0));
                }
                if (row > 0) {
                    BodyRef above = knots.get(n - SIDE);
                    upper.add(world.add(Joint.ball(above, knots.get(n)).at(k, 0.5 - row, 0)));
                }
            }
            for (int tick = 0; tick < 60; tick++) {
                world.step(STEP);
                assertTrue(gap(world) < 1e-6, "gap " + gap(world) + " in tick " + tick);
            }
            double weight = 2 * 9.81 * (SIDE - 1);
            for (int k = 0; k < SIDE; k++) {
                assertEquals(weight, upper.get(k).force(a).y, 1e-4 * weight, "thread " + k);
            }
        }
    }

    /**
     * Hung up by one corner a net tumbles, which a few rounds of conjugate gradients leave open by
     * centimetres. One that has factors goes on with them, also where it is taken up from a file.
     */
    @Test
    void netsThatTumbleStayTogether() {
        try (PhysicsWorld world = world(1);
                PhysicsWorld other = world(2)) {
            tumbler(world, 7);
            gainsNothing(world, 60, 5e-5, "tumbling net");
            other.restore(world.save());
            gainsNothing(world, 60, 5e-5, "tumbling net");
            for (int tick = 0; tick < 60; tick++) {
                other.step(STEP);
            }
            assertEquals(world.digest(), other.digest());
        }
    }

    private static void tumbler(PhysicsWorld world, int side) {
        List<BodyRef> knots = new ArrayList<>();
        for (int n = 0; n < side * side; n++) {
            Body body = n == 0 ? Body.fixed() : Body.dynamic().mass(1);
            body.shape(Sphere.of(0.4)).at(n % side, 0, n / side).filter(Filter.NOTHING);
            knots.add(world.add(body));
            if (n % side > 0) {
                Joint left = Joint.ball(knots.get(n - 1), knots.get(n));
                world.add(left.at(n % side - 0.5, 0, n / side));
            }
            if (n >= side) {
                Joint above = Joint.ball(knots.get(n - side), knots.get(n));
                world.add(above.at(n % side, 0, n / side - 0.5));
            }
        }
    }

    @Test
    void netsOfManyMassesGainNothing() {
        try (PhysicsWorld world = world(1)) {
            net(world, true, 3, false);
            gainsNothing(world, 90, Double.POSITIVE_INFINITY, "net of 1 to 1000 kg");
        }
    }

    @Test
    void theSameBitsForAnyNumberOfWorkers() {
        long[] digest = new long[2];
        for (int k = 0; k < 2; k++) {
            try (PhysicsWorld world = world(1 + 2 * k)) {
                List<BodyRef> knots = net(world, true, 0, true);
                knots.get(40).setVelocity(3, 0, 2);
                for (int n = 0; n < 4; n++) {
                    Body box = Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.4, 0.6)).mass(3);
                    world.add(box.at(4 + 4 * n, 0.85 + 0.2 * n, 6));
                }
                for (int tick = 0; tick < 40; tick++) {
                    world.step(STEP);
                }
                digest[k] = world.digest();
                assertTrue(gap(world) < 0.1, "gap " + gap(world));
            }
        }
        assertEquals(digest[0], digest[1]);
    }

    /** However roughly it is solved, a net that floats keeps its momenta. */
    @Test
    void floatingNetsKeepTheirMomenta() {
        try (PhysicsWorld world = world(1)) {
            world.setGravity(0, 0, 0);
            List<BodyRef> knots = net(world, false, 1, false);
            Random random = new Random(3);
            double size = 0;
            for (BodyRef knot : knots) {
                Vector3d v = new Vector3d(random.nextGaussian(), 1, random.nextGaussian());
                knot.setVelocity(v.x, v.y, v.z);
                size += knot.mass() * v.length();
            }
            Kinetics then = world.kinetics();
            for (int tick = 0; tick < 30; tick++) {
                world.step(STEP);
            }
            Kinetics now = world.kinetics();
            assertEquals(then.momentumX(), now.momentumX(), 1e-13 * size);
            assertEquals(then.momentumY(), now.momentumY(), 1e-13 * size);
            assertEquals(then.momentumZ(), now.momentumZ(), 1e-13 * size);
            double reach = size * SIDE;
            assertEquals(then.angularMomentumX(), now.angularMomentumX(), 1e-12 * reach);
            assertEquals(then.angularMomentumY(), now.angularMomentumY(), 1e-12 * reach);
            assertEquals(then.angularMomentumZ(), now.angularMomentumZ(), 1e-12 * reach);
            assertTrue(world.kineticEnergy() > 1, "it moves still");
        }
    }
}
