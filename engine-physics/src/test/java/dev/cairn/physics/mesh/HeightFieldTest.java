package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.mesh.ContactList;
import dev.cairn.physics.narrowphase.mesh.MeshContact;
import dev.cairn.physics.query.Closest;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** A height field is the surface of its triangles: told by the mesh of the same triangles. */
class HeightFieldTest {
    private static final long SEED = 28;
    private static final int WIDE = 71;
    private static final int DEEP = 45;
    private static final double STEP_X = .5;
    private static final double STEP_Z = .4;

    private final Random random = new Random(SEED);

    /** Hills, a plain, steps, and holes, also at the rim and side by side. */
    private HeightField field() {
        double[] heights = new double[WIDE * DEEP];
        for (int k = 0; k < heights.length; k++) {
            int i = k % WIDE;
            int j = k / WIDE;
            boolean plain = i > 40 && j > 20;
            heights[k] = plain ? .25 * i : i > 60 ? j % 2 : random.nextGaussian() * .3;
        }
        HeightField field = HeightField.of(WIDE, DEEP, STEP_X, STEP_Z, heights).withThickness(0);
        return field.withHole(3, 3, 2, 1, true)
                .withHole(0, 0, 1, 1, true)
                .withHole(44, 30, 1, 5, true)
                .withHole(31, 10, 3, 3, true)
                .withHole(32, 11, 1, 1, false);
    }

    private Quaterniond turn() {
        return new Quaterniond(
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian())
                .normalize();
    }

    /** The field's triangles that are there, in the order of the mesh that has those only. */
    private static List<Integer> present(HeightField field) {
        List<Integer> present = new ArrayList<>();
        int cells = field.samplesX() - 1;
        for (int t = 0; t < 2 * cells * (field.samplesZ() - 1); t++) {
            if (!field.isHole(t / 2 % cells, t / 2 / cells)) {
                present.add(t);
            }
        }
        return present;
    }

    @Test
    void trianglesAndWhatStandsOutAreThoseOfTheMesh() {
        HeightField field = field();
        TriangleMesh mesh = field.toMesh();
        List<Integer> present = present(field);
        assertEquals(2 * (70 * 44 - 2 - 1 - 5 - 8), mesh.report().triangles());
        TriangleSet fields = TriangleSet.of(field);
        TriangleSet meshs = TriangleSet.of(mesh);
        double[] c = new double[9];
        double[] d = new double[9];
        int out = 0;
        for (int t = 0; t < meshs.count(); t++) {
            int own = present.get(meshs.source(t));
            fields.corners(own, c);
            meshs.corners(t, d);
            assertArrayEquals(d, c, "corners of " + own);
            assertEquals(meshs.flags(t), fields.flags(own), "flags of " + own);
            out += fields.flags(own) == 0 ? 0 : 1;
            for (int k = 0; k < 3; k++) {
                assertEquals(meshs.vertex(t, k), fields.vertex(own, k));
            }
        }
        assertTrue(out > 1000 && out < meshs.count() - 500, out + " stand out");
    }

    @Test
    void boxesAndRaysFindWhatTheyFindInTheMesh() {
        HeightField field = field();
        TriangleMesh mesh = field.toMesh();
        List<Integer> present = present(field);
        TriangleSet.Found a = new TriangleSet.Found();
        TriangleSet.Found b = new TriangleSet.Found();
        double[] box = new double[6];
        int most = 0;
        for (int i = 0; i < 2000; i++) {
            double size = i % 10 == 0 ? 20 : 1;
            for (int axis = 0; axis < 3; axis++) {
                double at = random.nextDouble() * 40 - 4;
                // on lines of the grid too
                double step = axis == 0 ? STEP_X : axis == 1 ? .01 : STEP_Z;
                box[axis] = i % 3 == 0 ? Math.rint(at / step) * step : at;
                box[axis + 3] = box[axis] + (i % 7 == 0 ? step : size * random.nextDouble());
            }
            box[1] = random.nextGaussian();
            box[4] = box[1] + random.nextDouble();
            TriangleSet.of(field).find(box, a);
            TriangleSet.of(mesh).find(box, b);
            int[] wanted =
                    Arrays.stream(b.triangle, 0, b.count)
                            .map(t -> present.get(TriangleSet.of(mesh).source(t)))
                            .sorted()
                            .toArray();
            assertArrayEquals(wanted, Arrays.copyOf(a.triangle, a.count), "box " + i);
            most = Math.max(most, a.count);
        }
        assertTrue(most > 500, most + " at most");
    }

    @Test
    void questionsHaveTheAnswersOfTheMesh() {
        HeightField field = field();
        TriangleMesh mesh = field.toMesh();
        List<Integer> present = present(field);
        ShapeQueries queries = new ShapeQueries();
        Placement fieldAt = new Placement();
        Placement meshAt = new Placement();
        Placement shapeAt = new Placement();
        Hit hit = new Hit();
        Hit truth = new Hit();
        Closest near = new Closest();
        Closest nearTruth = new Closest();
        int hits = 0;
        for (int i = 0; i < 600; i++) {
            Quaterniond q = turn();
            fieldAt.set(field, 1, 2, 3, q.x, q.y, q.z, q.w);
            meshAt.set(mesh, 1, 2, 3, q.x, q.y, q.z, q.w);
            Vector3d from =
                    new Vector3d(
                            40 * random.nextDouble() - 2,
                            3 * random.nextDouble(),
                            22 * random.nextDouble() - 2);
            Vector3d to =
                    new Vector3d(
                                    random.nextGaussian(),
                                    i % 4 == 0 ? -3 : -.1 * random.nextDouble(),
                                    i % 5 == 0 ? 0 : random.nextGaussian())
                            .normalize();
            q.transform(from).add(1, 2, 3);
            q.transform(to);
            boolean meets =
                    queries.rayCast(meshAt, from.x, from.y, from.z, to.x, to.y, to.z, 30, truth);
            assertEquals(
                    meets,
                    queries.rayCast(fieldAt, from.x, from.y, from.z, to.x, to.y, to.z, 30, hit));
            if (meets) {
                hits++;
                assertEquals(truth.distance(), hit.distance());
                assertEquals(present.get(truth.triangle()), hit.triangle());
                assertEquals(truth.weight(1), hit.weight(1));
            }
            Shape shape = Grounds.kinds()[i % 6];
            shapeAt.set(shape, from.x, from.y, from.z, q.y, q.x, q.w, q.z);
            assertEquals(queries.distance(meshAt, shapeAt), queries.distance(fieldAt, shapeAt));
            if (i % 5 == 0) {
                queries.closest(meshAt, shapeAt, nearTruth);
                queries.closest(fieldAt, shapeAt, near);
                assertEquals(nearTruth.distance(), near.distance());
                meets = queries.shapeCast(shapeAt, to.x, to.y, to.z, 30, meshAt, truth);
                assertEquals(meets, queries.shapeCast(shapeAt, to.x, to.y, to.z, 30, fieldAt, hit));
                assertTrue(!meets || Math.abs(truth.distance() - hit.distance()) < 1e-9);
            }
        }
        assertTrue(hits > 120, hits + " hits");
    }

    /** All points of all contacts, by their names and normals, rounded. */
    private static Map<String, Integer> points(
            MeshContact contact, Shape ground, Shape shape, Vector3d at, Quaterniond q) {
        ContactList out = new ContactList();
        contact.collide(
                TriangleSet.of((dev.cairn.physics.shape.mesh.Meshed) ground),
                0,
                0,
                0,
                1,
                shape,
                q.x,
                q.y,
                q.z,
                q.w,
                at.x,
                at.y,
                at.z,
                0,
                0,
                0,
                .05,
                .05,
                out);
        Map<String, Integer> points = new HashMap<>();
        for (int k = 0; k < out.count; k++) {
            for (int p = 0; p < out.pointCount(k); p++) {
                String text =
                        String.format(
                                "%08x %.6f %.6f %.6f %.6f",
                                out.feature(k, p),
                                out.normal(k, 0) + 0.0,
                                out.normal(k, 1) + 0.0,
                                out.normal(k, 2) + 0.0,
                                out.separation(k, p));
                points.merge(text.replace("-0.000000", "0.000000"), 1, Integer::sum);
            }
        }
        return points;
    }

    @Test
    void contactsAreThoseOfTheMesh() {
        HeightField field = field();
        TriangleMesh mesh = field.toMesh();
        MeshContact contact = new MeshContact(new NarrowPhase());
        int touching = 0;
        int other = 0;
        for (int i = 0; i < 3000; i++) {
            double x = STEP_X * 70 * random.nextDouble();
            double z = STEP_Z * 44 * random.nextDouble();
            double height = field.height(x, z);
            Vector3d at =
                    new Vector3d(x, (height == height ? height : 0) + .3 * random.nextDouble(), z);
            Shape shape = Grounds.kinds()[i % 6];
            Quaterniond q = turn();
            Map<String, Integer> truth = points(contact, mesh, shape, at, q);
            touching += truth.isEmpty() ? 0 : 1;
            // the last digit, and which of equals comes first, may differ
            other += truth.equals(points(contact, field, shape, at, q)) ? 0 : 1;
        }
        assertTrue(touching > 1500, touching + " touch");
        assertTrue(other <= touching / 500, other + " of " + touching + " differ");
    }

    @Test
    void anEditIsTheFieldOfTheNewHeightsAndLeavesTheOldOne() {
        HeightField field = field();
        double[] old = field.heights();
        double[] all = field.heights();
        HeightField edited = field;
        for (int round = 0; round < 40; round++) {
            int x = random.nextInt(WIDE);
            int z = random.nextInt(DEEP);
            int wide = 1 + random.nextInt(WIDE - x);
            int deep = 1 + random.nextInt(DEEP - z);
            double[] patch = new double[wide * deep];
            for (int k = 0; k < patch.length; k++) {
                patch[k] = random.nextGaussian() * (round % 5 == 0 ? 10 : .1);
                all[(z + k / wide) * WIDE + x + k % wide] = patch[k];
            }
            HeightField next = edited.withHeights(x, z, wide, patch);
            double[] box = new double[6];
            assertTrue(edited.differs(next, box));
            assertEquals(Math.max(0, x - 1) * STEP_X, box[0]);
            assertEquals(Math.min(WIDE - 1, x + wide) * STEP_X, box[3]);
            assertEquals(Math.max(0, z - 1) * STEP_Z, box[2]);
            assertEquals(Math.min(DEEP - 1, z + deep) * STEP_Z, box[5]);
            edited = next;
        }
        assertArrayEquals(all, edited.heights());
        assertArrayEquals(old, field.heights());
        // bounds of the edited are bounds of a new one
        HeightField made = HeightField.of(WIDE, DEEP, STEP_X, STEP_Z, all).withThickness(0);
        assertFalse(made.differs(HeightField.of(WIDE, DEEP, STEP_X, STEP_Z, all), new double[6]));
        TriangleSet.Found a = new TriangleSet.Found();
        TriangleSet.Found b = new TriangleSet.Found();
        double[] pad = new double[3];
        HeightField again = made.withHole(3, 3, 2, 1, true).withHole(0, 0, 1, 1, true);
        again = again.withHole(44, 30, 1, 5, true).withHole(31, 10, 3, 3, true);
        again = again.withHole(32, 11, 1, 1, false);
        for (int i = 0; i < 300; i++) {
            double[] ray = {
                random.nextDouble() * 35,
                4 * random.nextGaussian(),
                random.nextDouble() * 17,
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian()
            };
            TriangleSet.of(edited).along(ray, 30, pad, a);
            TriangleSet.of(again).along(ray, 30, pad, b);
            assertArrayEquals(
                    Arrays.copyOf(b.triangle, b.count), Arrays.copyOf(a.triangle, a.count));
        }
    }

    @Test
    void heightsBetweenSamplesAreThoseOfTheTriangles() {
        HeightField field = HeightField.of(3, 2, 2, 1, new double[] {0, 1, 5, 3, 2, 7});
        assertEquals(1, field.height(1, .5), 1e-15, "on the diagonal from 0 to 2");
        assertEquals(.5, field.height(1, 0), 1e-15);
        assertEquals(2.5, field.height(1, 1), 1e-15);
        assertEquals(7, field.height(4, 1), 1e-15);
        assertTrue(Double.isNaN(field.height(4.0001, 1)));
        assertTrue(Double.isNaN(field.withHole(1, 0, 1, 1, true).height(3, .5)));
    }

    @Test
    void whatIsNoFieldIsTold() {
        double[] four = {0, 1, 2, 3};
        String said = told(() -> HeightField.of(2, 2, 1, 1, new double[] {0, 1, Double.NaN, 3}));
        assertTrue(said.contains("sample (0, 1) is NaN"), said);
        said = told(() -> HeightField.of(2, 2, 1, 1, new double[] {0, 1e31, 2, 3}));
        assertTrue(said.contains("(1, 0) is 1.0E31"), said);
        said = told(() -> HeightField.of(2, 3, 1, 1, four));
        assertTrue(said.contains("there are 4 heights; 2 x 3 samples want 6"), said);
        said = told(() -> HeightField.of(1, 4, 1, 1, four));
        assertTrue(said.contains("1 x 4 samples"), said);
        said = told(() -> HeightField.of(1 << 20, 1 << 20, 1, 1, four));
        assertTrue(said.contains("2^29"), said);
        said = told(() -> HeightField.of(2, 2, 0, 1, four));
        assertTrue(said.contains("stepX is 0.0 m"), said);
        HeightField field = HeightField.of(2, 2, 1, 1, four);
        said = told(() -> field.withHeights(1, 0, 2, new double[2]));
        assertTrue(said.contains("2 x 1 samples from (1, 0); there are 2 x 2"), said);
        said = told(() -> field.withHeights(0, 0, 2, new double[3]));
        assertTrue(said.contains("3 heights are no rows of 2"), said);
        said = told(() -> field.withHole(0, 0, 2, 1, true));
        assertTrue(said.contains("2 x 1 cells from (0, 0); there are 1 x 1"), said);
        said = told(() -> field.withThickness(-1));
        assertTrue(said.contains("thickness is -1.0 m"), said);
        assertThrows(
                DegenerateShapeException.class,
                () -> field.withHole(0, 0, 1, 1, true).toMesh(),
                "nothing is left");
    }

    private static String told(Runnable mistake) {
        return String.valueOf(
                assertThrows(IllegalArgumentException.class, mistake::run).getMessage());
    }
}
