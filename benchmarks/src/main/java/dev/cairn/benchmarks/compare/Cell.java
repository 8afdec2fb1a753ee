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
    double estimate(int bodies, Plan plan) {
        if (kind == Protocol.Kind.COLD) {
            return plan.coldSeconds() + 1;
        }
        double each = bodySeconds();
        if (peer.tuning() == PeerSettings.Tuning.BEST) {
            each *= BEST_FACTOR;
        }
        double tick = each * bodies * peer.substeps() * peer.iterationFactor();
        double whole = tick * scene.ticks();
        if (kind == Protocol.Kind.TIME) {
            double stepped = Math.max(plan.seconds(), whole);
            boolean enough = round * stepped >= plan.pointSeconds();
            return whole > plan.judgeSeconds() || (round > 0 && enough) ? 0 : stepped + 2 * tick;
        }
        if (peer.substeps() > 1 && whole / 2 > plan.judgeSeconds()) {
            return 0; // fewer sub-steps were too slow already
        }
        double looks = JUDGE_SECONDS * scene.lookCost() * bodies * scene.ticks();
        return Math.min(plan.judgeSeconds(), whole) + looks + 0.02;
    }

    /** Rough cost of a body in a sub-step, s. */
    private double bodySeconds() {
        return switch (engine) {
            case BOX3D -> 0.6e-6;
            case CAIRN -> 1e-6;
            case PHYSX -> 1.7e-6;
            case JOLT, BULLET -> 3e-6;
            case JBULLET -> 9e-6;
            case ODE4J -> 14e-6;
        };
    }
}
