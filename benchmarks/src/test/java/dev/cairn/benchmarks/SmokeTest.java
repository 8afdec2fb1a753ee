package dev.cairn.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;

import java.util.Collection;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;

/** Runs every benchmark once, small and in this JVM, so that none rots. Measures nothing. */
class SmokeTest {

    @Test
    @Timeout(120)
    void everyBenchmarkRuns() throws RunnerException {
        Collection<RunResult> results =
                new Runner(
                                new OptionsBuilder()
                                        .forks(0)
                                        .warmupIterations(0)
                                        .measurementIterations(1)
                                        .measurementTime(TimeValue.milliseconds(5))
                                        .param("entities", "200")
                                        .param("scene", "stack-4")
                                        .param("bodies", "200")
                                        .param("workers", "2")
                                        .param("blocks", "2")
                                        .timeout(TimeValue.seconds(60))
                                        .shouldFailOnError(true)
                                        .verbosity(VerboseMode.SILENT)
                                        .timeUnit(TimeUnit.MICROSECONDS)
                                        .build())
                        .run();
        TreeSet<String> suites = new TreeSet<>();
        for (RunResult result : results) {
            String benchmark = result.getParams().getBenchmark();
            assertTrue(result.getPrimaryResult().getScore() > 0.0, benchmark);
            Result<?> solver = result.getSecondaryResults().get("solverMicros");
            assertTrue(solver == null || solver.getScore() > 0.0, benchmark + " has no stages");
            suites.add(benchmark.split("\\.")[3]);
        }
        assertEquals(
                "[BroadPhasePairs, EcsCreateDelete, EcsIterate, JobsDispatch, JobsWake,"
                        + " NarrowPhasePairs, RollbackFrame, SaveRestore, SnapshotHandOver,"
                        + " SolverStages, WorldStep]",
                suites.toString());
        assertEquals(3 + 7 + 3 + 2 + 2 + 2 + 2 + 2 + 2 + 1 + 36, results.size());
    }
}
