package dev.cairn.render.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;

class ObjReaderTest {
    @TempDir Path folder;

    private Mesh read(String text) throws IOException {
        Path file = folder.resolve("mesh.obj");
        Files.writeString(file, text, StandardCharsets.ISO_8859_1);
        return ObjReader.read(file);
    }

    private static double area(Mesh mesh) {
        float[] v = mesh.vertices();
        int[] index = mesh.indices();
        double sum = 0;
        for (int i = 0; i < index.length; i += 3) {
            int a = index[i] * Mesh.FLOATS_PER_VERTEX;
            int b = index[i + 1] * Mesh.FLOATS_PER_VERTEX;
            int c = index[i + 2] * Mesh.FLOATS_PER_VERTEX;
            double ux = v[b] - v[a];
            double uy = v[b + 1] - v[a + 1];
            double uz = v[b + 2] - v[a + 2];
            double wx = v[c] - v[a];
            double wy = v[c + 1] - v[a + 1];
            double wz = v[c + 2] - v[a + 2];
            double nx = uy * wz - uz * wy;
            double ny = uz * wx - ux * wz;
            double nz = ux * wy - uy * wx;
            sum += 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "f 1 2 3",
                "f 1/1 2/2 3/3",
                "f 1//1 2//1 3//1",
                "f 1/1/1 2/2/1 3/3/1",
                "f -3 -2 -1",
                "f -3/-3/-1 -2/-2/-1 -1/-1/-1",
                "  f\t1 2 3  # a comment",
                "f 1 \\\n 2 3",
                "usemtl red\ns off\ng part\nl 1 2\nf 1 2 3"
            })
    void everyFormOfIndexGivesTheSameTriangle(String face) throws IOException {
        Mesh mesh =
                read(
                        "# w\u00fcrfel\n"
                                + "mtllib x.mtl\n"
                                + "o thing\n"
                                + "v 0 0 0\n"
                                + "v 2 0 0 1.0\n"
                                + "v 0 3 0 0.1 0.2 0.3\n"
                                + "vt 0 0\n"
                                + "vt 1 0\n"
                                + "vt 0 1 0\n"
                                + "vn 0 0 2\n"
                                + face);
        assertEquals(1, mesh.triangleCount());
        assertEquals(3, mesh.vertexCount());
        assertEquals(3, area(mesh), 1e-6);
        assertArrayEquals(new double[] {0, 0, 0, 2, 0, 0, 0, 3, 0}, mesh.points());
        float[] v = mesh.vertices();
        for (int i = 0; i < 3; i++) {
            assertEquals(1, v[8 * i + 5], 1e-6, "normal of vertex " + i);
            assertEquals(
                    face.contains("/") && !face.contains("//") ? (i == 1 ? 1 : 0) : 0,
                    v[8 * i + 6],
                    "u of " + i);
        }
    }

    @Test
    void negativeIndexCountsBackFromTheLineOfTheFace() throws IOException {
        Mesh mesh =
                read(
                        "v 0 0 0\n"
                                + "v 1 0 0\n"
                                + "v 0 1 0\n"
                                + "f -3 -2 -1\n"
                                + "v 5 0 0\n"
                                + "v 6 0 0\n"
                                + "v 5 1 0\n"
                                + "f -3 -2 -1\n");
        assertEquals(2, mesh.triangleCount());
        assertEquals(5, mesh.vertices()[3 * 8], 0);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void polygonsAreCutIntoTrianglesOfTheSameArea(long seed) throws IOException {
        // Star-shaped polygons, concave as a rule, in a plane that is tilted and far away.
        SplittableRandom random = new SplittableRandom(seed);
        int corners = 4 + (int) seed * 3;
        StringBuilder text = new StringBuilder();
        double[] x = new double[corners];
        double[] y = new double[corners];
        for (int i = 0; i < corners; i++) {
            double radius = random.nextDouble(0.4, 2);
            x[i] = radius * Math.cos(2 * Math.PI * i / corners);
            y[i] = radius * Math.sin(2 * Math.PI * i / corners);
            text.append("v ")
                    .append(10 + x[i])
                    .append(' ')
                    .append(0.6 * y[i])
                    .append(' ')
                    .append(0.8 * y[i])
                    .append('\n');
        }
        text.append('f');
        double twice = 0;
        for (int i = 0; i < corners; i++) {
            text.append(' ').append(i + 1);
            int j = (i + 1) % corners;
            twice += x[i] * y[j] - x[j] * y[i];
        }
        Mesh mesh = read(text.toString());
        assertEquals(corners - 2, mesh.triangleCount());
        assertEquals(twice / 2, area(mesh), 1e-5, "seed " + seed);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            textBlock =
                    """
                    v 1 2            | 1 | 3 coordinates
                    v 1 2 x          | 1 | a number after v, found 'x'
                    v 1 2 NaN        | 1 | a number after v, found 'NaN'
                    v 1 2 1e999      | 1 | within +-3.4e38
                    v 1 2 3f         | 1 | a number after v, found '3f'
                    v 1 1 1;f 1 1    | 2 | at least 3 corners after f, found 2
                    v 1 1 1;f 1 1 2  | 2 | 1..1 or -1..-1
                    v 1 1 1;f 0 1 1  | 2 | found 0
                    v 1 1 1;f 1 1 -2 | 2 | found -2
                    v 1 1 1;f 1/1 1 1| 2 | texture coordinate (vt) defined before this line (none was defined
                    v 1 1 1;f 1//1 1 1| 2 | normal (vn) defined before this line (none was defined
                    v 1 1 1;f a b c  | 2 | v/vt/vn after f, found 'a'
                    v 1 1 1;f 1.5 1 1| 2 | found '1.5'
                    vn 1 2           | 1 | 3 numbers after vn
                    vt               | 1 | 1 to 3 numbers after vt
                    hello world      | 1 | an .obj statement
                    v 1 1 1          | 0 | at least one face (f), found 1 vertices
                    "#"              | 0 | at least one face
                    """)
    void brokenFileIsRefusedWithFileAndLine(String text, int line, String words) {
        ObjFormatException e =
                assertThrows(ObjFormatException.class, () -> read(text.replace(";", "\n")));
        assertEquals(line, e.line());
        assertTrue(e.file().endsWith("mesh.obj"), e.file());
        assertTrue(e.getMessage().contains(words), e.getMessage());
        assertTrue(
                e.getMessage().contains("mesh.obj:" + (line > 0 ? line + ": " : " ")),
                e.getMessage());
        assertEquals(1, e.getMessage().lines().count());
    }

    /** Linear work: a fan is found at once, where ear clipping took the square of the corners. */
    @Test
    void faceOfManyCornersIsReadAtOnce() throws IOException {
        int corners = 300_000;
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            text.append("v ").append(Math.cos(angle)).append(' ').append(Math.sin(angle));
            text.append(" 0\n");
        }
        StringBuilder face = new StringBuilder("f");
        for (int i = 1; i <= corners; i++) {
            face.append(i % 5 == 0 ? " \\\n " : " ").append(i);
        }
        Mesh disc = read(text + "" + face);
        assertEquals(corners - 2, disc.triangleCount());
        // a regular polygon in the unit circle: n/2 sin(2 pi/n), less pi by 2e-10; floats
        assertEquals(Math.PI, area(disc), 1e-4);
        ObjFormatException told =
                assertThrows(
                        ObjFormatException.class, () -> read(text + "v 0 0 0\n" + face + " -1"));
        assertTrue(told.getMessage().contains("not convex"), told.getMessage());
    }

    /** A hub of flat faces: each face asks for a vertex of its own at the same place. */
    @Test
    void hubOfManyFacesIsReadAtOnce() throws IOException {
        int faces = 300_000;
        Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n".repeat(faces));
        assertEquals(faces, mesh.triangleCount());
    }

    @Test
    void pipeIsRefusedWithoutReadingIt() throws IOException, InterruptedException {
        Path pipe = folder.resolve("pipe.obj");
        assumeTrue(
                Files.isExecutable(Path.of("/usr/bin/mkfifo"))
                        && new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).start().waitFor()
                                == 0);
        assertThrows(ObjFormatException.class, () -> ObjReader.read(pipe));
    }

    @Test
    void missingFileFolderAndBinaryAreRefused() throws IOException {
        assertTrue(
                assertThrows(
                                ObjFormatException.class,
                                () -> ObjReader.read(folder.resolve("no.obj")))
                        .getMessage()
                        .contains("found nothing"));
        assertTrue(
                assertThrows(ObjFormatException.class, () -> ObjReader.read(folder))
                        .getMessage()
                        .contains("found a folder"));
        byte[] bytes = new byte[5000];
        new SplittableRandom(7).nextBytes(bytes);
        Path file = folder.resolve("binary.obj");
        Files.write(file, bytes);
        ObjFormatException e = assertThrows(ObjFormatException.class, () -> ObjReader.read(file));
        assertTrue(
                e.getMessage().chars().allMatch(c -> c >= ' '),
                "control characters in " + e.getMessage());
    }

    @Test
    void largeFileIsReadAndSharesVertices() throws IOException {
        int n = 200;
        StringBuilder text = new StringBuilder("vn 0 1 0\n");
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                text.append("v ").append(i).append(" 0 ").append(j).append('\n');
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int a = i * (n + 1) + j + 1;
                text.append("f ")
                        .append(a)
                        .append("//1 ")
                        .append(a + 1)
                        .append("//1 ")
                        .append(a + n + 2)
                        .append("//1 ")
                        .append(a + n + 1)
                        .append("//1\n");
            }
        }
        Mesh mesh = read(text.toString());
        assertEquals(2 * n * n, mesh.triangleCount());
        assertEquals((n + 1) * (n + 1), mesh.vertexCount());
        assertEquals((double) n * n, area(mesh), 1e-3);
    }
}
