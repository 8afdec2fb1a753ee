package dev.cairn.render.app;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.render.mesh.Model;

/** A world without physics, to put models where a test wants them. */
final class Stage implements AutoCloseable {
    private final World world = World.builder().workers(1).build();
    private final SnapshotExchange exchange = new SnapshotExchange();

    long add(Pose pose, Object model) {
        return world.spawn(pose, new Visual(model));
    }

    long add(Blocks.Block block, int rgb) {
        return add(
                block.pose(),
                Model.of(dev.cairn.render.mesh.Meshes.CUBE)
                        .scale(block.hx(), block.hy(), block.hz())
                        .color(rgb));
    }

    void set(long entity, Pose pose) {
        world.set(entity, pose);
    }

    PoseSnapshot publish() {
        exchange.publish(world);
        return exchange.latest();
    }

    PoseSnapshot step() {
        world.step(1.0 / 60);
        return publish();
    }

    @Override
    public void close() {
        world.close();
    }
}
