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
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;

/** Rays against the implicit functions of the shapes, and closest points that lie on both. */
class ShapeQueriesTest {
    private final ShapeQueries queries = new ShapeQueries();
    private final Placement at = new Placement(), other = new Placement();
    private final Hit hit = new Hit();
    private final Closest closest = new Closest();

    private static Shape shape(int i) {
        return shape(i, 1);
    }

    private static Shape shape(int i, double size) {
        return switch (i % 6) {
            case 0 -> Sphere.of(.7 * size);
            case 1 -> Box.ofHalfExtents(.5 * size, .8 * size, .3 * size);
            case 2 -> Capsule.of(.4 * size, .6 * size);
            case 3 -> Cylinder.of(.6 * size, .5 * size);
            case 4 -> Cone.of(.7 * size, .6 * size);
            default ->
                    ConvexHull.of(
                            new double[] {
                                size, 0, 0, -size, 0, 0, 0, size, 0, 0, -size, 0, 0, 0, size, 0, 0,
                                -size
                            });
        };
    }

    /** Above 0 outside; 0 on the surface. Shape frame. */
    private static double outside(Shape shape, Vector3d p) {
        double across = Math.sqrt(p.x * p.x + p.z * p.z);
        return switch (shape) {
            case Sphere s -> p.length() - s.radius();
            case Box b ->
                    Math.max(
                            Math.abs(p.x) - b.halfX(),
                            Math.max(Math.abs(p.y) - b.halfY(), Math.abs(p.z) - b.halfZ()));
            case Capsule c ->
                    Math.hypot(across, Math.max(0, Math.abs(p.y) - c.halfLength())) - c.radius();
            case Cylinder c -> Math.max(across - c.radius(), Math.abs(p.y) - c.halfHeight());
            case Cone c ->
                    Math.max(
                            across - c.radius() * (c.halfHeight() - p.y) / (2 * c.halfHeight()),
                            -c.halfHeight() - p.y);
            default -> Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z) - shape.outerRadius();
        };
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

    /** Where a ray enters, by the smallest of the function on it and halving; or infinity. */
    private static double enters(Shape shape, Vector3d o, Vector3d d, double reach) {
        int n = 4000;
        double low = 0;
        for (int i = 1; i <= n; i++) {
            double t = reach * i / n;
            if (outside(shape, new Vector3d(d).mul(t).add(o)) <= 0) {
                double high = t;
                for (int k = 0; k < 60; k++) {
                    double mid = (low + high) / 2;
                    if (outside(shape, new Vector3d(d).mul(mid).add(o)) <= 0) {
                        high = mid;
                    } else {
                        low = mid;
                    }
                }
                return high;
            }
            low = t;
        }
        return Double.POSITIVE_INFINITY;
    }

    @Test
    void raysMeetTheSurfaceWhereTheFunctionIsZero() {
        SplittableRandom r = new SplittableRandom(21);
        int hits = 0;
        for (int i = 0; i < 600; i++) {
            Shape shape = shape(i);
            Vector3d place = vector(r, 5);
            Quaterniond q = turn(r);
            Vector3d origin = vector(r, 3).add(place);
            Vector3d direction = vector(r, .6).add(place).sub(origin).normalize();
            at.set(shape, place.x, place.y, place.z, q.x, q.y, q.z, q.w);
            Vector3d o = q.transformInverse(new Vector3d(origin).sub(place));
            Vector3d d = q.transformInverse(new Vector3d(direction));
            boolean inside = outside(shape, o) <= 0;
            double truth = inside ? 0 : enters(shape, o, d, 10);
            String where = "seed 21 ray " + i + " " + shape;
            boolean found =
                    queries.rayCast(
                            at,
                            origin.x,
                            origin.y,
                            origin.z,
                            3 * direction.x,
                            3 * direction.y,
                            3 * direction.z,
                            10,
                            hit);
            if (found) {
                hits++;
                assertFalse(hit.capped(), where);
                Vector3d p = new Vector3d(hit.pointX(), hit.pointY(), hit.pointZ()).sub(place);
                q.transformInverse(p);
                if (!inside) {
                    assertEquals(0, outside(shape, p), 1e-12, where);
                    double n =
                            hit.normalX() * direction.x
                                    + hit.normalY() * direction.y
                                    + hit.normalZ() * direction.z;
                    assertTrue(n <= 0, where);
                }
                assertEquals(inside, hit.startsInside(), where);
            }
            if (truth < 10) {
                assertTrue(found, where);
                assertEquals(truth, hit.distance(), 1e-11, where);
            } else if (found) {
                // A chord between two samples of the search.
                assertTrue(
                        outside(shape, new Vector3d(d).mul(hit.distance()).add(o)) < 1e-11, where);
            }
        }
        assertTrue(hits > 300, hits + " hits");
    }

    @Test
    void aMovingShapeStopsWhereItTouches() {
        SplittableRandom r = new SplittableRandom(22);
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            Shape a = shape(i);
            Shape b = i % 7 == 6 ? HalfSpace.of() : shape(i / 6);
            Vector3d p = vector(r, 4);
            Quaterniond q = turn(r);
            Quaterniond u = turn(r);
            at.set(a, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
            other.set(b, 0, 0, 0, u.x, u.y, u.z, u.w);
            Vector3d d = vector(r, .5).sub(p).normalize();
            String where = "seed 22 cast " + i + " " + a + " to " + b;
            double before = queries.distance(at, other);
            if (queries.shapeCast(at, d.x, d.y, d.z, 20, other, hit)) {
                hits++;
                double t = hit.distance();
                at.set(a, p.x + t * d.x, p.y + t * d.y, p.z + t * d.z, q.x, q.y, q.z, q.w);
                double end = queries.distance(at, other);
                assertEquals(before <= 0, hit.startsInside(), where);
                if (before > 0) {
                    assertEquals(0, end, 1e-12, where);
                }
                // Never touched on the way.
                for (int k = 1; k < 20; k++) {
                    double s = t * k / 20;
                    at.set(a, p.x + s * d.x, p.y + s * d.y, p.z + s * d.z, q.x, q.y, q.z, q.w);
                    assertTrue(before <= 0 || queries.distance(at, other) > -1e-12, where);
                }
            }
        }
        assertTrue(hits > 150, hits + " hits");
    }

    /** Turned by quarters, about the shape's axis, and a little askew: flats and lines face. */
    private static Quaterniond nearlyUpright(SplittableRandom r) {
        Quaterniond q =
                new Quaterniond()
                        .rotateX(Math.PI / 2 * r.nextInt(4))
                        .rotateY(Math.PI / 2 * r.nextInt(4))
                        .rotateZ(Math.PI / 2 * r.nextInt(4));
        if (r.nextBoolean()) {
            q.rotateY(6 * r.nextDouble());
        }
        if (r.nextBoolean()) {
            Vector3d axis = vector(r, 1).normalize();
            q.rotateAxis(StrictMath.pow(10, -1 - 11 * r.nextDouble()), axis.x, axis.y, axis.z);
        }
        return q.normalize();
    }

    /** Places one shape of each pair so that the signed distance is what is asked for. */
    private void bring(Shape a, Vector3d p, Quaterniond q, double distance) {
        at.set(a, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
        double by = queries.closest(at, other, closest) - distance;
        p.add(new Vector3d(closest.normalX(), closest.normalY(), closest.normalZ()).mul(by));
    }

    /**
     * The points are where they should be: each on its shape's surface, up to a bar, and d n apart.
     * Of these two truths the first is from the implicit functions of the shapes.
     */
    private double pointsLieOnBoth(
            Shape a, Vector3d p, Quaterniond q, Shape b, Quaterniond u, double bar, String where) {
        at.set(a, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
        double d = queries.closest(at, other, closest);
        where += " " + a + " and " + b + ", " + d + " m apart";
        assertEquals(queries.distance(at, other), d, 0.0, where);
        assertEquals(d <= 0, queries.overlaps(at, other), where);
        Vector3d pa = new Vector3d(closest.pointAX(), closest.pointAY(), closest.pointAZ());
        Vector3d pb = new Vector3d(closest.pointBX(), closest.pointBY(), closest.pointBZ());
        Vector3d n = new Vector3d(closest.normalX(), closest.normalY(), closest.normalZ());
        assertEquals(0, n.mul(d).add(pa).distance(pb), 1e-14 * (1 + Math.abs(d)), where);
        double onA = outside(a, q.transformInverse(new Vector3d(pa).sub(p)));
        double onB = outside(b, u.transformInverse(new Vector3d(pb)));
        assertEquals(0, onA, bar, where + ": A");
        assertEquals(0, onB, bar, where + ": B");
        return d;
    }

    /** Pushed into each other by a little along the way on which they are nearest. */
    @Test
    void pointsOfShapesThatOverlapALittleLieOnBoth() {
        SplittableRandom r = new SplittableRandom(29);
        int overlapping = 0;
        for (int i = 0; i < 7200; i++) {
            double size = i % 4 == 0 ? StrictMath.pow(10, -3 * r.nextDouble()) : 1;
            Shape a = shape(i, size);
            Shape b = shape(i / 6);
            Vector3d p = vector(r, 1).normalize(2.5);
            Quaterniond q = turn(r);
            Quaterniond u = turn(r);
            other.set(b, 0, 0, 0, u.x, u.y, u.z, u.w);
            bring(a, p, q, -size * StrictMath.pow(10, -1 - 8 * r.nextDouble()));
            double d = pointsLieOnBoth(a, p, q, b, u, 1e-10, "seed 29 pair " + i);
            overlapping += d < 0 ? 1 : 0;
        }
        assertTrue(overlapping > 7000, overlapping + " overlap");
    }

    @Test
    void pointsOfShapesThatOverlapByMuchLieOnBoth() {
        SplittableRandom r = new SplittableRandom(30);
        int overlapping = 0;
        for (int i = 0; i < 7200; i++) {
            Shape a = shape(i);
            Shape b = shape(i / 6);
            Vector3d p = vector(r, 1).normalize(1.25 * r.nextDouble());
            Quaterniond q = turn(r);
            Quaterniond u = turn(r);
            other.set(b, 0, 0, 0, u.x, u.y, u.z, u.w);
            double d = pointsLieOnBoth(a, p, q, b, u, 1e-10, "seed 30 pair " + i);
            overlapping += d < 0 ? 1 : 0;
        }
        assertTrue(overlapping > 5000, overlapping + " overlap");
    }

    @Test
    void closestPointsLieOnBothShapes() {
        SplittableRandom r = new SplittableRandom(23);
        for (int i = 0; i < 7200; i++) {
            Shape a = shape(i);
            Shape b = shape(i / 6);
            Vector3d p = vector(r, i % 5 == 0 ? 20 : 2);
            Quaterniond q = turn(r);
            Quaterniond u = turn(r);
            other.set(b, 0, 0, 0, u.x, u.y, u.z, u.w);
            pointsLieOnBoth(a, p, q, b, u, 1e-10, "seed 23 pair " + i);
        }
    }

    /**
     * Faces, sides and edges that are parallel up to 1e-12 to 0.1 rad: where two axes are equal up
     * to rounding, 1e-16, either may be told, and what touches along them is up to sqrt(1e-16)
     * apart.
     */
    @Test
    void pointsOfShapesThatAreNearlyParallelLieOnBoth() {
        SplittableRandom r = new SplittableRandom(31);
        for (int i = 0; i < 14_400; i++) {
            Shape a = shape(i);
            Shape b = shape(i / 6);
            Vector3d p = vector(r, 1).normalize(i / 36 % 3 == 0 ? 1.25 * r.nextDouble() : 2.5);
            Quaterniond q = nearlyUpright(r);
            Quaterniond u = nearlyUpright(r);
            other.set(b, 0, 0, 0, u.x, u.y, u.z, u.w);
            if (i / 36 % 3 == 1) {
                bring(a, p, q, -StrictMath.pow(10, -1 - 8 * r.nextDouble()));
            }
            pointsLieOnBoth(a, p, q, b, u, 1e-8, "seed 31 pair " + i);
        }
    }

    @Test
    void wrongNumbersAreNamed() {
        at.set(Sphere.of(1), 0, 0, 0);
        assertThrows(
                IllegalArgumentException.class,
                () -> queries.rayCast(at, Double.NaN, 0, 0, 1, 0, 0, 1, hit));
        assertThrows(
                IllegalArgumentException.class,
                () -> queries.rayCast(at, 9, 0, 0, 0, 0, 0, 1, hit));
        assertThrows(
                IllegalArgumentException.class,
                () -> queries.rayCast(at, 9, 0, 0, 1, 0, 0, -1, hit));
        assertThrows(
                IllegalArgumentException.class, () -> at.set(Sphere.of(1), 0, 0, 0, 1, 1, 0, 0));
    }

    @Test
    void queriesAllocateNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Shape[] shapes = {shape(0), shape(1), shape(2), shape(3), shape(4), shape(5)};
        long bytes = 0;
        for (int round = 0; round < 2; round++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 2_000; i++) {
                at.set(shapes[i % 6], .001 * i, 1, 0);
                other.set(shapes[i / 6 % 6], 0, 0, .1);
                queries.rayCast(at, 5, 1, 0, -1, 0, 0, 10, hit);
                queries.shapeCast(at, 0, -1, 0, 10, other, hit);
                queries.closest(at, other, closest);
            }
            bytes = threads.getCurrentThreadAllocatedBytes() - before;
        }
        assertEquals(0, bytes);
    }
}
