package dev.cairn.benchmarks.peer;

/**
 * How a scene is run.
 *
 * @param workers threads that step, at least 1
 * @param substeps parts that a tick is cut into, at least 1
 * @param counting true to count contacts where that costs time; never true while time is taken
 * @param tuning whose settings
 * @param iterationFactor the engine's solver iterations are multiplied by it, at least 1
 * @param collisionsPerTick parts of a tick in each of which contacts are found anew, at least 1;
 *     for engines that find them once a tick
 */
public record PeerSettings(
        int workers,
        int substeps,
        boolean counting,
        Tuning tuning,
        int iterationFactor,
        int collisionsPerTick) {

    /** Checks the values. */
    public PeerSettings {
        if (workers < 1 || substeps < 1 || iterationFactor < 1 || collisionsPerTick < 1) {
            throw new IllegalArgumentException(
                    "workers %d, substeps %d, iterationFactor %d, collisionsPerTick %d: all start"
                                    .formatted(
                                            workers, substeps, iterationFactor, collisionsPerTick)
                            + " at 1");
        }
        if (substeps % collisionsPerTick != 0) {
            throw new IllegalArgumentException(
                    "substeps %d: not a multiple of collisionsPerTick %d"
                            .formatted(substeps, collisionsPerTick));
        }
    }

    /**
     * Settings without any refinement.
     *
     * @param workers threads
     * @param substeps parts of a tick
     * @param counting see the component
     * @param tuning whose settings
     */
    public PeerSettings(int workers, int substeps, boolean counting, Tuning tuning) {
        this(workers, substeps, counting, tuning, 1, 1);
    }

    /**
     * The same with another number of threads.
     *
     * @param count threads that step, at least 1
     * @return a copy
     */
    public PeerSettings withWorkers(int count) {
        return new PeerSettings(
                count, substeps, counting, tuning, iterationFactor, collisionsPerTick);
    }

    /** Whose settings an engine runs with. */
    public enum Tuning {
        /** The engine's own. */
        DEFAULT,
        /** What its documentation offers for accuracy, whatever it costs. */
        BEST
    }
}
