package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;

/**
 * A system that runs once per tick on the simulation thread, with all its chunks and the workers at
 * hand. It is a level of its own in the schedule, so nothing else runs beside it.
 *
 * <p>It may change objects that it does not declare, bodies of the physics for instance. So two
 * world systems of a schedule need an order: one reads with {@code next} what the other writes, or
 * asks with {@link Access#before} or {@link Access#after}.
 */
public non-sealed interface WorldSystem extends EcsSystem {
    /**
     * Does the system's work of one tick. May fork with {@code tick.jobs().run(..)}; then each
     * chunk's {@code out} columns must be asked for by one thread only.
     *
     * @param tick the tick that is being computed, valid during this call
     */
    void run(Tick tick);
}
