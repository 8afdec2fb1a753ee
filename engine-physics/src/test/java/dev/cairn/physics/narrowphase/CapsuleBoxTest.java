package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * A capsule and a box, whose axis has a closed form: what {@link EveryPairTest} asks of every pair,
 * in more poses and to the last digits, for rounding hides one feature behind another in few.
 */
class CapsuleBoxTest {
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
        for (int i = 0; i < 70_000; i++) {
            EveryPairTest.Sort sort = sorts[i % sorts.length];
            Scene s = sort.scene(r, kinds);
            String where = kinds + " " + sort + " seed " + seed + " pose " + i;
            double size = ShapeKind.size(s) + s.d.length();
            double d = s.distance(special);
            Vector3d axis = EveryPairTest.axis(special);
            ways = Math.max(ways, Math.abs(s.distance(general) - d) / size);
            assertTrue(ways <= ROUNDING, where + ": GENERAL differs by " + ways);
            s.d.fma(-d, axis);
            out = Math.max(out, Math.abs(s.distance(special)) / size);
            assertTrue(out <= ROUNDING, where + ": pushed out, left " + out);
        }
        System.out.printf("| %s | %.1e from GENERAL | pushed out %.1e |%n", kinds, ways, out);
    }

    @Test
    void agreesWithTheGeneralWayToTheLastDigits() {
        check(ShapeKind.CAPSULE, ShapeKind.BOX, 301);
        check(ShapeKind.BOX, ShapeKind.CAPSULE, 302);
    }

    /** The segment touches the box, or is 1e-16 to 1e-9 of the size apart or inside. */
    @Test
    void aSegmentThatTouchesTheBoxIsMeasuredToTheLastDigits() {
        SplittableRandom r = new SplittableRandom(306);
        ShapeKind.Two kinds = new ShapeKind.Two(ShapeKind.BOX, ShapeKind.CAPSULE);
        for (int i = 0; i < 20_000; i++) {
            Scene s = EveryPairTest.Sort.RANDOM.scene(r, kinds);
            double size = ShapeKind.size(s);
            double gap = size * Scene.logUniform(r, 1e-16, 1e-9) * (r.nextBoolean() ? 1 : -1);
            double radius = s.b.innerRadius();
            for (int k = 0; k < 2; k++) {
                double d = s.distance(special) + radius;
                s.d.fma(gap - d, EveryPairTest.axis(special));
            }
            String where = "seed 306 pose " + i;
            double d = s.distance(special);
            assertEquals(s.distance(general), d, ROUNDING * size, where);
            assertEquals(s.swapped().distance(special), d, ROUNDING * size, where);
        }
    }

    /** The segment all but parallel to an edge: rounding hides where it leaves the box's side. */
    @Test
    void nearlyParallelToAnEdgeTheNearestFeatureIsFound() {
        SplittableRandom r = new SplittableRandom(303);
        for (int i = 0; i < 100_000; i++) {
            Scene s =
                    new Scene(
                            Box.ofHalfExtents(1, 2, .5), Capsule.of(.25, .5 + 2 * r.nextDouble()));
            double tilt = Scene.logUniform(r, 1e-17, 1e-12);
            Vector3d axis = Scene.direction(r);
            s.qb.rotateAxis(tilt, axis.x, axis.y, axis.z);
            s.at(.8 + 2 * r.nextDouble(), 4 * r.nextDouble() - 2, 2 * r.nextDouble() - 1);
            String where = "seed 303 pose " + i;
            double d = s.distance(special);
            axis = EveryPairTest.axis(special);
            // The capsule is as good as parallel: a rectangle and a round rod seen from above.
            double gapY = Math.max(0, Math.abs(s.d.y) - 2 - ((Capsule) s.b).halfLength());
            double gapX = s.d.x - 1;
            double gapZ = Math.abs(s.d.z) - .5;
            double truth;
            if (gapX <= 0 && gapZ <= 0 && gapY == 0) {
                double insideY = Math.abs(s.d.y) - 2 - ((Capsule) s.b).halfLength();
                truth = Math.max(insideY, Math.max(gapX, gapZ));
            } else {
                double x = Math.max(0, gapX);
                double z = Math.max(0, gapZ);
                truth = Math.sqrt(x * x + gapY * gapY + z * z);
            }
            assertEquals(truth - .25, d, 2e-11, where);
            s.d.fma(-d, axis);
            assertEquals(0, s.distance(special), 1e-14, where + " pushed out");
        }
    }

    /** The general way finds the same points by clipping whatever lies on whatever. */
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
        int twoPoints = 0;
        int others = 0;
        for (int order = 0; order < 2; order++) {
            ShapeKind a = order == 0 ? ShapeKind.CAPSULE : ShapeKind.BOX;
            ShapeKind b = order == 0 ? ShapeKind.BOX : ShapeKind.CAPSULE;
            SplittableRandom r = new SplittableRandom(304 + order);
            for (int i = 0; i < 40_000; i++) {
                Scene s = sorts[i % sorts.length].scene(r, new ShapeKind.Two(a, b));
                double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
                long word = s.collide(special, margin, 0, manifold);
                long wordOther = s.collide(general, margin, 0, other);
                boolean same = word == wordOther && manifold.pointCount == other.pointCount;
                for (int p = 0; same && p < manifold.pointCount; p++) {
                    double x = manifold.pointX[p] - other.pointX[p];
                    double y = manifold.pointY[p] - other.pointY[p];
                    double z = manifold.pointZ[p] - other.pointZ[p];
                    same =
                            manifold.feature[p] == other.feature[p]
                                    && x * x + y * y + z * z <= 1e-14 * s.size() * s.size();
                }
                contacts += other.pointCount > 0 ? 1 : 0;
                twoPoints += other.pointCount > 1 ? 1 : 0;
                others += same ? 0 : 1;
            }
        }
        System.out.printf("%d contacts, %d of 2 points, %d others%n", contacts, twoPoints, others);
        assertTrue(contacts > 40_000 && twoPoints > 1_000, contacts + " contacts");
        assertTrue(others <= 1e-3 * contacts, others + " of " + contacts + " contacts differ");
    }

    /** Lying on a face the capsule has two points, upright one, over an edge one. */
    @Test
    void lyingItHasTwoPointsAndUprightOne() {
        Scene s = new Scene(Box.ofHalfExtents(2, .5, 2), Capsule.of(.25, .5));
        s.at(.3, .5 + .25 + .5 - 1e-3, .1).collide(special, .01, 0, manifold);
        assertEquals(1, manifold.pointCount);
        assertEquals(-1e-3, manifold.separation[0], 1e-15);
        assertEquals(.5 - .5e-3, manifold.pointY[0], 1e-15);
        s.qb.rotateZ(StrictMath.PI / 2);
        s.at(.3, .75 - 1e-3, .1).collide(special, .01, 0, manifold);
        assertEquals(2, manifold.pointCount);
        assertEquals(1, manifold.normalY, 1e-15);
        double x = Math.abs(manifold.pointX[0] - manifold.pointX[1]);
        assertEquals(1, x, 1e-15, "from end to end");
        // Half of it beyond the edge of the face.
        s.at(2, .75 - 1e-3, .1).collide(special, .01, 0, manifold);
        assertEquals(2, manifold.pointCount);
        assertEquals(2, Math.max(manifold.pointX[0], manifold.pointX[1]), 1e-15);
        assertEquals(1.5, Math.min(manifold.pointX[0], manifold.pointX[1]), 1e-15);
    }
}
