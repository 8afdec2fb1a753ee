package dev.cairn.render.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.app.Picture;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;

class MeshesTest {
    /** Volume by the divergence theorem: positive only if the triangles are wound outwards. */
    private static double volume(Mesh mesh) {
        float[] v = mesh.vertices();
        int[] index = mesh.indices();
        double sum = 0;
        for (int i = 0; i < index.length; i += 3) {
            int a = 8 * index[i];
            int b = 8 * index[i + 1];
            int c = 8 * index[i + 2];
            sum +=
                    v[a] * ((double) v[b + 1] * v[c + 2] - (double) v[b + 2] * v[c + 1])
                            + v[a + 1] * ((double) v[b + 2] * v[c] - (double) v[b] * v[c + 2])
                            + v[a + 2] * ((double) v[b] * v[c + 1] - (double) v[b + 1] * v[c]);
        }
        return sum / 6;
    }

    private static void assertNormalsPointOutwards(Mesh mesh) {
        float[] v = mesh.vertices();
        for (int i = 0; i < v.length; i += 8) {
            double length =
                    Math.sqrt(v[i + 3] * v[i + 3] + v[i + 4] * v[i + 4] + v[i + 5] * v[i + 5]);
            assertEquals(1, length, 1e-5, mesh + " vertex " + i / 8);
            assertTrue(
                    v[i] * v[i + 3] + v[i + 1] * v[i + 4] + v[i + 2] * v[i + 5] > 0,
                    mesh + " vertex " + i / 8);
        }
    }

    @Test
    void meshesEncloseTheVolumeOfTheirShapes() {
        SplittableRandom random = new SplittableRandom(3);
        double[] points = new double[90];
        for (int i = 0; i < points.length; i++) {
            points[i] = random.nextDouble(-1, 1);
        }
        ConvexHull hull = ConvexHull.of(points);
        assertEquals(hull.volume(), volume(Meshes.of(hull)), 1e-5);
        assertEquals(
                8 * 0.5 * 0.7 * 1.1, volume(Meshes.of(Box.ofHalfExtents(0.5, 0.7, 1.1))), 1e-5);
        double ball = volume(Meshes.of(Sphere.of(2)));
        assertEquals(Sphere.of(2).volume(), ball, 0.02 * ball);
        assertNormalsPointOutwards(Meshes.of(hull));
        assertNormalsPointOutwards(Meshes.CUBE);
        assertNormalsPointOutwards(Meshes.BALL);
        assertEquals(2, Meshes.plane(3, 4).triangleCount());
        assertEquals(5, Meshes.plane(3, 4).radius(), 1e-9);
    }

    @Test
    void shapesOfOneKindShareAMesh() {
        assertSame(
                Model.of(Box.ofHalfExtents(1, 2, 3)).mesh(),
                Model.of(Box.cubeOfHalfExtent(9)).mesh());
        assertSame(Model.of(Sphere.of(1)).mesh(), Model.of(Sphere.of(2)).mesh());
        ConvexHull hull = ConvexHull.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
        assertSame(Model.of(hull).mesh(), Model.of(hull).mesh());
        assertEquals(Texture.grid().tiledEvery(2), Texture.grid().tiledEvery(2));
        assertNotEquals(Texture.grid().tiledEvery(2), Texture.grid());
    }

    @Test
    void badValuesAreNamed() {
        assertTrue(
                assertThrows(IllegalArgumentException.class, () -> Meshes.box(1, 0, 1))
                        .getMessage()
                        .contains("halfY is 0.0"));
        assertThrows(IllegalArgumentException.class, () -> Meshes.sphere(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> Model.of(Meshes.CUBE).scale(-1));
        assertThrows(
                IllegalArgumentException.class,
                () -> Model.of(Meshes.CUBE).origin(Double.NaN, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> Mesh.of("m", new float[7], new int[0]));
        assertThrows(
                IllegalArgumentException.class,
                () -> Mesh.of("m", new float[8], new int[] {0, 0, 1}));
        assertThrows(IllegalArgumentException.class, () -> Texture.of("t", 2, 2, new int[3]));
        assertThrows(IllegalArgumentException.class, () -> Texture.grid().tiledEvery(-1));
    }

    @Test
    void pngComesBackAsItWasWritten(@TempDir Path folder) throws Exception {
        SplittableRandom random = new SplittableRandom(5);
        int[] argb = new int[13 * 7];
        for (int i = 0; i < argb.length; i++) {
            argb[i] = 0xFF000000 | random.nextInt(0x1000000);
        }
        Path file = folder.resolve("new/deep/picture.png");
        new Picture(13, 7, argb).savePng(file);
        Texture back = Texture.read(file);
        assertEquals(13, back.width());
        assertEquals(7, back.height());
        assertArrayEquals(argb, back.argb());
        Path broken = folder.resolve("broken.png");
        Files.write(broken, new byte[] {1, 2, 3});
        assertTrue(
                assertThrows(IllegalArgumentException.class, () -> Texture.read(broken))
                        .getMessage()
                        .contains("broken.png"));
        assertTrue(
                assertThrows(
                                IllegalArgumentException.class,
                                () -> Texture.read(folder.resolve("no.png")))
                        .getMessage()
                        .contains("found nothing"));
    }
}
