package dev.cairn.samples.fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;

/** Worlds of fixed seeds break none of the laws that hold, see {@code docs/laws.md}. */
final class LawsTest {
    private static final long SEED = 1;

    /** Worlds of several bodies, of which 24 of 142 had other bits with 4 lanes than with one. */
    @Test
    void anyNumberOfWorkersAndLanesGivesTheSameBits() {
        System.out.println("seed " + SEED);
        for (int i = 0; i < 160; i++) {
            FuzzWorld fuzz = WorldGenerator.world(SEED, i, null);
            if (fuzz.movers() > 1 && fuzz.movers() < 20) {
                FuzzWorld brief = fuzz.lasting(90, fuzz.scene().tick().substeps());
                Breach breach = Laws.broken(brief, true).get(Law.BITS);
                assertTrue(breach == null, () -> "world " + fuzz.index() + ": " + breach);
            }
        }
    }

    @Test
    void theSameSeedGivesTheSameWorldAndItsFileHoldsIt(@TempDir Path folder) {
        for (int i = 0; i < 50; i++) {
            FuzzWorld fuzz = WorldGenerator.world(SEED, i, null);
            assertEquals(fuzz, WorldGenerator.world(SEED, i, null));
            Path file = folder.resolve(i + ".json");
            SceneWriter.write(fuzz.scene(), file);
            assertEquals(fuzz.scene(), SceneReader.read(file));
        }
    }

    /** A floor that is not there is the plainest breach: all of the body is below it. */
    @Test
    void aWorldThatBreaksALawIsMadeSmall() {
        FuzzWorld fuzz = worldOfMany();
        for (int i = fuzz.scene().entities().size() - 1; i >= 0; i--) {
            if (!fuzz.scene().entities().get(i).name().isEmpty()) {
                fuzz = fuzz.without(i);
            }
        }
        fuzz = fuzz.lasting(120, 4);
        Map<Law, Breach> broken = Laws.broken(fuzz, false);
        Breach breach = broken.get(Law.WALLS);
        assertFalse(breach == null, "no floor, and nobody fell below it");
        FuzzWorld least = Shrinker.shrink(fuzz, breach);
        assertEquals(1, least.movers());
        assertTrue(Laws.broken(least, false).containsKey(Law.WALLS));
    }

    private static FuzzWorld worldOfMany() {
        for (int i = 0; ; i++) {
            FuzzWorld fuzz = WorldGenerator.world(SEED, i, Family.HOUSE);
            if (fuzz.movers() > 8 && fuzz.room() == Double.POSITIVE_INFINITY) {
                return fuzz;
            }
        }
    }

    @Test
    void theCommandTellsWhatItFoundAndRefusesNonsense(@TempDir Path folder) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        String[] few = {"--seed", "3", "--worlds", "5", "--keep", "1", "--to", folder.toString()};
        int code = run(out, few);
        String text = out.toString(StandardCharsets.UTF_8);
        assertTrue(text.contains("| all | 5 |"), text);
        assertEquals(text.contains(", 0 broke a law") ? 0 : 1, code, text);
        assertEquals(2, run(out, "--worlds", "-1"));
        assertEquals(2, run(out, "--family", "ZOO"));
    }

    private static int run(ByteArrayOutputStream out, String... arguments) {
        PrintStream print = new PrintStream(out, true, StandardCharsets.UTF_8);
        return FuzzCommand.run(arguments, print, print, false);
    }
}
