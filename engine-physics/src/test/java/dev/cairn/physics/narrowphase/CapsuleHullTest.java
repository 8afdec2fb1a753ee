package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * A capsule and a hull, whose axis comes from near features where these settle it: against the
 * iteration, and against the closed form of a box with the same corners.
 */
class CapsuleHullTest {
    /** Of the size. */
    private static final double ROUNDING = 4e-15;

    private final NarrowPhase special = new NarrowPhase();
    private final NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
    private final Manifold manifold = new Manifold();

    private void check(ShapeKind a, ShapeKind b, long seed) {
        ShapeKind.Two kinds = new ShapeKind.Two(a, b);
        EveryPairTest.Sort[] sorts = EveryPairTest.Sort.values();
        SplittableRandom r = new SplittableRandom(seed);
        double ways = 0;
        double out = 0;
        int settled = 0;
        for (int i = 0; i < 28_000; i++) {
            EveryPairTest.Sort sort = sorts[i % sorts.length];
            Scene s = sort.scene(r, kinds);
            String where = kinds + " " + sort + " seed " + seed + " pose " + i;
            double size = ShapeKind.size(s) + s.d.length();
            special.forgetIterations();
            double d = s.distance(special);
            settled += special.iterations() == 0 ? 1 : 0;
            Vector3d axis = EveryPairTest.axis(special);
            ways = Math.max(ways, Math.abs(s.distance(general) - d) / size);
            assertTrue(ways <= ROUNDING, where + ": GENERAL differs by " + ways);
            s.d.fma(-d, axis);
            out = Math.max(out, Math.abs(s.distance(special)) / size);
            assertTrue(out <= ROUNDING, where + ": pushed out, left " + out);
        }
        System.out.printf(
                "| %s | %.1e from GENERAL | pushed out %.1e | without iteration %d |%n",
                kinds, ways, out, settled);
        assertTrue(settled > 15_000, settled + " without iteration");
    }

    @Test
    void agreesWithTheGeneralWayToTheLastDigits() {
        check(ShapeKind.CAPSULE, ShapeKind.HULL, 311);
        check(ShapeKind.HULL, ShapeKind.CAPSULE, 312);
    }

    /** From 76 to 996 faces, round and long ones. */
    @Test
    void agreesWithTheGeneralWayOnHullsOfManyFaces() {
        SplittableRandom r = new SplittableRandom(316);
        EveryPairTest.Sort[] sorts = EveryPairTest.Sort.values();
        ConvexHull[] hulls = new ConvexHull[12];
        for (int i = 0; i < hulls.length; i++) {
            int points = (int) Scene.logUniform(r, 40, 500);
            double[] xyz = new double[3 * points];
            double wide = Scene.logUniform(r, .2, 2);
            double high = Scene.logUniform(r, .2, 2);
            for (int k = 0; k < points; k++) {
                Vector3d p = Scene.direction(r);
                xyz[3 * k] = wide * p.x;
                xyz[3 * k + 1] = high * p.y;
                xyz[3 * k + 2] = p.z;
            }
            hulls[i] = ConvexHull.of(xyz);
        }
        ShapeKind.Two kinds = new ShapeKind.Two(ShapeKind.HULL, ShapeKind.CAPSULE);
        double ways = 0;
        double out = 0;
        int settled = 0;
        for (int i = 0; i < 14_000; i++) {
            EveryPairTest.Sort sort = sorts[i % sorts.length];
            Scene s = sort.scene(r, kinds);
            ConvexHull hull = hulls[r.nextInt(hulls.length)];
            double bySize = hull.outerRadius() / s.a.outerRadius();
            s.d.mul(bySize);
            s.b = ShapeKind.scaled(s.b, bySize);
            s.a = hull;
            String where = "seed 316 pose " + i + " " + sort;
            double size = ShapeKind.size(s) + s.d.length();
            special.forgetIterations();
            double d = s.distance(special);
            settled += special.iterations() == 0 ? 1 : 0;
            Vector3d axis = EveryPairTest.axis(special);
            ways = Math.max(ways, Math.abs(s.distance(general) - d) / size);
            assertTrue(ways <= ROUNDING, where + ": GENERAL differs by " + ways);
            s.d.fma(-d, axis);
            out = Math.max(out, Math.abs(s.distance(special)) / size);
            assertTrue(out <= ROUNDING, where + ": pushed out, left " + out);
        }
        System.out.printf(
                "many faces: %.1e from GENERAL, pushed out %.1e, without iteration %d%n",
                ways, out, settled);
        assertTrue(settled > 7_000, settled + " without iteration");
    }

    private static ConvexHull hullOf(Box box) {
        double[] xyz = new double[24];
        for (int i = 0; i < 8; i++) {
            xyz[3 * i] = (i & 1) == 0 ? -box.halfX() : box.halfX();
            xyz[3 * i + 1] = (i & 2) == 0 ? -box.halfY() : box.halfY();
            xyz[3 * i + 2] = (i & 4) == 0 ? -box.halfZ() : box.halfZ();
        }
        return ConvexHull.of(xyz);
    }

    /** Apart, resting, touching with the segment, parallel to edges and faces. */
    @Test
    void theHullOfABoxIsAsFarAsTheBox() {
        SplittableRandom r = new SplittableRandom(313);
        EveryPairTest.Sort[] sorts = EveryPairTest.Sort.values();
        Box[] boxes = new Box[40];
        ConvexHull[] hulls = new ConvexHull[boxes.length];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] =
                    Box.ofHalfExtents(
                            Scene.logUniform(r, .1, 2),
                            Scene.logUniform(r, .1, 2),
                            Scene.logUniform(r, .1, 2));
            hulls[i] = hullOf(boxes[i]);
        }
        ShapeKind.Two kinds = new ShapeKind.Two(ShapeKind.BOX, ShapeKind.CAPSULE);
        int settled = 0;
        for (int i = 0; i < 100_000; i++) {
            int which = r.nextInt(boxes.length);
            EveryPairTest.Sort sort = sorts[i % sorts.length];
            Scene s = sort.scene(r, kinds);
            double bySize = boxes[which].outerRadius() / s.a.outerRadius();
            s.d.mul(bySize);
            s.b = ShapeKind.scaled(s.b, bySize);
            s.a = boxes[which];
            String where = "seed 313 pose " + i + " " + sort;
            double truth = s.distance(special);
            Vector3d axis = EveryPairTest.axis(special);
            s.a = hulls[which];
            special.forgetIterations();
            double d = s.distance(special);
            settled += special.iterations() == 0 ? 1 : 0;
            double size = ShapeKind.size(s) + s.d.length();
            assertEquals(truth, d, ROUNDING * size, where);
            boolean clear = d + s.b.innerRadius() > 1e-2 * size;
            if (clear) {
                // The way to the nearest point is but one; it turns by the root of what is lost.
                double off = axis.distance(EveryPairTest.axis(special));
                assertTrue(off <= 2e-6, where + ": axis off by " + off);
            }
        }
        System.out.println(settled + " without iteration");
        assertTrue(settled > 50_000, settled + " without iteration");
    }

    @Test
    void itsPointsAreThoseOfTheGeneralWay() {
        Manifold other = new Manifold();
        EveryPairTest.Sort[] sorts = {
            EveryPairTest.Sort.RANDOM,
            EveryPairTest.Sort.TOUCHING,
            EveryPairTest.Sort.DEEP,
            EveryPairTest.Sort.NEARLY_PARALLEL
        };
        int contacts = 0;
        int others = 0;
        for (int order = 0; order < 2; order++) {
            ShapeKind a = order == 0 ? ShapeKind.CAPSULE : ShapeKind.HULL;
            ShapeKind b = order == 0 ? ShapeKind.HULL : ShapeKind.CAPSULE;
            SplittableRandom r = new SplittableRandom(314 + order);
            for (int i = 0; i < 40_000; i++) {
                Scene s = sorts[i % sorts.length].scene(r, new ShapeKind.Two(a, b));
                double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
                s.collide(special, margin, 0, manifold);
                s.collide(general, margin, 0, other);
                boolean same = manifold.pointCount == other.pointCount;
                for (int p = 0; same && p < manifold.pointCount; p++) {
                    double x = manifold.pointX[p] - other.pointX[p];
                    double y = manifold.pointY[p] - other.pointY[p];
                    double z = manifold.pointZ[p] - other.pointZ[p];
                    same =
                            manifold.feature[p] == other.feature[p]
                                    && x * x + y * y + z * z <= 1e-14 * s.size() * s.size();
                }
                contacts += other.pointCount > 0 ? 1 : 0;
                others += same ? 0 : 1;
            }
        }
        System.out.printf("%d contacts, %d others%n", contacts, others);
        assertTrue(contacts > 30_000, contacts + " contacts");
        assertTrue(others <= 1e-3 * contacts, others + " of " + contacts + " contacts differ");
    }
}
