package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.cairn.benchmarks.peer.Engine;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The adapters, each engine in a JVM of its own; skipped where an engine is not there. */
class PeersTest {
    private static final double G = 9.81;
    private static final double TICK = 1.0 / 60;
    private static final double LIMIT = 60;

    @TempDir private Path logs;

    private static Protocol.Request judge(String scene, int substeps) {
        return new Protocol.Request(Protocol.Kind.JUDGE, scene, Map.of(), 1, substeps, 0);
    }

    private static double error(EngineProcess engine, String scene, int substeps) {
        Protocol.Answer answer = engine.ask(judge(scene, substeps), LIMIT);
        assumeFalse(answer.missing(), () -> "skipped: " + answer.failure());
        assertNull(answer.failure());
        assertNotNull(answer.error());
        return answer.error();
    }

    /**
     * Free flight: semi-implicit Euler is off by g T h/2 after T (catalogue 1.2 and 1.3, all
     * engines there); Cairn flies the parabola. And a ball that rolls tells whether inertia and
     * friction arrived: 5/7 g sin, to first order in h.
     */
    @ParameterizedTest
    @EnumSource
    void agreesWithClosedForms(Engine engine) {
        try (EngineProcess process =
                new EngineProcess(engine, logs, List.of("-XX:TieredStopAtLevel=1"))) {
            for (int n : new int[] {1, 4}) {
                double flight = error(process, "free-flight", n);
                double roll = error(process, "roll", n);
                double firstOrder = engine == Engine.CAIRN ? 0 : G * 1.5 * TICK / n / 2;
                assertEquals(firstOrder, flight, 2e-4, "flight, N = " + n);
                assertTrue(roll < 0.012 / n, "roll, N = " + n + ": " + roll);
            }
        }
    }

    @Test
    void missingEngineIsReported() {
        String flag = "-Dcairn.natives.jolt=" + logs.resolve("absent.so");
        try (EngineProcess process = new EngineProcess(Engine.JOLT, logs, List.of(flag))) {
            Protocol.Answer answer = process.ask(judge("free-flight", 1), LIMIT);
            assertTrue(answer.missing());
            assertTrue(String.valueOf(answer.failure()).contains("absent.so"), answer.failure());
        }
    }

    @Test
    void deadEngineIsReportedAndTheNextRequestStartsAnother() {
        try (EngineProcess process = new EngineProcess(Engine.CAIRN, logs, List.of())) {
            assertNull(process.ask(judge("free-flight", 1), LIMIT).failure());
            process.kill();
            Protocol.Answer dead = process.ask(judge("free-flight", 1), LIMIT);
            assertTrue(String.valueOf(dead.failure()).contains("JVM"), dead.failure());
            assertNull(process.ask(judge("free-flight", 1), LIMIT).failure());
        }
    }
}
