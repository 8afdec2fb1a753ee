package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.SplittableRandom;

/** Contact points: how many, where, how deep, and under which names. */
class ManifoldTest {
    private final Manifold m = new Manifold();

    private double deepest() {
        double least = Double.MAX_VALUE;
        for (int i = 0; i < m.pointCount; i++) {
            least = Math.min(least, m.separation[i]);
        }
        return least;
    }

    private int[] names() {
        return Arrays.copyOf(m.feature, m.pointCount);
    }

    @ParameterizedTest
    @EnumSource
    void aCubeOnACubeHasFourPointsThatKeepTheirNames(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        SplittableRandom r = new SplittableRandom(21);
        Scene s =
                new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5))
                        .at(1e-3, 1 - 1e-4, -1e-3);
        s.qb.rotateY(1e-3);
        long word = s.collide(n, .02, 0, m);
        int[] first = names();
        assertEquals(4, first.length);
        for (int tick = 0; tick < 1_000; tick++) {
            double turn = 1e-3 + 1e-4 * Scene.gauss(r);
            double lean = 1e-5 * Scene.gauss(r);
            s.at(1e-3 + 1e-4 * Scene.gauss(r), 1 - 1e-4, -1e-3 + 1e-4 * Scene.gauss(r));
            s.qb.identity().rotateY(turn).rotateX(lean);
            word = s.collide(n, .02, word, m);
            assertArrayEquals(first, names(), "seed 21 tick " + tick);
            assertEquals(1, m.normalY, 1e-9);
        }
        s.at(1e-3, 1 - 1e-4, -1e-3);
        s.qb.identity().rotateY(1e-3);
        s.collide(n, .02, word, m);
        for (int i = 0; i < 4; i++) {
            assertEquals(-1e-4, m.separation[i], 1e-15);
            assertEquals(.5 - .5e-4, m.pointY[i], 1e-15);
            assertEquals(.5, Math.abs(m.pointX[i]), 2.1e-3);
            assertEquals(.5, Math.abs(m.pointZ[i]), 2.1e-3);
        }
    }

    @ParameterizedTest
    @EnumSource
    void flushCubesKeepTheCornersOfTheUpperOneUnderNoise(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        SplittableRandom r = new SplittableRandom(22);
        long word = 0;
        for (int tick = 0; tick < 500; tick++) {
            Scene s =
                    new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5))
                            .at(1e-8 * Scene.gauss(r), 1 - 1e-6, 1e-8 * Scene.gauss(r));
            s.qb.rotateY(1e-8 * Scene.gauss(r)).rotateX(1e-9 * Scene.gauss(r));
            word = s.collide(n, .02, word, m);
            int[] corners = {0, 1, 4, 5};
            for (int i = 0; i < 4; i++) {
                assertEquals(
                        FeatureIds.VERTEX_B | corners[i], m.feature[i], "seed 22 tick " + tick);
            }
            assertEquals(4, m.pointCount);
        }
    }

    @ParameterizedTest
    @EnumSource
    void touchingIsZeroAndTheMarginIsASharpBound(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5)).at(.25, 1, 0);
        s.collide(n, 0, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(0, m.separation[0], 0.0);
        s.at(.25, 1.0078125, 0).collide(n, .0078125, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(.0078125, m.separation[3], 0.0);
        s.collide(n, .0078124, 0, m);
        assertEquals(0, m.pointCount);
        // Corner against corner: every axis of the fifteen says "near", the true distance says
        // "apart".
        s.at(1.01, 1.01, 1.01).collide(n, .012, 0, m);
        assertEquals(0, m.pointCount);
        s.collide(n, .02, 0, m);
        assertEquals(1, m.pointCount);
        assertEquals(.01 * Math.sqrt(3), m.separation[0], 1e-15);
        assertEquals(.505, m.pointX[0], 1e-15);
    }

    @ParameterizedTest
    @EnumSource
    void aCubeRestsOnAWideFloorAtAnyCornerOfIt(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s =
                new Scene(Box.ofHalfExtents(50, .5, 50), Box.cubeOfHalfExtent(.5))
                        .at(37.3, .999, -41.7);
        s.qb.rotateY(.3);
        s.collide(n, .02, 0, m);
        assertEquals(4, m.pointCount);
        for (int i = 0; i < 4; i++) {
            assertEquals(-.001, m.separation[i], 1e-14);
            assertEquals(.4995, m.pointY[i], 1e-14);
        }
        Scene t = s.swapped();
        t.collide(n, .02, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(-1, m.normalY, 1e-14);
        s =
                new Scene(Box.ofHalfExtents(500, 500, 500), Box.cubeOfHalfExtent(.5))
                        .at(3, 500.5 - 1e-6, 4);
        s.collide(n, .02, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(-1e-6, deepest(), 2e-13);
        s =
                new Scene(Box.ofHalfExtents(1, .1, 1), Box.ofHalfExtents(.03, 5e-7, .05))
                        .at(0, .1 + 5e-7 - 1e-9, 0);
        s.collide(n, 1e-8, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(-1e-9, deepest(), 1e-16);
    }

    @ParameterizedTest
    @EnumSource
    void nearlyParallelFacesStayAFaceContactAtAnyTilt(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        for (int k = -14; k <= -3; k++) {
            double tilt = StrictMath.pow(10, k);
            Scene s =
                    new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5)).at(.1, .999, .05);
            s.qb.rotateXYZ(tilt, tilt, -tilt);
            s.collide(n, .02, 0, m);
            assertEquals(4, m.pointCount, "tilt " + tilt);
            assertEquals(1, m.normalY, 1e-5, "tilt " + tilt);
            assertEquals(-.001, deepest(), 1.1 * tilt + 1e-15);
        }
    }

    @ParameterizedTest
    @EnumSource
    void crossedEdgesTouchAtOnePointBetweenThem(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s =
                new Scene(Box.ofHalfExtents(.5, .5, 2), Box.ofHalfExtents(2, .5, .5))
                        .at(0, Math.sqrt(2) - .01, 0);
        s.qa.rotateZ(Math.PI / 4);
        s.qb.rotateX(Math.PI / 4);
        s.collide(n, .02, 0, m);
        assertEquals(1, m.pointCount);
        assertEquals(-.01, m.separation[0], 1e-14);
        assertEquals(1, m.normalY, 1e-14);
        assertEquals(0, m.pointX[0], 1e-14);
        assertEquals(Math.sqrt(.5) - .005, m.pointY[0], 1e-14);
        assertEquals(2, m.feature[0] >>> 30);
        s.at(0, Math.sqrt(2) + .01, 0).collide(n, .02, 0, m);
        assertEquals(1, m.pointCount);
        assertEquals(.01, m.separation[0], 1e-14);
    }

    @ParameterizedTest
    @EnumSource
    void ballsTouchInOnePointMidway(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s = new Scene(Box.ofHalfExtents(5, 1, 5), Sphere.of(.5)).at(1, 1.49, 2);
        s.collide(n, .02, 0, m);
        assertEquals(1, m.pointCount);
        assertEquals(-.01, m.separation[0], 1e-15);
        assertEquals(1, m.normalY, 0.0);
        assertEquals(.995, m.pointY[0], 1e-15);
        s.swapped().collide(n, .02, 0, m);
        assertEquals(-1, m.normalY, 0.0);
        assertEquals(-.495, m.pointY[0], 1e-15);
        s = new Scene(Sphere.of(1), Sphere.of(2)).at(0, 0, 3.5);
        s.collide(n, 1, 0, m);
        assertEquals(.5, m.separation[0], 1e-15);
        assertEquals(1.25, m.pointZ[0], 1e-15);
        s.at(0, 0, 0).collide(n, 0, 0, m);
        assertEquals(-3, m.separation[0], 0.0);
        assertEquals(1, m.normalX * m.normalX + m.normalY * m.normalY + m.normalZ * m.normalZ, 0.0);
    }

    /**
     * Whatever the pose: bounded error, points on both surfaces, order of names, mirrored normal,
     * any word.
     */
    @ParameterizedTest
    @EnumSource
    void everyManifoldKeepsItsPromises(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        SplittableRandom r = new SplittableRandom(23);
        Manifold back = new Manifold();
        int faces = 0;
        for (int i = 0; i < 3_000; i++) {
            Scene s =
                    (i & 1) == 0
                            ? Scene.random(r, Scene.box(r), Scene.box(r))
                            : Scene.random(r, Scene.hull(r, 4 + r.nextInt(40), 1), Scene.box(r));
            double truth = s.distance(n);
            Vector3d axis = new Vector3d(n.axisX(), n.axisY(), n.axisZ());
            s.d.fma(-truth - .05 * r.nextDouble() * s.a.innerRadius(), axis);
            truth = s.distance(n);
            axis.set(n.axisX(), n.axisY(), n.axisZ());
            double margin = .02 * s.size();
            s.collide(n, margin, 0, m);
            String where = method + " seed 23 pose " + i + " distance " + truth;
            assertTrue(m.pointCount > 0, where);
            faces += m.pointCount > 1 ? 1 : 0;
            assertEquals(truth, deepest(), m.bound, where);
            double inner = Math.min(s.a.innerRadius(), s.b.innerRadius());
            Vector3d normal = new Vector3d(m.normalX, m.normalY, m.normalZ);
            // A face stands in for an edge pair that is hardly better, or within 0.1 rad of the
            // face's normal.
            assertTrue(
                    m.bound <= 2e-3 * inner + .2 * Math.abs(deepest()) || normal.dot(axis) > .995,
                    where + " bound " + m.bound);
            assertEquals(1, normal.length(), 1e-14, where);
            for (int p = 0; p < m.pointCount; p++) {
                Vector3d point = new Vector3d(m.pointX[p], m.pointY[p], m.pointZ[p]);
                Vector3d onA = new Vector3d(point).fma(-m.separation[p] / 2, normal);
                Vector3d onB = new Vector3d(point).fma(m.separation[p] / 2, normal).sub(s.d);
                assertTrue(
                        height(s.a, s.qa.transformInverse(onA)) < 2e-5 * inner + 1e-14 * s.size(),
                        where);
                assertTrue(
                        height(s.b, s.qb.transformInverse(onB)) < 2e-5 * inner + 1e-14 * s.size(),
                        where);
                assertTrue(m.separation[p] <= margin, where);
                assertTrue(
                        p == 0 || Integer.compareUnsigned(m.feature[p - 1], m.feature[p]) < 0,
                        where);
            }
            s.swapped().collide(n, margin, 0, back);
            assertEquals(m.pointCount, back.pointCount, where);
            assertEquals(-1, normal.dot(back.normalX, back.normalY, back.normalZ), 1e-12, where);
            s.collide(n, margin, r.nextLong(), back);
            assertTrue(back.pointCount > 0, where);
            double least = Double.MAX_VALUE;
            for (int p = 0; p < back.pointCount; p++) {
                least = Math.min(least, back.separation[p]);
            }
            assertEquals(truth, least, back.bound, where);
        }
        assertTrue(faces > 1_000, "face contacts: " + faces);
    }

    private static double height(Shape shape, Vector3d p) {
        Polyhedron h = ConvexOracle.polyhedron(shape);
        double most = -Double.MAX_VALUE;
        for (int f = 0; f < h.faceCount(); f++) {
            most =
                    Math.max(
                            most,
                            h.normalX(f) * p.x
                                    + h.normalY(f) * p.y
                                    + h.normalZ(f) * p.z
                                    - h.offset(f));
        }
        return most;
    }

    @ParameterizedTest
    @EnumSource
    void eightCornersAreReducedToFourThatCarryTheLoad(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5)).at(0, .999, 0);
        s.qb.rotateY(Math.PI / 4).rotateX(1e-4);
        long word = s.collide(n, .02, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(s.distance(n), deepest(), m.bound);
        double area = 0;
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                area =
                        Math.max(
                                area,
                                Math.hypot(m.pointX[i] - m.pointX[j], m.pointZ[i] - m.pointZ[j]));
            }
        }
        assertTrue(area > 1.0, "diagonal " + area);
        int[] first = names();
        for (int tick = 1; tick <= 100; tick++) {
            s.qb.identity().rotateY(Math.PI / 4 + 1e-4 * tick).rotateX(1e-7 * (tick % 7));
            word = s.collide(n, .02, word, m);
            assertArrayEquals(first, names(), "tick " + tick);
        }
    }

    @Test
    void aHullOfFiveHundredPointsRestsOnABox() {
        NarrowPhase n = new NarrowPhase();
        SplittableRandom r = new SplittableRandom(24);
        for (int i = 0; i < 100; i++) {
            ConvexHull hull = Scene.hull(r, 500, 1);
            Scene s = new Scene(Box.ofHalfExtents(5, 1, 5), hull);
            s.qb = Scene.turn(r);
            double[] bounds = new double[6];
            hull.bounds(s.qb.x, s.qb.y, s.qb.z, s.qb.w, bounds, 0);
            s.at(.3, 1 - bounds[1] - 1e-3, .4);
            s.collide(n, .002, 0, m);
            assertTrue(m.pointCount > 0, "seed 24 pose " + i);
            assertEquals(-1e-3, deepest(), m.bound, "seed 24 pose " + i);
            assertTrue(m.normalY > .99, "seed 24 pose " + i);
            assertEquals(-1e-3, s.distance(n), 1e-14, "seed 24 pose " + i);
        }
    }

    @Test
    void facesWithAThousandSidesKeepDistinctNames() {
        int sides = 1000;
        double[] xyz = new double[6 * sides];
        for (int i = 0; i < sides; i++) {
            double angle = 2 * StrictMath.PI * i / sides;
            for (int end = 0; end < 2; end++) {
                int at = 3 * (2 * i + end);
                xyz[at] = StrictMath.cos(angle);
                xyz[at + 1] = end == 0 ? -.5 : .5;
                xyz[at + 2] = StrictMath.sin(angle);
            }
        }
        ConvexHull disc = ConvexHull.of(xyz);
        assertEquals(2 * sides, Polyhedron.of(disc).vertexCount());
        Scene s = new Scene(disc, disc).at(.3, .999, .2);
        s.qb.rotateY(.0007);
        s.collide(new NarrowPhase(), .01, 0, m);
        assertEquals(4, m.pointCount);
        assertEquals(-.001, deepest(), 1e-14);
        assertEquals(4, Arrays.stream(names()).distinct().count());
    }

    @Test
    void equalPosesAndWordsGiveEqualBits() {
        SplittableRandom r = new SplittableRandom(25);
        NarrowPhase used = new NarrowPhase();
        Manifold other = new Manifold();
        for (int i = 0; i < 2_000; i++) {
            Scene s = Scene.random(r, Scene.hull(r, 4 + r.nextInt(100), 1), Scene.box(r));
            long word = r.nextLong();
            long a = s.collide(used, .1, word, m);
            long b = s.collide(new NarrowPhase(), .1, word, other);
            assertEquals(a, b, "seed 25 pose " + i);
            assertEquals(m.pointCount, other.pointCount);
            assertEquals(
                    m.pointCount == 0 ? 0 : m.normalX, m.pointCount == 0 ? 0 : other.normalX, 0.0);
            for (int p = 0; p < m.pointCount; p++) {
                assertEquals(m.separation[p], other.separation[p], 0.0);
                assertEquals(m.pointX[p], other.pointX[p], 0.0);
                assertEquals(m.feature[p], other.feature[p]);
            }
        }
    }

    @Test
    void collidingAllocatesNothing() {
        SplittableRandom r = new SplittableRandom(26);
        Scene[] scenes = new Scene[300];
        for (int i = 0; i < scenes.length; i++) {
            Shape a = i % 3 == 0 ? Sphere.of(1) : i % 3 == 1 ? Scene.box(r) : Scene.hull(r, 60, 1);
            Shape b = i % 4 == 0 ? Sphere.of(1) : i % 4 < 3 ? Scene.box(r) : Scene.hull(r, 20, 1);
            scenes[i] = Scene.random(r, a, b);
        }
        NarrowPhase n = new NarrowPhase();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long allocated = Long.MAX_VALUE;
        for (int attempt = 0; attempt < 5; attempt++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (Scene s : scenes) {
                s.distance(n);
                s.collide(n, .1, s.collide(n, .1, 0, m), m);
            }
            allocated = Math.min(allocated, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertEquals(0, allocated);
    }
}
