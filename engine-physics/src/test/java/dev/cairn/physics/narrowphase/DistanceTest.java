package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.SplittableRandom;
import java.util.function.Function;

/** Signed distances against brute force over all features, and against themselves. */
class DistanceTest {
    private static final Function<SplittableRandom, Scene> BOXES =
            r -> Scene.random(r, Scene.box(r), Scene.box(r));
    private static final Function<SplittableRandom, Scene> HULLS =
            r ->
                    Scene.random(
                            r,
                            Scene.hull(r, 4 + r.nextInt(16), 1),
                            Scene.hull(r, 4 + r.nextInt(16), 1));
    private static final Function<SplittableRandom, Scene> LATTICE =
            r -> {
                Scene s =
                        new Scene(
                                Box.ofHalfExtents(.5 * (1 + r.nextInt(3)), .5, 1),
                                Box.ofHalfExtents(.5, 1, .5 * (1 + r.nextInt(2))));
                s.d.set(
                        (r.nextInt(33) - 16) / 8.0,
                        (r.nextInt(33) - 16) / 8.0,
                        (r.nextInt(33) - 16) / 8.0);
                s.qb.rotateX(Math.PI / 2 * r.nextInt(4)).rotateY(Math.PI / 2 * r.nextInt(4));
                return s;
            };

    private static void agrees(
            NarrowPhase.Method method,
            int poses,
            long seed,
            Function<SplittableRandom, Scene> make) {
        SplittableRandom r = new SplittableRandom(seed);
        NarrowPhase n = new NarrowPhase(method);
        for (int i = 0; i < poses; i++) {
            Scene s = make.apply(r);
            double d = s.distance(n);
            double truth = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
            if (truth > 0) {
                truth = ConvexOracle.distance(s.placedA(), s.placedB());
            }
            String where = method + " seed " + seed + " pose " + i + " truth " + truth;
            assertEquals(truth, d, 1e-12 * s.size(), where);
            assertFalse(n.capped(), where);
        }
    }

    @ParameterizedTest
    @EnumSource
    void boxesAgreeWithBruteForce(NarrowPhase.Method method) {
        agrees(method, 10_000, 11, BOXES);
    }

    @ParameterizedTest
    @EnumSource
    void alignedBoxesOnALatticeAgreeWithBruteForce(NarrowPhase.Method method) {
        agrees(method, 2_000, 12, LATTICE);
    }

    @ParameterizedTest
    @EnumSource
    void hullsAgreeWithBruteForce(NarrowPhase.Method method) {
        agrees(method, 300, 13, HULLS);
    }

    @ParameterizedTest
    @EnumSource
    void ballAgainstPolyhedronAgreesWithProjection(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(14);
        NarrowPhase n = new NarrowPhase(method);
        for (int i = 0; i < 4_000; i++) {
            double radius = Scene.logUniform(r, .01, 2);
            Scene s =
                    Scene.random(
                            r,
                            (i & 1) == 0 ? Scene.box(r) : Scene.hull(r, 4 + r.nextInt(60), 1),
                            Sphere.of(radius));
            ConvexOracle.Placed a = s.placedA();
            double truth = ConvexOracle.pointDistance(a, s.d);
            String where = method + " seed 14 pose " + i;
            assertEquals(truth - radius, s.distance(n), 1e-12 * s.size(), where);
            assertEquals(truth - radius, s.swapped().distance(n), 1e-12 * s.size(), where);
        }
    }

    @ParameterizedTest
    @EnumSource
    void movedByTheDepthAlongTheAxisTheShapesJustTouch(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(15);
        NarrowPhase n = new NarrowPhase(method);
        int overlapping = 0;
        for (int i = 0; i < 5_000; i++) {
            Scene s =
                    (i & 3) == 0
                            ? HULLS.apply(r)
                            : (i & 3) == 1 ? LATTICE.apply(r) : BOXES.apply(r);
            double d = s.distance(n);
            Vector3d axis = new Vector3d(n.axisX(), n.axisY(), n.axisZ());
            String where = method + " seed 15 pose " + i + " distance " + d;
            assertEquals(1, axis.length(), 1e-14, where);
            overlapping += d < 0 ? 1 : 0;
            s.d.fma(-d, axis);
            assertEquals(0, s.distance(n), (d < 0 ? 4e-15 : 1e-13) * s.size(), where);
        }
        assertTrue(overlapping > 1_000, "poses overlap: " + overlapping);
    }

    @ParameterizedTest
    @EnumSource
    void theOrderOfTheShapesDoesNotMatter(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(16);
        NarrowPhase n = new NarrowPhase(method);
        for (int i = 0; i < 5_000; i++) {
            Scene s = (i & 1) == 0 ? HULLS.apply(r) : BOXES.apply(r);
            double d = s.distance(n);
            Vector3d axis = new Vector3d(n.axisX(), n.axisY(), n.axisZ());
            assertEquals(
                    d, s.swapped().distance(n), 1e-13 * s.size(), method + " seed 16 pose " + i);
            Vector3d back = new Vector3d(n.axisX(), n.axisY(), n.axisZ());
            // Where two axes are equally deep either may be reported, and nothing is said about the
            // angle between them.
            assertTrue(back.add(axis).length() < 1e-7, method + " seed 16 pose " + i + " " + back);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aPowerOfTwoScalesEveryResultExactly(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Manifold one = new Manifold();
        Manifold two = new Manifold();
        for (int k = -30; k <= 30; k += 3) {
            SplittableRandom r = new SplittableRandom(17);
            double scale = StrictMath.scalb(1.0, k);
            for (int i = 0; i < 200; i++) {
                Scene s = BOXES.apply(r);
                Box a = (Box) s.a;
                Box b = (Box) s.b;
                Scene big =
                        new Scene(
                                Box.ofHalfExtents(
                                        scale * a.halfX(), scale * a.halfY(), scale * a.halfZ()),
                                Box.ofHalfExtents(
                                        scale * b.halfX(), scale * b.halfY(), scale * b.halfZ()));
                big.qa = s.qa;
                big.qb = s.qb;
                big.d = s.d.mul(scale, new Vector3d());
                assertEquals(
                        scale * s.distance(n), big.distance(n), 0.0, "scale 2^" + k + " pose " + i);
                s.collide(n, .1, 0, one);
                big.collide(n, .1 * scale, 0, two);
                assertEquals(one.pointCount, two.pointCount);
                for (int p = 0; p < one.pointCount; p++) {
                    assertEquals(scale * one.separation[p], two.separation[p], 0.0);
                    assertEquals(scale * one.pointY[p], two.pointY[p], 0.0);
                    assertEquals(one.feature[p], two.feature[p]);
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void slidingThroughChangesTheDistanceNoFasterThanTheMotion(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(18);
        NarrowPhase n = new NarrowPhase(method);
        for (int sweep = 0; sweep < 60; sweep++) {
            Scene s = (sweep & 1) == 0 ? HULLS.apply(r) : LATTICE.apply(r);
            Vector3d along = Scene.direction(r);
            double step = s.size() / 200;
            s.d.fma(-200 * step, along);
            double last = s.distance(n);
            for (int i = 0; i < 400; i++) {
                s.d.fma(step, along);
                double d = s.distance(n);
                assertTrue(
                        Math.abs(d - last) <= step + 1e-14 * s.size(),
                        method
                                + " seed 18 sweep "
                                + sweep
                                + " step "
                                + i
                                + ": "
                                + last
                                + " to "
                                + d);
                last = d;
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void posesThatBrokeOtherEnginesHaveTheirClosedForm(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        // libccd issue 25: two cubes of 2 m at z = 1.9.
        assertEquals(
                -.1,
                new Scene(Box.cubeOfHalfExtent(1), Box.cubeOfHalfExtent(1))
                        .at(0, 0, 1.9)
                        .distance(n),
                1e-15);
        // FCL issue 493: cubes that kiss.
        assertEquals(
                0,
                new Scene(Box.cubeOfHalfExtent(.25), Box.cubeOfHalfExtent(.25))
                        .at(.5, 0, 0)
                        .distance(n),
                0.0);
        assertEquals(
                0,
                new Scene(Box.cubeOfHalfExtent(.25), Box.cubeOfHalfExtent(.25))
                        .at(.5, .5, .5)
                        .distance(n),
                0.0);
        // FCL issue 495: cubes an epsilon apart, on both sides of touching.
        for (int k = -15; k <= -1; k++) {
            double gap = StrictMath.pow(10, k);
            assertEquals(
                    gap,
                    new Scene(Box.cubeOfHalfExtent(.125), Box.cubeOfHalfExtent(.125))
                            .at(.25 + gap, .01, .02)
                            .distance(n),
                    2e-16);
            assertEquals(
                    -gap,
                    new Scene(Box.cubeOfHalfExtent(.125), Box.cubeOfHalfExtent(.125))
                            .at(.01, .25 - gap, .02)
                            .distance(n),
                    2e-16);
        }
        // mujoco_warp issue 1526: identical cubes dropped by 2.5e-4.
        assertEquals(
                -2.5e-4,
                new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5))
                        .at(0, 1 - 2.5e-4, 0)
                        .distance(n),
                2e-16);
        // Concentric.
        assertEquals(
                -2, new Scene(Box.cubeOfHalfExtent(1), Box.cubeOfHalfExtent(1)).distance(n), 1e-15);
        assertEquals(-4, new Scene(Sphere.of(2), Sphere.of(2)).distance(n), 0.0);
        assertEquals(1, Math.abs(n.axisX()) + Math.abs(n.axisY()) + Math.abs(n.axisZ()), 0.0);
        assertEquals(-3, new Scene(Box.cubeOfHalfExtent(1), Sphere.of(2)).distance(n), 0.0);
    }

    @ParameterizedTest
    @EnumSource
    void thinAndUnequalShapesKeepTheirDigits(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(19);
        NarrowPhase n = new NarrowPhase(method);
        for (int i = 0; i < 500; i++) {
            double thin = Scene.logUniform(r, 1e-6, 1e-2);
            double small = Scene.logUniform(r, 1e-3, 1);
            Scene s =
                    new Scene(
                            (i & 1) == 0
                                    ? Box.ofHalfExtents(1, thin, 1)
                                    : Box.ofHalfExtents(thin, 10, thin),
                            Box.ofHalfExtents(small, small, 2 * small));
            s.qa = Scene.turn(r);
            s.qb = Scene.turn(r);
            s.d =
                    s.qa.transform(
                            new Vector3d(
                                    Scene.gauss(r) * .5,
                                    small * Scene.gauss(r),
                                    Scene.gauss(r) * .5));
            double truth = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
            if (truth > 0) {
                truth = ConvexOracle.distance(s.placedA(), s.placedB());
            }
            assertEquals(truth, s.distance(n), 1e-12 * s.size(), method + " seed 19 pose " + i);
        }
    }

    @Test
    void climbingFindsTheSameSupportAsScanning() {
        SplittableRandom r = new SplittableRandom(20);
        for (int points : new int[] {50, 500, 4000}) {
            ConvexHull hull = Scene.hull(r, points, 1);
            Polyhedron h = Polyhedron.of(hull);
            for (int i = 0; i < 2_000; i++) {
                int face = r.nextInt(h.faceCount());
                Vector3d n =
                        (i & 1) == 0
                                ? Scene.direction(r)
                                : new Vector3d(h.normalX(face), h.normalY(face), h.normalZ(face));
                double best = -Double.MAX_VALUE;
                for (int v = 0; v < h.vertexCount(); v++) {
                    best =
                            Math.max(
                                    best,
                                    n.x * h.vertexX(v) + n.y * h.vertexY(v) + n.z * h.vertexZ(v));
                }
                int v = h.support(n.x, n.y, n.z, r.nextInt(h.vertexCount()));
                assertEquals(
                        best, n.x * h.vertexX(v) + n.y * h.vertexY(v) + n.z * h.vertexZ(v), 1e-15);
            }
        }
    }
}
