package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Arrays;
import java.util.SplittableRandom;

/** A contact at rest keeps its face and its names, and pays for that with a stated error. */
class CalmTest {
    private final Manifold m = new Manifold();

    private double deepest() {
        return Arrays.stream(m.separation, 0, m.pointCount).min().orElseThrow();
    }

    static ConvexHull ball(int points) {
        double[] xyz = new double[3 * points];
        double golden = StrictMath.PI * (3 - Math.sqrt(5));
        for (int i = 0; i < points; i++) {
            double y = 1 - 2 * (i + .5) / points;
            double radius = Math.sqrt(1 - y * y);
            xyz[3 * i] = radius * StrictMath.cos(golden * i);
            xyz[3 * i + 1] = y;
            xyz[3 * i + 2] = radius * StrictMath.sin(golden * i);
        }
        return ConvexHull.of(xyz);
    }

    /** Neighbouring faces of a needle differ by little, and a face's axis may lie far off. */
    static ConvexHull needle(int points) {
        double[] xyz = ball(points).vertices();
        for (int i = 0; i < xyz.length; i += 3) {
            xyz[i] *= .1;
            xyz[i + 1] *= 2;
            xyz[i + 2] *= .1;
        }
        return ConvexHull.of(xyz);
    }

    static ConvexHull cylinder(int sides) {
        double[] xyz = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            double angle = 2 * StrictMath.PI * (i / 2) / sides;
            xyz[3 * i] = .5 * StrictMath.cos(angle);
            xyz[3 * i + 1] = (i & 1) - .5;
            xyz[3 * i + 2] = .5 * StrictMath.sin(angle);
        }
        return ConvexHull.of(xyz);
    }

    private void depthIsTrue(Scene s, double truth, String where) {
        NarrowPhase n = new NarrowPhase();
        s.collide(n, .01, 0, m);
        double inner = Math.min(s.a.innerRadius(), s.b.innerRadius());
        double bound = 1.5e-3 * inner + .15 * Math.abs(truth) + 1e-13 * s.size();
        if (truth <= 0) {
            assertTrue(m.pointCount > 0, where);
        }
        if (m.pointCount > 0) {
            assertEquals(truth, deepest(), bound, where);
            assertEquals(truth, deepest(), m.bound, where);
        }
    }

    @Test
    void theDepthOfFacetedShapesIsTheTrueOneWithinTheBound() {
        Shape[] shapes = {ball(60), cylinder(24), Box.ofHalfExtents(.7, .4, .9), cylinder(7)};
        SplittableRandom r = new SplittableRandom(51);
        for (int i = 0; i < 150; i++) {
            Scene s = Scene.random(r, shapes[r.nextInt(2)], shapes[r.nextInt(4)]);
            double truth = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
            if (truth > 0) {
                truth = ConvexOracle.distance(s.placedA(), s.placedB());
            }
            depthIsTrue(s, truth, "seed 51 pose " + i + " truth " + truth);
        }
    }

    /** Too many features for brute force; {@code distance} is checked against it elsewhere. */
    @Test
    void theDepthOfFineShapesIsTheTrueOneWithinTheBound() {
        Shape[] shapes = {ball(500), needle(300), cylinder(128), Box.ofHalfExtents(.7, .4, .9)};
        SplittableRandom r = new SplittableRandom(52);
        NarrowPhase n = new NarrowPhase();
        for (int i = 0; i < 1_500; i++) {
            Scene s = Scene.random(r, shapes[r.nextInt(3)], shapes[r.nextInt(4)]);
            double truth = s.distance(n);
            // Most of the poses barely overlap, as at rest.
            if (i % 4 > 0) {
                Vector3d axis = new Vector3d(n.axisX(), n.axisY(), n.axisZ());
                double inner = Math.min(s.a.innerRadius(), s.b.innerRadius());
                s.d.fma(-truth - .1 * inner * r.nextDouble(), axis);
                truth = s.distance(n);
            }
            depthIsTrue(s, truth, "seed 52 pose " + i + " truth " + truth);
        }
    }

    /** Near touching every axis is as deep as any other, and none but the edges' is right. */
    @ParameterizedTest
    @EnumSource
    void crossedEdgesKeepTheirNormalUntilTheyPart(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s = new Scene(Box.ofHalfExtents(.5, .5, 2), Box.ofHalfExtents(2, .5, .5));
        s.qa.rotateZ(Math.PI / 4);
        s.qb.rotateX(Math.PI / 4 + .1).rotateY(.2);
        double touching = touchingHeight(n, s);
        long word = 0;
        for (int tick = 0; tick <= 200; tick++) {
            s.at(.01, touching - 1e-3 + 1e-5 * tick, .02);
            word = s.collide(n, .02, word, m);
            assertEquals(1, m.pointCount, "tick " + tick);
            assertEquals(2, m.feature[0] >>> 30, "tick " + tick);
            assertTrue(m.normalY > .97, "tick " + tick + " normal " + m.normalY);
        }
    }

    private static double touchingHeight(NarrowPhase n, Scene s) {
        double low = 1;
        double high = 2;
        for (int i = 0; i < 60; i++) {
            double mid = .5 * (low + high);
            if (s.at(.01, mid, .02).distance(n) > 0) {
                high = mid;
            } else {
                low = mid;
            }
        }
        return low;
    }

    /** Cubes that sway by a little more than the first tolerance: one change of names at most. */
    @ParameterizedTest
    @EnumSource
    void swayingCubesKeepTheirNames(NarrowPhase.Method method) {
        for (double sway : new double[] {1e-9, 1e-7, 4e-6, 6e-6, 2e-5, 1e-4, 2e-4}) {
            NarrowPhase n = new NarrowPhase(method);
            SplittableRandom r = new SplittableRandom(53);
            long word = 0;
            int changes = 0;
            int[] before = {};
            for (int tick = 0; tick < 400; tick++) {
                Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5));
                s.at(sway * Scene.gauss(r), .9999, sway * Scene.gauss(r));
                s.qb.rotateY(sway * Scene.gauss(r))
                        .rotateX(.1 * sway * Scene.gauss(r))
                        .rotateZ(.1 * sway * Scene.gauss(r));
                word = s.collide(n, .01, word, m);
                int[] names = Arrays.copyOf(m.feature, m.pointCount);
                changes += tick > 50 && !Arrays.equals(before, names) ? 1 : 0;
                before = names;
                assertEquals(4, m.pointCount, "sway " + sway + " tick " + tick);
            }
            assertEquals(0, changes, method + " seed 53 sway " + sway);
        }
    }

    /** A cube pushed corner-deep into another, two faces equally good: the first one stays. */
    @ParameterizedTest
    @EnumSource
    void ofEquallyGoodFacesTheFirstOneStays(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        SplittableRandom r = new SplittableRandom(54);
        long word = 0;
        double side = 0;
        for (int tick = 0; tick < 400; tick++) {
            Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5));
            s.at(.9 + 1e-5 * Scene.gauss(r), .9 + 1e-5 * Scene.gauss(r), 0);
            word = s.collide(n, .01, word, m);
            side = tick == 0 ? m.normalX : side;
            assertEquals(side, m.normalX, 1e-3, "seed 54 tick " + tick);
        }
    }
}
