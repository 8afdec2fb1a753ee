package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Which measurements a plan asks for, in which order, and which of them are superfluous by what is
 * known already. Stateless but for the store that it looks into.
 */
final class Schedule {
    static final int BASE_SUBSTEPS = 4;
    private static final int REFINED = 16;
    private static final int MORE_ITERATIONS = 8;

    private final Plan plan;
    private final CellStore store;

    Schedule(Plan plan, CellStore store) {
        this.plan = plan;
        this.store = store;
    }

    /** All cells of a scene in the order of measurement: errors, then rounds that interleave. */
    List<Cell> cells(Case scene) {
        List<Cell> cells = new ArrayList<>();
        plan.engines().forEach(engine -> cells.addAll(errors(scene, engine)));
        for (int round = 0; round < plan.rounds(); round++) {
            cells.addAll(times(scene, round));
        }
        cells.addAll(colds(scene));
        return cells;
    }

    /**
     * Error runs of an engine: those of its curves, fewer sub-steps first, then the refinements.
     */
    List<Cell> errors(Case scene, Engine engine) {
        List<Cell> cells = new ArrayList<>();
        for (PeerSettings peer : settings(scene, engine)) {
            cells.add(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0));
        }
        for (PeerSettings peer : refinements(scene, engine).values()) {
            cells.add(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0));
        }
        return cells;
    }

    /** A timed round; each begins with another engine. */
    List<Cell> times(Case scene, int round) {
        List<Cell> cells = new ArrayList<>();
        int count = plan.engines().size();
        for (int i = 0; i < count; i++) {
            Engine engine = plan.engines().get((i + round) % count);
            for (PeerSettings peer : settings(scene, engine)) {
                cells.add(new Cell(scene, engine, peer, Protocol.Kind.TIME, round));
            }
        }
        return cells;
    }

    List<Cell> colds(Case scene) {
        List<Cell> cells = new ArrayList<>();
        if (plan.coldSeconds() > 0 && scene.id().equals("pyramid")) {
            for (Engine engine : plan.engines()) {
                cells.add(new Cell(scene, engine, base(), Protocol.Kind.COLD, 0));
            }
        }
        return cells;
    }

    static PeerSettings base() {
        return new PeerSettings(1, BASE_SUBSTEPS, false, Tuning.DEFAULT);
    }

    /** The points of an engine's curves. */
    List<PeerSettings> settings(Case scene, Engine engine) {
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
                    if (isWanted(scene, substeps, first)
                            && (tuning == Tuning.DEFAULT || isWantedOfBest(scene, substeps))) {
                        settings.add(new PeerSettings(workers, substeps, false, tuning));
                    }
                }
            }
        }
        return settings;
    }

    /** More than the scene allows only where nothing else was asked for; scaling at one N. */
    private boolean isWanted(Case scene, int substeps, boolean first) {
        if (plan.substeps().size() == 1) {
            return true;
        }
        boolean scaled = first || substeps == scalingSubsteps(plan.substeps());
        return scaled && substeps <= scene.maxSubsteps();
    }

    /** Where sub-steps are limited for time's sake, best effort shows the ends of its curve. */
    private boolean isWantedOfBest(Case scene, int substeps) {
        return scene.maxSubsteps() >= Case.MOST_SUBSTEPS
                || substeps == plan.substeps().getFirst()
                || substeps == scalingSubsteps(plan.substeps());
    }

    /** The largest number of sub-steps up to 4, or the smallest there is. */
    static int scalingSubsteps(List<Integer> substeps) {
        int best = substeps.getFirst();
        for (int n : substeps) {
            best = n <= BASE_SUBSTEPS ? Math.max(best, n) : best;
        }
        return best;
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

    /**
     * Says what would be known without an error run: the engine is not there, or was already too
     * slow with fewer sub-steps and no more iterations.
     */
    Protocol.@Nullable Answer foregone(Cell cell) {
        PeerSettings wanted = cell.peer();
        for (Cell other : errors(cell.scene(), cell.engine())) {
            Protocol.Answer known = store.get(other.key());
            if (known == null) {
                continue;
            }
            if (known.missing()) {
                return known;
            }
            PeerSettings peer = other.peer();
            if (Results.tooSlow(known)
                    && peer.tuning() == wanted.tuning()
                    && peer.workers() == wanted.workers()
                    && peer.substeps() <= wanted.substeps()
                    && peer.iterationFactor() <= wanted.iterationFactor()) {
                return Protocol.Answer.failed(
                        "not run: N = %d was too slow".formatted(peer.substeps()), false);
            }
        }
        return null;
    }

    /**
     * Says whether a timed run adds something: not where the error run says that there is nothing
     * to time, and not where the rounds before it have run for long enough.
     */
    boolean isWorthTiming(Cell cell) {
        Protocol.Answer judged = judged(cell.scene(), cell.engine(), cell.peer());
        if (judged == null || judged.missing() || judged.ticks() == 0 || Results.tooSlow(judged)) {
            return false;
        }
        double spent = 0;
        for (int round = 0; round < cell.round(); round++) {
            Protocol.Answer timed = timed(cell.scene(), cell.engine(), cell.peer(), round);
            Double micros = timed == null ? null : timed.cpuMicros();
            spent += timed == null || micros == null ? 0 : micros * timed.ticks() * timed.bodies();
        }
        return spent / 1e6 < plan.pointSeconds();
    }

    Protocol.@Nullable Answer judged(Case scene, Engine engine, PeerSettings peer) {
        return store.get(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0).key());
    }

    Protocol.@Nullable Answer timed(Case scene, Engine engine, PeerSettings peer, int round) {
        return store.get(new Cell(scene, engine, peer, Protocol.Kind.TIME, round).key());
    }

    Protocol.@Nullable Answer cold(Case scene, Engine engine) {
        return store.get(new Cell(scene, engine, base(), Protocol.Kind.COLD, 0).key());
    }
}
