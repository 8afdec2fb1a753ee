package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** What is left out is known beforehand, and what is timed is timed until it is known. */
class ScheduleTest {
    private static final double LIMIT = 10;
    private static final Case SCENE = Case.of("stack-4");
    private static final Plan PLAN =
            new Plan(
                    List.of(SCENE, Case.of("pyramid")),
                    List.of(Engine.ODE4J, Engine.JOLT),
                    List.of(Tuning.values()),
                    List.of(1, 2),
                    List.of(1, 2, 4, 8, 16),
                    10,
                    0.03,
                    1,
                    1,
                    LIMIT,
                    0,
                    true);

    @TempDir private Path folder;
    private CellStore store;
    private Schedule schedule;

    @BeforeEach
    void begin() throws IOException {
        store = new CellStore(folder.resolve("cells.jsonl"), PLAN.setup());
        schedule = new Schedule(PLAN, store);
    }

    @AfterEach
    void end() throws IOException {
        store.close();
    }

    private static Cell cell(int substeps, Tuning tuning, Protocol.Kind kind, int round) {
        PeerSettings peer = new PeerSettings(1, substeps, false, tuning);
        return new Cell(SCENE, Engine.ODE4J, peer, kind, round);
    }

    /** An error run of 4 bodies and 300 ticks that stepped for so long. */
    private void took(int substeps, double seconds, @Nullable String failure) throws IOException {
        double micros = seconds * 1e6 / 4 / 300;
        Protocol.Answer answer =
                new Protocol.Answer(
                        failure, false, 0.01, Map.of(), null, 1, 1, 4, 300, micros, null, null, -1,
                        List.of(), List.of());
        store.put(cell(substeps, Tuning.DEFAULT, Protocol.Kind.JUDGE, 0).key(), answer, seconds);
    }

    private Protocol.@Nullable Answer foregone(int substeps, Tuning tuning) {
        return schedule.foregone(cell(substeps, tuning, Protocol.Kind.JUDGE, 0));
    }

    @Test
    void whatWillTakeTooLongByTheTwoBeforeIsNotTried() throws IOException {
        took(2, 4, null);
        assertNull(foregone(8, Tuning.DEFAULT), "one number tells no slope");
        took(4, 7, null);
        // 4 s + 3 s more for 2 more: 13 s for 8
        Protocol.Answer slow = foregone(8, Tuning.DEFAULT);
        assertNotNull(slow);
        assertEquals(
                "too slow: 13 s expected from 4.0 s at N = 2 and 7.0 s at N = 4, the limit is 10 s",
                slow.failure());
        assertTrue(Results.tooSlow(slow));
        assertNotNull(slow.cpuMicros());
        assertEquals(13e6 / 4 / 300, slow.cpuMicros(), 1e-6);
        assertNull(foregone(8, Tuning.BEST), "other settings have their own slope");
    }

    @Test
    void whatFitsOrMayFitIsTried() throws IOException {
        took(1, 1, null);
        took(2, 2, null);
        assertNull(foregone(4, Tuning.DEFAULT));
        took(4, 6, null);
        // 4.4 s + 6.8 s: within the margin of a fifth
        took(1, 1, null);
        took(2, 4.4, null);
        assertNull(foregone(4, Tuning.DEFAULT));
    }

    @Test
    void whoFellHasNoSlope() throws IOException {
        took(2, 9, "error 3 is above the limit of 0.25");
        took(4, 9.9, null);
        assertNull(foregone(16, Tuning.DEFAULT));
    }

    @Test
    void bestEffortIsNotTriedWhereTheDefaultWasTooSlow() throws IOException {
        took(4, 10, "too slow: stopped after 10 s at tick 7 of 300");
        Protocol.Answer best = foregone(8, Tuning.BEST);
        assertNotNull(best);
        assertEquals("not run: N = 4 with default settings was too slow", best.failure());
        assertNull(foregone(2, Tuning.BEST));
        assertNull(foregone(2, Tuning.DEFAULT));
    }

    @Test
    void roundsEndWhenTheirMedianIsKnown() throws IOException {
        took(1, 0.1, null);
        double[] steady = {1, 1.001, 0.999, 1};
        for (int round = 0; round < 4; round++) {
            assertTrue(worth(round), "round " + round);
            time(round, steady[round]);
        }
        assertFalse(worth(4));
    }

    @Test
    void roundsGoOnWhileTheyDiffer() throws IOException {
        took(1, 0.1, null);
        double[] restless = {1, 1.2, 0.9, 1.1, 1.3, 0.8};
        for (int round = 0; round < restless.length; round++) {
            time(round, restless[round]);
        }
        assertTrue(worth(restless.length));
    }

    @Test
    void aSecondOfCpuTimeIsEnough() throws IOException {
        took(1, 0.1, null);
        time(0, 0.6e6 / 4 / 300);
        assertTrue(worth(1));
        time(1, 0.6e6 / 4 / 300);
        assertFalse(worth(2));
    }

    private boolean worth(int round) {
        return schedule.isWorthTiming(cell(1, Tuning.DEFAULT, Protocol.Kind.TIME, round));
    }

    private void time(int round, double micros) throws IOException {
        store.put(
                cell(1, Tuning.DEFAULT, Protocol.Kind.TIME, round).key(),
                Protocol.Answer.timed(4, 300, micros, 1, 2, 0),
                1);
    }

    /** Errors do not depend on the number of workers, so only times are taken of the second. */
    @Test
    void moreWorkersAreTimedOnly() {
        Case pyramid = Case.of("pyramid");
        assertTrue(
                schedule.errors(pyramid, Engine.JOLT).stream()
                        .allMatch(cell -> cell.peer().workers() == 1));
        assertEquals(
                1,
                schedule.times(pyramid, 0).stream()
                        .filter(cell -> cell.peer().workers() == 2)
                        .count());
    }
}
