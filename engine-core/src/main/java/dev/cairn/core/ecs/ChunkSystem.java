package dev.cairn.core.ecs;

/** A system that runs once per matching chunk, chunks in parallel. */
public non-sealed interface ChunkSystem extends EcsSystem {
    /**
     * Works on one chunk. Any worker thread; chunks of one tick run in any order and at the same
     * time, so the method must not write anything that another chunk reads. Must not allocate in
     * steady state.
     *
     * @param chunk the rows and their columns, valid during this call
     * @param tick the tick that is being computed, valid during this call
     */
    void run(Chunk chunk, Tick tick);
}
