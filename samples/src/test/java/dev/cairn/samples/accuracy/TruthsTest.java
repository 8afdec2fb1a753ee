package dev.cairn.samples.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The truths of the accuracy table against published numbers, and against each other. */
class TruthsTest {
    @Test
    void ellipticIntegralAgreesWithTheTables() {
        // Abramowitz and Stegun, table 17.1: K at m = k² = 0, 0.5, 0.9
        assertEquals(StrictMath.PI / 2, Truths.ellipticK(1), 1e-15);
        assertEquals(1.854074677301372, Truths.ellipticK(0.5), 1e-14);
        assertEquals(2.578092113348173, Truths.ellipticK(0.1), 1e-14);
    }

    @Test
    void periodOfDzhanibekovsBody() {
        double period = Truths.period(new double[] {1, 2, 3}, new double[] {0.01, 10, 0.01});
        assertEquals(5.5061681108, period, 1e-9);
    }

    @Test
    void ellipticPeriodIsThatOfTheRungeKuttaReference() {
        double[] inertia = {1, 2, 3};
        double[] spin = {0.01, 10, 0.01};
        List<Double> flips =
                new RigidReference(inertia, new double[3], spin).advance(10, 200_000).flips();
        assertEquals(4, flips.size());
        double half = 0.5 * Truths.period(inertia, spin);
        // flips are found by straight lines through steps of 50 us
        assertEquals(half, flips.get(1) - flips.get(0), 1e-7);
        assertEquals(half, flips.get(2) - flips.get(1), 1e-7);
    }

    @Test
    void referenceConservesEnergy() {
        RigidReference body =
                new RigidReference(new double[] {1, 1.5, 2}, new double[3], new double[] {1, 2, 3});
        double start = body.energy();
        assertEquals(start, body.advance(10, 200_000).energy(), 1e-11 * start);
    }

    @Test
    void aDiscsFrictionHasWeidmansTerminalRatio() {
        // v / (r w) tends to 0.653 as both go to zero, and stays where it is (Weidman and Malhotra
        // 2007)
        DiscReference disc = new DiscReference(0.653, 1, 0.3 * 9.81);
        while (disc.slide() > 0.1) {
            disc.advance(1e-3);
        }
        assertEquals(0.653, disc.slide() / disc.rim(), 0.003);
    }

    @Test
    void casesHaveUniqueNamesAndMetrics() {
        Set<String> ids = new HashSet<>();
        for (AccuracyCase one : AccuracyCases.all()) {
            assertTrue(ids.add(one.id()), one.id());
            assertTrue(!one.metrics().isEmpty(), one.id());
            assertTrue(!(one.setup() + one.truth()).contains("|"), one.id() + " breaks the table");
        }
    }

    @Test
    void theCommandPrintsARowForEachMetricOfACase() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream print = new PrintStream(out, true, StandardCharsets.UTF_8);
        assertEquals(0, AccuracyCommand.run(new String[] {"a1", "A2"}, print, print, false));
        String text = out.toString(StandardCharsets.UTF_8);
        assertTrue(text.contains("| A1 parabola | largest distance, m |"), text);
        assertTrue(text.contains("| A2 stable-axis spin | attitude, rad |"), text);
        assertEquals(2, AccuracyCommand.run(new String[] {"Z9"}, print, print, false));
    }
}
