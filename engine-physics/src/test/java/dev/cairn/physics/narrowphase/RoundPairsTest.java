package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.round.RoundContacts;
import dev.cairn.physics.narrowphase.round.RoundPairs;
import dev.cairn.physics.narrowphase.wide.BoxAxes;
import dev.cairn.physics.narrowphase.wide.RoundBatch;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * A batch of balls and capsules, a pair to a lane, gives the bits of the single path, whichever
 * kinds share a batch and in whatever pose; what it leaves to the general way is what the single
 * path leaves.
 */
class RoundPairsTest {
    private static final ShapeKind[] KINDS = {ShapeKind.BALL, ShapeKind.CAPSULE};

    private static final EveryPairTest.Sort[] SORTS = EveryPairTest.Sort.values();

    private static Scene scene(SplittableRandom r, boolean balls) {
        while (true) {
            ShapeKind a = balls ? ShapeKind.BALL : KINDS[r.nextInt(2)];
            ShapeKind b = balls ? ShapeKind.BALL : KINDS[r.nextInt(2)];
            EveryPairTest.Sort sort = SORTS[r.nextInt(SORTS.length)];
            Scene s = sort.scene(r, new ShapeKind.Two(a, b));
            if (RoundContacts.fits(s.a) && RoundContacts.fits(s.b)) {
                return s;
            }
        }
    }

    private static void put(RoundPairs batch, int i, Scene s, double margin) {
        batch.put(
                i, s.d.x, s.d.y, s.d.z, s.a.innerRadius(), half(s.a), s.b.innerRadius(), half(s.b));
        batch.ahead(i, 0, 0, 0, margin, 0);
        batch.turn(i, false, s.qa.x, s.qa.y, s.qa.z, s.qa.w);
        batch.turn(i, true, s.qb.x, s.qb.y, s.qb.z, s.qb.w);
    }

    /** Batches of all pairs, and of those where only A, only B, neither or both are capsules. */
    private static boolean isOf(Scene s, int sort) {
        boolean a = s.a instanceof Capsule;
        boolean b = s.b instanceof Capsule;
        return switch (sort) {
            case 1 -> a && !b;
            case 2 -> b && !a;
            case 3 -> !a && !b;
            case 4 -> a && b;
            default -> true;
        };
    }

    private static double half(Shape shape) {
        return shape instanceof Capsule c ? c.halfLength() : 0;
    }

    @Test
    void aBatchGivesTheBitsOfTheSinglePath() {
        assumeTrue(BoxAxes.wide(), "no lanes on this machine");
        SplittableRandom r = new SplittableRandom(81);
        RoundPairs batch = new RoundPairs();
        RoundContacts single = new RoundContacts();
        Manifold one = new Manifold();
        Manifold two = new Manifold();
        Scene[] scenes = new Scene[RoundBatch.CAPACITY];
        int touching = 0;
        int left = 0;
        for (int round = 0; round < 1_000; round++) {
            int count = 1 + r.nextInt(scenes.length);
            double margin = r.nextInt(3) == 0 ? 1 : .02;
            for (int i = 0; i < count; i++) {
                do {
                    scenes[i] = scene(r, round % 5 == 3);
                } while (!isOf(scenes[i], round % 5));
                put(batch, i, scenes[i], margin);
            }
            boolean capsulesA = false;
            boolean capsulesB = false;
            for (int i = 0; i < count; i++) {
                capsulesA |= scenes[i].a instanceof Capsule;
                capsulesB |= scenes[i].b instanceof Capsule;
            }
            batch.run(count, capsulesA, capsulesB, 1, 0);
            for (int i = 0; i < count; i++) {
                Scene s = scenes[i];
                String where = "seed 81 round " + round + " pair " + i + " " + s.a + " " + s.b;
                boolean done =
                        single.collide(
                                s.a, s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z,
                                s.qb.w, s.d.x, s.d.y, s.d.z, margin, one);
                assertEquals(done, batch.take(i, two), where);
                if (!done) {
                    left++;
                    continue;
                }
                assertEquals(single.key(), RoundPairs.key(two), where);
                assertEquals(one.pointCount, two.pointCount, where);
                assertEquals(one.bound, two.bound, 0.0, where);
                if (one.pointCount == 0) {
                    continue;
                }
                touching++;
                assertEquals(one.separation[0], two.separation[0], 0.0, where);
                assertEquals(one.normalX, two.normalX, 0.0, where);
                assertEquals(one.normalY, two.normalY, 0.0, where);
                assertEquals(one.normalZ, two.normalZ, 0.0, where);
                assertEquals(one.pointX[0], two.pointX[0], 0.0, where);
                assertEquals(one.pointY[0], two.pointY[0], 0.0, where);
                assertEquals(one.pointZ[0], two.pointZ[0], 0.0, where);
                assertEquals(one.feature[0], two.feature[0], where);
            }
        }
        assertTrue(touching > 3_000 && left > 100, touching + " contacts, " + left + " left");
    }

    /** The general way finds them by laying lines over each other in A's frame. */
    @Test
    void capsulesSideBySideHaveThePointsOfTheGeneralWay() {
        NarrowPhase special = new NarrowPhase();
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        Manifold one = new Manifold();
        Manifold two = new Manifold();
        SplittableRandom r = new SplittableRandom(82);
        int lines = 0;
        int others = 0;
        for (int i = 0; i < 40_000; i++) {
            Scene s = new Scene(capsule(r), capsule(r));
            double tilt = Scene.logUniform(r, 1e-12, .4);
            s.qa = Scene.turn(r);
            s.qb = new org.joml.Quaterniond(s.qa);
            s.qb.rotateX(r.nextInt(2) * StrictMath.PI).rotateZ(tilt).rotateX(tilt * Scene.gauss(r));
            double far = s.a.innerRadius() + s.b.innerRadius() - .01;
            s.at(far, 2 * Scene.gauss(r), 0).d.rotateY(6 * r.nextDouble());
            s.qa.transform(s.d);
            long word = s.collide(special, .02, 0, one);
            long wordOther = s.collide(general, .02, 0, two);
            lines += two.pointCount == 2 ? 1 : 0;
            boolean same = one.pointCount == two.pointCount && word == wordOther;
            for (int p = 0; same && p < one.pointCount && one.pointCount == 2; p++) {
                double x = one.pointX[p] - two.pointX[p];
                double y = one.pointY[p] - two.pointY[p];
                double z = one.pointZ[p] - two.pointZ[p];
                // The axis of lines that hardly cross is known within rounding over their tilt.
                same = Math.sqrt(x * x + y * y + z * z) <= 1e-9;
                same &= Math.abs(one.separation[p] - two.separation[p]) <= 1e-14;
                same &= one.feature[p] == two.feature[p];
            }
            others += same ? 0 : 1;
        }
        System.out.println(lines + " side by side, " + others + " others");
        assertTrue(lines > 10_000, lines + " side by side");
        assertTrue(others <= 1e-3 * lines, others + " of " + lines + " are others");
    }

    private static Capsule capsule(SplittableRandom r) {
        return Capsule.of(.2 + .3 * r.nextDouble(), .2 + .8 * r.nextDouble());
    }
}
