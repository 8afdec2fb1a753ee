package dev.cairn.samples.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.render.app.Offscreen;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The page of animations shows all that the command makes, and they are small. */
class GalleryTest {
    private static final long MOST_BYTES_OF_ALL = 3_000_000;

    private static Path root() {
        Path at = Path.of("").toAbsolutePath();
        while (!Files.exists(at.resolve("engine-core"))) {
            at = at.getParent();
        }
        return at;
    }

    @Test
    void thePageShowsEachFileAndNoOther() throws IOException {
        Path docs = root().resolve("docs");
        String page = Files.readString(docs.resolve("gallery.md"));
        Set<String> made = new TreeSet<>();
        long sum = 0;
        for (GalleryCommand.Take take : GalleryCommand.TAKES) {
            made.add(take.file());
            Path file = root().resolve(GalleryCommand.FOLDER).resolve(take.file());
            long bytes = Files.size(file);
            assertTrue(bytes <= GalleryCommand.MOST_BYTES, file + " has " + bytes + " bytes");
            sum += bytes;
            assertTrue(page.contains("(images/gallery/" + take.file() + ")"), take.file());
            assertTrue(page.contains("`--scene " + take.scene() + "`"), take.scene());
        }
        assertTrue(sum <= MOST_BYTES_OF_ALL, "all have " + sum + " bytes");
        try (Stream<Path> files = Files.list(root().resolve(GalleryCommand.FOLDER))) {
            assertEquals(
                    made,
                    files.map(file -> String.valueOf(file.getFileName()))
                            .collect(Collectors.toCollection(TreeSet::new)));
        }
        String readme = Files.readString(root().resolve("README.md"));
        assertTrue(readme.contains("(docs/gallery.md)"));
    }

    @Test
    void aTakeHasTheSameBytesEachTime(@TempDir Path folder) throws IOException {
        assumeTrue(Offscreen.unavailableReason() == null, "no OpenGL here");
        GalleryCommand.Take take = new GalleryCommand.Take("cradle", 0, 16);
        Path first = folder.resolve("first.png");
        Path second = folder.resolve("second.png");
        GalleryCommand.shoot(take, first);
        GalleryCommand.shoot(take, second);
        assertArrayEquals(Files.readAllBytes(first), Files.readAllBytes(second));
    }
}
