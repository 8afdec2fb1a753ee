package dev.cairn.samples.editor;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Whatever a user of the editor does, nothing fails, and the way back is the way there. */
class RandomSessionTest {
    private static final int ACTIONS = 60;

    @TempDir private Path folder;

    private void files() throws IOException {
        Files.createDirectories(folder.resolve("sub"));
        Files.writeString(folder.resolve("wrong.json"), "{\"format\": 1}");
        Files.writeString(folder.resolve("wrong.obj"), "f 1 2 3\n");
        Files.writeString(folder.resolve("wrong.png"), "no picture");
        Files.writeString(
                folder.resolve("tetra.obj"),
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }

    private static List<Long> actions(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Long> all = new ArrayList<>();
        for (int i = 0; i < ACTIONS; i++) {
            all.add(random.nextLong());
        }
        return all;
    }

    /** The failure, or null. */
    private Throwable run(long seed, List<Long> actions, List<String> done) throws IOException {
        files();
        RandomSession session = new RandomSession(folder, seed % 7 == 0);
        try (session) {
            for (long action : actions) {
                session.act(action);
            }
            session.end();
            return null;
        } catch (RuntimeException | AssertionError | StackOverflowError | OutOfMemoryError failed) {
            return failed;
        } finally {
            done.addAll(session.done);
        }
    }

    /** Leaves actions out as long as it fails in the same way. */
    private List<Long> least(long seed, List<Long> actions, Throwable failed) throws IOException {
        List<Long> now = new ArrayList<>(actions);
        for (int width = now.size() / 2; width >= 1; width /= 2) {
            for (int i = 0; i + width <= now.size(); ) {
                List<Long> fewer = new ArrayList<>(now.subList(0, i));
                fewer.addAll(now.subList(i + width, now.size()));
                Throwable then = run(seed, fewer, new ArrayList<>());
                if (then != null && cause(then).equals(cause(failed))) {
                    now = fewer;
                } else {
                    i += width;
                }
            }
        }
        return now;
    }

    /** Where it was thrown. */
    static String cause(Throwable failed) {
        for (StackTraceElement each : failed.getStackTrace()) {
            if (each.getClassName().startsWith("dev.cairn")) {
                return failed.getClass().getSimpleName() + " " + each;
            }
        }
        return failed.getClass().getSimpleName();
    }

    private void sessions(long first, long count) throws IOException {
        for (long seed = first; seed < first + count; seed++) {
            List<Long> all = actions(seed);
            Throwable failed = run(seed, all, new ArrayList<>());
            if (failed != null) {
                List<String> done = new ArrayList<>();
                Throwable last = run(seed, least(seed, all, failed), done);
                throw new AssertionError(
                        "seed " + seed + ":\n  " + String.join("\n  ", done) + "\n" + last, failed);
            }
        }
    }

    @Test
    void whateverIsDone() throws IOException {
        sessions(1, Long.getLong("editor.sessions", 60));
    }

    @Test
    @Tag("soak")
    void whateverIsDoneForLong() throws IOException {
        sessions(Long.getLong("soak.seed", 1000), Long.getLong("soak.sessions", 5000));
    }
}
