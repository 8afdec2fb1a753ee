package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;

/**
 * What the panels cost the window's thread, with a driver that draws nothing, so that the time is
 * our own and Mesa's front end. Prints it; a time is no truth to assert.
 */
class PanelCostTest extends WindowFixture {
    private static final int ROUNDS = 7;

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    @Override
    public Map<String, String> environment() {
        return Map.of("GALLIUM_NOOP", "1");
    }

    /** After the JIT's first seconds. */
    @Override
    public boolean ready(Seen seen) {
        return seen.number("frame") >= 1000;
    }

    @Test
    void theCostOfThePanelsIsTold() throws IOException, InterruptedException {
        double shown = median();
        click("Plots");
        settle();
        double plots = median();
        type("key", "h");
        settle();
        double hidden = median();
        System.out.printf(
                Locale.ROOT,
                "panels, ms of wall time a frame, median of %d half seconds: %.3f, with plots %.3f,"
                        + " hidden %.3f%n",
                ROUNDS,
                shown,
                plots,
                hidden);
        assertTrue(shown > 0 && plots > 0 && hidden > 0, "each is measured");
    }

    private double median() throws IOException, InterruptedException {
        double[] known = {now().number("panelMillis")};
        await("the half second to end", seen -> seen.number("panelMillis") != known[0]);
        double[] millis = new double[ROUNDS];
        for (int i = 0; i < ROUNDS; i++) {
            known[0] = now().number("panelMillis");
            millis[i] =
                    await("another", seen -> seen.number("panelMillis") != known[0])
                            .number("panelMillis");
        }
        Arrays.sort(millis);
        return millis[ROUNDS / 2];
    }
}
