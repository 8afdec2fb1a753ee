package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;

/**
 * A system: a name and a contract. Implement {@link ChunkSystem} (rows of raw columns, chunks in
 * parallel) or {@link WorldSystem} (once per tick, on the simulation thread), not this interface.
 */
public sealed interface EcsSystem permits ChunkSystem, WorldSystem {
    /**
     * The system's name, unique in its schedule; by default the simple name of its class. It names
     * the system in {@link Access#before}, in messages and in the profile; no result depends on it.
     *
     * @return the name, never blank
     */
    default String name() {
        String simple = getClass().getSimpleName();
        if (!simple.isEmpty()) {
            return simple;
        }
        String binary = getClass().getName();
        return binary.substring(binary.lastIndexOf('.') + 1);
    }

    /**
     * Declares what the system reads and writes. Called once, when its schedule is built; from this
     * alone the job graph is derived.
     *
     * @param access receives the declarations
     */
    void describe(Access access);
}
