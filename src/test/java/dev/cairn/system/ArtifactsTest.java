package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** What comes along with the artifacts, and what does not. */
final class ArtifactsTest {
    /** The same bytes as in the repository's root, in what Maven compiled or packed. */
    @ParameterizedTest
    @ValueSource(strings = {"engine-core", "engine-physics", "engine-render", "samples"})
    void everyArtifactHasLicenceAndNotice(String module) throws IOException {
        Path built = DocsTest.ROOT.resolve(module).resolve("target").resolve("classes");
        List<Path> onPath =
                classPath().filter(path -> path.startsWith(DocsTest.ROOT.resolve(module))).toList();
        assumeTrue(!onPath.isEmpty() || Files.isDirectory(built), "only Maven packs resources");
        List<Path> places = onPath.isEmpty() ? List.of(built) : onPath;
        for (Path place : places) {
            for (String name : List.of("LICENSE", "NOTICE")) {
                String wanted = Files.readString(DocsTest.ROOT.resolve(name));
                assertEquals(wanted, read(place, "META-INF/" + name), place + ": " + name);
            }
        }
    }

    private static String read(Path place, String name) throws IOException {
        if (Files.isDirectory(place)) {
            return Files.readString(place.resolve(name));
        }
        try (ZipFile jar = new ZipFile(place.toFile())) {
            ZipEntry entry = jar.getEntry(name);
            assertNotNull(entry, place + " has no " + name);
            try (InputStream in = jar.getInputStream(entry)) {
                return new String(in.readAllBytes(), StandardCharsets.UTF_8);
            }
        }
    }

    private static java.util.stream.Stream<Path> classPath() {
        String all = System.getProperty("java.class.path");
        return Arrays.stream(all.split(File.pathSeparator)).map(Path::of).map(Path::toAbsolutePath);
    }

    /** Each library that ships is named with its licence. */
    @Test
    void theNoticeNamesWhatComesAlong() throws IOException {
        String notice = Files.readString(DocsTest.ROOT.resolve("NOTICE"));
        for (String work :
                List.of(
                        "JCTools",
                        "JOML",
                        "LWJGL",
                        "Roboto",
                        "GLFW",
                        "Nuklear",
                        "nativefiledialog-extended",
                        "stb",
                        "Gson",
                        "picocli",
                        "progressbar",
                        "JLine")) {
            assertTrue(notice.contains(work), work);
        }
    }

    /** The letters come as a jar of their own, without the look and feel that it is made for. */
    @Test
    void theFontBringsNoSwing() {
        assertThrows(
                ClassNotFoundException.class, () -> Class.forName("com.formdev.flatlaf.FlatLaf"));
        String font = "com/formdev/flatlaf/fonts/roboto/Roboto-Regular.ttf";
        assertNotNull(getClass().getClassLoader().getResource(font));
        assertFalse(
                classPath()
                        .anyMatch(path -> path.getFileName().toString().matches("flatlaf-\\d.*")));
    }
}
