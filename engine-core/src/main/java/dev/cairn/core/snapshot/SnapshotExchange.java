package dev.cairn.core.snapshot;

import dev.cairn.core.ecs.World;

/** Hands poses from the simulation thread to one reader. */
public final class SnapshotExchange {
    /** Empty exchange. */
    public SnapshotExchange() {}

    /** @param world after a step */
    public void publish(World world) { throw new UnsupportedOperationException(); }
    /** @return newest */
    public PoseSnapshot latest() { throw new UnsupportedOperationException(); }
}
