package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ReachOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.SplittableRandom;

/**
 * What needs no oracle but the reach of a shape, for every pair of kinds, moved shapes among them,
 * in every sort of pose: the distance is that along its axis, pushing out by it leaves none, the
 * order does not matter, nor does a power of two, nor a mirror. {@code mvn -Psoak verify} runs
 * {@code -Dsoak.poses} (a million by default) of each pair.
 */
class EveryPairTest {
    /** Of the size. */
    private static final double ALONG = 1e-14;

    /**
     * Of the size of the pair: round shapes that are nearly parallel lose digits, others do not.
     */
    private static final double ROUND = 1e-10;

    private static final double FLAT = 1e-12;

    /** Of the size, when one shape is a millionth of the other. */
    private static final double UNEQUAL = 5e-12;

    /**
     * Of the poses: points at the very margin, and the normals of two drums side by side, are told
     * apart by rounding.
     */
    private static final double NOT_MIRRORED = 1e-3;

    /** What brings scenes together; a new one for each would take most of a soak's time. */
    private static final ThreadLocal<NarrowPhase> PLACING =
            ThreadLocal.withInitial(NarrowPhase::new);

    enum Sort {
        RANDOM,
        NEARLY_PARALLEL,
        TOUCHING,
        DEEP,
        CONCENTRIC,
        A_MILLION_TO_ONE,
        APART;

        Scene scene(SplittableRandom r, ShapeKind.Two kinds) {
            Scene s = new Scene(kinds.a().shape(r), kinds.b().shape(r));
            s.qa = Scene.turn(r);
            s.qb = Scene.turn(r);
            double size = ShapeKind.size(s);
            s.d = Scene.direction(r).mul(r.nextDouble() * .9 * size);
            switch (this) {
                case RANDOM -> {}
                case NEARLY_PARALLEL -> parallel(s, r);
                case TOUCHING -> touch(s, r, 1e-15, 1e-1);
                case DEEP -> s.d.mul(.05);
                case CONCENTRIC -> concentric(s, r, kinds);
                case A_MILLION_TO_ONE -> {
                    shrink(s);
                    if (r.nextBoolean()) {
                        parallel(s, r);
                    }
                    touch(s, r, 1e-9, 1e-6);
                }
                case APART -> s.d.mul(Scene.logUniform(r, 2, 1e6));
            }
            return s;
        }

        private static void parallel(Scene s, SplittableRandom r) {
            double tilt = r.nextInt(4) == 0 ? 0 : Scene.logUniform(r, 1e-16, 1e-1);
            Quaterniond turn = new Quaterniond().rotationX(.5 * StrictMath.PI * r.nextInt(4));
            Vector3d axis = Scene.direction(r);
            s.qb = new Quaterniond(s.qa).mul(turn);
            s.qb.rotateAxis(tilt, axis.x, axis.y, axis.z).normalize();
        }

        private static void concentric(Scene s, SplittableRandom r, ShapeKind.Two kinds) {
            s.d.zero();
            if (r.nextBoolean()) {
                s.qb = new Quaterniond(s.qa);
                s.b = kinds.a() == kinds.b() && r.nextBoolean() ? s.a : s.b;
            }
        }

        private static void shrink(Scene s) {
            if (!(s.b instanceof HalfSpace)) {
                s.b = ShapeKind.scaled(s.b, 1e-6 * ShapeKind.size(s) / ShapeKind.size(s.b));
            }
        }

        /** Apart or overlapping by a part of the size that is between two bounds. */
        private static void touch(Scene s, SplittableRandom r, double low, double high) {
            NarrowPhase n = PLACING.get();
            double gap = ShapeKind.size(s) * Scene.logUniform(r, low, high);
            gap = r.nextBoolean() ? gap : -gap;
            for (int i = 0; i < 2; i++) {
                double d = s.distance(n);
                s.d.fma(gap - d, axis(n));
            }
        }
    }

    static Vector3d axis(NarrowPhase n) {
        return new Vector3d(n.axisX(), n.axisY(), n.axisZ());
    }

    static List<ShapeKind.Two> pairs() {
        return ShapeKind.pairs();
    }

    /** Worst cases of one pair, of the size; and how often. */
    private static final class Tally {
        double along, out, order, ways;
        long poses, capped, contactsNotMirrored;
    }

    private final NarrowPhase special = new NarrowPhase();
    private final NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
    private final ReachOracle oracle = new ReachOracle();
    private final Manifold one = new Manifold(), two = new Manifold();

    private void run(ShapeKind.Two kinds, long poses, long seed) {
        Tally tally = new Tally();
        boolean round = isRound(kinds.a()) || isRound(kinds.b());
        double bar = round ? ROUND : FLAT;
        Sort[] sorts = Sort.values();
        SplittableRandom r = new SplittableRandom(seed);
        for (long i = 0; i < poses; i++) {
            Sort sort = sorts[(int) (i % sorts.length)];
            Scene s = sort.scene(r, kinds);
            String where = kinds + " " + sort + " seed " + seed + " pose " + i;
            boolean unequal = sort == Sort.A_MILLION_TO_ONE;
            check(s, sort, r, unequal ? Math.max(bar, UNEQUAL) : bar, tally, where);
        }
        // A circle of directions that are nearly equally good is more than the polytope holds.
        assertTrue(
                tally.capped <= (round ? 1 + 2e-3 * tally.poses : 0),
                kinds + " seed " + seed + ": caps met " + tally.capped + " of " + tally.poses);
        // None of the 140 poses of the normal build.
        assertTrue(
                tally.contactsNotMirrored <= NOT_MIRRORED * tally.poses,
                kinds + " seed " + seed + ": contacts not mirrored " + tally.contactsNotMirrored);
        System.out.printf(
                "| %s | %,d | %.1e | %.1e | %.1e | %.1e | %d | %d |%n",
                kinds,
                tally.poses,
                tally.along,
                tally.out,
                tally.order,
                tally.ways,
                tally.capped,
                tally.contactsNotMirrored);
    }

    private static boolean isRound(ShapeKind kind) {
        return kind == ShapeKind.CYLINDER || kind == ShapeKind.CONE || kind == ShapeKind.CAPSULE;
    }

    private void check(
            Scene s, Sort sort, SplittableRandom r, double bar, Tally tally, String where) {
        double size = ShapeKind.size(s) + s.d.length();
        double d = s.distance(special);
        Vector3d axis = axis(special);
        tally.poses++;
        tally.capped += special.capped() ? 1 : 0;
        assertEquals(1, axis.length(), 1e-14, where);
        double along = Math.abs(oracle.separation(s, axis) - d) / size;
        tally.along = Math.max(tally.along, along);
        assertTrue(along <= ALONG, where + ": not the separation along its axis, by " + along);
        double ways = Math.abs(s.distance(general) - d) / size;
        tally.ways = Math.max(tally.ways, ways);
        assertTrue(ways <= bar, where + " GENERAL and SPECIALISED " + ways);
        scaled(s, d, axis, r.nextInt(61) - 30, where);
        if (sort != Sort.CONCENTRIC) {
            mirrored(s, d, axis, bar, tally, where);
        }
        double order = Math.abs(s.swapped().distance(special) - d) / size;
        tally.order = Math.max(tally.order, order);
        assertTrue(order <= bar, where + " f(A,B) = -f(B,A) " + order);
        s.d.fma(-d, axis);
        double out = Math.abs(s.distance(special)) / size;
        tally.out = Math.max(tally.out, out);
        assertTrue(out <= bar, where + " pushed out " + out);
    }

    /** G7: a power of two changes nothing but the exponents. */
    private void scaled(Scene s, double d, Vector3d axis, int k, String where) {
        double f = StrictMath.scalb(1.0, k);
        Scene t = ShapeKind.scaled(s, f);
        String scale = where + " scale 2^" + k;
        assertEquals(f * d, t.distance(special), 0.0, scale);
        assertEquals(axis, axis(special), scale);
        double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
        long word = s.collide(special, margin, 0, one);
        assertEquals(word, t.collide(special, f * margin, 0, two), scale);
        assertEquals(one.pointCount, two.pointCount, scale);
        for (int i = 0; i < one.pointCount; i++) {
            assertEquals(one.feature[i], two.feature[i], scale);
            assertEquals(f * one.separation[i], two.separation[i], 0.0, scale);
            assertEquals(f * one.pointX[i], two.pointX[i], 0.0, scale);
            assertEquals(f * one.pointY[i], two.pointY[i], 0.0, scale);
            assertEquals(f * one.pointZ[i], two.pointZ[i], 0.0, scale);
        }
    }

    /**
     * Whether a mirror image is as far apart to the bit, along the mirrored axis, and touches at as
     * many points along the mirrored normal.
     */
    private void mirrored(Scene s, double d, Vector3d axis, double bar, Tally tally, String where) {
        Scene t = ShapeKind.mirrored(s);
        double m = t.distance(special);
        double size = ShapeKind.size(s) + s.d.length();
        assertEquals(d, m, bar * size, where + " mirrored");
        boolean same = d == m && areMirrored(axis, axis(special));
        assertTrue(same, where + " mirrored " + d + " " + m);
        if (!(roundAgainstFlat(s.a, s.b) || roundAgainstFlat(s.b, s.a))) {
            double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
            s.collide(special, margin, 0, one);
            t.collide(special, margin, 0, two);
            same = one.pointCount == two.pointCount;
            same &= one.pointCount == 0 || areMirrored(normal(one), normal(two));
            tally.contactsNotMirrored += same ? 0 : 1;
        }
    }

    private static Vector3d normal(Manifold m) {
        return new Vector3d(m.normalX, m.normalY, m.normalZ);
    }

    private static boolean areMirrored(Vector3d v, Vector3d w) {
        return v.x == -w.x && v.y == w.y && v.z == w.z;
    }

    /** Of these the points, which start at another corner in the mirror, may choose the normal. */
    private static boolean roundAgainstFlat(Shape a, Shape b) {
        return isDrum(a) && (inner(b) instanceof Box || inner(b) instanceof ConvexHull);
    }

    private static boolean isDrum(Shape shape) {
        Shape s = inner(shape);
        return s instanceof Capsule || s instanceof Cylinder || s instanceof Cone;
    }

    private static Shape inner(Shape shape) {
        return shape instanceof Moved m ? m.inner() : shape;
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void g7EveryPairInEverySortOfPose(ShapeKind.Two kinds) {
        run(kinds, 140, 201);
    }

    /**
     * Few poses tell: those whose best axis is right across an edge of a box, and drums side by
     * side, of which a whole circle of axes may be as good.
     */
    @ParameterizedTest
    @MethodSource("mirrors")
    void g7MirroredPairsHaveMirroredBits(ShapeKind.Two kinds) {
        SplittableRandom r = new SplittableRandom(203);
        for (int i = 0; i < 4_000; i++) {
            Sort sort = Sort.values()[i % 7];
            Scene s = sort.scene(r, kinds);
            if (sort != Sort.CONCENTRIC) {
                double d = s.distance(special);
                Vector3d axis = axis(special);
                String where = kinds + " " + sort + " seed 203 pose " + i;
                assertEquals(d, ShapeKind.mirrored(s).distance(special), where);
                assertTrue(areMirrored(axis, axis(special)), where + " axis " + axis);
            }
        }
    }

    static List<ShapeKind.Two> mirrors() {
        return List.of(
                new ShapeKind.Two(ShapeKind.CAPSULE, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.CYLINDER, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.CONE, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.BOX, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.HULL, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.CAPSULE, ShapeKind.CONE),
                new ShapeKind.Two(ShapeKind.CYLINDER, ShapeKind.CYLINDER),
                new ShapeKind.Two(ShapeKind.CYLINDER, ShapeKind.CONE),
                new ShapeKind.Two(ShapeKind.CONE, ShapeKind.CONE));
    }

    /** One of these poses in ten thousand ends GJK on a sliver, far from the nearest points. */
    @Test
    void g7HullsOfAMillionToOneAreMeasuredAlikeFromBothSides() {
        ShapeKind.Two hulls = new ShapeKind.Two(ShapeKind.HULL, ShapeKind.HULL);
        SplittableRandom r = new SplittableRandom(5);
        for (int i = 0; i < 8_000; i++) {
            Scene s = Sort.A_MILLION_TO_ONE.scene(r, hulls);
            String where = "seed 5 pose " + i;
            double size = ShapeKind.size(s) + s.d.length();
            double d = s.distance(special);
            Vector3d axis = axis(special);
            assertEquals(d, s.swapped().distance(special), UNEQUAL * size, where);
            s.d.fma(-d, axis);
            assertEquals(0, s.distance(special), UNEQUAL * size, where + " pushed out");
        }
    }

    @Tag("soak")
    @ParameterizedTest
    @MethodSource("pairs")
    void g7EveryPairAMillionTimes(ShapeKind.Two kinds) {
        run(kinds, Long.getLong("soak.poses", 1_000_000), Long.getLong("soak.seed", 202));
    }

    /** G14: moving by ds changes the distance by no more than ds. */
    private void sweep(ShapeKind.Two kinds, long sweeps, int samples, long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        double worst = 0;
        double bar = isRound(kinds.a()) || isRound(kinds.b()) ? ROUND : FLAT;
        for (long i = 0; i < sweeps; i++) {
            Scene s = Sort.values()[(int) (i % 4)].scene(r, kinds);
            Vector3d along = Scene.direction(r);
            double size = ShapeKind.size(s);
            double step = 2 * size / samples;
            s.d.fma(-.5 * samples * step, along);
            double last = s.distance(special);
            for (int k = 0; k < samples; k++) {
                s.d.fma(step, along);
                double d = s.distance(special);
                double over = (Math.abs(d - last) - step) / size;
                worst = Math.max(worst, over);
                String where = kinds + " seed " + seed + " sweep " + i + " step " + k;
                assertTrue(over <= bar, where + ": " + last + " to " + d + " by " + step);
                last = d;
            }
        }
        System.out.printf("| %s | %,d sweeps of %d | %.1e |%n", kinds, sweeps, samples, worst);
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void g14NoDistanceChangesFasterThanTheMotion(ShapeKind.Two kinds) {
        sweep(kinds, 20, 60, 211);
    }

    @Tag("soak")
    @ParameterizedTest
    @MethodSource("pairs")
    void g14ManySweeps(ShapeKind.Two kinds) {
        sweep(kinds, Long.getLong("soak.sweeps", 100_000), 100, Long.getLong("soak.seed", 212));
    }
}
