package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.List;

/** The samples as they are started from a command line, seen by their title alone. */
class WholeProgramTest extends MainFixture {
    @Override
    public List<String> arguments() {
        return List.of("--scene", "room", "--window");
    }

    @Test
    void aSceneThatIsNamedIsTheFirstOfAllAndNotTheOnlyOne()
            throws IOException, InterruptedException {
        String first = other("");
        assertTrue(first.toLowerCase(java.util.Locale.ROOT).contains("room"), first);
        type("key", "Page_Down");
        String next = other(first);
        look("scene-after-room");
        type("key", "Page_Up");
        assertEquals(first, other(next));
        type("key", "1");
        assertTrue(!other(first).equals(next), "the first of the list");
        type("key", "Escape");
        assertEquals(0, ended());
    }

    /** The name of the scene in the title, when it is no longer that. */
    private String other(String known) throws IOException, InterruptedException {
        long end = System.nanoTime() + 30_000_000_000L;
        String name = known;
        while ((name.equals(known) || !name.startsWith("Cairn: ")) && System.nanoTime() < end) {
            name = title().replaceAll(" - .*", "");
        }
        assertTrue(!name.equals(known), "the title is still " + name);
        return name;
    }
}
