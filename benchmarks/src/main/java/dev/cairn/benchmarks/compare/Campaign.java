package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.EngineProcess;
import dev.cairn.benchmarks.compare.measure.Judge;
import dev.cairn.benchmarks.compare.measure.Machine;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.samples.Parameter;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Runs scenes x engines x settings by the protocol. Error runs of two engines go on at a time, for
 * errors do not depend on who else is running; times are taken alone. Not reusable.
 */
final class Campaign {
    /** Besides the time that was asked for: building, measuring overlaps, a slow machine. */
    private static final double GRACE_SECONDS = 60;

    private static final int JUDGES = 2;

    private static final double START_SECONDS = 1.4;

    /** After so many crashes or silences an engine is left out of the scenes that are left. */
    private static final int MOST_DEATHS = 5;

    /** Hears how the campaign goes on. */
    @FunctionalInterface
    interface Progress {
        /** So many more of the estimated seconds are done; this is under way. */
        void done(double seconds, String underWay);
    }

    private final Plan plan;
    private final Path logs;
    private final CellStore store;
    private final Schedule schedule;
    private final Map<String, Integer> bodies = new LinkedHashMap<>();
    private final Map<Engine, EngineProcess> processes = new EnumMap<>(Engine.class);
    private final Map<Engine, Integer> deaths = new ConcurrentHashMap<>();
    private final Map<Engine, Boolean> warm = new ConcurrentHashMap<>();
    private Progress progress = (seconds, underWay) -> {};

    Campaign(Plan plan, Path logs, CellStore store) {
        this.plan = plan;
        this.logs = logs;
        this.store = store;
        this.schedule = new Schedule(plan, store);
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
            for (Cell cell : schedule.cells(scene)) {
                pending += store.get(cell.key()) == null ? estimate(cell) : 0;
            }
            seconds += pending;
            if (pending > 0) {
                for (Engine engine : plan.engines()) {
                    // Its JVM starts and warms up, two at a time.
                    seconds += (START_SECONDS + plan.warmSeconds(engine)) / judges();
                }
            }
        }
        return seconds;
    }

    private double estimate(Cell cell) {
        int count = bodies.getOrDefault(cell.scene().id(), 1);
        if (cell.kind() == Protocol.Kind.JUDGE) {
            return schedule.foregone(cell) != null ? 0 : cell.estimate(count, plan) / judges();
        }
        Protocol.Answer judged = schedule.judged(cell.scene(), cell.engine(), cell.peer());
        return judged != null && cell.kind() == Protocol.Kind.TIME && !schedule.isWorthTiming(cell)
                ? 0
                : cell.estimate(count, plan);
    }

    private static int judges() {
        return Math.min(JUDGES, Runtime.getRuntime().availableProcessors());
    }

    Results run(Progress listener) throws IOException {
        progress = listener;
        Machine machine = new Machine();
        List<Results.Point> points = new ArrayList<>();
        List<Budget> budgets = new ArrayList<>();
        List<Results.Cold> colds = new ArrayList<>();
        for (Case scene : plan.scenes()) {
            try {
                plan.engines().forEach(this::open);
                judge(scene);
                for (int round = 0; round < plan.rounds(); round++) {
                    for (Cell cell : schedule.times(scene, round)) {
                        time(cell);
                    }
                }
                for (Cell cell : schedule.colds(scene)) {
                    cold(cell);
                }
            } finally {
                processes.forEach(
                        (engine, process) -> deaths.merge(engine, process.deaths(), Integer::sum));
                processes.values().forEach(EngineProcess::close);
                processes.clear();
                warm.clear();
            }
            collect(scene, points, budgets, colds);
        }
        Map<String, String> settings = plan.words();
        settings.put("time of all measurements, added up", minutes());
        return new Results(machine.describe(), settings, points, budgets, colds);
    }

    private String minutes() {
        return "%.0f min".formatted(Math.ceil(store.seconds() / 60));
    }

    private void open(Engine engine) {
        EngineProcess process = new EngineProcess(engine, logs, List.of());
        int before = deaths.getOrDefault(engine, 0);
        if (before >= MOST_DEATHS) {
            process.giveUp("died or was silent %d times in this run".formatted(before));
        }
        processes.put(engine, process);
    }

    /** Error runs, {@value #JUDGES} engines at a time, each engine's own in order. */
    private void judge(Case scene) throws IOException {
        try (ExecutorService threads = Executors.newFixedThreadPool(judges())) {
            List<Future<?>> running = new ArrayList<>();
            for (Engine engine : plan.engines()) {
                EngineProcess process = Objects.requireNonNull(processes.get(engine));
                running.add(threads.submit(() -> judge(schedule.errors(scene, engine), process)));
            }
            for (Future<?> one : running) {
                one.get();
            }
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof UncheckedIOException broken) {
                throw broken.getCause();
            }
            throw new IllegalStateException("an error run could not be asked for", failed);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", stop);
        }
    }

    private void judge(List<Cell> cells, EngineProcess process) {
        for (Cell cell : cells) {
            if (store.get(cell.key()) != null) {
                continue;
            }
            double estimate = estimate(cell);
            under(cell, "errors");
            Protocol.Answer known = schedule.foregone(cell);
            if (known == null) {
                // An error run has a time limit, which would punish who compiles while it runs.
                warmUp(process, cell);
            }
            long start = System.nanoTime();
            Protocol.Answer answer =
                    known != null ? known : ask(process, cell, judgeSeconds(cell.scene()));
            put(cell, answer, start, judges());
            done(estimate);
        }
    }

    private void time(Cell cell) {
        if (store.get(cell.key()) != null || !schedule.isWorthTiming(cell)) {
            return;
        }
        double estimate = estimate(cell);
        EngineProcess process = Objects.requireNonNull(processes.get(cell.engine()));
        under(cell, "round " + (cell.round() + 1));
        long start = System.nanoTime();
        warmUp(process, cell);
        put(cell, ask(process, cell, plan.seconds()), start, 1);
        done(estimate);
    }

    private void warmUp(EngineProcess process, Cell cell) {
        if (warm.putIfAbsent(cell.engine(), true) == null) {
            ask(process, warmCell(cell), plan.warmSeconds(cell.engine()));
        }
    }

    private Cell warmCell(Cell cell) {
        int middle = plan.substeps().get(plan.substeps().size() / 2);
        PeerSettings peer =
                new PeerSettings(
                        cell.peer().workers(),
                        Math.min(middle, cell.scene().maxSubsteps()),
                        false,
                        cell.peer().tuning());
        return new Cell(cell.scene(), cell.engine(), peer, Protocol.Kind.WARM, 0);
    }

    private void cold(Cell cell) {
        if (store.get(cell.key()) != null) {
            return;
        }
        double estimate = estimate(cell);
        under(cell, "cold start");
        long start = System.nanoTime();
        try (EngineProcess fresh = new EngineProcess(cell.engine(), logs, List.of())) {
            put(cell, ask(fresh, cell, plan.coldSeconds(cell.engine())), start, 1);
        }
        done(estimate);
    }

    private synchronized void put(Cell cell, Protocol.Answer answer, long start, int sharing) {
        try {
            store.put(cell.key(), answer, (System.nanoTime() - start) / 1e9 / sharing);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    private synchronized void under(Cell cell, String what) {
        progress.done(
                0,
                "%s %s N=%d, %s"
                        .formatted(
                                cell.scene().id(),
                                cell.engine().title(),
                                cell.peer().substeps(),
                                what));
    }

    private synchronized void done(double estimate) {
        progress.done(estimate, "");
    }

    private Protocol.Answer ask(EngineProcess process, Cell cell, double seconds) {
        return process.ask(
                new Protocol.Request(
                        cell.kind(),
                        cell.scene().id(),
                        cell.scene().settings(),
                        cell.peer(),
                        seconds),
                GRACE_SECONDS + 3 * Math.max(seconds, judgeSeconds(cell.scene())));
    }

    private double judgeSeconds(Case scene) {
        return plan.judgeSeconds(bodies.getOrDefault(scene.id(), 1));
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
            for (PeerSettings peer : schedule.settings(scene, engine)) {
                Protocol.Answer judged = schedule.judged(scene, engine, peer);
                List<Protocol.Answer> rounds = new ArrayList<>();
                for (int round = 0; round < plan.rounds(); round++) {
                    Protocol.Answer timed = schedule.timed(scene, engine, peer, round);
                    if (timed != null) {
                        rounds.add(timed);
                    }
                }
                if (judged != null) {
                    boolean alone = peer.workers() == plan.workers().getFirst();
                    points.add(
                            new Results.Point(
                                    scene.id(),
                                    parameters,
                                    engine,
                                    peer,
                                    alone ? judged : judged.withoutErrors(),
                                    rounds));
                }
            }
            Map<String, Double> errors = new LinkedHashMap<>();
            schedule.refinements(scene, engine)
                    .forEach((name, peer) -> {
                        Protocol.Answer judged = schedule.judged(scene, engine, peer);
                        if (judged != null && judged.error() != null && judged.failure() == null) {
                            errors.put(name, judged.error());
                        }
                    });
            if (errors.containsKey(Budget.BASE)) {
                budgets.add(new Budget(scene.id(), engine, errors));
            }
            Protocol.Answer cold = schedule.cold(scene, engine);
            if (cold != null && cold.failure() == null && !cold.cold().isEmpty()) {
                colds.add(new Results.Cold(scene.id(), engine, cold.cold(), cold.errors()));
            }
        }
    }
}
