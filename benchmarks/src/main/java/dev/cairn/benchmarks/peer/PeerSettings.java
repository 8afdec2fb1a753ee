package dev.cairn.benchmarks.peer;

/**
 * How a scene is run.
 *
 * @param workers threads that step, at least 1
 * @param substeps parts that a tick is cut into, at least 1
 * @param counting true to count contacts where that costs time; never true while time is taken
 */
public record PeerSettings(int workers, int substeps, boolean counting) {
    /** Checks the values. */
    public PeerSettings {
        if (workers < 1 || substeps < 1) {
            throw new IllegalArgumentException(
                    "workers %d, substeps %d: both start at 1".formatted(workers, substeps));
        }
    }
}
