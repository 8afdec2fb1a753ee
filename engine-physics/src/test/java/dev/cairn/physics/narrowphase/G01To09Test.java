package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.hull.HullAxis;
import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.ExactOracle;
import dev.cairn.physics.narrowphase.oracle.GaussMapOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * The cases G1 to G6, G8 and G9 of the accuracy catalogue, with its bars; G7 is in {@link
 * EveryPairTest}. Truth: exact arithmetic, or brute force that was written for the tests.
 */
class G01To09Test {
    private static String line(String name, double worst, String bar) {
        return String.format("%s: worst %.2g, bar %s", name, worst, bar);
    }

    private static Scene g1Scene(SplittableRandom r) {
        Scene s = Scene.random(r, Scene.box(r), Scene.box(r));
        NarrowPhase n = new NarrowPhase();
        double gap = r.nextDouble() - .5;
        for (int i = 0; i < 2; i++) {
            double d = s.distance(n);
            s.d.fma(gap - d, EveryPairTest.axis(n));
        }
        return s;
    }

    /** Gaps of half a metre on both sides of touching. */
    @ParameterizedTest
    @EnumSource
    void g1BoxesAgreeWithExactArithmetic(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(301);
        NarrowPhase n = new NarrowPhase(method);
        double worst = 0;
        for (int i = 0; i < 40; i++) {
            Scene s = g1Scene(r);
            double truth = ExactOracle.distance(s);
            double d = s.distance(n);
            worst = Math.max(worst, Math.abs(d - truth) / s.size());
            assertEquals(truth, d, 1e-12 * s.size(), method + " seed 301 pose " + i);
        }
        System.out.println(line("G1 " + method, worst, "1e-12 of the size"));
    }

    /** The iterations: their largest numbers must stay near the mean. */
    @Test
    void g1IterationsOfAThousandthAreFewMoreThanTheMean() {
        SplittableRandom r = new SplittableRandom(302);
        Pair p = new Pair();
        Gjk gjk = new Gjk();
        Epa epa = new Epa();
        int poses = 10_000;
        int[] count = new int[poses];
        long sum = 0;
        for (int i = 0; i < poses; i++) {
            Scene s = Scene.random(r, Scene.box(r), Scene.box(r));
            p.set(
                    s.a, s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z, s.qb.w, s.d.x,
                    s.d.y, s.d.z);
            gjk.run(p, p.dx, p.dy, p.dz, Double.MAX_VALUE);
            count[i] = gjk.iterations;
            if (gjk.overlap) {
                epa.run(p, gjk);
                count[i] += epa.iterations;
            }
            sum += count[i];
        }
        Arrays.sort(count);
        double mean = sum / (double) poses;
        int late = count[poses - poses / 1000];
        System.out.printf(
                "G1 iterations: mean %.1f, p99.9 %d, most %d%n", mean, late, count[poses - 1]);
        assertTrue(late < 5 * mean, "p99.9 " + late + ", mean " + mean);
        // The difference of two boxes has at most 30 faces; who looks at half of them searches.
        assertTrue(mean < 15, "mean " + mean);
    }

    /** The nearest points of two segments by trying all places, for capsules. */
    private static double segments(Scene s, double h, double k) {
        Vector3d u = s.qa.transform(new Vector3d(0, 1, 0));
        Vector3d v = s.qb.transform(new Vector3d(0, 1, 0));
        double best = Double.MAX_VALUE;
        double uv = u.dot(v);
        double det = 1 - uv * uv;
        double ud = u.dot(s.d);
        double vd = v.dot(s.d);
        double a = (ud - uv * vd) / det;
        double b = (uv * ud - vd) / det;
        if (Math.abs(a) <= h && Math.abs(b) <= k) {
            best = new Vector3d(s.d).fma(b, v).fma(-a, u).length();
        }
        for (int sign = -1; sign <= 1; sign += 2) {
            Vector3d end = new Vector3d(s.d).fma(sign * k, v);
            double t = Math.max(-h, Math.min(h, end.dot(u)));
            best = Math.min(best, end.fma(-t, u).length());
            Vector3d start = new Vector3d(u).mul(sign * h).sub(s.d);
            double w = Math.max(-k, Math.min(k, start.dot(v)));
            best = Math.min(best, start.fma(-w, v).length());
        }
        return best;
    }

    private static double g2Truth(Scene s) {
        if (s.a instanceof Box box && s.b instanceof Sphere ball) {
            Vector3d c = s.qa.transformInverse(s.d, new Vector3d());
            double x = Math.abs(c.x) - box.halfX();
            double y = Math.abs(c.y) - box.halfY();
            double z = Math.abs(c.z) - box.halfZ();
            double inside = Math.max(x, Math.max(y, z));
            double out = new Vector3d(Math.max(x, 0), Math.max(y, 0), Math.max(z, 0)).length();
            return (inside <= 0 ? inside : out) - ball.radius();
        }
        double h = s.a instanceof Capsule c ? c.halfLength() : 0;
        double k = s.b instanceof Capsule c ? c.halfLength() : 0;
        double radii = s.a.outerRadius() - h + s.b.outerRadius() - k;
        return (h == 0 && k == 0 ? s.d.length() : segments(s, h, k)) - radii;
    }

    @Test
    void g2RoundCoresHaveTheirClosedForm() {
        SplittableRandom r = new SplittableRandom(303);
        NarrowPhase n = new NarrowPhase();
        double worst = 0;
        for (int i = 0; i < 8_000; i++) {
            double big = Scene.logUniform(r, .1, 3);
            Shape ball = Sphere.of(Scene.logUniform(r, .05, 3));
            Shape capsule = Capsule.of(big, Scene.logUniform(r, .1, 3));
            Shape other = Capsule.of(Scene.logUniform(r, .1, 3), Scene.logUniform(r, .1, 3));
            Scene s =
                    switch (i % 4) {
                        case 0 -> Scene.random(r, Scene.box(r), ball);
                        case 1 -> Scene.random(r, Sphere.of(big), ball);
                        case 2 -> Scene.random(r, capsule, ball);
                        default -> Scene.random(r, capsule, other);
                    };
            // Some centres deep inside, some the same.
            s.d.mul(i % 3 == 0 ? .1 : i % 31 == 0 ? 0 : 1);
            double truth = g2Truth(s);
            double d = s.distance(n);
            worst = Math.max(worst, Math.abs(truth - d) / s.size());
            assertEquals(truth, d, 1e-14 * s.size(), "seed 303 pose " + i);
            assertEquals(truth, s.swapped().distance(n), 1e-14 * s.size(), "seed 303 pose " + i);
        }
        System.out.println(line("G2", worst, "1e-14 of the size"));
    }

    private static void g3(int poses, int most, long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        NarrowPhase n = new NarrowPhase();
        double worst = 0;
        for (int i = 0; i < poses; i++) {
            ConvexHull a = Scene.hull(r, 4 + r.nextInt(most - 3), Scene.logUniform(r, .3, 3));
            ConvexHull b = Scene.hull(r, 4 + r.nextInt(most - 3), Scene.logUniform(r, .3, 3));
            Scene s = Scene.random(r, a, b);
            double truth = GaussMapOracle.depth(s.placedA(), s.placedB());
            if (truth > 0) {
                truth = ConvexOracle.distance(s.placedA(), s.placedB());
            }
            double d = s.distance(n);
            worst = Math.max(worst, Math.abs(truth - d) / s.size());
            assertEquals(truth, d, 1e-12 * s.size(), "seed " + seed + " pose " + i);
        }
        System.out.println(line("G3, " + poses + " pairs", worst, "1e-12 of the size"));
    }

    @Test
    void g3HullsAgreeWithAllFacesAndEdgePairs() {
        g3(60, 128, 304);
    }

    @Tag("soak")
    @Test
    void g3ManyHulls() {
        g3(Integer.getInteger("soak.hulls", 100_000), 128, 305);
    }

    /** The pair's poses at which a face, an edge or a vertex of each touches the other's. */
    private static Scene[] g4Scenes() {
        Quaterniond edge = new Quaterniond().rotationZ(StrictMath.PI / 4);
        Quaterniond across = new Quaterniond().rotationX(StrictMath.PI / 4);
        Quaterniond corner = new Quaterniond().rotationXYZ(.7, .3, -1.1);
        Quaterniond plain = new Quaterniond();
        Quaterniond[][] turns = {
            {plain, plain},
            {plain, edge},
            {plain, corner},
            {edge, across},
            {corner, corner},
            {corner, edge}
        };
        Scene[] all = new Scene[turns.length + 2];
        for (int i = 0; i < all.length; i++) {
            Quaterniond[] t = turns[i % turns.length];
            all[i] = new Scene(Box.ofHalfExtents(.5, .75, .6), Box.ofHalfExtents(.4, .3, .55));
            all[i].qa = t[0];
            all[i].qb = t[1];
            all[i].d.set(.03, 1, -.04);
        }
        // Corner against corner, and corner against edge.
        all[turns.length].d.set(1, 1.1, 1.3);
        all[turns.length + 1].d.set(1, 1.1, .1);
        return all;
    }

    @ParameterizedTest
    @EnumSource
    void g4TouchingIsMeasuredToFourUlpsAndInOrder(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        double worst = 0;
        int sort = 0;
        for (Scene s : g4Scenes()) {
            double d = s.distance(n);
            Vector3d axis = EveryPairTest.axis(n);
            s.d.fma(-d, axis);
            Vector3d touching = new Vector3d(s.d);
            double last = -1;
            for (int k = -30; k <= 30; k += 3) {
                double gap =
                        k == 0 ? 0 : Math.signum(k) * StrictMath.pow(10, -16 + Math.abs(k) / 2.);
                s.d.set(touching).fma(gap, axis);
                double truth = ExactOracle.distance(s);
                d = s.distance(n);
                worst = Math.max(worst, Math.abs(truth - d) / Math.ulp(s.size()));
                String where = method + " sort " + sort + " gap " + gap + " truth " + truth;
                assertEquals(truth, d, 4 * Math.ulp(s.size()), where);
                assertTrue(d >= last - 4 * Math.ulp(s.size()), where + " after " + last);
                last = d;
            }
            sort++;
        }
        System.out.println(line("G4 " + method, worst, "4 ulp of the size"));
    }

    /** Stacked upright, every kind on every kind: the truth is a sum. */
    @ParameterizedTest
    @EnumSource
    void g4EveryKindTouchesUpright(NarrowPhase.Method method) {
        Shape[] kinds = {
            Sphere.of(.5),
            Capsule.of(.25, .5),
            Cylinder.of(.5, .75),
            Cone.of(.5, .5),
            Box.ofHalfExtents(.5, 1, .25)
        };
        double[] up = {.5, .75, .75, .75, 1};
        double[] down = {.5, .75, .75, .25, 1};
        NarrowPhase n = new NarrowPhase(method);
        double worst = 0;
        for (int a = 0; a < kinds.length; a++) {
            for (int b = 0; b < kinds.length; b++) {
                Scene s = new Scene(kinds[a], kinds[b]);
                double last = -1;
                for (int k = -15; k <= 15; k++) {
                    double gap = k == 0 ? 0 : Math.signum(k) * StrictMath.pow(10, Math.abs(k) - 16);
                    s.d.set(0, up[a] + down[b] + gap, 0);
                    double truth = s.d.y - up[a] - down[b];
                    double d = s.distance(n);
                    worst = Math.max(worst, Math.abs(truth - d) / Math.ulp(s.size()));
                    String where = method + " " + s.a + " below " + s.b + " gap " + gap;
                    assertEquals(truth, d, 4 * Math.ulp(s.size()), where);
                    assertTrue(d >= last, where);
                    last = d;
                }
            }
        }
        System.out.println(line("G4 upright " + method, worst, "4 ulp of the size"));
    }

    private static Shape prism(int sides) {
        double[] xyz = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            double angle = 2 * StrictMath.PI * (i / 2) / sides;
            xyz[3 * i] = .5 * StrictMath.cos(angle);
            xyz[3 * i + 1] = (i & 1) - .5;
            xyz[3 * i + 2] = .5 * StrictMath.sin(angle);
        }
        return ConvexHull.of(xyz);
    }

    /** Flats that are tilted by 1e-14 to 1e-1 and overlap by a millimetre. */
    @ParameterizedTest
    @EnumSource
    void g5NearlyParallelFlatsKeepFourPointsAndTheirNormal(NarrowPhase.Method method) {
        Shape[] lower = {Box.ofHalfExtents(1, .5, 1), prism(12), Cylinder.of(1, .5)};
        Shape[] upper = {Box.cubeOfHalfExtent(.5), prism(6), Cylinder.of(.5, .5), Cone.of(.5, 1)};
        NarrowPhase n = new NarrowPhase(method);
        Manifold m = new Manifold();
        for (Shape a : lower) {
            for (Shape b : upper) {
                long word = 0;
                for (int k = -14; k <= -1; k++) {
                    double tilt = StrictMath.pow(10, k);
                    Scene s = new Scene(a, b).at(.05, .999, .03);
                    s.qb.rotateXYZ(tilt, 0, -tilt);
                    String where = method + " " + a + " under " + b + " tilt " + tilt;
                    word = s.collide(n, .01, word, m);
                    double least = 1;
                    for (int i = 0; i < m.pointCount; i++) {
                        least = Math.min(least, m.separation[i]);
                    }
                    double depth = s.distance(n);
                    assertEquals(depth, least, m.bound + 1e-15, where);
                    assertEquals(-1e-3, least, 1.1 * tilt + 1e-14, where);
                    if (tilt < 1e-4) {
                        assertEquals(4, m.pointCount, where);
                        assertEquals(1, m.normalY, 2 * tilt * tilt + 1e-15, where);
                    }
                }
            }
        }
    }

    /** A small body on a large one, at rest or nearly so. */
    @Test
    void g6TheSizeOfTheGroundDoesNotMatter() {
        NarrowPhase special = new NarrowPhase();
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        Shape[] small = {
            Box.cubeOfHalfExtent(.1),
            Sphere.of(.1),
            Capsule.of(.1, .1),
            Cylinder.of(.1, .1),
            Cone.of(.1, .1),
            prism(8)
        };
        double[] down = {.1, .1, .2, .1, .05, .5};
        for (double half = 1; half <= 1e6; half *= 10) {
            double bar = half <= 1e5 ? 1e-9 * .1 : 1e-8 * .1;
            for (int i = 0; i < small.length; i++) {
                for (double depth : new double[] {1.078e-4, 1e-7, 0, -1e-7, -1e-2}) {
                    Scene s = new Scene(Box.ofHalfExtents(half, half, half), small[i]);
                    s.d.set(.3 * half, half + down[i] - depth, -.2 * half);
                    s.qb.rotateY(.3);
                    double truth = s.d.y - half - down[i];
                    String where = "half size " + half + " under " + small[i] + " depth " + depth;
                    assertEquals(truth, s.distance(special), bar, where);
                    assertEquals(truth, s.distance(general), bar, where);
                    assertEquals(truth, s.swapped().distance(special), bar, where);
                    assertEquals(1, Math.abs(special.axisY()), 1e-9, where);
                }
            }
        }
    }

    @Test
    void g8FarFromTheOriginTheAnswerIsThatOfTheDifference() {
        SplittableRandom r = new SplittableRandom(308);
        ShapeQueries queries = new ShapeQueries();
        Placement a = new Placement();
        Placement b = new Placement();
        NarrowPhase n = new NarrowPhase();
        ShapeKind[] kinds = {
            ShapeKind.BOX,
            ShapeKind.HULL,
            ShapeKind.CYLINDER,
            ShapeKind.CONE,
            ShapeKind.CAPSULE,
            ShapeKind.BALL
        };
        for (int i = 0; i < 2_000; i++) {
            double far = StrictMath.pow(10, 3 + i % 7);
            Scene s =
                    Scene.random(
                            r,
                            kinds[r.nextInt(kinds.length)].shape(r),
                            kinds[r.nextInt(kinds.length)].shape(r));
            Vector3d at = Scene.direction(r).mul(far);
            Vector3d other = new Vector3d(at).add(s.d);
            a.setCentre(s.a, at.x, at.y, at.z, s.qa.x, s.qa.y, s.qa.z, s.qa.w);
            b.setCentre(s.b, other.x, other.y, other.z, s.qb.x, s.qb.y, s.qb.z, s.qb.w);
            // What the rounded places mean, without another rounding.
            s.d.set(other).sub(at);
            double d = queries.distance(a, b);
            String where = "seed 308 pose " + i + " at " + far;
            assertEquals(s.distance(n), d, 2 * Math.ulp(far), where);
        }
    }

    /** Any start and any simplex: the depth and the distance are those from cold, to the bit. */
    @Test
    void g9WhateverItStartsFromTheDepthIsTheSame() {
        SplittableRandom r = new SplittableRandom(309);
        Pair p = new Pair();
        Gjk gjk = new Gjk();
        Axes axes = new Axes();
        ContactPoints points = new ContactPoints(p, axes, gjk);
        HullAxis search = new HullAxis(p, gjk, new Epa(), axes, points, false);
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        NarrowPhase special = new NarrowPhase();
        double nan = Double.NaN;
        int overlaps = 0;
        for (int i = 0; i < 2_000; i++) {
            Scene s =
                    i % 2 == 0
                            ? Scene.random(r, Scene.box(r), Scene.box(r))
                            : Scene.random(r, Scene.hull(r, 12, 1), Scene.hull(r, 9, 1));
            p.set(
                    s.a, s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z, s.qb.w, s.d.x,
                    s.d.y, s.d.z);
            Vector3d any = Scene.direction(r);
            double[][] starts = {
                {p.dx, p.dy, p.dz},
                {0, 0, 0},
                {nan, nan, nan},
                {nan, 1, 0},
                {1, 0, 0},
                {0, 0, -1},
                {1e-300, 0, 0},
                {1e300, 1e300, -1e300},
                {any.x, any.y, any.z},
                {Double.POSITIVE_INFINITY, 0, 0}
            };
            double cold = s.distance(general);
            overlaps += cold < 0 ? 1 : 0;
            for (double[] start : starts) {
                gjk.run(p, start[0], start[1], start[2], Double.MAX_VALUE);
                search.general = true;
                double d = search.distanceAfterRun(true);
                String where = "seed 309 pose " + i + " start " + Arrays.toString(start);
                assertEquals(cold, d, 0.0, where);
            }
            double fifteen = s.distance(special);
            for (int k = 0; k < 10; k++) {
                // Stale vertices, the same one again and again, some on a line or in a plane.
                long word = r.nextLong() & (k % 2 == 0 ? 0xC01C_0701_C070_1C07L : -1L);
                String where = "seed 309 pose " + i + " word " + Long.toHexString(word);
                assertEquals(cold, distance(s, general, word), 0.0, where);
                assertEquals(fifteen, distance(s, special, word), 0.0, where);
            }
        }
        assertTrue(overlaps > 500 && overlaps < 1_500, "overlaps " + overlaps);
    }

    private static double distance(Scene s, NarrowPhase n, long word) {
        return n.distance(
                s.a, s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z, s.qb.w, s.d.x,
                s.d.y, s.d.z, word);
    }

    @ParameterizedTest
    @EnumSource
    void g9AnInstanceThatWasUsedAnswersAsANewOne(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(310);
        NarrowPhase used = new NarrowPhase(method);
        Manifold one = new Manifold();
        Manifold two = new Manifold();
        for (int i = 0; i < 1_000; i++) {
            ShapeKind.Two kinds = ShapeKind.pairs().get(r.nextInt(ShapeKind.pairs().size()));
            Scene s = EveryPairTest.Sort.values()[i % 7].scene(r, kinds);
            String where = method + " " + kinds + " seed 310 pose " + i;
            NarrowPhase fresh = new NarrowPhase(method);
            assertEquals(s.distance(fresh), s.distance(used), 0.0, where);
            // A word of another pair, or no word at all.
            long word = r.nextLong();
            long a = s.collide(fresh, .05, word, one);
            assertEquals(a, s.collide(used, .05, word, two), where);
            assertEquals(one.pointCount, two.pointCount, where);
            double least = Double.MAX_VALUE;
            for (int k = 0; k < one.pointCount; k++) {
                assertEquals(one.separation[k], two.separation[k], 0.0, where);
                least = Math.min(least, one.separation[k]);
            }
            if (one.pointCount > 0) {
                double size = ShapeKind.size(s);
                assertEquals(s.distance(fresh), least, one.bound + 1e-12 * size, where);
            }
        }
    }
}
