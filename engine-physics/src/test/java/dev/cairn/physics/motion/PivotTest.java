package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.tuning.Precision;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Tops: bodies that turn on one corner, beside the pinned body of theory. */
class PivotTest {
    private static final double TICK = 1 / 60.0;
    private static final double G = 9.81;

    /** Tip to centre of mass, m. */
    private static final double LENGTH = 0.1;

    private static final double TILT = 0.35;

    /** Moments of the body, kg m², its axis the second. */
    private static final double[] LOPSIDED = {0.001, 0.0025, 0.0015};

    private static Shape hull() {
        double[] corners = new double[15];
        double[] x = {1, 0, -1, 0};
        for (int i = 0; i < 4; i++) {
            corners[3 * i] = 0.05 * x[i];
            corners[3 * i + 1] = LENGTH / 0.75;
            corners[3 * i + 2] = 0.05 * x[(i + 1) % 4];
        }
        return ConvexHull.of(corners);
    }

    private static PhysicsWorld world(int substeps, Precision precision, double friction) {
        PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -G, 0)
                        .workers(1)
                        .settings(
                                PhysicsSettings.DEFAULT
                                        .withSubsteps(substeps)
                                        .withPrecision(precision)
                                        .withSleeping(false))
                        .build();
        Material surface = new Material(friction, 0, 1000);
        world.add(Body.fixed().shape(HalfSpace.of()).material(surface));
        return world;
    }

    /** Let go with a spin about its axis. */
    private static BodyRef top(PhysicsWorld world, Shape shape, double spin, double friction) {
        Vector3d axis = new Vector3d(Math.sin(TILT), Math.cos(TILT), 0);
        Vector3d w = new Vector3d(axis).mul(spin);
        // a cone has its apex up
        boolean isCone = shape instanceof Cone;
        double up = isCone ? LENGTH / 1.5 : 0;
        return world.add(
                Body.dynamic()
                        .shape(shape)
                        .mass(1)
                        .inertia(LOPSIDED[0], LOPSIDED[1], LOPSIDED[2])
                        .at(up * axis.x, up * axis.y, 0)
                        .rotationAbout(0, 0, 1, isCone ? Math.PI - TILT : -TILT)
                        .angularVelocity(w.x, w.y, w.z)
                        .material(new Material(friction, 0, 1000)));
    }

    private static Vector3d axis(BodyRef top) {
        return top.orientation()
                .transform(new Vector3d(0, top.shape() instanceof Cone ? -1 : 1, 0));
    }

    private static Vector3d tip(BodyRef top) {
        return top.centreOfMass(new Vector3d()).fma(-LENGTH, axis(top));
    }

    /** Largest distance of the axis from that of the pinned body in a second; the tip stays. */
    private static double error(Shape shape, int substeps, Precision precision) {
        try (PhysicsWorld world = world(substeps, precision, 1)) {
            BodyRef top = top(world, shape, 300, 1);
            Pinned truth = new Pinned(300);
            double worst = 0;
            for (int tick = 0; tick < 60; tick++) {
                world.step(TICK);
                truth.run(TICK);
                worst = Math.max(worst, axis(top).distance(truth.axis()));
                assertTrue(tip(top).length() < 1e-13, "the tip moves");
            }
            return worst;
        }
    }

    @Test
    void aTopFollowsThePinnedBodyToTheSecondOrder() {
        double coarse = error(hull(), 2, Precision.DOUBLE);
        double fine = error(hull(), 4, Precision.DOUBLE);
        assertTrue(fine < 2e-4, () -> "axis off by " + fine);
        assertEquals(4, coarse / fine, 0.4, "order");
        assertEquals(fine, error(hull(), 4, Precision.SINGLE), 1e-9, "with contacts in floats");
        assertEquals(fine, error(Cone.of(0.05, LENGTH / 1.5), 4, Precision.DOUBLE), 1e-9, "cone");
    }

    /** What friction cannot hold slips, and loses energy by it. */
    @Test
    void aTopSlipsWhereItIsSmooth() {
        try (PhysicsWorld world = world(4, Precision.DOUBLE, 0.02)) {
            BodyRef top = top(world, hull(), 20, 0.02);
            for (int tick = 0; tick < 6; tick++) {
                world.step(TICK);
            }
            assertTrue(tip(top).length() > 1e-4, "the tip stays");
        }
    }

    /** The contact tells what holds the top: its weight, in the mean. */
    @Test
    void theContactCarriesTheWeight() {
        try (PhysicsWorld world = world(4, Precision.DOUBLE, 1)) {
            BodyRef top = top(world, hull(), 300, 1);
            double sum = 0;
            for (int tick = 0; tick < 60; tick++) {
                world.step(TICK);
                sum += world.contacts().normalImpulse(0, 0);
            }
            double momentum = top.velocity(new Vector3d()).y;
            assertEquals(G + momentum, sum, 1e-9, "N s");
        }
    }

    /** A cube that turns on its corner comes down from there: energy to 1e-3 until it lands. */
    @Test
    void aCubeOnItsCornerKeepsItsEnergy() {
        double half = 0.1;
        try (PhysicsWorld world = world(4, Precision.DOUBLE, 1)) {
            // the corner (-1, -1, -1) down, and a little over
            Quaterniond upright = new Quaterniond().rotationTo(1, 1, 1, 0, 1, 0);
            Quaterniond q = new Quaterniond().rotateX(0.05).mul(upright);
            Vector3d centre = q.transform(new Vector3d(half, half, half));
            BodyRef cube =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(half))
                                    .mass(1)
                                    .at(centre.x, centre.y, centre.z)
                                    .rotation(q)
                                    .material(new Material(1, 0, 1000)));
            double inertia = 2 * half * half / 3;
            double start = G * centre.y;
            double fastest = 0;
            for (int tick = 0; tick < 20; tick++) {
                world.step(TICK);
                double speed = cube.angularVelocity().length();
                fastest = Math.max(fastest, speed);
                double energy =
                        0.5 * cube.velocity().lengthSquared()
                                + 0.5 * inertia * speed * speed
                                + G * cube.position().y;
                assertEquals(start, energy, 1e-3, "J at tick " + tick);
            }
            assertTrue(fastest > 1, "it must fall");
        }
    }

    /** Same bits twice. */
    @Test
    void isDeterministic() {
        double[][] ends = new double[2][];
        for (int run = 0; run < 2; run++) {
            try (PhysicsWorld world = world(4, Precision.DOUBLE, 1)) {
                BodyRef top = top(world, hull(), 200, 1);
                for (int tick = 0; tick < 120; tick++) {
                    world.step(TICK);
                }
                Vector3d p = top.position();
                Vector3d w = top.angularVelocity();
                ends[run] = new double[] {p.x, p.y, p.z, w.x, w.y, w.z};
            }
        }
        assertArrayEquals(ends[0], ends[1], 0.0);
    }

    /** The body pinned at its tip, by Runge and Kutta's method of the fourth order. */
    private static final class Pinned {
        private static final double STEP = 2e-5;

        /** Orientation, then momentum about the tip. */
        private final double[] state = new double[7];

        Pinned(double spin) {
            Quaterniond q = new Quaterniond().rotateZ(-TILT);
            Vector3d momentum = q.transform(new Vector3d(0, LOPSIDED[1] * spin, 0));
            state[0] = q.x;
            state[1] = q.y;
            state[2] = q.z;
            state[3] = q.w;
            state[4] = momentum.x;
            state[5] = momentum.y;
            state[6] = momentum.z;
        }

        private static Quaterniond orientation(double[] s) {
            return new Quaterniond(s[0], s[1], s[2], s[3]).normalize();
        }

        Vector3d axis() {
            return orientation(state).transform(new Vector3d(0, 1, 0));
        }

        private static double[] rate(double[] s) {
            Quaterniond q = orientation(s);
            Vector3d w = q.transformInverse(new Vector3d(s[4], s[5], s[6]));
            double more = LENGTH * LENGTH;
            w.div(LOPSIDED[0] + more, LOPSIDED[1], LOPSIDED[2] + more);
            q.transform(w);
            Quaterniond d =
                    new Quaterniond(w.x, w.y, w.z, 0).mul(new Quaterniond(s[0], s[1], s[2], s[3]));
            Vector3d r = q.transform(new Vector3d(0, LENGTH, 0));
            Vector3d torque = r.cross(0, -G, 0, new Vector3d());
            return new double[] {d.x / 2, d.y / 2, d.z / 2, d.w / 2, torque.x, torque.y, torque.z};
        }

        private static double[] along(double[] s, double[] k, double h) {
            double[] sum = s.clone();
            for (int i = 0; i < 7; i++) {
                sum[i] += h * k[i];
            }
            return sum;
        }

        void run(double seconds) {
            int steps = (int) Math.round(seconds / STEP);
            double h = seconds / steps;
            for (int n = 0; n < steps; n++) {
                double[] a = rate(state);
                double[] b = rate(along(state, a, h / 2));
                double[] c = rate(along(state, b, h / 2));
                double[] d = rate(along(state, c, h));
                for (int i = 0; i < 7; i++) {
                    state[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
                }
            }
        }
    }
}
