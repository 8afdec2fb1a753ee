package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ReachOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Every pair with a capsule, cylinder or cone against {@link ReachOracle}, in random, nearly
 * parallel, touching, deep, concentric and unequal poses; {@code mvn -Psoak verify} runs {@code
 * -Dsoak.poses} (100 000 by default) of each.
 */
class CurvedPairsTest {
    /** Of the size: what the search of the oracle may leave. */
    private static final double SEARCH = 2e-9;

    enum Kind {
        BALL,
        CAPSULE,
        CYLINDER,
        CONE,
        BOX,
        HULL;

        Shape shape(SplittableRandom r) {
            double size = Scene.logUniform(r, .2, 3);
            double other = size * Scene.logUniform(r, .1, 3);
            return switch (this) {
                case BALL -> Sphere.of(size);
                case CAPSULE -> Capsule.of(size, other);
                case CYLINDER -> Cylinder.of(size, other);
                case CONE -> Cone.of(size, other);
                case BOX -> Box.ofHalfExtents(size, other, size * Scene.logUniform(r, .1, 3));
                case HULL -> Scene.hull(r, 4 + r.nextInt(12), size);
            };
        }
    }

    record Kinds(Kind a, Kind b) {}

    static List<Kinds> kinds() {
        List<Kinds> all = new ArrayList<>();
        for (Kind a : new Kind[] {Kind.CAPSULE, Kind.CYLINDER, Kind.CONE}) {
            for (Kind b : Kind.values()) {
                boolean twice = b.ordinal() >= 1 && b.ordinal() <= 3 && b.ordinal() < a.ordinal();
                if (!twice) {
                    all.add(new Kinds(a, b));
                }
            }
        }
        return all;
    }

    /** A pose of one of eight sorts. */
    private static Scene scene(SplittableRandom r, Kinds kinds, long i) {
        Scene s = Scene.random(r, kinds.a.shape(r), kinds.b.shape(r));
        switch ((int) (i % 8)) {
            case 3 -> nearlyParallel(s, r);
            case 4 -> s.d.zero();
            case 5 -> s.d.mul(.05);
            case 6 -> s.b = scaled(s.b, 1e-3);
            case 7 -> touching(s, r);
            default -> {}
        }
        return s;
    }

    private static void nearlyParallel(Scene s, SplittableRandom r) {
        double tilt = Scene.logUniform(r, 1e-14, 1e-1);
        Quaterniond turn = new Quaterniond().rotationX(.5 * StrictMath.PI * r.nextInt(4));
        Vector3d axis = Scene.direction(r);
        s.qb = new Quaterniond(s.qa).mul(turn);
        s.qb.rotateAxis(tilt, axis.x, axis.y, axis.z).normalize();
    }

    /** Apart or overlapping by 1e-15 to 1e-1 of the size. */
    private static void touching(Scene s, SplittableRandom r) {
        NarrowPhase n = new NarrowPhase();
        double gap = s.size() * Scene.logUniform(r, 1e-15, 1e-1) * (r.nextBoolean() ? 1 : -1);
        double d = s.distance(n);
        s.d.fma(gap - d, new Vector3d(n.axisX(), n.axisY(), n.axisZ()));
    }

    private static Shape scaled(Shape shape, double f) {
        return switch (shape) {
            case Sphere b -> Sphere.of(f * b.radius());
            case Capsule c -> Capsule.of(f * c.radius(), f * c.halfLength());
            case Cylinder c -> Cylinder.of(f * c.radius(), f * c.halfHeight());
            case Cone c -> Cone.of(f * c.radius(), f * c.halfHeight());
            case Box b -> Box.ofHalfExtents(f * b.halfX(), f * b.halfY(), f * b.halfZ());
            default -> shape;
        };
    }

    private static String check(Kinds kinds, long poses, long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        ReachOracle oracle = new ReachOracle();
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        NarrowPhase special = new NarrowPhase(NarrowPhase.Method.SPECIALISED);
        Manifold m = new Manifold();
        double worst = 0;
        double ways = 0;
        double order = 0;
        double out = 0;
        for (long i = 0; i < poses; i++) {
            Scene s = scene(r, kinds, i);
            String where = kinds + " seed " + seed + " pose " + i;
            double size = s.size();
            double d = s.distance(special);
            assertFalse(special.capped(), where);
            Vector3d axis = new Vector3d(special.axisX(), special.axisY(), special.axisZ());
            assertEquals(1, axis.length(), 1e-15, where);
            assertEquals(oracle.separation(s, axis), d, 1e-14 * size, where + " along its axis");
            double truth = oracle.distance(s);
            worst = Math.max(worst, (truth - d) / size);
            assertTrue(d >= truth - SEARCH * size, where + ": " + d + " below " + truth);
            double g = s.distance(general);
            assertFalse(general.capped(), where);
            ways = Math.max(ways, Math.abs(g - d) / size);
            order = Math.max(order, Math.abs(s.swapped().distance(special) - d) / size);
            contact(s, d, special, m, where);
            s.d.fma(-d, axis);
            out = Math.max(out, Math.abs(s.distance(special)) / size);
        }
        assertTrue(ways <= 1e-7, kinds + " seed " + seed + " GENERAL and SPECIALISED " + ways);
        assertTrue(order <= 1e-7, kinds + " seed " + seed + " f(A,B) = -f(B,A) " + order);
        assertTrue(out <= 1e-7, kinds + " seed " + seed + " pushed out " + out);
        return String.format(
                "| %s, %s | %.1e | %.1e | %.1e | %.1e |",
                kinds.a, kinds.b, worst, ways, order, out);
    }

    private static void contact(Scene s, double d, NarrowPhase n, Manifold m, String where) {
        double inner = Math.min(s.a.innerRadius(), s.b.innerRadius());
        double margin = .02 * inner;
        s.collide(n, margin, 0, m);
        double rounding = 1e-12 * s.size();
        assertEquals(d <= margin, m.pointCount > 0, where);
        double least = Double.MAX_VALUE;
        for (int p = 0; p < m.pointCount; p++) {
            least = Math.min(least, m.separation[p]);
            assertTrue(m.separation[p] <= margin + rounding, where);
        }
        if (m.pointCount > 0) {
            assertEquals(d, least, 1.5e-3 * inner + .15 * Math.abs(d) + rounding, where);
            assertEquals(d, least, m.bound + rounding, where);
            double length = m.normalX * m.normalX + m.normalY * m.normalY + m.normalZ * m.normalZ;
            assertEquals(1, length, 1e-14, where);
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void everyKindAgreesWithTheReach(Kinds kinds) {
        System.out.println(check(kinds, 160, 81));
    }

    @Tag("soak")
    @ParameterizedTest
    @MethodSource("kinds")
    void everyKindAgreesWithTheReachManyTimes(Kinds kinds) {
        long poses = Long.getLong("soak.poses", 100_000);
        System.out.println(check(kinds, poses, Long.getLong("soak.seed", 82)));
    }
}
