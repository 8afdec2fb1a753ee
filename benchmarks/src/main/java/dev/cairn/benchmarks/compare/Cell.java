package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Judge;
import dev.cairn.benchmarks.compare.measure.Protocol;
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

    /** After so many rounds the median of most points is known. */
    private static final int USUAL_ROUNDS = 6;

    /** Looking for overlaps, per body of a tick's share, s. */
    private static final double JUDGE_SECONDS = 4e-6;

    /** Reading a pose and placing it, s. */
    private static final double POSE_SECONDS = 1e-6;

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
            return plan.coldSeconds(engine) + 1;
        }
        double each = bodySeconds();
        if (peer.tuning() == PeerSettings.Tuning.BEST) {
            each *= BEST_FACTOR;
        }
        double tick = each * bodies * peer.substeps() * peer.iterationFactor();
        double whole = tick * scene.ticks();
        double limit = plan.judgeSeconds(bodies);
        if (kind == Protocol.Kind.TIME) {
            double stepped = Math.max(plan.seconds(), whole);
            boolean enough = round * stepped >= plan.pointSeconds() || round >= USUAL_ROUNDS;
            return whole > limit || (round > 0 && enough) ? 0 : stepped + 2 * tick;
        }
        boolean known = peer.substeps() > 2 && peer.iterationFactor() == 1;
        if (peer.substeps() > 1 && whole / (known ? 1.2 : 2) > limit) {
            return 0; // fewer sub-steps were too slow already, or tell that it will be
        }
        double looked = Math.min(Judge.BODIES_PER_LOOK, scene.lookCost() * bodies);
        double looks = (POSE_SECONDS * bodies + JUDGE_SECONDS * looked) * scene.ticks();
        return Math.min(limit, whole) + looks + 0.02;
    }

    /** Rough cost of a body in a sub-step, s. */
    private double bodySeconds() {
        return switch (engine) {
            case BOX3D -> 0.6e-6;
            case CAIRN, CAIRN_SINGLE -> 1e-6;
            case PHYSX -> 1.7e-6;
            case JOLT, BULLET -> 3e-6;
            case JBULLET -> 9e-6;
            case ODE4J -> 14e-6;
        };
    }
}
