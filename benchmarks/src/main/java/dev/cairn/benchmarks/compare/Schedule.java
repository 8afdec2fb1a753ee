package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.Spread;
import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Which measurements a plan asks for, in which order, and which of them are superfluous by what is
 * known already. Stateless but for the store that it looks into.
 */
final class Schedule {
    static final int BASE_SUBSTEPS = 4;
    private static final int REFINED = 16;
    private static final int MORE_ITERATIONS = 8;

    /** Rounds of a point end when two standard errors of their median are below this share. */
    static final double AGREEMENT = 0.02;

    /** And there are so many: the deviation of fewer says little. */
    static final int FEWEST_ROUNDS = 4;

    /** Scenes whose first seconds are told: small, of islands that move, one large island. */
    private static final Set<String> COLD = Set.of("pyramid", "falling-boxes", "large-pyramid");

    /** What is expected to take longer than this times the limit is not tried. */
    private static final double PREDICTION_MARGIN = 1.2;

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
            if (peer.workers() == plan.workers().getFirst()) {
                cells.add(new Cell(scene, engine, peer, Protocol.Kind.JUDGE, 0));
            }
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
        if (plan.coldSeconds() > 0 && COLD.contains(scene.id())) {
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

    /** Best effort shows the ends and the middle of its curve; of limited ones no far end. */
    private boolean isWantedOfBest(Case scene, int substeps) {
        return substeps == plan.substeps().getFirst()
                || substeps == scalingSubsteps(plan.substeps())
                || (scene.maxSubsteps() >= Case.MOST_SUBSTEPS
                        && substeps == plan.substeps().getLast());
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
     * Says what is known without an error run: the engine is not there, was too slow already with
     * fewer sub-steps and no more iterations, or will be by what the two numbers below took.
     */
    Protocol.@Nullable Answer foregone(Cell cell) {
        PeerSettings wanted = cell.peer();
        Protocol.Answer before = null;
        Protocol.Answer last = null;
        int beforeSubsteps = 0;
        int lastSubsteps = 0;
        for (Cell other : errors(cell.scene(), cell.engine())) {
            Protocol.Answer known = store.get(other.key());
            if (known == null) {
                continue;
            }
            if (known.missing()) {
                return known;
            }
            PeerSettings peer = other.peer();
            if (Results.tooSlow(known) && costsNoMore(peer, wanted)) {
                return Protocol.Answer.failed(
                        "not run: N = %d%s was too slow"
                                .formatted(
                                        peer.substeps(),
                                        peer.tuning() == wanted.tuning()
                                                ? ""
                                                : " with default settings"),
                        false);
            }
            boolean alike =
                    peer.tuning() == wanted.tuning()
                            && peer.workers() == wanted.workers()
                            && peer.iterationFactor() == wanted.iterationFactor()
                            && peer.collisionsPerTick() == wanted.collisionsPerTick();
            if (alike && peer.substeps() < wanted.substeps() && peer.substeps() > lastSubsteps) {
                before = last;
                beforeSubsteps = lastSubsteps;
                last = known;
                lastSubsteps = peer.substeps();
            }
        }
        return before == null || last == null
                ? null
                : expected(before, beforeSubsteps, last, lastSubsteps, wanted.substeps());
    }

    /** Best effort is more work than the default settings, at the same N. */
    private static boolean costsNoMore(PeerSettings known, PeerSettings wanted) {
        return (known.tuning() == wanted.tuning() || known.tuning() == Tuning.DEFAULT)
                && known.workers() == wanted.workers()
                && known.substeps() <= wanted.substeps()
                && known.iterationFactor() <= wanted.iterationFactor();
    }

    /**
     * Goes on in a straight line from the times of two numbers of sub-steps; returns null where
     * that ends below the limit, or where one of the two fell, which changes what a step costs.
     */
    private Protocol.@Nullable Answer expected(
            Protocol.Answer first, int n1, Protocol.Answer second, int n2, int n) {
        Double micros1 = first.cpuMicros();
        Double micros2 = second.cpuMicros();
        if (first.failure() != null
                || second.failure() != null
                || micros1 == null
                || micros2 == null) {
            return null;
        }
        double micros = micros2 + (micros2 - micros1) * (n - n2) / (n2 - n1);
        double seconds = micros * 1e-6 * second.bodies() * second.ticks();
        double limit = plan.judgeSeconds(second.bodies());
        if (seconds <= limit * PREDICTION_MARGIN) {
            return null;
        }
        return Protocol.Answer.slow(
                String.format(
                        Locale.ROOT,
                        "too slow: %.0f s expected from %.1f s at N = %d and %.1f s at N = %d, the"
                                + " limit is %.0f s",
                        seconds,
                        micros1 * 1e-6 * first.bodies() * first.ticks(),
                        n1,
                        micros2 * 1e-6 * second.bodies() * second.ticks(),
                        n2,
                        limit),
                second.bodies(),
                micros);
    }

    /**
     * Says whether a timed run adds something: not where the error run says that there is nothing
     * to time, and not where the rounds before it have run for long enough or agree.
     */
    boolean isWorthTiming(Cell cell) {
        Protocol.Answer judged = judged(cell.scene(), cell.engine(), cell.peer());
        if (judged == null || judged.missing() || judged.ticks() == 0 || Results.tooSlow(judged)) {
            return false;
        }
        double spent = 0;
        List<Double> rounds = new ArrayList<>();
        for (int round = 0; round < cell.round(); round++) {
            Protocol.Answer timed = timed(cell.scene(), cell.engine(), cell.peer(), round);
            Double micros = timed == null ? null : timed.cpuMicros();
            if (timed != null && micros != null) {
                spent += micros * timed.ticks() * timed.bodies();
                rounds.add(micros);
            }
        }
        return spent / 1e6 < plan.pointSeconds()
                && (rounds.size() < FEWEST_ROUNDS || 2 * Spread.error(rounds) >= AGREEMENT);
    }

    /**
     * The error run of a point. With more workers than the first number that is that of the first:
     * only times are taken then.
     */
    Protocol.@Nullable Answer judged(Case scene, Engine engine, PeerSettings peer) {
        PeerSettings alone = peer.withWorkers(plan.workers().getFirst());
        return store.get(new Cell(scene, engine, alone, Protocol.Kind.JUDGE, 0).key());
    }

    Protocol.@Nullable Answer timed(Case scene, Engine engine, PeerSettings peer, int round) {
        return store.get(new Cell(scene, engine, peer, Protocol.Kind.TIME, round).key());
    }

    Protocol.@Nullable Answer cold(Case scene, Engine engine) {
        return store.get(new Cell(scene, engine, base(), Protocol.Kind.COLD, 0).key());
    }
}
