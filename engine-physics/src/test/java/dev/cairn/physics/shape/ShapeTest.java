package dev.cairn.physics.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.DegenerateShapeException.Reason;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** Mass against closed forms, hulls against their definition, bad input against its reason. */
class ShapeTest {
    private static double[] corners(
            double hx, double hy, double hz, Vector3d at, Quaterniond turn) {
        double[] xyz = new double[24];
        for (int i = 0; i < 8; i++) {
            Vector3d p =
                    turn.transform(
                                    new Vector3d(
                                            (i & 1) == 0 ? -hx : hx,
                                            (i & 2) == 0 ? -hy : hy,
                                            (i & 4) == 0 ? -hz : hz))
                            .add(at);
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        return xyz;
    }

    /** Outward planes, every input point below all of them, Euler's formula. */
    private static void isHullOf(double[] xyz, ConvexHull hull, double tolerance) {
        Polyhedron h = Polyhedron.of(hull);
        assertEquals(2, h.vertexCount() - h.edgeCount() + h.faceCount());
        Vector3d c = hull.centreOfMass(new Vector3d());
        double extent = 2 * h.outerRadius();
        for (int f = 0; f < h.faceCount(); f++) {
            assertTrue(h.offset(f) > 0, "the centre of mass is inside");
            for (int i = 0; i < xyz.length; i += 3) {
                double above =
                        h.normalX(f) * (xyz[i] - c.x)
                                + h.normalY(f) * (xyz[i + 1] - c.y)
                                + h.normalZ(f) * (xyz[i + 2] - c.z)
                                - h.offset(f);
                assertTrue(
                        above <= tolerance * extent,
                        "point " + i / 3 + " above face " + f + " by " + above);
            }
        }
    }

    @Test
    void aBoxSaysInItsNameWhetherItTakesHalfOrWholeEdges() {
        Box box = Box.ofEdges(1, 2, 4);
        assertEquals(8, box.volume());
        assertEquals(Box.ofHalfExtents(.5, 1, 2).toString(), box.toString());
        assertEquals(8, Box.cubeOfEdge(2).volume());
        assertEquals(8, Box.cubeOfHalfExtent(1).volume());
        assertThrows(DegenerateShapeException.class, () -> Box.ofEdges(1, -1, 1));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "3, -4, 5", "1e4, -2e4, 3e4"})
    void aHullOfBoxCornersIsTheBox(double x, double y, double z) {
        Quaterniond turn = new Quaterniond().rotateXYZ(.3, .7, -1.1);
        double[] xyz = corners(.5, 1, 2, new Vector3d(x, y, z), turn);
        ConvexHull hull = ConvexHull.of(xyz);
        Box box = Box.ofHalfExtents(.5, 1, 2);
        double tolerance = 1e-14 * (1 + 10 * Math.abs(x));
        assertEquals(6, Polyhedron.of(hull).faceCount());
        assertEquals(12, Polyhedron.of(hull).edgeCount());
        assertEquals(box.volume(), hull.volume(), 8 * tolerance);
        assertEquals(box.innerRadius(), hull.innerRadius(), 4 * tolerance);
        assertEquals(box.outerRadius(), hull.outerRadius(), 4 * tolerance);
        assertEquals(0, hull.centreOfMass(new Vector3d()).distance(x, y, z), 4 * tolerance);
        MassProperties m = hull.massProperties(3);
        MassProperties b = box.massProperties(3);
        assertEquals(3 * 8, b.mass(), 1e-14);
        assertEquals(24.0 / 3 * (1 + 4), b.ixx(), 1e-13);
        Matrix3d r = new Matrix3d().set(turn);
        Matrix3d expected =
                new Matrix3d(r)
                        .mul(new Matrix3d().m00(b.ixx()).m11(b.iyy()).m22(b.izz()))
                        .mul(new Matrix3d(r).transpose());
        assertEquals(expected.m00, m.ixx(), 100 * tolerance);
        assertEquals(expected.m11, m.iyy(), 100 * tolerance);
        assertEquals(expected.m22, m.izz(), 100 * tolerance);
        assertEquals(expected.m10, m.ixy(), 100 * tolerance);
        assertEquals(expected.m20, m.ixz(), 100 * tolerance);
        assertEquals(expected.m21, m.iyz(), 100 * tolerance);
    }

    @Test
    void aTetrahedronHasItsClosedForm() {
        ConvexHull hull = ConvexHull.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
        MassProperties m = hull.massProperties(6);
        assertEquals(1, m.mass(), 1e-15);
        assertEquals(.25, m.comX(), 1e-16);
        assertEquals(.25, m.comY(), 1e-16);
        assertEquals(.25, m.comZ(), 1e-16);
        assertEquals(3.0 / 40, m.ixx(), 1e-16);
        assertEquals(3.0 / 40, m.iyy(), 1e-16);
        assertEquals(3.0 / 40, m.izz(), 1e-16);
        assertEquals(1.0 / 80, m.ixy(), 1e-16);
        assertEquals(1.0 / 80, m.ixz(), 1e-16);
        assertEquals(1.0 / 80, m.iyz(), 1e-16);
    }

    @Test
    void aBallHasItsClosedForm() {
        MassProperties m = Sphere.of(2).massProperties(10);
        assertEquals(10 * 32 / 3.0 * Math.PI, m.mass(), 1e-12);
        assertEquals(.4 * m.mass() * 4, m.iyy(), 1e-12);
        double[] bounds = new double[7];
        Sphere.of(2).bounds(0, 0, 0, 1, bounds, 1);
        assertEquals(-2, bounds[1], 0.0);
        assertEquals(2, bounds[6], 0.0);
    }

    @Test
    void aFineHullOfABallApproachesTheBall() {
        SplittableRandom r = new SplittableRandom(31);
        double[] xyz = onBall(r, 10_000);
        ConvexHull hull = ConvexHull.of(xyz);
        assertEquals(10_000, Polyhedron.of(hull).vertexCount());
        assertEquals(4.0 / 3 * Math.PI, hull.volume(), .005);
        assertEquals(.4 * hull.volume(), hull.massProperties(1).ixx(), .005);
    }

    private static double[] onBall(SplittableRandom r, int n) {
        double[] xyz = new double[3 * n];
        for (int i = 0; i < n; i++) {
            Vector3d p = new Vector3d();
            do {
                p.set(2 * r.nextDouble() - 1, 2 * r.nextDouble() - 1, 2 * r.nextDouble() - 1);
            } while (p.lengthSquared() > 1 || p.lengthSquared() < .01);
            p.normalize();
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        return xyz;
    }

    @Test
    void everyPointLiesInItsHull() {
        SplittableRandom r = new SplittableRandom(32);
        for (int i = 0; i < 300; i++) {
            int n = 4 + r.nextInt(60);
            double[] xyz = onBall(r, n);
            int kind = i % 3;
            for (int k = 0; k < xyz.length; k++) {
                xyz[k] =
                        kind == 0
                                ? xyz[k]
                                : r.nextInt(5) + (kind == 1 ? 0 : 1e-12 * r.nextDouble());
            }
            try {
                isHullOf(xyz, ConvexHull.of(xyz), 3e-7);
            } catch (DegenerateShapeException e) {
                assertTrue(kind > 0, "seed 32 hull " + i + ": " + e.getMessage());
            }
        }
    }

    @Test
    void aGridOfManyPointsWithDuplicatesIsACube() {
        double[] xyz = new double[3 * 2 * 21 * 21 * 21];
        int at = 0;
        for (int copy = 0; copy < 2; copy++) {
            for (int i = 0; i < 21 * 21 * 21; i++) {
                xyz[at++] = i % 21 * .1;
                xyz[at++] = i / 21 % 21 * .1;
                xyz[at++] = i / 441 * .1;
            }
        }
        ConvexHull hull = ConvexHull.of(xyz);
        assertEquals(8, Polyhedron.of(hull).vertexCount());
        assertEquals(6, Polyhedron.of(hull).faceCount());
        assertEquals(8, hull.volume(), 1e-14);
        assertEquals(4, Polyhedron.of(hull).largestFace());
        double[] corners = hull.vertices();
        assertTrue(
                Arrays.stream(corners).allMatch(c -> c == 0 || c == 2), Arrays.toString(corners));
        assertEquals(4, hull.faceLoops()[0].length);
    }

    /** Caps with thousands of corners; a hull that rebuilds the cap for each takes minutes. */
    @ParameterizedTest
    @ValueSource(doubles = {0, .4, 1.3})
    void aDrumOfThreeThousandSidesHasTwoCaps(double tilt) {
        int sides = 3000;
        Quaterniond q = new Quaterniond().rotateXYZ(tilt, .7 * tilt, .3 * tilt);
        double[] xyz = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            double angle = 2 * StrictMath.PI * (i / 2) / sides;
            Vector3d p =
                    q.transform(
                            new Vector3d(
                                    StrictMath.cos(angle), (i & 1) - .5, StrictMath.sin(angle)));
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        ConvexHull drum = ConvexHull.of(xyz);
        assertEquals(sides + 2, Polyhedron.of(drum).faceCount());
        assertEquals(2 * sides, Polyhedron.of(drum).vertexCount());
        assertEquals(sides, Polyhedron.of(drum).largestFace());
        assertEquals(.5 * sides * StrictMath.sin(2 * StrictMath.PI / sides), drum.volume(), 1e-12);
    }

    @Test
    void thinCardsAndNeedlesAreSolid() {
        for (double thin : new double[] {1e-3, 1e-6}) {
            ConvexHull card =
                    ConvexHull.of(
                            corners(1, thin, 1, new Vector3d(), new Quaterniond().rotateX(.4)));
            assertEquals(6, Polyhedron.of(card).faceCount());
            assertEquals(8 * thin, card.volume(), 1e-14);
        }
        ConvexHull needle =
                ConvexHull.of(
                        corners(1e-5, 1, 1e-5, new Vector3d(), new Quaterniond().rotateX(.4)));
        assertEquals(8e-10, needle.volume(), 1e-19);
    }

    @Test
    void loopsRunCounterClockwiseAndEveryEdgeHasTwoFaces() {
        Polyhedron h = Polyhedron.of(Box.ofHalfExtents(1, 2, 3));
        int[] uses = new int[h.edgeCount()];
        for (int f = 0; f < h.faceCount(); f++) {
            for (int s = h.faceBegin(f); s < h.faceBegin(f + 1); s++) {
                uses[h.slotEdge(s)]++;
                int v = h.slotVertex(s);
                double on =
                        h.normalX(f) * h.vertexX(v)
                                + h.normalY(f) * h.vertexY(v)
                                + h.normalZ(f) * h.vertexZ(v);
                assertEquals(h.offset(f), on, 0.0);
                double inside = h.sideOffset(s);
                assertTrue(inside > 0, "the face's centre is inside each of its sides");
            }
            int axis = f / 2;
            double[] n = {h.normalX(f), h.normalY(f), h.normalZ(f)};
            assertEquals((f & 1) == 0 ? -1 : 1, n[axis], 0.0);
        }
        assertTrue(Arrays.stream(uses).allMatch(u -> u == 2));
    }

    @Test
    void boundsTouchTheRotatedCorners() {
        SplittableRandom r = new SplittableRandom(33);
        double[] box = new double[6];
        double[] hull = new double[6];
        for (int i = 0; i < 1_000; i++) {
            Quaterniond q =
                    new Quaterniond(
                                    r.nextDouble() - .5,
                                    r.nextDouble() - .5,
                                    r.nextDouble() - .5,
                                    r.nextDouble())
                            .normalize();
            Box shape =
                    Box.ofHalfExtents(
                            .5 + r.nextDouble(), .5 + r.nextDouble(), .5 + r.nextDouble());
            shape.bounds(q.x, q.y, q.z, q.w, box, 0);
            Polyhedron.of(shape).bounds(q.x, q.y, q.z, q.w, hull, 0);
            double top = -Double.MAX_VALUE;
            for (int v = 0; v < 8; v++) {
                Polyhedron p = Polyhedron.of(shape);
                top =
                        Math.max(
                                top,
                                q.transform(new Vector3d(p.vertexX(v), p.vertexY(v), p.vertexZ(v)))
                                        .y);
            }
            assertEquals(top, box[4], 4e-15);
            for (int k = 0; k < 6; k++) {
                assertEquals(box[k], hull[k], 4e-15, "seed 33 turn " + i);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY, Double.MIN_VALUE, 1e-60, 1e300})
    void aLengthThatIsNoLengthIsRefused(double bad) {
        for (Reason reason : List.of(Double.isFinite(bad) ? Reason.EXTENT : Reason.NOT_FINITE)) {
            var sphere = assertThrows(DegenerateShapeException.class, () -> Sphere.of(bad));
            assertSame(reason, sphere.reason());
            assertTrue(sphere.getMessage().contains(String.valueOf(bad)), sphere.getMessage());
            assertSame(
                    reason,
                    assertThrows(DegenerateShapeException.class, () -> Box.ofHalfExtents(1, bad, 1))
                            .reason());
            assertSame(
                    reason,
                    assertThrows(DegenerateShapeException.class, () -> Box.cubeOfHalfExtent(bad))
                            .reason());
        }
        if (!(bad > 0 && Double.isFinite(bad))) {
            assertThrows(IllegalArgumentException.class, () -> Sphere.of(1).massProperties(bad));
        }
    }

    @Test
    void pointsWithoutAVolumeAreRefusedWithTheReason() {
        refused(Reason.TOO_FEW_POINTS, 0, 0, 0, 1, 0, 0, 0, 1, 0);
        refused(Reason.COINCIDENT, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3);
        refused(Reason.COLLINEAR, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 5, 5, 5);
        refused(Reason.COPLANAR, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, .5, .3, 0);
        refused(Reason.NOT_FINITE, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, Double.NaN, 1);
        refused(Reason.NOT_FINITE, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, Double.NEGATIVE_INFINITY, 1);
        refused(Reason.EXTENT, 0, 0, 0, 1e-60, 0, 0, 0, 1e-60, 0, 0, 0, 1e-60);
        assertThrows(IllegalArgumentException.class, () -> ConvexHull.of(new double[13]));
        assertThrows(IllegalArgumentException.class, () -> ConvexHull.of((double[]) null));
        assertThrows(IllegalArgumentException.class, () -> ConvexHull.of((List<Vector3d>) null));
        var hole =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> ConvexHull.of(Arrays.asList(new Vector3d(), null)));
        assertTrue(hole.getMessage().contains("point 1 of 2"), hole.getMessage());
    }

    private static void refused(Reason reason, double... xyz) {
        var e = assertThrows(DegenerateShapeException.class, () -> ConvexHull.of(xyz));
        assertSame(reason, e.reason(), e.getMessage());
        for (int i = 0; i < xyz.length; i += 3) {
            double[] again = Arrays.copyOf(xyz, xyz.length + 3);
            System.arraycopy(xyz, i, again, xyz.length, 3);
            if (reason != Reason.TOO_FEW_POINTS) {
                assertThrows(DegenerateShapeException.class, () -> ConvexHull.of(again));
            }
        }
    }

    @Test
    void vectorsGiveTheSameHullAsNumbers() {
        List<Vector3d> points =
                List.of(
                        new Vector3d(),
                        new Vector3d(1, 0, 0),
                        new Vector3d(0, 1, 0),
                        new Vector3d(0, 0, 1));
        assertEquals(1.0 / 6, ConvexHull.of(points).volume(), 1e-16);
    }

    /** Leaning prisms, so that faces have many corners and the centre is no round number. */
    @Test
    void mirroredHullsHaveMirroredBits() {
        SplittableRandom r = new SplittableRandom(71);
        for (int sides = 3; sides <= 14; sides++) {
            double[] xyz = new double[6 * sides];
            double lean = r.nextDouble();
            for (int i = 0; i < 2 * sides; i++) {
                double angle = (i / 2 + .6 * r.nextDouble()) * 2 * StrictMath.PI / sides;
                angle = i % 2 == 1 ? StrictMath.atan2(xyz[3 * i - 1], xyz[3 * i - 3]) : angle;
                xyz[3 * i] = StrictMath.cos(angle);
                xyz[3 * i + 1] = i % 2;
                xyz[3 * i + 2] = StrictMath.sin(angle);
            }
            for (int i = 0; i < 2 * sides; i++) {
                xyz[3 * i] += lean * (i % 2) + 3;
            }
            double[] image = xyz.clone();
            for (int i = 0; i < image.length; i += 3) {
                image[i] = -image[i];
            }
            ConvexHull hull = ConvexHull.of(xyz);
            ConvexHull other = ConvexHull.of(image);
            String where = sides + " sides, seed 71";
            MassProperties m = hull.massProperties(1);
            MassProperties n = other.massProperties(1);
            assertEquals(m.mass(), n.mass(), 0.0, where);
            assertEquals(m.comX(), -n.comX(), 0.0, where);
            assertEquals(m.comY(), n.comY(), 0.0, where);
            assertEquals(m.ixx(), n.ixx(), 0.0, where);
            assertEquals(m.ixz(), -n.ixz(), 0.0, where);
            Polyhedron p = Polyhedron.of(hull);
            Polyhedron q = Polyhedron.of(other);
            assertEquals(p.faceCount(), q.faceCount(), where);
            for (int f = 0; f < p.faceCount(); f++) {
                assertEquals(p.normalX(f), -q.normalX(f), 0.0, where);
                assertEquals(p.normalY(f), q.normalY(f), 0.0, where);
                assertEquals(p.offset(f), q.offset(f), 0.0, where);
            }
        }
    }
}
