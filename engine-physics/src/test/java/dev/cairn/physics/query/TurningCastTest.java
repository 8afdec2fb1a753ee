package dev.cairn.physics.query;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;

/** First meetings against closed forms, and against a look at very many moments. */
class TurningCastTest {
    private static final Motion REST = new Motion();

    private final ShapeQueries queries = new ShapeQueries();
    private final Placement a = new Placement(), b = new Placement();
    private final Hit hit = new Hit(), other = new Hit();

    /** A shape on its way, by JOML's rotations and StrictMath. */
    private record Mover(
            Shape shape,
            Vector3d p,
            Quaterniond q,
            Vector3d v,
            Vector3d g,
            Vector3d w,
            Vector3d pivot) {
        static Mover of(Shape shape, SplittableRandom r, double near, double spin) {
            Vector3d p = vector(r, near);
            boolean falls = r.nextInt(3) == 0;
            return new Mover(
                    shape,
                    p,
                    turn(r),
                    vector(r, 5),
                    falls ? vector(r, 10) : new Vector3d(),
                    r.nextInt(4) == 0 ? new Vector3d() : vector(r, spin),
                    r.nextInt(4) == 0 ? vector(r, 3) : p);
        }

        void at(double t, Placement out) {
            double speed = w.length();
            double h = speed * t / 2;
            double s = speed == 0 ? 0 : StrictMath.sin(h) / speed;
            Quaterniond d = new Quaterniond(s * w.x, s * w.y, s * w.z, StrictMath.cos(h));
            Vector3d c = d.transform(new Vector3d(p).sub(pivot)).add(pivot);
            c.fma(t, v).fma(t * t / 2, g);
            d.mul(q);
            out.setCentre(shape, c.x, c.y, c.z, d.x, d.y, d.z, d.w);
        }

        Motion motion() {
            Motion m = new Motion().velocity(v).acceleration(g.x, g.y, g.z).angularVelocity(w);
            return pivot == p ? m : m.about(pivot.x, pivot.y, pivot.z);
        }
    }

    private static Vector3d vector(SplittableRandom r, double size) {
        return new Vector3d(
                size * (2 * r.nextDouble() - 1),
                size * (2 * r.nextDouble() - 1),
                size * (2 * r.nextDouble() - 1));
    }

    private static Quaterniond turn(SplittableRandom r) {
        return new Quaterniond(
                        r.nextDouble() - .5,
                        r.nextDouble() - .5,
                        r.nextDouble() - .5,
                        r.nextDouble() - .5)
                .normalize();
    }

    private static Shape shape(SplittableRandom r) {
        double[] points = new double[30];
        for (int i = 0; i < points.length; i++) {
            points[i] = 2 * r.nextDouble() - 1;
        }
        return switch (r.nextInt(7)) {
            case 0 -> Sphere.of(.2 + r.nextDouble());
            case 1 ->
                    Box.ofHalfExtents(
                            .05 + r.nextDouble(), .05 + r.nextDouble(), .05 + r.nextDouble());
            case 2 -> Capsule.of(.1 + .4 * r.nextDouble(), .1 + r.nextDouble());
            case 3 -> Cylinder.of(.1 + r.nextDouble(), .05 + .5 * r.nextDouble());
            case 4 -> Cone.of(.7, .6);
            case 5 -> Box.ofHalfExtents(2, .02, .02);
            default -> ConvexHull.of(points);
        };
    }

    /** The first root of a function that is above 0 before it, by fine steps and halving. */
    private static double root(DoubleUnaryOperator gap, double until) {
        int n = 60_000;
        for (int i = 1; i <= n; i++) {
            double high = until * i / n;
            if (gap.applyAsDouble(high) <= 0) {
                double low = until * (i - 1) / n;
                for (int k = 0; k < 80; k++) {
                    double mid = (low + high) / 2;
                    if (gap.applyAsDouble(mid) <= 0) {
                        high = mid;
                    } else {
                        low = mid;
                    }
                }
                return high;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    @Test
    void ballsMeetAtTheRootOfTheirDistance() {
        SplittableRandom r = new SplittableRandom(31);
        for (int i = 0; i < 30; i++) {
            Mover x = Mover.of(Sphere.of(.3), r, 2, 100);
            Vector3d aim = new Vector3d(x.p).add(vector(r, .4));
            Vector3d p = vector(r, 1).add(4, 0, 0);
            Vector3d v = new Vector3d(aim).sub(p).mul(1 + 3 * r.nextDouble()).add(x.v);
            Mover y =
                    new Mover(
                            Sphere.of(.2 + r.nextDouble()),
                            p,
                            new Quaterniond(),
                            v,
                            vector(r, 3),
                            new Vector3d(),
                            p);
            x = new Mover(x.shape, x.p, x.q, x.v, x.g, x.w, x.p);
            double far = ((Sphere) x.shape).radius() + ((Sphere) y.shape).radius();
            Vector3d p0 = new Vector3d(y.p).sub(x.p);
            Vector3d v0 = new Vector3d(y.v).sub(x.v);
            Vector3d g0 = new Vector3d(y.g).sub(x.g);
            double truth =
                    root(t -> new Vector3d(p0).fma(t, v0).fma(t * t / 2, g0).length() - far, 2);
            x.at(0, a);
            y.at(0, b);
            boolean meets = queries.timeOfImpact(a, x.motion(), b, y.motion(), 2, hit);
            assertEquals(truth < 2, meets, "seed 31 case " + i);
            if (meets) {
                assertEquals(truth, hit.seconds(), 1e-12, "seed 31 case " + i);
            }
        }
    }

    /**
     * A rod about its middle at 120 rad/s, a ball that comes slowly: many turns before they meet.
     */
    @Test
    void aSpinningRodMeetsABall() {
        double half = 2;
        double thin = .02;
        double radius = .1;
        for (double speed : new double[] {1, 3, 10}) {
            for (double spin : new double[] {1, 120, 1000}) {
                DoubleUnaryOperator gap =
                        t -> {
                            double x = 3 - speed * t;
                            double along = x * StrictMath.cos(spin * t);
                            double across = -x * StrictMath.sin(spin * t);
                            double dx = Math.max(0, Math.abs(along) - half);
                            double dy = Math.max(0, Math.abs(across) - thin);
                            return StrictMath.sqrt(dx * dx + dy * dy) - radius;
                        };
                double truth = root(gap, 3);
                a.set(Box.ofHalfExtents(half, thin, thin), 0, 0, 0);
                b.set(Sphere.of(radius), 3, 0, 0);
                Motion rod = new Motion().angularVelocity(0, 0, spin);
                Motion ball = new Motion().velocity(-speed, 0, 0);
                assertTrue(queries.timeOfImpact(a, rod, b, ball, 3, hit));
                assertEquals(truth, hit.seconds(), 1e-12, speed + " m/s, " + spin + " rad/s");
                assertFalse(hit.capped());
            }
        }
    }

    /** A box that tumbles down on a plane, and a plane that comes up to the box. */
    @Test
    void aCornerMeetsAPlane() {
        SplittableRandom r = new SplittableRandom(32);
        for (int i = 0; i < 20; i++) {
            Mover box = Mover.of(Box.ofHalfExtents(.3, .5, .2), r, 1, 30);
            Vector3d p = new Vector3d(0, 3, 0);
            Vector3d g = new Vector3d(0, -9.81, 0);
            box = new Mover(box.shape, p, box.q, box.v, g, box.w, p);
            Mover body = box;
            Placement at = new Placement();
            double[] bounds = new double[6];
            DoubleUnaryOperator gap =
                    t -> {
                        body.at(t, at);
                        at.bounds(bounds);
                        return bounds[1] - .5 * t;
                    };
            double truth = root(t -> t < .3 ? 1 : gap.applyAsDouble(t), 1.5);
            box.at(0, a);
            b.set(HalfSpace.of(), 0, 0, 0);
            Motion up = new Motion().velocity(0, .5, 0);
            assertTrue(queries.timeOfImpact(a, box.motion(), b, up, 1.5, hit), "seed 32 case " + i);
            assertEquals(truth, hit.seconds(), 1e-12, "seed 32 case " + i);
            assertEquals(1, hit.normalY(), 1e-15);
            assertEquals(.5 * truth, hit.pointY(), 1e-12);
        }
    }

    /** A door: it turns about its hinge, and the hinge is at rest. */
    @Test
    void aDoorMeetsABallOnItsFace() {
        a.set(Box.ofHalfExtents(.5, 1, .02), .5, 0, 0);
        b.set(Sphere.of(.1), 0, .3, -.7);
        Motion door = new Motion().about(0, 0, 0).angularVelocity(0, 2, 0);
        assertTrue(queries.turningCast(a, door, 2, b, hit));
        // the face is .02 from the axis of the door, the ball .7
        double angle = Math.PI / 2 - StrictMath.asin(.12 / .7);
        assertEquals(angle / 2, hit.seconds(), 1e-12);
        assertEquals(0, hit.distance(), 0);
        assertTrue(queries.turningCast(a, door, hit.seconds() + 1e-12, b, other));
        assertFalse(queries.turningCast(a, door, hit.seconds() - 1e-12, b, other));
    }

    @Test
    void noMeetingIsMissed() {
        int hits = 0;
        for (int i = 0; i < 10_000; i++) {
            SplittableRandom r = new SplittableRandom(1000 + i);
            double spin = r.nextInt(3) == 0 ? 100 : r.nextInt(2) == 0 ? 10 : 1;
            Mover x = Mover.of(shape(r), r, 2.5, spin);
            boolean endless = r.nextInt(8) == 0;
            Shape second = endless ? HalfSpace.of() : shape(r);
            Mover y = Mover.of(second, r, 2.5, endless ? 2 : spin);
            hits += check("seed " + (1000 + i), x, y, .2 + r.nextDouble(), 60) ? 1 : 0;
        }
        assertTrue(hits > 1000, hits + " met");
    }

    /** Compares with many moments; returns whether they met on the way. */
    private boolean check(String what, Mover x, Mover y, double seconds, int moments) {
        x.at(0, a);
        y.at(0, b);
        boolean meets = queries.timeOfImpact(a, x.motion(), b, y.motion(), seconds, hit);
        if (meets && hit.startsInside()) {
            assertTrue(queries.distance(a, b) <= 1e-12, what);
            return false;
        }
        double end = meets ? hit.seconds() : seconds;
        for (int k = 0; k < moments; k++) {
            x.at(end * k / moments, a);
            y.at(end * k / moments, b);
            double d = queries.distance(a, b);
            assertTrue(d > -1e-11, () -> what + ": missed, " + d + " m");
        }
        if (meets) {
            x.at(end, a);
            y.at(end, b);
            assertEquals(0, queries.distance(a, b), 1e-11, what);
            assertFalse(hit.capped(), what);
        }
        return meets;
    }

    // Surfaces of triangles ----------------------------------------------------------------------

    private static final double[] CUBE = {
        -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1
    };

    /** Outwards counter-clockwise. */
    private static final int[] FACES = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 3, 7, 6, 3, 6, 2, 0, 4, 7, 0, 7, 3, 1,
        2, 6, 1, 6, 5
    };

    @Test
    void aBoxOfTrianglesIsMetAsTheBox() {
        TriangleMesh mesh = TriangleMesh.of(CUBE, FACES);
        Box box = Box.cubeOfHalfExtent(1);
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            SplittableRandom r = new SplittableRandom(5000 + i);
            double spin = r.nextInt(2) == 0 ? 20 : 3;
            Mover x = Mover.of(shape(r), r, 4, spin);
            Mover y = Mover.of(box, r, 4, spin);
            Mover z = new Mover(mesh, y.p, y.q, y.v, y.g, y.w, y.pivot);
            x.at(0, a);
            y.at(0, b);
            String what = "seed " + (5000 + i);
            if (queries.distance(a, b) <= 0) {
                continue;
            }
            boolean truth = queries.timeOfImpact(a, x.motion(), b, y.motion(), 1, hit);
            z.at(0, b);
            assertEquals(truth, queries.timeOfImpact(a, x.motion(), b, z.motion(), 1, other), what);
            if (truth) {
                hits++;
                assertEquals(hit.seconds(), other.seconds(), 1e-9, what);
                assertTrue(other.triangle() >= 0, what);
                double sum = other.weight(0) + other.weight(1) + other.weight(2);
                assertEquals(1, sum, 1e-9, what);
            }
            double normal = other.normalX();
            assertEquals(truth, queries.timeOfImpact(b, z.motion(), a, x.motion(), 1, other), what);
            if (truth) {
                assertEquals(hit.seconds(), other.seconds(), 1e-9, what);
                assertEquals(-normal, other.normalX(), 1e-6, what);
            }
        }
        assertTrue(hits > 200, hits + " met");
    }

    /** The least of its triangles, each as a shape of its own. */
    @Test
    void groundIsMetWhereItsTrianglesAre() {
        SplittableRandom r = new SplittableRandom(33);
        int n = 60;
        double[] heights = new double[n * n];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = .5 * r.nextDouble();
        }
        HeightField field = HeightField.of(n, n, .5, .5, heights);
        double[] around = new double[6];
        placed(field).bounds(around);
        double midX = (around[0] + around[3]) / 2;
        double midZ = (around[2] + around[5]) / 2;
        int hits = 0;
        for (int i = 0; i < 150; i++) {
            Mover x = Mover.of(shape(r), r, 2, r.nextInt(2) == 0 ? 50 : 2);
            Vector3d p = new Vector3d(x.p).add(0, 4, 0);
            Vector3d v = new Vector3d(x.v).add(0, -6, 0);
            x = new Mover(x.shape, p, x.q, v, x.g, x.w, p);
            x.at(0, a);
            b.set(field, -midX, 0, -midZ);
            String what = "seed 33 case " + i;
            boolean meets = queries.turningCast(a, x.motion(), 1, b, hit);
            double end = meets ? hit.seconds() : 1;
            for (int k = 0; k < 40; k++) {
                x.at(end * k / 40, a);
                assertTrue(queries.distance(a, b) > -1e-11, what);
            }
            if (meets && !hit.startsInside()) {
                hits++;
                x.at(end, a);
                assertEquals(0, queries.distance(a, b), 1e-11, what);
                assertEquals(0, pointDistance(b, hit), 1e-9, what);
            }
        }
        assertTrue(hits > 100, hits + " met");
    }

    private double pointDistance(Placement surface, Hit at) {
        return queries.distance(
                new Placement().set(Sphere.of(1e-12), at.pointX(), at.pointY(), at.pointZ()),
                surface);
    }

    /** A blade passes a sheet through its back, and half a turn later meets its front. */
    @Test
    void aSheetIsMetFromItsFront() {
        TriangleMesh sheet =
                TriangleMesh.of(
                        new double[] {.5, -1, 0, 2, -1, 0, 2, 1, 0, .5, 1, 0},
                        new int[] {0, 1, 2, 0, 2, 3});
        a.set(
                Box.ofHalfExtents(1, .1, .05),
                0,
                0,
                0,
                0,
                StrictMath.sin(.25),
                0,
                StrictMath.cos(.25));
        b.set(sheet, 0, 0, 0);
        // the arm along +x is turned to -z, behind the sheet; the other one is before it
        Motion up = new Motion().angularVelocity(0, -2, 0);
        Motion down = new Motion().angularVelocity(0, 2, 0);
        assertTrue(queries.turningCast(a, down, 10, b, hit));
        double back = (Math.PI - .5 - .1) / 2;
        assertEquals(back, hit.seconds(), .05);
        assertTrue(hit.normalZ() > .9);

        assertTrue(queries.turningCast(a, up, 10, placed(sheet.twoSided()), other));
        assertEquals((.5 - .1) / 2, other.seconds(), .05);
        assertTrue(other.normalZ() < -.9);
        assertFalse(queries.turningCast(a, up, 10, b, other), "it only comes through its back");
    }

    private Placement placed(Shape shape) {
        return new Placement().set(shape, 0, 0, 0);
    }

    @Test
    void wrongNumbersAreNamed() {
        a.set(Sphere.of(1), 0, 0, 0);
        b.set(Sphere.of(1), 5, 0, 0);
        Motion fast = new Motion().angularVelocity(0, 1e4, 0);
        for (Runnable bad :
                List.<Runnable>of(
                        () -> queries.turningCast(a, REST, -1, b, hit),
                        () -> queries.turningCast(a, REST, Double.NaN, b, hit),
                        () -> queries.turningCast(a, REST, Double.POSITIVE_INFINITY, b, hit),
                        () -> queries.timeOfImpact(a, REST, b, fast, 100, hit),
                        () -> new Motion().velocity(0, Double.NaN, 0),
                        () -> new Motion().acceleration(0, 0, Double.NEGATIVE_INFINITY),
                        () -> new Motion().about(Double.NaN, 0, 0),
                        () -> new Motion().angularVelocity(Double.NaN, 0, 0))) {
            String message = assertThrows(IllegalArgumentException.class, bad::run).getMessage();
            assertTrue(message.contains(" is ") || message.contains("turns by"), message);
        }
    }

    @Test
    void queriesAllocateNothing() {
        TriangleMesh mesh = TriangleMesh.of(CUBE, FACES);
        SplittableRandom r = new SplittableRandom(34);
        Mover[] movers = new Mover[40];
        Motion[] motions = new Motion[40];
        for (int i = 0; i < movers.length; i++) {
            movers[i] = Mover.of(i % 5 == 0 ? mesh : shape(r), r, 4, 5);
            motions[i] = movers[i].motion();
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long bytes = 0;
        for (int round = 0; round < 2; round++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 4000; i++) {
                Mover x = movers[i % 40];
                Mover y = movers[i * 7 % 39];
                a.setCentre(x.shape, x.p.x, x.p.y, x.p.z, x.q.x, x.q.y, x.q.z, x.q.w);
                b.setCentre(y.shape, y.p.x, y.p.y, y.p.z, y.q.x, y.q.y, y.q.z, y.q.w);
                queries.timeOfImpact(a, motions[i % 40], b, motions[i * 7 % 39], .2, hit);
            }
            bytes = threads.getCurrentThreadAllocatedBytes() - before;
        }
        assertEquals(0, bytes);
    }
}
