package dev.cairn.core.snapshot;

import org.jspecify.annotations.Nullable;

/**
 * Adds data of its own to a snapshot, so that it travels with the poses of the same tick; see
 * {@link SnapshotExchange#publish(dev.cairn.core.ecs.World, SnapshotExtra)}.
 */
@FunctionalInterface
public interface SnapshotExtra {
    /**
     * Fills the data of one tick. Simulation thread, between steps.
     *
     * @param used an object that an earlier call returned and that nobody reads any more, to be
     *     filled again, so that a steady publication allocates nothing; null if there is none
     * @return the filled object, or null if there is nothing to add
     */
    @Nullable Object fill(@Nullable Object used);
}
