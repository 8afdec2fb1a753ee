package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A scene that comes from anywhere reads nothing but meshes and pictures from its own folder. */
class AssetPathTest {
    private static final List<String> MESHES = AssetPath.MESHES;

    private static String refused(Path folder, String name) {
        return String.valueOf(
                assertThrows(
                                IllegalArgumentException.class,
                                () -> AssetPath.of(folder, name, MESHES))
                        .getMessage());
    }

    @Test
    void whatIsInTheFolderIsFound(@TempDir Path root) {
        Path folder = root.resolve("scenes");
        assertEquals(folder.resolve("a.obj"), AssetPath.of(folder, "a.obj", MESHES));
        assertEquals(folder.resolve("in/B.OBJ"), AssetPath.of(folder, "in/B.OBJ", MESHES));
        assertTrue(AssetPath.of(folder, "in/../a.obj", MESHES).endsWith("a.obj"));
    }

    @Test
    void whatIsOutsideIsRefusedByAnyWay(@TempDir Path root) throws IOException {
        Path folder = Files.createDirectories(root.resolve("scenes"));
        Path secret = Files.writeString(root.resolve("secret.obj"), "password\n");
        Files.createSymbolicLink(folder.resolve("link.obj"), secret);
        Files.createSymbolicLink(folder.resolve("up"), root);
        for (String name :
                List.of("../secret.obj", secret.toString(), "link.obj", "up/secret.obj")) {
            assertTrue(refused(folder, name).contains("outside of both"), name);
        }
    }

    @Test
    void otherFilesAreRefusedByName(@TempDir Path folder) {
        for (String name : List.of("passwd", "a.obj.txt", "")) {
            assertTrue(refused(folder, name).contains("ends in .obj"), name);
        }
    }

    @Test
    void aSceneThatNamesAnotherFileShowsAPlaceholderAndNothingOfIt(@TempDir Path root)
            throws IOException {
        Path folder = Files.createDirectories(root.resolve("scenes"));
        Files.writeString(root.resolve("secret.obj"), "password\u001b[31m\n");
        Files.writeString(folder.resolve("odd.obj"), "odd\u001b[31m\n");
        String body =
                "{\"position\": [%d, 0, 0], \"shape\": {\"type\": \"mesh\", \"file\": \"%s\"}}";
        Path file =
                Files.writeString(
                        folder.resolve("scene.json"),
                        "{\"format\": \"cairn-scene\", \"version\": 1, \"entities\": ["
                                + body.formatted(0, "../secret.obj")
                                + ","
                                + body.formatted(5, "odd.obj")
                                + "]}");
        SampleScene scene = SceneLoader.sample(file, SceneReader.read(file));
        SceneReport report =
                new SceneRun(scene, SceneOptions.defaults(scene), 1, 1, 4).run(() -> {});
        String told = String.join("\n", report.remarks());
        assertEquals(2, report.remarks().size(), told);
        assertFalse(told.contains("password"), told);
        assertFalse(told.contains("\u001b"), told);
    }
}
