package dev.cairn.core.snapshot;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.ecs.component.ObjectField;

import org.jspecify.annotations.Nullable;

import java.util.Objects;

/**
 * Hands the poses of a world from the simulation thread to one reader, usually the one that draws.
 * The reader gets whole ticks, never a torn one, and never an older one after a newer one; neither
 * side ever waits for the other.
 *
 * <pre>{@code
 * world.step(h);                    // simulation thread
 * exchange.publish(world);
 *
 * PoseSnapshot s = exchange.latest();   // drawing thread, once per frame
 * }</pre>
 */
public final class SnapshotExchange {
    private static final DoubleField X = Pose.COMPONENT.doubleField("x");
    private static final DoubleField Y = Pose.COMPONENT.doubleField("y");
    private static final DoubleField Z = Pose.COMPONENT.doubleField("z");
    private static final DoubleField QX = Pose.COMPONENT.doubleField("qx");
    private static final DoubleField QY = Pose.COMPONENT.doubleField("qy");
    private static final DoubleField QZ = Pose.COMPONENT.doubleField("qz");
    private static final DoubleField QW = Pose.COMPONENT.doubleField("qw");
    private static final IntField JUMPS = Pose.COMPONENT.intField("jumps");
    private static final ObjectField<Object> MODEL =
            Visual.COMPONENT.objectField("model", Object.class);

    private final TripleBuffer<PoseSnapshot> buffer = new TripleBuffer<>(PoseSnapshot::new);
    private PoseHistory history = new PoseHistory();
    private @Nullable World world;
    private @Nullable Query visible;
    private long lastTick = -1;

    /** An exchange with nothing published: {@link #latest} gives an empty snapshot of tick -1. */
    public SnapshotExchange() {}

    /**
     * Publishes the present state. Simulation thread, between steps; call it after every step,
     * since the previous pose is the one that was published before. A second call for one tick, say
     * after an edit during a pause, keeps the previous poses. Allocates only while the number of
     * entities grows.
     *
     * @param world the world; another one than before starts anew
     * @throws NullPointerException if it is null
     * @throws IllegalStateException during a step
     */
    public void publish(World world) {
        publish(world, null);
    }

    /**
     * Publishes the present state together with data of the caller's, which the reader finds in
     * {@link PoseSnapshot#extra}; all else as in {@link #publish(World)}.
     *
     * @param world the world; another one than before starts anew
     * @param extra fills the data, called once, on this thread; null = no data
     * @throws NullPointerException if the world is null
     * @throws IllegalStateException during a step
     */
    public void publish(World world, @Nullable SnapshotExtra extra) {
        Query query = visibleOf(world);
        int chunks = query.chunkCount();
        int rows = 0;
        for (int i = 0; i < chunks; i++) {
            rows += query.chunk(i).size();
        }
        long tick = world.tickNumber();
        PoseSnapshot snapshot = buffer.writing();
        snapshot.begin(tick, world.stepSeconds(), rows);
        int row = 0;
        for (int i = 0; i < chunks; i++) {
            Chunk chunk = query.chunk(i);
            gather(chunk, snapshot, row);
            remember(chunk, snapshot, row, tick);
            row += chunk.size();
        }
        lastTick = tick;
        snapshot.attach(extra);
        snapshot.end(System.nanoTime());
        buffer.publish();
    }

    private Query visibleOf(World newWorld) {
        Objects.requireNonNull(newWorld, "world must not be null");
        Query known = visible;
        if (known == null || world != newWorld) {
            known = newWorld.query(Pose.COMPONENT, Visual.COMPONENT);
            visible = known;
            world = newWorld;
            history = new PoseHistory();
            lastTick = -1;
        }
        return known;
    }

    private static void gather(Chunk chunk, PoseSnapshot snapshot, int first) {
        double[] x = chunk.in(X);
        double[] y = chunk.in(Y);
        double[] z = chunk.in(Z);
        double[] qx = chunk.in(QX);
        double[] qy = chunk.in(QY);
        double[] qz = chunk.in(QZ);
        double[] qw = chunk.in(QW);
        double[] pose = snapshot.current();
        int at = first * PoseSnapshot.STRIDE;
        for (int row = 0, n = chunk.size(); row < n; row++, at += PoseSnapshot.STRIDE) {
            pose[at] = x[row];
            pose[at + 1] = y[row];
            pose[at + 2] = z[row];
            pose[at + 3] = qx[row];
            pose[at + 4] = qy[row];
            pose[at + 5] = qz[row];
            pose[at + 6] = qw[row];
        }
    }

    private void remember(Chunk chunk, PoseSnapshot snapshot, int first, long tick) {
        int[] jumps = chunk.in(JUMPS);
        long[] entities = chunk.entities();
        Object[] models = chunk.in(MODEL);
        double[] pose = snapshot.current();
        double[] from = snapshot.previous();
        for (int row = 0, n = chunk.size(); row < n; row++) {
            long entity = entities[row];
            snapshot.put(first + row, entity, models[row]);
            int at = (first + row) * PoseSnapshot.STRIDE;
            history.advance(entity, jumps[row], tick, lastTick, pose, from, at);
        }
    }

    /**
     * The newest published snapshot. One reader thread.
     *
     * @return the snapshot, the reader's own until its next call; the same one again if nothing new
     *     was published
     */
    public PoseSnapshot latest() {
        return buffer.latest();
    }
}
