package dev.cairn.physics.decomposition;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.physics.shape.decomposition.Decomposition;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;

/** Convex parts of solids whose places have known distances. */
class DecompositionTest {
    private static final String[] L = {"#..", "#..", "###"};
    private static final String[] U = {"#.#", "#.#", "###"};
    private static final String[] CROSS = {".#.", "###", ".#."};
    private static final String[] COMB = {"#.#.#.#", "#.#.#.#", "#######"};
    private static final String[] RING = {"###", "#.#", "###"};
    private static final String[] TWO = {"##..", "##..", "...#"};

    @Test
    void boxesAreFoundAgain() {
        int[] most = {2, 3, 2, 5, 4, 2};
        String[][] all = {L, U, CROSS, COMB, RING, TWO};
        for (int k = 0; k < all.length; k++) {
            String[] rows = all[k];
            Decomposition d = Decomposer.of(Concaves.letter(1, rows)).error(.02).run();
            assertEquals(most[k], d.parts().size(), String.join("/", rows));
            assertEquals(0, d.missing());
            assertTrue(d.beyond() < 1e-12, () -> "beyond " + d.beyond());
            assertTrue(d.isWithinAllowed());
            int cells = 0;
            boolean areWhole = true;
            for (ConvexHull part : d.parts()) {
                areWhole &= Arrays.stream(part.vertices()).allMatch(x -> x == Math.rint(x));
            }
            int shared = 0;
            for (int i = 0; i < 16 * rows.length * rows[0].length(); i++) {
                double x = .125 + .25 * (i % (4 * rows[0].length()));
                double y = .125 + .25 * (i / (4 * rows[0].length()));
                boolean isCell = Concaves.isCell(rows, rows.length - 1 - (int) y, (int) x);
                for (double z = .125; z < 1; z += .25) {
                    double h = z;
                    List<ConvexHull> in =
                            d.parts().stream().filter(p -> Concaves.above(p, x, y, h) < 0).toList();
                    assertEquals(isCell, !in.isEmpty(), () -> x + " " + y + " " + h);
                    cells += isCell ? 1 : 0;
                    shared += isCell ? in.size() - 1 : 0;
                }
            }
            assertTrue(areWhole, String.join("/", rows));
            // what two parts share is counted twice
            assertEquals((cells + shared) / 64.0, d.volume(), 1e-12 * d.volume());
            assertEquals(cells / 64.0, d.massProperties(1).mass(), 1e-12 * cells);
        }
    }

    @Test
    void aConvexMeshIsOnePart() {
        Decomposition d = Decomposer.of(Concaves.letter(1, "###", "###")).run();
        assertEquals(1, d.parts().size());
        assertEquals(6, d.volume(), 1e-12);
    }

    /** Random places of the parts are near the solid, places of the mesh near the parts. */
    @Test
    void theErrorsAreTrue() {
        long seed = 28;
        SplittableRandom random = new SplittableRandom(seed);
        TriangleMesh mesh = Concaves.torus(48, 24, 1, .3);
        // facets lie inside the smooth torus by at most these sagittas
        double sagitta = 1.3 * (1 - Math.cos(Math.PI / 48)) + .3 * (1 - Math.cos(Math.PI / 24));
        Decomposition d = Decomposer.of(mesh).error(.02).parts(32).run();
        assertTrue(d.isWithinAllowed(), () -> d + " seed " + seed);
        assertTrue(d.parts().size() <= 20, () -> d.toString());
        for (ConvexHull part : d.parts()) {
            double[] v = part.vertices();
            for (int i = 0; i < 2000; i++) {
                double[] p = new double[3];
                double sum = 0;
                for (int k = 0; k < 4; k++) {
                    double weight = -StrictMath.log(random.nextDouble());
                    int at = 3 * random.nextInt(v.length / 3);
                    for (int axis = 0; axis < 3; axis++) {
                        p[axis] += weight * v[at + axis];
                    }
                    sum += weight;
                }
                double out = Math.sqrt(p[0] * p[0] + p[2] * p[2]) / sum - 1;
                double away = Math.sqrt(out * out + p[1] * p[1] / (sum * sum)) - .3;
                assertTrue(away <= d.beyondAtMost(), away + " m, seed " + seed);
            }
        }
        double[] v = mesh.vertices();
        int[] index = mesh.indices();
        for (int i = 0; i < 5000; i++) {
            int t = 3 * random.nextInt(index.length / 3);
            double a = random.nextDouble();
            double b = random.nextDouble() * (1 - a);
            double[] p = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                p[axis] =
                        (1 - a - b) * v[3 * index[t] + axis]
                                + a * v[3 * index[t + 1] + axis]
                                + b * v[3 * index[t + 2] + axis];
            }
            double above = Double.POSITIVE_INFINITY;
            for (ConvexHull part : d.parts()) {
                above = Math.min(above, Concaves.above(part, p[0], p[1], p[2]));
            }
            double least = above;
            assertTrue(above <= d.missing() + 1e-12, () -> least + " m, seed " + seed);
        }
        assertTrue(d.missing() <= d.allowed() / 4 && sagitta < d.allowed());
    }

    @Test
    void theHoleOfARingStaysOpen() {
        for (ConvexHull part : Decomposer.of(Concaves.torus(48, 24, 1, .3)).run().parts()) {
            for (double y = -.5; y <= .5; y += .01) {
                assertTrue(Concaves.above(part, 0, y, 0) > .6);
            }
        }
    }

    private static double[] numbers(Decomposition d) {
        List<double[]> all = new ArrayList<>();
        d.parts().forEach(p -> all.add(p.vertices()));
        all.add(new double[] {d.beyond(), d.beyondAtMost(), d.missing()});
        return all.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    @Test
    void theSameBitsForAnyWorkers() {
        TriangleMesh mesh = Concaves.torus(24, 12, 1, .3);
        double[] alone = numbers(Decomposer.of(mesh).error(.03).seed(5).run());
        for (int workers : new int[] {2, 3}) {
            try (Jobs jobs = Jobs.perturbed(workers, workers)) {
                assertArrayEquals(alone, numbers(Decomposer.of(mesh).error(.03).seed(5).run(jobs)));
            }
        }
    }

    @Test
    void sizeDoesNotMatter() {
        Decomposition one = Decomposer.of(Concaves.letter(1, COMB)).run();
        for (double scale : new double[] {1e-3, 0x1p-9, 1e3, 1e20}) {
            Decomposition d = Decomposer.of(Concaves.letter(scale, COMB)).run();
            assertEquals(one.parts().size(), d.parts().size());
            for (int k = 0; k < d.parts().size(); k++) {
                ConvexHull expected = one.parts().get(k);
                ConvexHull part = d.parts().get(k);
                assertEquals(expected.volume(), part.volume() / (scale * scale * scale), 1e-12);
                double[] v = expected.vertices();
                assertEquals(v.length, part.vertices().length);
                for (int i = 0; i < v.length; i += 3) {
                    double x = scale * v[i];
                    double above = Concaves.above(part, x, scale * v[i + 1], scale * v[i + 2]);
                    assertEquals(0, above / scale, 1e-12);
                }
            }
        }
    }

    @Test
    void fewPartsAreAllThatThereAre() {
        Decomposition d = Decomposer.of(Concaves.letter(1, COMB)).parts(3).run();
        assertEquals(3, d.parts().size());
        assertFalse(d.isWithinAllowed());
        assertTrue(d.beyond() > d.allowed() && d.beyond() <= d.beyondAtMost(), d.toString());
        Decomposition one = Decomposer.of(Concaves.letter(1, U)).parts(1).run();
        assertEquals(1, one.parts().size());
        // the place in the slot that is farthest from its three walls, 1 m wide and 2 m deep
        assertEquals(.5, one.beyond(), one.beyondAtMost() - one.beyond() + 1e-12);
    }

    @Test
    void progressAscendsAndCancelEnds() {
        List<Double> told = new ArrayList<>();
        Decomposer.of(Concaves.letter(1, COMB)).progress(told::add).run();
        for (int i = 1; i < told.size(); i++) {
            assertTrue(told.get(i) >= told.get(i - 1), told::toString);
        }
        assertEquals(0, told.get(0));
        assertEquals(1, told.get(told.size() - 1));
        int[] asked = {0};
        Decomposer stopped = Decomposer.of(Concaves.letter(1, COMB)).cancel(() -> ++asked[0] > 3);
        assertThrows(CancellationException.class, stopped::run);
        assertEquals(4, asked[0]);
    }

    @Test
    void brokenMeshesAreToldOrWork() {
        TriangleMesh flat =
                TriangleMesh.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, ints(0, 1, 2));
        assertThrows(DegenerateShapeException.class, () -> Decomposer.of(flat).run());
        TriangleMesh whole = Concaves.letter(1, L);
        int[] index = whole.indices();
        TriangleMesh open =
                TriangleMesh.of(whole.vertices(), Arrays.copyOf(index, index.length - 3));
        Decomposition d = Decomposer.of(open).run();
        assertEquals(2, d.parts().size(), "a hole of one triangle");
        String message =
                assertThrows(IllegalArgumentException.class, () -> d.massProperties(1))
                        .getMessage();
        assertTrue(message.contains("not closed"), message);
        TriangleMesh inside = turned(whole);
        assertEquals(2, Decomposer.of(inside).run().parts().size(), "inside out");
        assertThrows(IllegalArgumentException.class, () -> inside.solidProperties(1));
        assertThrows(IllegalArgumentException.class, () -> Decomposer.of(whole).parts(0));
        assertThrows(IllegalArgumentException.class, () -> Decomposer.of(whole).error(0));
        assertThrows(IllegalArgumentException.class, () -> Decomposer.of(whole).error(Double.NaN));
    }

    private static int[] ints(int... values) {
        return values;
    }

    private static TriangleMesh turned(TriangleMesh mesh) {
        int[] index = mesh.indices();
        for (int t = 0; t < index.length; t += 3) {
            int swap = index[t];
            index[t] = index[t + 1];
            index[t + 1] = swap;
        }
        return TriangleMesh.of(mesh.vertices(), index);
    }

    /** An L of three cubes: centre and tensor by the parallel axes. */
    @Test
    void theMassIsThatOfTheSolid() {
        MassProperties p = Concaves.letter(1, "#.", "##").solidProperties(3);
        assertEquals(9, p.mass(), 1e-12);
        double c = (.5 + .5 + 1.5) / 3;
        assertEquals(c, p.comX(), 1e-12);
        assertEquals(c, p.comY(), 1e-12);
        assertEquals(.5, p.comZ(), 1e-12);
        double[][] cubes = {{.5, .5}, {1.5, .5}, {.5, 1.5}};
        double xx = 0;
        double xy = 0;
        double zz = 0;
        for (double[] cube : cubes) {
            double dx = cube[0] - c;
            double dy = cube[1] - c;
            xx += 3 * (1 / 6.0 + dy * dy);
            zz += 3 * (1 / 6.0 + dx * dx + dy * dy);
            xy -= 3 * dx * dy;
        }
        assertEquals(xx, p.ixx(), 1e-12);
        assertEquals(zz, p.izz(), 1e-12);
        assertEquals(xy, p.ixy(), 1e-12);
    }
}
