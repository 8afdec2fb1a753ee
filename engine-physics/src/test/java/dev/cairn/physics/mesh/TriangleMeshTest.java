package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.MeshReport;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** What a mesh is made from, and what it refuses. */
class TriangleMeshTest {
    /** A cube of edge 2, with eight vertices. */
    static double[] cube() {
        double[] xyz = new double[24];
        for (int v = 0; v < 8; v++) {
            for (int axis = 0; axis < 3; axis++) {
                xyz[3 * v + axis] = (v >> axis & 1) == 0 ? -1 : 1;
            }
        }
        return xyz;
    }

    static int[] sides() {
        int[] quads = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
        int[] index = new int[36];
        for (int q = 0; q < 6; q++) {
            int[] corner = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < 6; k++) {
                index[6 * q + k] = quads[4 * q + corner[k]];
            }
        }
        return index;
    }

    @Test
    void aClosedCubeIsWithoutFault() {
        MeshReport report = TriangleMesh.of(cube(), sides()).report();
        assertEquals(new MeshReport(12, List.of(), 0, 0, 0, 0), report);
        assertTrue(report.isClosed());
    }

    @Test
    void whatIsWrongIsTold() {
        // each triangle with vertices of its own: they are welded
        int[] sides = sides();
        double[] own = new double[9 * 12 + 6];
        for (int i = 0; i < 36; i++) {
            System.arraycopy(cube(), 3 * sides[i], own, 3 * i, 3);
        }
        int[] index = new int[36 + 6];
        Arrays.setAll(index, i -> i);
        index[36] = 0; // two corners at one place
        index[37] = 0;
        index[38] = 1;
        own[108] = -1; // three corners on a line
        own[109] = -1;
        own[110] = 3;
        index[39] = 0;
        index[40] = 1;
        index[41] = 36;
        index[3] = 4; // the second triangle is turned over
        index[4] = 3;
        TriangleMesh mesh = TriangleMesh.of(own, index);
        assertEquals(new MeshReport(12, List.of(12, 13), 28, 0, 0, 3), mesh.report());
        int[] open = Arrays.copyOf(sides, 33);
        assertEquals(3, TriangleMesh.of(cube(), open).report().openEdges());
        int[] crowded = Arrays.copyOf(sides, 39);
        crowded[36] = 0;
        crowded[37] = 7;
        crowded[38] = 4;
        MeshReport report = TriangleMesh.of(cube(), crowded).report();
        assertFalse(report.isClosed());
        assertEquals(2, report.crowdedEdges());
        assertEquals(1, report.openEdges());
    }

    @Test
    void badInputIsRefused() {
        double[] xyz = {0, 0, 0, 1, 0, 0, 0, 0, -1};
        int[] one = {0, 1, 2};
        refused("vertices is null", null, one);
        refused("indices is null", xyz, null);
        refused("vertices has 4 entries", new double[4], one);
        refused("indices has 2 entries", xyz, new int[2]);
        refused("corner 1 of triangle 0 is vertex 3; there are 3", xyz, new int[] {0, 3, 2});
        refused("corner 0 of triangle 0 is vertex -1", xyz, new int[] {-1, 1, 2});
        refused("corner 2", xyz, new int[] {0, 1, Integer.MAX_VALUE});
        refused("none of the 0 triangles", xyz, new int[0]);
        refused("none of the 1 triangles", new double[9], one);
        refused("y of vertex 1 is NaN", new double[] {0, 0, 0, 1, Double.NaN, 0, 0, 0, 1}, one);
        refused("must lie in [-1e30, 1e30]", new double[] {0, 0, 0, 1e31, 0, 0, 0, 0, 1}, one);
        TriangleMesh mesh = TriangleMesh.of(xyz, one);
        assertThrows(IllegalArgumentException.class, () -> mesh.scaled(1, 0, 1));
        assertThrows(IllegalArgumentException.class, () -> mesh.scaled(1, Double.NaN, 1));
        assertThrows(DegenerateShapeException.class, () -> mesh.scaled(1e200, 1, 1));
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Body body = Body.dynamic().shape(mesh);
            String told =
                    assertThrows(IllegalArgumentException.class, () -> world.add(body))
                            .getMessage();
            assertTrue(told.contains("fixed or kinematic") && told.contains("ConvexHull"), told);
            BodyRef fixed = world.add(Body.fixed().shape(mesh));
            assertThrows(
                    IllegalArgumentException.class,
                    () -> fixed.setType(dev.cairn.physics.body.BodyType.DYNAMIC));
        }
    }

    private static void refused(String what, double[] xyz, int[] index) {
        String told =
                assertThrows(IllegalArgumentException.class, () -> TriangleMesh.of(xyz, index))
                        .getMessage();
        assertTrue(told.contains(what), told);
    }

    /** A box on a mirrored and stretched step: what was up stays up. */
    @Test
    void aMirroredMeshKeepsItsFront() {
        TriangleMesh mesh = TriangleMesh.of(cube(), sides()).scaled(-2, .5, 3);
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).build()) {
            world.add(Body.fixed().shape(mesh));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.2)).at(1.7, .8, -2.7));
            for (int i = 0; i < 120; i++) {
                world.step(1 / 60.0);
            }
            assertEquals(.7, box.position(new Vector3d()).y, 1e-3);
        }
    }

    /** The arrays themselves where nothing was left out of them. */
    @Test
    void whatWasGivenIsTold() {
        TriangleMesh mesh = TriangleMesh.of(cube(), sides());
        assertArrayEquals(cube(), mesh.vertices());
        assertArrayEquals(sides(), mesh.indices());
        assertArrayEquals(sides(), mesh.twoSided().indices());
    }

    /** Each triangle has three vertices of its own, and every fifth one is a line. */
    @Test
    void whatWasGivenIsToldThoughVerticesAreWeldedAndTrianglesLeftOut() {
        TriangleMesh clean = Grounds.irregular(8, 30, 5);
        double[] place = clean.vertices();
        int[] corner = clean.indices();
        double[] xyz = new double[3 * corner.length];
        int[] index = new int[corner.length];
        for (int i = 0; i < corner.length; i++) {
            System.arraycopy(place, 3 * corner[i], xyz, 3 * i, 3);
            index[i] = i % 15 == 2 ? i - 1 : i;
        }
        TriangleMesh soup = TriangleMesh.of(xyz, index);
        assertTrue(soup.report().weldedVertices() > 0);
        assertEquals((corner.length + 12) / 15, soup.report().degenerate().size());
        assertArrayEquals(xyz, soup.vertices());
        int[] told = soup.indices();
        assertEquals(index.length, told.length);
        for (int i = 0; i < told.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(xyz[3 * index[i] + axis], xyz[3 * told[i] + axis], "corner " + i);
            }
        }
        TriangleMesh again = TriangleMesh.of(soup.vertices(), told);
        assertEquals(soup.report(), again.report());
    }

    /** Tree, edges and report, whoever builds them; what is done is told up to all of it. */
    @Test
    void aMeshIsTheSameForAnyNumberOfWorkers() {
        TriangleMesh one = Grounds.irregular(20, 90, 3);
        double[] xyz = one.vertices();
        for (int i = 1; i < xyz.length; i += 3) {
            xyz[i] = .1 * StrictMath.sin(3 * xyz[i - 1]) + (i % 7 == 0 ? .2 : 0);
        }
        int[] index = one.indices();
        for (int t = 0; t < index.length / 2; t += 300) {
            index[t] = index[t + 3]; // open, crowded, flipped and degenerate here and there
        }
        one = TriangleMesh.of(xyz, index);
        TriangleSet truth = TriangleSet.of(one);
        assertTrue(truth.count() > 15_000, truth.count() + " triangles");
        for (int workers = 1; workers <= 3; workers++) {
            List<Double> told = new ArrayList<>();
            TriangleMesh mesh;
            try (Jobs jobs = Jobs.of(workers)) {
                mesh = TriangleMesh.of(xyz, index, jobs, told::add);
            }
            assertEquals(one.report(), mesh.report());
            TriangleSet set = TriangleSet.of(mesh);
            for (int t = 0; t < truth.count(); t++) {
                assertEquals(truth.source(t), set.source(t));
                assertEquals(truth.flags(t), set.flags(t));
            }
            TriangleSet.Found a = new TriangleSet.Found();
            TriangleSet.Found b = new TriangleSet.Found();
            for (int i = 0; i < 50; i++) {
                double[] box = {i - 25, -1, -i, i - 24.5, 1, .5 - i};
                truth.find(box, a);
                set.find(box, b);
                assertArrayEquals(a.triangle, b.triangle);
            }
            assertEquals(told.stream().sorted().toList(), told, "ascending");
            assertTrue(told.size() > 10 && told.get(told.size() - 1) == 1, "told " + told);
        }
    }
}
