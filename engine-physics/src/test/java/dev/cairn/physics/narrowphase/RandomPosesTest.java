package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.SplittableRandom;

/**
 * Random poses of every pair kind: the distance against brute force, the push-out, the mirrored
 * order, and the bound of the manifold. {@code mvn -Psoak verify} runs a million of each; {@code
 * -Dsoak.poses=N} and {@code -Dsoak.seed=N} choose another number and other poses.
 */
class RandomPosesTest {
    enum Kind {
        BALL_BALL(2_000),
        BALL_BOX(1_000),
        BALL_HULL(500),
        BOX_BOX(2_000),
        BOX_HULL(200),
        HULL_HULL(100);

        final int poses;

        Kind(int poses) {
            this.poses = poses;
        }

        Scene scene(SplittableRandom r) {
            Shape a =
                    switch (this) {
                        case BALL_BALL, BALL_BOX, BALL_HULL -> ball(r);
                        case BOX_BOX, BOX_HULL -> Scene.box(r);
                        case HULL_HULL -> hull(r);
                    };
            Shape b =
                    switch (this) {
                        case BALL_BALL -> ball(r);
                        case BALL_BOX, BOX_BOX -> Scene.box(r);
                        case BALL_HULL, BOX_HULL, HULL_HULL -> hull(r);
                    };
            Scene s = Scene.random(r, a, b);
            return r.nextBoolean() ? s : s.swapped();
        }

        private static Shape ball(SplittableRandom r) {
            return Sphere.of(Scene.logUniform(r, .01, 3));
        }

        private static Shape hull(SplittableRandom r) {
            return Scene.hull(r, 4 + r.nextInt(16), Scene.logUniform(r, .1, 3));
        }
    }

    private static double truth(Scene s) {
        if (s.a instanceof Sphere && s.b instanceof Sphere) {
            return s.d.length() - s.size();
        }
        if (s.a instanceof Sphere) {
            return truth(s.swapped());
        }
        if (s.b instanceof Sphere) {
            return ConvexOracle.pointDistance(s.placedA(), s.d) - s.b.outerRadius();
        }
        double overlap = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
        return overlap <= 0 ? overlap : ConvexOracle.distance(s.placedA(), s.placedB());
    }

    private static void check(Kind kind, long poses, long seed, boolean progress) {
        SplittableRandom r = new SplittableRandom(seed);
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        NarrowPhase special = new NarrowPhase(NarrowPhase.Method.SPECIALISED);
        Manifold m = new Manifold();
        double worst = 0;
        for (long i = 0; i < poses; i++) {
            Scene s = kind.scene(r);
            String where = kind + " seed " + seed + " pose " + i;
            double truth = truth(s);
            double d = s.distance(special);
            worst = Math.max(worst, Math.abs(truth - d) / s.size());
            assertEquals(truth, d, 1e-12 * s.size(), where);
            assertFalse(special.capped(), where);
            Vector3d axis = new Vector3d(special.axisX(), special.axisY(), special.axisZ());
            assertEquals(truth, s.distance(general), 1e-12 * s.size(), where);
            assertFalse(general.capped(), where);
            assertEquals(truth, s.swapped().distance(special), 1e-12 * s.size(), where);
            contact(s, truth, special, m, where);
            s.d.fma(-d, axis);
            assertEquals(0, s.distance(special), 2e-13 * s.size(), where + " pushed out");
            if (progress && (i + 1) % Math.max(1, poses / 20) == 0) {
                System.out.printf(
                        "%s: %,d of %,d poses, worst error %.2g of the size%n",
                        kind, i + 1, poses, worst);
            }
        }
    }

    private static void contact(Scene s, double truth, NarrowPhase n, Manifold m, String where) {
        double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
        s.collide(n, margin, 0, m);
        double rounding = 1e-12 * s.size();
        assertTrue(m.pointCount > 0 || truth > -rounding, where);
        assertTrue(m.pointCount == 0 || truth <= margin + rounding, where + " truth " + truth);
        double least = Double.MAX_VALUE;
        for (int p = 0; p < m.pointCount; p++) {
            least = Math.min(least, m.separation[p]);
        }
        if (m.pointCount > 0) {
            double allowed = .075 * margin + .15 * Math.abs(truth) + rounding;
            assertEquals(truth, least, Math.max(allowed, margin), where);
            if (truth < 0) {
                assertEquals(truth, least, allowed, where);
                assertEquals(truth, least, m.bound + rounding, where);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void everyKindAgreesWithBruteForce(Kind kind) {
        check(kind, kind.poses, 61, false);
    }

    @Tag("soak")
    @ParameterizedTest
    @EnumSource
    void everyKindAgreesWithBruteForceAMillionTimes(Kind kind) {
        check(kind, Long.getLong("soak.poses", 1_000_000), Long.getLong("soak.seed", 62), true);
    }
}
