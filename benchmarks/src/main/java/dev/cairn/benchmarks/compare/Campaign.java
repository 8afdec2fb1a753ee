package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;
import dev.cairn.samples.Parameter;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Runs scenes x engines x settings by the protocol. One thread; not reusable. */
final class Campaign {
    /** Silence beyond this, besides the time that was asked for, is a crash. */
    private static final double GRACE_SECONDS = 120;

    private static final int BASE_SUBSTEPS = 4;
    private static final int REFINED = 16;
    private static final int MORE_ITERATIONS = 8;

    /**
     * What to run.
     *
     * @param scenes the scenes, their parameters set
     * @param engines the engines, in the order of tables
     * @param tunings whose settings
     * @param workers numbers of threads, for scenes with enough bodies; others run with the first
     * @param substeps numbers of sub-steps, ascending
     * @param rounds timed runs per point
     * @param seconds stepped per timed run, at least
     * @param warmSeconds warm-up per engine and scene, at most
     * @param judgeSeconds stepped per error run, at most
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
            double warmSeconds,
            double judgeSeconds,
            double coldSeconds,
            boolean budget) {

        Plan {
            scenes = List.copyOf(scenes);
            engines = List.copyOf(engines);
            tunings = List.copyOf(tunings);
            workers = List.copyOf(workers);
            substeps = List.copyOf(substeps);
        }

        /** Returns what the measurements depend on, besides the cell itself. */
        Map<String, String> setup() {
            Map<String, String> setup = new LinkedHashMap<>();
            setup.put("seconds per timed run", Double.toString(seconds));
            setup.put("warm-up seconds", Double.toString(warmSeconds));
            setup.put("seconds per error run", Double.toString(judgeSeconds));
            setup.put("build of this jar", Machine.build());
            setup.put("JVM", Runtime.version().toString());
            setup.put("processor", Machine.processor());
            return setup;
        }
    }

    /** Hears how the campaign goes on. */
    @FunctionalInterface
    interface Progress {
        /** So many more of the estimated seconds are done; this is under way. */
        void done(double seconds, String underWay);
    }

    private final Plan plan;
    private final Path logs;
    private final CellStore store;
    private final Map<String, Integer> bodies = new LinkedHashMap<>();
    private final Map<Engine, EngineProcess> processes = new EnumMap<>(Engine.class);
    private final Map<Engine, Boolean> warm = new EnumMap<>(Engine.class);
    private Progress progress = (seconds, underWay) -> {};

    Campaign(Plan plan, Path logs, CellStore store) {
        this.plan = plan;
        this.logs = logs;
        this.store = store;
        for (Case scene : plan.scenes()) {
            try (Judge judge = new Judge(scene)) {
                bodies.put(scene.id(), judge.description().movable());
            }
        }
    }

    /** Returns the estimated time of what is not measured yet, s. */
    double estimate() {
        double seconds = 0;
        for (Case scene : plan.scenes()) {
            double pending = 0;
            for (Cell cell : cells(scene)) {
                pending += store.get(cell.key()) == null ? estimate(cell) : 0;
            }
            seconds += pending;
            if (pending > 0) {
                // Each engine's JVM starts and warms up; half the limit is usual.
                seconds += plan.engines().size() * (0.7 + plan.warmSeconds() / 2);
            }
        }
        return seconds;
    }

    private double estimate(Cell cell) {
        return cell.estimate(bodies.getOrDefault(cell.scene().id(), 1), plan);
    }

    /** All cells of a scene in the order of measurement: errors, then rounds that interleave. */
    List<Cell> cells(Case scene) {
        List<Cell> cells = new ArrayList<>();
        for (Engine engine : plan.engines()) {
            for (PeerSettings peer : settings(scene, engine)) {
                cells.add(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0));
            }
            for (PeerSettings peer : refinements(scene, engine).values()) {
                cells.add(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0));
            }
        }
        int count = plan.engines().size();
        for (int round = 0; round < plan.rounds(); round++) {
            for (int i = 0; i < count; i++) {
                Engine engine = plan.engines().get((i + round) % count);
                for (PeerSettings peer : settings(scene, engine)) {
                    cells.add(new Cell(scene, engine, peer, Protocol.Kind.TIME, round));
                }
            }
        }
        if (plan.coldSeconds() > 0 && isColdStarted(scene)) {
            for (Engine engine : plan.engines()) {
                cells.add(new Cell(scene, engine, base(), Protocol.Kind.COLD, 0));
            }
        }
        return cells;
    }

    private static boolean isColdStarted(Case scene) {
        return scene.id().equals("pyramid");
    }

    private static PeerSettings base() {
        return new PeerSettings(1, BASE_SUBSTEPS, false, Tuning.DEFAULT);
    }

    /** The points of an engine's curves. */
    private List<PeerSettings> settings(Case scene, Engine engine) {
        List<PeerSettings> settings = new ArrayList<>();
        for (Tuning tuning : plan.tunings()) {
            if (tuning == Tuning.BEST && !engine.hasBest()) {
                continue;
            }
            for (int workers : plan.workers()) {
                boolean first = workers == plan.workers().getFirst();
                if (workers > engine.maxWorkers()
                        || (!first && (!scene.scaling() || tuning == Tuning.BEST))) {
                    continue;
                }
                for (int substeps : plan.substeps()) {
                    // More than the scene allows only where nothing else was asked for.
                    if (substeps <= scene.maxSubsteps() || plan.substeps().size() == 1) {
                        settings.add(new PeerSettings(workers, substeps, false, tuning));
                    }
                }
            }
        }
        return settings;
    }

    /** What is refined, one thing in turn, for the error budget; empty where none is wanted. */
    Map<String, PeerSettings> refinements(Case scene, Engine engine) {
        Map<String, PeerSettings> refined = new LinkedHashMap<>();
        if (!plan.budget() || scene.scaling()) {
            return refined;
        }
        Tuning own = Tuning.DEFAULT;
        refined.put(Budget.BASE, base());
        if (engine.collidesOncePerTick()) {
            refined.put(
                    Budget.CONTACTS,
                    new PeerSettings(1, BASE_SUBSTEPS, false, own, 1, BASE_SUBSTEPS));
        }
        if (engine.hasIterations()) {
            refined.put(
                    Budget.SOLVER,
                    new PeerSettings(1, BASE_SUBSTEPS, false, own, MORE_ITERATIONS, 1));
        }
        int fine = BASE_SUBSTEPS * REFINED;
        refined.put(Budget.STEP, new PeerSettings(1, fine, false, own));
        refined.put(
                Budget.ALL,
                new PeerSettings(
                        1,
                        fine,
                        false,
                        own,
                        engine.hasIterations() ? MORE_ITERATIONS : 1,
                        engine.collidesOncePerTick() ? REFINED : 1));
        return refined;
    }

    Results run(Progress listener) throws IOException {
        progress = listener;
        Machine machine = new Machine();
        List<Results.Point> points = new ArrayList<>();
        List<Budget> budgets = new ArrayList<>();
        List<Results.Cold> colds = new ArrayList<>();
        for (Case scene : plan.scenes()) {
            try {
                for (Cell cell : cells(scene)) {
                    measure(cell);
                }
            } finally {
                processes.values().forEach(EngineProcess::close);
                processes.clear();
                warm.clear();
            }
            collect(scene, points, budgets, colds);
        }
        return new Results(machine.describe(), words(), points, budgets, colds);
    }

    private void measure(Cell cell) throws IOException {
        if (store.get(cell.key()) != null) {
            return;
        }
        double estimate = estimate(cell);
        progress.done(
                0,
                "%s %s N=%d"
                        .formatted(
                                cell.scene().id(), cell.engine().title(), cell.peer().substeps()));
        if (cell.kind() == Protocol.Kind.COLD) {
            try (EngineProcess fresh = new EngineProcess(cell.engine(), logs, List.of())) {
                store.put(cell.key(), ask(fresh, cell, plan.coldSeconds()));
            }
        } else if (cell.kind() == Protocol.Kind.JUDGE) {
            store.put(cell.key(), judgeUnlessMissing(cell));
        } else if (isWorthTiming(cell)) {
            EngineProcess process = process(cell.engine());
            if (warm.putIfAbsent(cell.engine(), true) == null) {
                int middle = plan.substeps().get(plan.substeps().size() / 2);
                Cell warmUp =
                        new Cell(
                                cell.scene(),
                                cell.engine(),
                                new PeerSettings(
                                        cell.peer().workers(),
                                        Math.min(middle, cell.scene().maxSubsteps()),
                                        false,
                                        cell.peer().tuning()),
                                Protocol.Kind.WARM,
                                0);
                ask(process, warmUp, plan.warmSeconds());
            }
            store.put(cell.key(), ask(process, cell, plan.seconds()));
        }
        progress.done(estimate, "");
    }

    /** An engine that is not there is asked once per scene. */
    private Protocol.Answer judgeUnlessMissing(Cell cell) {
        for (PeerSettings peer : settings(cell.scene(), cell.engine())) {
            Protocol.Answer one = judged(cell.scene(), cell.engine(), peer);
            if (one != null && one.missing()) {
                return one;
            }
        }
        return ask(process(cell.engine()), cell, plan.judgeSeconds());
    }

    private boolean isWorthTiming(Cell cell) {
        Protocol.Answer judged = judged(cell.scene(), cell.engine(), cell.peer());
        return judged != null && !judged.missing() && !Results.tooSlow(judged);
    }

    private Protocol.@Nullable Answer judged(Case scene, Engine engine, PeerSettings peer) {
        return store.get(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0).key());
    }

    private EngineProcess process(Engine engine) {
        return processes.computeIfAbsent(engine, _ -> new EngineProcess(engine, logs, List.of()));
    }

    private static Protocol.Answer ask(EngineProcess process, Cell cell, double seconds) {
        return process.ask(
                new Protocol.Request(
                        cell.kind(),
                        cell.scene().id(),
                        cell.scene().settings(),
                        cell.peer(),
                        seconds),
                GRACE_SECONDS + 8 * seconds);
    }

    private void collect(
            Case scene,
            List<Results.Point> points,
            List<Budget> budgets,
            List<Results.Cold> colds) {
        Map<String, String> parameters = new LinkedHashMap<>();
        scene.options()
                .values()
                .forEach((name, value) -> parameters.put(name, Parameter.show(value)));
        for (Engine engine : plan.engines()) {
            for (PeerSettings peer : settings(scene, engine)) {
                Protocol.Answer judged = judged(scene, engine, peer);
                List<Protocol.Answer> rounds = new ArrayList<>();
                for (int round = 0; round < plan.rounds(); round++) {
                    Protocol.Answer timed =
                            store.get(
                                    new Cell(scene, engine, peer, Protocol.Kind.TIME, round).key());
                    if (timed != null) {
                        rounds.add(timed);
                    }
                }
                if (judged != null) {
                    points.add(
                            new Results.Point(
                                    scene.id(), parameters, engine, peer, judged, rounds));
                }
            }
            Map<String, Double> errors = new LinkedHashMap<>();
            refinements(scene, engine)
                    .forEach((name, peer) -> {
                        Protocol.Answer judged = judged(scene, engine, peer);
                        if (judged != null && judged.error() != null && judged.failure() == null) {
                            errors.put(name, judged.error());
                        }
                    });
            if (errors.containsKey(Budget.BASE)) {
                budgets.add(new Budget(scene.id(), engine, errors));
            }
            Protocol.Answer cold =
                    store.get(new Cell(scene, engine, base(), Protocol.Kind.COLD, 0).key());
            if (cold != null && cold.failure() == null) {
                colds.add(new Results.Cold(scene.id(), engine, cold.cold()));
            }
        }
    }

    private Map<String, String> words() {
        Map<String, String> settings = new LinkedHashMap<>();
        settings.put("sub-steps N", plan.substeps() + ", fewer in scenes of many bodies");
        settings.put("workers", plan.workers() + ", more than one in scenes of many bodies");
        settings.put("timed rounds, interleaved over the engines", plan.rounds() + "");
        settings.put("stepped per round and point", plan.seconds() + " s or one whole run");
        settings.put("stepped per error run, at most", plan.judgeSeconds() + " s");
        settings.put(
                "warm-up per engine and scene",
                "until three windows agree within 2 %, at most " + plan.warmSeconds() + " s");
        return settings;
    }
}
