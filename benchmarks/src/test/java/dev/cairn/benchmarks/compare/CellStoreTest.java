package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Interrupted campaigns go on; changed ones start over. */
class CellStoreTest {
    private static final Map<String, String> SETUP = Map.of("seconds", "0.1");

    @TempDir private Path folder;

    private static Protocol.Answer answer(double cpu) {
        return Protocol.Answer.timed(4, 300, cpu, 1, 2, 0);
    }

    @Test
    void goesOnWhereItStopped() throws Exception {
        Path file = folder.resolve("cells.jsonl");
        try (CellStore store = new CellStore(file, SETUP)) {
            store.put("a", answer(1), 2);
            store.put("b", answer(2), 3);
        }
        // Stopped in the middle of a line.
        Files.writeString(file, Files.readString(file) + "{\"key\":\"c\",\"answ");
        try (CellStore store = new CellStore(file, SETUP)) {
            assertNull(store.changed());
            assertEquals(2, store.size());
            Protocol.Answer b = store.get("b");
            assertNotNull(b);
            assertEquals(2, b.cpuMicros());
            assertNull(store.get("c"));
            store.put("c", answer(3), 4);
        }
        try (CellStore store = new CellStore(file, SETUP)) {
            assertEquals(3, store.size());
            assertEquals(9, store.seconds());
        }
    }

    @Test
    void changedSetupStartsOverAndSaysWhatChanged() throws Exception {
        Path file = folder.resolve("cells.jsonl");
        try (CellStore store = new CellStore(file, SETUP)) {
            store.put("a", answer(1), 2);
        }
        try (CellStore store = new CellStore(file, Map.of("seconds", "0.3"))) {
            assertEquals("seconds was \"0.1\" and is \"0.3\"", store.changed());
            assertEquals(0, store.size());
        }
    }

    /** A campaign whose cells are all there measures nothing and still reports everything. */
    @Test
    void finishedCampaignOnlyReports() throws Exception {
        Plan plan =
                new Plan(
                        List.of(Case.of("stack-4"), Case.of("pyramid")),
                        List.of(Engine.CAIRN, Engine.JBULLET),
                        List.of(Tuning.values()),
                        List.of(1, 2),
                        List.of(1, 4),
                        3,
                        0.1,
                        100,
                        1,
                        1,
                        1,
                        true);
        try (CellStore store = new CellStore(folder.resolve("cells.jsonl"), plan.setup())) {
            Campaign campaign = new Campaign(plan, folder, store);
            double before = campaign.estimate();
            assertTrue(before > 10, "estimate " + before);
            Set<String> keys = new HashSet<>();
            int cells = 0;
            for (Case scene : plan.scenes()) {
                for (Cell cell : new Schedule(plan, store).cells(scene)) {
                    store.put(cell.key(), answer(1), 1);
                    keys.add(cell.key());
                    cells++;
                }
            }
            // The budget's first line is the curve's own point.
            assertTrue(keys.size() >= cells - 4, keys.size() + " keys of " + cells + " cells");
            assertEquals(0, campaign.estimate());
            Results results = campaign.run((seconds, underWay) -> {});
            // stack-4: 2 N x (Cairn + JBullet x 2); pyramid: the same, and Cairn on 2 workers at 4.
            assertEquals(6 + 7, results.points().size());
            for (Results.Point point : results.points()) {
                assertEquals(3, point.rounds().size());
            }
            try (var files = Files.list(folder)) {
                assertEquals(1, files.count(), "no engine was started, so none has a log");
            }
        }
    }
}
