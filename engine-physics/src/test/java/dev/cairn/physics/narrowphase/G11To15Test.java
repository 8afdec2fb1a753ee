package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.ReachOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;

/**
 * The cases G11, G12, G13 and G15 of the accuracy catalogue, with its bars; G14 is in {@link
 * EveryPairTest}.
 */
class G11To15Test {
    private static List<Quaterniond> quarterTurns() {
        List<Quaterniond> all = new ArrayList<>();
        for (int x = 0; x < 4; x++) {
            for (int y = 0; y < 4; y++) {
                for (int z = 0; z < 4; z++) {
                    Quaterniond q =
                            new Quaterniond()
                                    .rotateX(x * StrictMath.PI / 2)
                                    .rotateY(y * StrictMath.PI / 2)
                                    .rotateZ(z * StrictMath.PI / 2);
                    if (all.stream().noneMatch(p -> Math.abs(p.dot(q)) > .99)) {
                        all.add(q);
                    }
                }
            }
        }
        return all;
    }

    private static void g11(NarrowPhase.Method method, int poses, long seed) {
        List<Quaterniond> turns = quarterTurns();
        assertEquals(24, turns.size());
        SplittableRandom r = new SplittableRandom(seed);
        NarrowPhase n = new NarrowPhase(method);
        Manifold m = new Manifold();
        double worst = 0;
        for (int i = 0; i < poses; i++) {
            Scene s = new Scene(Box.ofHalfExtents(.5, .75, 1), Box.ofHalfExtents(.5, .75, 1));
            s.qb = turns.get(r.nextInt(24));
            s.d.set(r.nextInt(-17, 18) / 8., r.nextInt(-17, 18) / 8., r.nextInt(-17, 18) / 8.);
            Vector3d half = s.qb.transform(new Vector3d(.5, .75, 1)).absolute();
            double x = Math.abs(s.d.x) - .5 - half.x;
            double y = Math.abs(s.d.y) - .75 - half.y;
            double z = Math.abs(s.d.z) - 1 - half.z;
            double inside = Math.max(x, Math.max(y, z));
            double out = new Vector3d(Math.max(x, 0), Math.max(y, 0), Math.max(z, 0)).length();
            double truth = inside <= 0 ? inside : out;
            String where = method + " seed " + seed + " pose " + i + " " + s.d;
            double d = s.distance(n);
            worst = Math.max(worst, Math.abs(d - truth));
            assertEquals(truth, d, 4e-15, where);
            s.collide(n, .01, 0, m);
            assertEquals(truth < .005, m.pointCount > 0, where + " dropped");
        }
        System.out.printf("G11 %s, %,d poses: worst %.2g, none dropped%n", method, poses, worst);
    }

    @ParameterizedTest
    @EnumSource
    void g11AlignedBoxesAreNeverDropped(NarrowPhase.Method method) {
        g11(method, 10_000, 321);
    }

    @Tag("soak")
    @ParameterizedTest
    @EnumSource
    void g11AlignedBoxesAMillionTimes(NarrowPhase.Method method) {
        g11(method, Integer.getInteger("soak.poses", 1_000_000), 322);
    }

    /** A block with a grid of points on each face, all in the plane but for rounding. */
    private static ConvexHull plateaus(SplittableRandom r, int side) {
        Quaterniond q = Scene.turn(r);
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                double a = 2. * i / (side - 1) - 1;
                double b = 2. * j / (side - 1) - 1;
                // Rims that are bent a little, so that the corners stay vertices.
                double c = 1 - 1e-5 * (a * a + b * b);
                points.add(q.transform(new Vector3d(a, b, c)));
                points.add(q.transform(new Vector3d(a, b, -c)));
            }
        }
        return ConvexHull.of(points);
    }

    @Test
    void g12ClimbingFindsWhatScanningFinds() {
        SplittableRandom r = new SplittableRandom(331);
        for (int points : new int[] {4, 8, 20, 64, 300, 2_000, 10_000}) {
            g12(Scene.hull(r, points, 1), r, points + " points");
        }
        g12(Polyhedron.of(Box.ofHalfExtents(1, 2, 3)), r, "box");
        for (int side : new int[] {4, 12, 30}) {
            g12(plateaus(r, side), r, "plateaus of " + side);
        }
    }

    private static void g12(ConvexHull hull, SplittableRandom r, String name) {
        g12(Polyhedron.of(hull), r, name);
    }

    private static void g12(Polyhedron h, SplittableRandom r, String name) {
        int tries = Math.min(1_000, 4_000_000 / h.vertexCount());
        for (int i = 0; i < tries; i++) {
            int face = r.nextInt(h.faceCount());
            Vector3d n =
                    i % 2 == 0
                            ? Scene.direction(r)
                            : new Vector3d(h.normalX(face), h.normalY(face), h.normalZ(face));
            double most = -Double.MAX_VALUE;
            for (int v = 0; v < h.vertexCount(); v++) {
                most = Math.max(most, reach(h, v, n));
            }
            int v = h.support(n.x, n.y, n.z, r.nextInt(h.vertexCount()));
            // Vertices of a face are as far along its normal up to what rounding says.
            double bar = i % 2 == 0 ? 0 : 4 * Math.ulp(h.outerRadius());
            assertEquals(most, reach(h, v, n), bar, name + " seed 331 try " + i);
        }
    }

    private static double reach(Polyhedron h, int v, Vector3d n) {
        return n.x * h.vertexX(v) + n.y * h.vertexY(v) + n.z * h.vertexZ(v);
    }

    private static double area(List<double[]> polygon) {
        double sum = 0;
        for (int i = 0; i < polygon.size(); i++) {
            double[] p = polygon.get(i);
            double[] q = polygon.get((i + 1) % polygon.size());
            sum += p[0] * q[1] - q[0] * p[1];
        }
        return Math.abs(sum) / 2;
    }

    /** Sutherland and Hodgman, in the plane, from the caps' own corners. */
    private static List<double[]> overlap(double[][] a, double[][] b) {
        List<double[]> polygon = new ArrayList<>(List.of(a));
        for (int i = 0; i < b.length; i++) {
            double[] p = b[i];
            double[] q = b[(i + 1) % b.length];
            List<double[]> next = new ArrayList<>();
            for (int k = 0; k < polygon.size(); k++) {
                double[] u = polygon.get(k);
                double[] v = polygon.get((k + 1) % polygon.size());
                double su = side(p, q, u);
                double sv = side(p, q, v);
                if (su >= 0) {
                    next.add(u);
                }
                if ((su > 0 && sv < 0) || (su < 0 && sv > 0)) {
                    double t = su / (su - sv);
                    next.add(new double[] {u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1])});
                }
            }
            polygon = next;
        }
        return polygon;
    }

    private static double side(double[] p, double[] q, double[] u) {
        return (q[0] - p[0]) * (u[1] - p[1]) - (q[1] - p[1]) * (u[0] - p[0]);
    }

    /** A regular polygon of the plane, counter-clockwise, turned and shifted. */
    private static double[][] ring(int sides, double radius, double turn, double x, double y) {
        double[][] ring = new double[sides][];
        for (int i = 0; i < sides; i++) {
            double angle = turn + 2 * StrictMath.PI * i / sides;
            ring[i] =
                    new double[] {
                        x + radius * StrictMath.cos(angle), y + radius * StrictMath.sin(angle)
                    };
        }
        return ring;
    }

    private static double bestFour(List<double[]> p) {
        double best = area(p);
        if (p.size() <= 4) {
            return best;
        }
        best = 0;
        for (int i = 0; i < p.size(); i++) {
            for (int j = i + 1; j < p.size(); j++) {
                for (int k = j + 1; k < p.size(); k++) {
                    for (int l = k + 1; l < p.size(); l++) {
                        List<double[]> four = List.of(p.get(i), p.get(j), p.get(k), p.get(l));
                        best = Math.max(best, area(four));
                    }
                }
            }
        }
        return best;
    }

    private static double area(Manifold m) {
        double best = 0;
        // Of four points in any order, the largest of the three quadrilaterals.
        int[][] orders = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}};
        for (int[] order : orders) {
            List<double[]> p = new ArrayList<>();
            for (int i : order) {
                if (i < m.pointCount) {
                    p.add(new double[] {m.pointX[i], m.pointZ[i]});
                }
            }
            best = Math.max(best, area(p));
        }
        return best;
    }

    private static ConvexHull prism(int sides, double radius) {
        double[][] ring = ring(sides, radius, 0, 0, 0);
        double[] xyz = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            xyz[3 * i] = ring[i / 2][0];
            xyz[3 * i + 1] = (i & 1) - .5;
            xyz[3 * i + 2] = ring[i / 2][1];
        }
        return ConvexHull.of(xyz);
    }

    /**
     * The sides that a corner of the overlap of two polygons lies on, which is what it is: a vertex
     * or a crossing. Those of the lower one are counted from 1000.
     */
    private static Set<Integer> sides(double x, double y, double[][] over, double[][] under) {
        Set<Integer> on = new HashSet<>();
        double[] u = {x, y};
        for (int k = 0; k < over.length + under.length; k++) {
            double[][] ring = k < over.length ? over : under;
            int i = k < over.length ? k : k - over.length;
            double[] p = ring[i];
            double[] q = ring[(i + 1) % ring.length];
            double length = Math.hypot(q[0] - p[0], q[1] - p[1]);
            if (Math.abs(side(p, q, u)) <= 1e-9 * length) {
                on.add(k < over.length ? i : 1000 + i);
            }
        }
        return on;
    }

    /** The corner of the overlap that a contact point is. */
    private static Set<Integer> sides(
            Manifold m, int i, List<double[]> polygon, double[][] over, double[][] under) {
        double[] nearest = polygon.get(0);
        double least = Double.MAX_VALUE;
        for (double[] p : polygon) {
            double d = Math.hypot(p[0] - m.pointX[i], p[1] - m.pointZ[i]);
            nearest = d < least ? p : nearest;
            least = Math.min(least, d);
        }
        return sides(nearest[0], nearest[1], over, under);
    }

    /**
     * Prisms, drums and cones on prisms and drums, turned by a degree a tick: four points keep 95 %
     * of the area of the best four, the deepest is among them, and names stay: all of what is
     * round, and of prisms at least 99 % of those whose corner of the overlap is still one in the
     * next tick. (A square that turns on a square loses four corners and then the other four each
     * quarter turn; halfway the four that were best have to be changed for the other four, or they
     * would not keep the area.)
     */
    @Test
    void g13FourPointsKeepTheAreaTheDeepestAndTheirNames() {
        int[] kept = new int[3];
        int[] stayed = new int[3];
        int ticks = 0;
        for (int sides : new int[] {4, 5, 8, 64}) {
            for (double aside : new double[] {0, .1, .45}) {
                ticks += 180;
                for (int kind = 0; kind < 3; kind++) {
                    int[] names = g13(sides, kind, aside);
                    kept[kind] += names[0];
                    stayed[kind] += names[1];
                    String where = sides + " sides, kind " + kind + ", aside " + aside;
                    assertTrue(
                            names[0] >= (kind == 0 ? .98 : 1) * names[1],
                            where + ": " + names[0] + " names of " + names[1]);
                }
            }
        }
        System.out.printf(
                "G13: of %,d names those of prisms kept %,d, of %,d whose corner stayed; of round"
                        + " shapes %,d and %,d%n",
                4 * ticks, kept[0], stayed[0], kept[1], kept[2]);
        assertTrue(stayed[0] >= .95 * 4 * ticks, "corners that stay " + stayed[0]);
        assertTrue(kept[0] >= .99 * stayed[0], "names kept " + kept[0] + " of " + stayed[0]);
        assertTrue(kept[0] + kept[1] + kept[2] >= .99 * 12 * ticks, "all names kept");
        assertEquals(4 * ticks, kept[1], "names of cylinders");
        assertEquals(4 * ticks, kept[2], "names of cones");
    }

    /** Names kept, and names whose corner stayed one. */
    private static int[] g13(int sides, int kind, double aside) {
        Shape below = prism(sides, 1);
        Shape above = kind == 0 ? prism(4, .8) : kind == 1 ? Cylinder.of(.7, .5) : Cone.of(.7, 1);
        NarrowPhase n = new NarrowPhase();
        Manifold m = new Manifold();
        long word = 0;
        int kept = 0;
        int stayed = 0;
        Map<Integer, Set<Integer>> last = new HashMap<>();
        for (int degree = 0; degree <= 180; degree++) {
            double turn = StrictMath.toRadians(degree);
            Scene s = new Scene(below, above).at(aside, 1 - 1e-4, .3 * aside);
            // A rotation about y turns x towards -z, so the ring turns the other way round.
            s.qb.rotateY(-turn).rotateX(1e-7);
            word = s.collide(n, .01, word, m);
            String where = sides + " sides, kind " + kind + ", aside " + aside + " at " + degree;
            assertEquals(4, m.pointCount, where);
            double[][] under = ring(sides, 1, 0, 0, 0);
            double[][] over =
                    kind == 0
                            ? ring(4, .8, turn, aside, .3 * aside)
                            : ring(720, .7, 0, aside, .3 * aside);
            List<double[]> polygon = overlap(over, under);
            g13Area(m, kind, polygon, where);
            double least = Double.MAX_VALUE;
            Map<Integer, Set<Integer>> names = new HashMap<>();
            for (int i = 0; i < 4; i++) {
                least = Math.min(least, m.separation[i]);
                // A round shape's points have no corners; all of its names are to stay.
                names.put(m.feature[i], kind == 0 ? sides(m, i, polygon, over, under) : Set.of());
            }
            assertEquals(s.distance(n), least, 1e-5, where);
            assertEquals(4, names.size(), where);
            Set<Set<Integer>> corners = new HashSet<>();
            if (kind == 0) {
                polygon.forEach(p -> corners.add(sides(p[0], p[1], over, under)));
            }
            for (Map.Entry<Integer, Set<Integer>> name : last.entrySet()) {
                if (kind != 0 || corners.contains(name.getValue())) {
                    stayed++;
                    kept += names.containsKey(name.getKey()) ? 1 : 0;
                }
            }
            last = names;
        }
        return new int[] {kept, stayed};
    }

    private static void g13Area(Manifold m, int kind, List<double[]> polygon, String where) {
        if (kind == 0) {
            double best = bestFour(polygon);
            assertTrue(area(m) >= .95 * best, where + ": " + area(m) + " of " + best);
        } else {
            // Of a round patch four points hold no more than 2 / pi; and all of a lens' middle.
            double whole = area(polygon);
            assertTrue(area(m) >= .5 * whole, where + ": " + area(m) + " of " + whole);
        }
    }

    private static ConvexHull block(double x, double y, double z) {
        double[] xyz = new double[24];
        for (int i = 0; i < 8; i++) {
            xyz[3 * i] = (i & 1) == 0 ? -x : x;
            xyz[3 * i + 1] = (i & 2) == 0 ? -y : y;
            xyz[3 * i + 2] = (i & 4) == 0 ? -z : z;
        }
        return ConvexHull.of(xyz);
    }

    /** Cards from 1e-3 to 1e-6 m, needles of 1 : 100 000, of every kind that can be one. */
    @ParameterizedTest
    @EnumSource
    void g15ThinCardsAndNeedlesKeepTheirDigits(NarrowPhase.Method method) {
        SplittableRandom r = new SplittableRandom(341);
        NarrowPhase n = new NarrowPhase(method);
        ReachOracle oracle = new ReachOracle();
        double worst = 0;
        for (int i = 0; i < 1_500; i++) {
            double thin = Scene.logUniform(r, 1e-6, 1e-3);
            Shape[] kinds = {
                Box.ofHalfExtents(1, thin, 1),
                block(1, thin, .7),
                Cylinder.of(1, thin),
                Cone.of(1, thin),
                Box.ofHalfExtents(1e-5, 1, 1e-5),
                block(1e-5, 1, 1e-5),
                Cylinder.of(1e-5, 1),
                Capsule.of(1e-5, 1),
                Cone.of(1e-5, 1)
            };
            Scene s = new Scene(kinds[r.nextInt(9)], kinds[r.nextInt(9)]);
            s.qa = Scene.turn(r);
            s.qb = Scene.turn(r);
            if (i % 3 == 0) {
                s.qb = new Quaterniond(s.qa);
            }
            s.d = Scene.direction(r).mul(r.nextDouble());
            double d = s.distance(n);
            Vector3d axis = EveryPairTest.axis(n);
            // Near touching: a thousandth to a hundred times the thickness.
            double gap = thin * Scene.logUniform(r, 1e-3, 100) * (r.nextBoolean() ? 1 : -.01);
            s.d.fma(gap - d, axis);
            d = s.distance(n);
            axis = EveryPairTest.axis(n);
            String where = method + " seed 341 pose " + i + " " + s.a + " " + s.b + " gap " + gap;
            // A tenth of a micrometre apart, the way between two needles is known to 1e-10.
            assertEquals(oracle.separation(s, axis), d, 1e-10, where);
            double swapped = s.swapped().distance(n);
            worst = Math.max(worst, Math.abs(swapped - d));
            assertEquals(d, swapped, 1e-9, where);
            s.d.fma(-d, axis);
            double out = s.distance(n);
            worst = Math.max(worst, Math.abs(out));
            assertEquals(0, out, 1e-9, where + " pushed out");
        }
        System.out.printf("G15 %s: worst %.2g m, bar 1e-9 m%n", method, worst);
    }

    /** Flat on flat: no touching before the surfaces do. */
    @ParameterizedTest
    @EnumSource
    void g15CardsDoNotTouchBeforeTheyMeet(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Manifold m = new Manifold();
        for (double thin : new double[] {1e-3, 1e-4, 1e-5, 1e-6}) {
            Shape[] kinds = {
                Box.ofHalfExtents(1, thin, 1), block(1, thin, .7), Cylinder.of(1, thin)
            };
            for (Shape a : kinds) {
                for (Shape b : kinds) {
                    for (double gap : new double[] {-1e-2, -1e-6, 0, 1e-6, 1e-2, 1}) {
                        Scene s = new Scene(a, b).at(.1, 2 * thin + gap * thin, .2);
                        double truth = s.d.y - 2 * thin;
                        String where = method + " " + a + " under " + b + " gap " + gap * thin;
                        assertEquals(truth, s.distance(n), 1e-15, where);
                        s.collide(n, 1e-3 * thin, 0, m);
                        assertEquals(gap <= 1e-3, m.pointCount > 0, where);
                        for (int i = 0; i < m.pointCount; i++) {
                            assertEquals(truth, m.separation[i], 1e-15, where);
                        }
                    }
                }
            }
        }
    }
}
