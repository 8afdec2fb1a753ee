package dev.cairn.physics.state;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.job.BlockJob;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.contact.StepLimits;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * From slots to columns: writes Pose and Velocity of a chunk's rows, one block to a chunk, clears
 * the forces, and puts bodies back whose state is no longer finite.
 */
public final class Publisher {
    private static final IntField SLOT = RigidBody.COMPONENT.intField("slot");
    private static final DoubleField X = Pose.COMPONENT.doubleField("x");
    private static final DoubleField Y = Pose.COMPONENT.doubleField("y");
    private static final DoubleField Z = Pose.COMPONENT.doubleField("z");
    private static final DoubleField QX = Pose.COMPONENT.doubleField("qx");
    private static final DoubleField QY = Pose.COMPONENT.doubleField("qy");
    private static final DoubleField QZ = Pose.COMPONENT.doubleField("qz");
    private static final DoubleField QW = Pose.COMPONENT.doubleField("qw");
    private static final IntField JUMPS = Pose.COMPONENT.intField("jumps");
    private static final DoubleField VX = Velocity.COMPONENT.doubleField("vx");
    private static final DoubleField VY = Velocity.COMPONENT.doubleField("vy");
    private static final DoubleField VZ = Velocity.COMPONENT.doubleField("vz");
    private static final DoubleField WX = Velocity.COMPONENT.doubleField("wx");
    private static final DoubleField WY = Velocity.COMPONENT.doubleField("wy");
    private static final DoubleField WZ = Velocity.COMPONENT.doubleField("wz");

    private final BodyRegistry registry;
    private final BlockJob job = this::block;
    private @Nullable Tick tick;
    private int[] failuresInChunk = {};
    private boolean[] failed = {};
    private int failures;

    /**
     * Chunks in which all bodies sleep and are published: nothing is written, nothing looked at.
     */
    private boolean[] unchangedChunk = {};

    private boolean[] settledInChunk = {};
    private int unchangedChunks;
    private long knownChanges = -1;
    private long knownRevision = -1;
    private boolean known;
    private boolean wasKnown;
    private double[][] scratch = {};

    /**
     * A publisher.
     *
     * @param registry the bodies that are there
     */
    public Publisher(BodyRegistry registry) {
        this.registry = registry;
    }

    /** Writes the rows of the tick. */
    public void run(Tick current) {
        tick = current;
        int chunks = current.chunkCount();
        if (failuresInChunk.length < chunks) {
            failuresInChunk = new int[chunks + (chunks >> 1)];
        }
        if (failed.length < registry.bodies.kind.length) {
            failed = Arrays.copyOf(failed, registry.bodies.kind.length);
        }
        remember(chunks);
        int workers = current.jobs().workers();
        if (scratch.length < workers) {
            scratch = new double[workers][3];
        }
        current.jobs().run(job, chunks);
        tick = null;
        failures = 0;
        for (int c = 0; c < chunks; c++) {
            failures += failuresInChunk[c];
            known &= !settledInChunk[c];
        }
    }

    /** Which chunks are unchanged is known as long as no body came, went, woke or fell asleep. */
    private void remember(int chunks) {
        if (unchangedChunk.length < chunks) {
            unchangedChunk = new boolean[failuresInChunk.length];
            settledInChunk = new boolean[failuresInChunk.length];
            known = false;
        }
        long changes = registry.sleepers.changes();
        known &=
                changes == knownChanges
                        && registry.revision == knownRevision
                        && chunks == unchangedChunks;
        knownChanges = changes;
        knownRevision = registry.revision;
        unchangedChunks = chunks;
        wasKnown = known;
        known = true;
    }

    /** How many bodies were put back in the last run. */
    public int failures() {
        return failures;
    }

    /** Whether the body was put back in this tick; asks once. */
    public boolean takeFailure(int slot) {
        boolean was = failed[slot];
        failed[slot] = false;
        return was;
    }

    private void block(int block, int worker) {
        Tick current = tick;
        if (current == null) {
            throw new IllegalStateException("no tick runs");
        }
        Chunk chunk = current.chunk(block);
        failuresInChunk[block] = 0;
        settledInChunk[block] = false;
        if (registry.sleepers.asleepCount() > 0) {
            if (!wasKnown) {
                unchangedChunk[block] = isUnchanged(chunk);
            }
            if (unchangedChunk[block]) {
                return;
            }
            settledInChunk[block] = settle(chunk);
        } else {
            unchangedChunk[block] = false;
        }
        failuresInChunk[block] = putBack(chunk);
        poses(chunk, scratch[worker]);
        velocities(chunk);
    }

    private boolean isUnchanged(Chunk chunk) {
        int[] slots = chunk.in(SLOT);
        int size = chunk.size();
        for (int row = 0; row < size; row++) {
            if (!registry.sleepers.settled(slots[row])) {
                return false;
            }
        }
        return true;
    }

    /** Whether a body is published for the first time since it fell asleep. */
    private boolean settle(Chunk chunk) {
        int[] slots = chunk.in(SLOT);
        int size = chunk.size();
        boolean any = false;
        for (int row = 0; row < size; row++) {
            any |= registry.sleepers.settle(slots[row]);
        }
        return any;
    }

    /** Each row whose body left the range of numbers goes back to its published pose, at rest. */
    private int putBack(Chunk chunk) {
        int[] slots = chunk.in(SLOT);
        int size = chunk.size();
        int count = 0;
        for (int row = 0; row < size; row++) {
            int s = slots[row];
            if (!isValid(registry.bodies, s)) {
                restore(chunk, row, s);
                failed[s] = true;
                count++;
            }
        }
        return count;
    }

    private static boolean isValid(BodyStore b, int s) {
        double limit = StepLimits.LARGEST;
        return Math.abs(b.positionX[s]) <= limit
                && Math.abs(b.positionY[s]) <= limit
                && Math.abs(b.positionZ[s]) <= limit
                && Math.abs(b.velocityX[s]) <= limit
                && Math.abs(b.velocityY[s]) <= limit
                && Math.abs(b.velocityZ[s]) <= limit
                && Math.abs(b.angularVelocityX[s]) <= limit
                && Math.abs(b.angularVelocityY[s]) <= limit
                && Math.abs(b.angularVelocityZ[s]) <= limit
                && Math.abs(b.orientationX[s]) <= 2
                && Math.abs(b.orientationY[s]) <= 2
                && Math.abs(b.orientationZ[s]) <= 2
                && Math.abs(b.orientationW[s]) <= 2;
    }

    private void restore(Chunk chunk, int row, int s) {
        BodyStore b = registry.bodies;
        b.orientationX[s] = chunk.in(QX)[row];
        b.orientationY[s] = chunk.in(QY)[row];
        b.orientationZ[s] = chunk.in(QZ)[row];
        b.orientationW[s] = chunk.in(QW)[row];
        double[] com = new double[3];
        Rotations.rotate(
                b.orientationX[s],
                b.orientationY[s],
                b.orientationZ[s],
                b.orientationW[s],
                registry.comX[s],
                registry.comY[s],
                registry.comZ[s],
                com);
        b.place(s, chunk.in(X)[row] + com[0], chunk.in(Y)[row] + com[1], chunk.in(Z)[row] + com[2]);
        b.velocityX[s] = 0;
        b.velocityY[s] = 0;
        b.velocityZ[s] = 0;
        b.angularVelocityX[s] = 0;
        b.angularVelocityY[s] = 0;
        b.angularVelocityZ[s] = 0;
    }

    private void poses(Chunk chunk, double[] com) {
        BodyStore b = registry.bodies;
        int[] slots = chunk.in(SLOT);
        double[] x = chunk.out(X);
        double[] y = chunk.out(Y);
        double[] z = chunk.out(Z);
        double[] qx = chunk.out(QX);
        double[] qy = chunk.out(QY);
        double[] qz = chunk.out(QZ);
        double[] qw = chunk.out(QW);
        int[] jumps = chunk.out(JUMPS);
        int size = chunk.size();
        for (int row = 0; row < size; row++) {
            int s = slots[row];
            double ox = b.orientationX[s];
            double oy = b.orientationY[s];
            double oz = b.orientationZ[s];
            double ow = b.orientationW[s];
            Rotations.rotate(
                    ox, oy, oz, ow, registry.comX[s], registry.comY[s], registry.comZ[s], com);
            x[row] = b.positionX[s] - com[0];
            y[row] = b.positionY[s] - com[1];
            z[row] = b.positionZ[s] - com[2];
            qx[row] = ox;
            qy[row] = oy;
            qz[row] = oz;
            qw[row] = ow;
            jumps[row] = registry.jumps[s];
        }
    }

    private void velocities(Chunk chunk) {
        BodyStore b = registry.bodies;
        int[] slots = chunk.in(SLOT);
        double[] vx = chunk.out(VX);
        double[] vy = chunk.out(VY);
        double[] vz = chunk.out(VZ);
        double[] wx = chunk.out(WX);
        double[] wy = chunk.out(WY);
        double[] wz = chunk.out(WZ);
        int size = chunk.size();
        for (int row = 0; row < size; row++) {
            int s = slots[row];
            vx[row] = b.velocityX[s];
            vy[row] = b.velocityY[s];
            vz[row] = b.velocityZ[s];
            wx[row] = b.angularVelocityX[s];
            wy[row] = b.angularVelocityY[s];
            wz[row] = b.angularVelocityZ[s];
            registry.clearForces(s);
        }
    }
}
