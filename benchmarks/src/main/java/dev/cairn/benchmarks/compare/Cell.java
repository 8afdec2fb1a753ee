package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;

import java.util.Locale;

/**
 * One measurement: a scene in an engine, set one way, judged or timed once.
 *
 * @param scene the scene, its parameters set
 * @param engine the engine
 * @param peer how it is set
 * @param kind what is measured
 * @param round number of the timed round, 0 elsewhere
 */
record Cell(Case scene, Engine engine, PeerSettings peer, Protocol.Kind kind, int round) {
    /** Rough cost of a body in a sub-step, s, for the estimate of the time that is left. */
    private static final double NATIVE_SECONDS = 1.0e-6;

    private static final double JAVA_SECONDS = 6e-6;
    private static final double BEST_FACTOR = 2.5;

    /** Building, reading poses and looking for overlaps, per body and tick, s. */
    private static final double JUDGE_SECONDS = 4e-6;

    /** What tells this cell from all others, whatever the order in which they are measured. */
    String key() {
        return String.format(
                Locale.ROOT,
                "%s %s %s w%d n%d %s i%d c%d %s %d",
                scene.id(),
                scene.settings(),
                engine.id(),
                peer.workers(),
                peer.substeps(),
                peer.tuning(),
                peer.iterationFactor(),
                peer.collisionsPerTick(),
                kind,
                round);
    }

    /** Guesses how long it takes, s; right within a factor of a few. */
    double estimate(int bodies, Campaign.Plan plan) {
        if (kind == Protocol.Kind.COLD) {
            return plan.coldSeconds() + 1;
        }
        double each =
                switch (engine) {
                    case ODE4J, JBULLET -> JAVA_SECONDS;
                    case CAIRN -> 2 * NATIVE_SECONDS;
                    default -> NATIVE_SECONDS;
                };
        if (peer.tuning() == PeerSettings.Tuning.BEST) {
            each *= BEST_FACTOR;
        }
        double tick = each * bodies * peer.substeps() * peer.iterationFactor();
        if (kind == Protocol.Kind.TIME) {
            double whole = tick * scene.ticks();
            return Math.max(plan.seconds(), Math.min(4 * plan.seconds(), whole)) + 2 * tick;
        }
        double looks = JUDGE_SECONDS * scene.lookCost() * bodies * scene.ticks();
        return Math.min(plan.judgeSeconds(), tick * scene.ticks()) + looks + 0.02;
    }
}
