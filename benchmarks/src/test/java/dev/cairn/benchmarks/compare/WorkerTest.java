package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.Gson;

import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.compare.measure.Worker;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** What an engine's JVM answers, also where the machine is too busy to keep to times. */
class WorkerTest {
    /** As on a machine on which building the scene took longer than all the time to measure. */
    @Test
    void atLeastOneRunIsTimedHoweverShortTheTime() {
        Protocol.Request request =
                new Protocol.Request(
                        Protocol.Kind.TIME,
                        "stack-4",
                        Map.of(),
                        new PeerSettings(1, 4, false, PeerSettings.Tuning.DEFAULT),
                        0);
        Protocol.Answer answer = new Worker(Engine.of("cairn")).answer(request);
        assertNull(answer.failure());
        assertTrue(answer.ticks() > 0);
        assertNotNull(answer.cpuMicros());
        assertTrue(Double.isFinite(answer.cpuMicros()) && answer.cpuMicros() > 0);
    }

    /** JSON has no NaN; such an answer is a failure of the measurement, and the JVM lives on. */
    @Test
    void anAnswerThatIsNoNumberIsToldAsAFailure() {
        Protocol.Answer broken =
                new Protocol.Answer(
                        null,
                        false,
                        Double.NaN,
                        Map.of(),
                        null,
                        1,
                        1,
                        1,
                        1,
                        1.0,
                        null,
                        null,
                        -1,
                        List.of(),
                        List.of());
        Gson gson = new Gson();
        Protocol.Answer told = gson.fromJson(Worker.line(gson, broken), Protocol.Answer.class);
        assertNotNull(told.failure());
        assertTrue(told.failure().startsWith("the measurement gave no number"), told.failure());
    }
}
