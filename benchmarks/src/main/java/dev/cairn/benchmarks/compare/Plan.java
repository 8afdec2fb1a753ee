package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Machine;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What to run.
 *
 * @param scenes the scenes, their parameters set
 * @param engines the engines, in the order of tables
 * @param tunings whose settings
 * @param workers numbers of threads, for scenes with enough bodies; others run with the first
 * @param substeps numbers of sub-steps, ascending
 * @param rounds timed runs per point, at most
 * @param seconds stepped per timed run, at least; more only where one run of the scene takes more
 * @param pointSeconds CPU time after which a point gets no further round
 * @param warmSeconds warm-up per engine and scene, at most; native engines need less
 * @param judgeSeconds stepped per error run, at most, in scenes of few bodies
 * @param coldSeconds length of a cold start, 0 for none
 * @param budget whether errors are taken apart
 */
record Plan(
        List<Case> scenes,
        List<Engine> engines,
        List<Tuning> tunings,
        List<Integer> workers,
        List<Integer> substeps,
        int rounds,
        double seconds,
        double pointSeconds,
        double warmSeconds,
        double judgeSeconds,
        double coldSeconds,
        boolean budget) {

    private static final double NATIVE_WARM_SECONDS = 1;
    private static final double NATIVE_COLD_SECONDS = 8;
    private static final double SECONDS_PER_BODY = 4e-3;
    private static final double MOST_SECONDS = 20;

    Plan {
        scenes = List.copyOf(scenes);
        engines = List.copyOf(engines);
        tunings = List.copyOf(tunings);
        workers = List.copyOf(workers);
        substeps = List.copyOf(substeps);
    }

    /** How long an error run of so many movable bodies may step, s of CPU time. */
    double judgeSeconds(int bodies) {
        return Math.clamp(
                SECONDS_PER_BODY * bodies, judgeSeconds, Math.max(judgeSeconds, MOST_SECONDS));
    }

    /** Native code is compiled already: only the calls into it have to be. */
    double warmSeconds(Engine engine) {
        return engine.isJava() ? warmSeconds : Math.min(warmSeconds, NATIVE_WARM_SECONDS);
    }

    /** Native code has nothing to wait for. */
    double coldSeconds(Engine engine) {
        return engine.isJava() ? coldSeconds : Math.min(coldSeconds, NATIVE_COLD_SECONDS);
    }

    /** Returns what the measurements depend on, besides the cell itself. */
    Map<String, String> setup() {
        Map<String, String> setup = new LinkedHashMap<>();
        setup.put("seconds per timed run", Double.toString(seconds));
        setup.put("seconds per point", Double.toString(pointSeconds));
        setup.put("warm-up seconds", Double.toString(warmSeconds));
        setup.put("seconds per error run", Double.toString(judgeSeconds));
        setup.put("build", Machine.build());
        setup.put("JVM", Runtime.version().toString());
        setup.put("processor", Machine.processor());
        return setup;
    }

    /** Returns how it is run, by name, for the report. */
    Map<String, String> words() {
        Map<String, String> words = new LinkedHashMap<>();
        words.put("sub-steps N", substeps + ", fewer in scenes of many bodies");
        words.put("workers", workers + "; more than one in scenes of many bodies, at N = 4");
        words.put(
                "timed rounds, interleaved over the engines",
                String.format(
                        Locale.ROOT,
                        "%d at most; no further one once a point has %s s of CPU time, or %d rounds"
                                + " whose median is known to %.0f %% (two standard errors)",
                        rounds,
                        pointSeconds,
                        Schedule.FEWEST_ROUNDS,
                        100 * Schedule.AGREEMENT));
        words.put("a timed round", "whole runs of the scene, until " + seconds + " s are stepped");
        words.put(
                "an error run",
                "is stopped after "
                        + judgeSeconds
                        + " s of CPU time, in scenes of many bodies after 4 ms per body, at most"
                        + " after 20 s; larger N of the same engine are then left out, and what"
                        + " would take longer by the times of the two N before it");
        words.put(
                "warm-up per engine and scene",
                "until three windows agree within 2 %, at most "
                        + warmSeconds
                        + " s; native engines "
                        + Math.min(warmSeconds, NATIVE_WARM_SECONDS)
                        + " s");
        return words;
    }
}
