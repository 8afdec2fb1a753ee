package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.SplittableRandom;

/** The four corners that are kept, against all fours there are. */
class ReductionTest {
    private static final double TIE = 1e-5;
    private static final double CALM = 1e-3;

    private final Pair pair = new Pair();
    private final Clipper clipper = new Clipper();
    private final Reduction reduction = new Reduction();
    private double[] x = {}, z = {}, depth = {};
    private int[] name = {};

    /** A prism with corners at random places of an oval: every cap is another polygon. */
    private static ConvexHull prism(SplittableRandom r, int sides) {
        double[] xyz = new double[6 * sides];
        double wide = .5 + r.nextDouble();
        for (int i = 0; i < sides; i++) {
            double angle = 2 * StrictMath.PI * (i + .9 * r.nextDouble()) / sides;
            for (int end = 0; end < 2; end++) {
                int at = 3 * (2 * i + end);
                xyz[at] = wide * StrictMath.cos(angle);
                xyz[at + 1] = end - .5;
                xyz[at + 2] = StrictMath.sin(angle);
            }
        }
        return ConvexHull.of(xyz);
    }

    private static int face(Polyhedron h, double y) {
        int best = 0;
        for (int f = 1; f < h.faceCount(); f++) {
            best = h.normalY(f) * y > h.normalY(best) * y ? f : best;
        }
        return best;
    }

    /** Clips the cap of B against the cap of A and remembers the whole polygon. */
    private int clip(SplittableRandom r, double tilt, int last) {
        int sides = 3 + r.nextInt(20);
        ConvexHull a = prism(r, sides);
        ConvexHull b = prism(r, 3 + r.nextInt(20));
        return clip(new Scene(a, b), r, tilt, last);
    }

    private int clip(Scene s, SplittableRandom r, double tilt, int last) {
        s.at(.3 * Scene.gauss(r), .999, .3 * Scene.gauss(r));
        s.qb.rotateXYZ(tilt * Scene.gauss(r), 6 * r.nextDouble(), tilt * Scene.gauss(r));
        pair.set(s.a, s.b, 0, 0, 0, 1, s.qb.x, s.qb.y, s.qb.z, s.qb.w, s.d.x, s.d.y, s.d.z);
        int top = face(pair.a, 1);
        clipper.clip(pair, false, top, face(pair.b, -1), 1, last);
        x = Arrays.copyOf(clipper.x, clipper.count);
        z = Arrays.copyOf(clipper.z, clipper.count);
        depth = Arrays.copyOf(clipper.separation, clipper.count);
        name = Arrays.copyOf(clipper.feature, clipper.count);
        return top;
    }

    private double area(int i, int j, int k, int l) {
        return Math.max(crossed(i, j, k, l), Math.max(crossed(i, k, j, l), crossed(i, l, j, k)));
    }

    /** Half the cross product of i-j and k-l: the area when these are the diagonals. */
    private double crossed(int i, int j, int k, int l) {
        return .5 * Math.abs((x[j] - x[i]) * (z[l] - z[k]) - (z[j] - z[i]) * (x[l] - x[k]));
    }

    private double bestArea(double deep) {
        double best = 0;
        int n = x.length;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++) {
                for (int k = j + 1; k < n; k++) {
                    for (int l = k + 1; l < n; l++) {
                        double least =
                                Math.min(
                                        Math.min(depth[i], depth[j]), Math.min(depth[k], depth[l]));
                        if (least <= deep) {
                            best = Math.max(best, area(i, j, k, l));
                        }
                    }
                }
            }
        }
        return best;
    }

    private int[] kept() {
        int[] kept = new int[clipper.count];
        for (int i = 0; i < kept.length; i++) {
            for (int j = 0; j < name.length; j++) {
                kept[i] = name[j] == clipper.feature[i] ? j : kept[i];
            }
        }
        return kept;
    }

    private void reduce(int top, double inner, int last) {
        reduction.reduce(
                clipper,
                pair.a.normalX(top),
                pair.a.normalY(top),
                pair.a.normalZ(top),
                TIE * inner,
                CALM * inner,
                last);
    }

    @Test
    void theDeepestCornerIsKeptAndTheAreaIsNearlyTheBest() {
        SplittableRandom r = new SplittableRandom(41);
        int large = 0;
        for (int i = 0; i < 1_500; i++) {
            int last = i % 3 == 2 ? r.nextInt() : 0;
            int top = clip(r, i % 2 == 0 ? 0 : .01, last);
            if (x.length <= 4) {
                continue;
            }
            large += x.length > 16 ? 1 : 0;
            double least = Arrays.stream(depth).min().orElseThrow();
            double best = bestArea(least + TIE * pair.inner);
            reduce(top, pair.inner, last);
            String where = "seed 41 polygon " + i + " of " + x.length + " corners";
            assertEquals(4, clipper.count, where);
            int[] f = kept();
            double share = area(f[0], f[1], f[2], f[3]) / best;
            assertTrue(share >= .95, where + " area " + share);
            double deepest = Arrays.stream(f).mapToDouble(k -> depth[k]).min().orElseThrow();
            double slack = last == 0 ? TIE : CALM;
            assertTrue(deepest <= least + slack * pair.inner, where);
        }
        assertTrue(large > 100, "polygons that are thinned: " + large);
    }

    /** The corners of an octagon span four equal squares: noise must not choose between them. */
    @Test
    void theSameFourStayWhileTheyAreAsGoodAsAny() {
        SplittableRandom r = new SplittableRandom(42);
        Manifold m = new Manifold();
        NarrowPhase n = new NarrowPhase();
        int[] first = {};
        long word = 0;
        for (int tick = 0; tick < 500; tick++) {
            Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5));
            s.at(1e-6 * Scene.gauss(r), .999, 1e-6 * Scene.gauss(r));
            s.qb.rotateY(Math.PI / 4 + 1e-6 * Scene.gauss(r))
                    .rotateX(1e-6 * Scene.gauss(r))
                    .rotateZ(1e-6 * Scene.gauss(r));
            word = s.collide(n, .02, word, m);
            first = tick == 0 ? m.feature.clone() : first;
            assertTrue(Arrays.equals(first, m.feature), "seed 42 tick " + tick);
        }
    }
}
