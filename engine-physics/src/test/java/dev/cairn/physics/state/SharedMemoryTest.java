package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.TriangleMesh;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;

/** What never changes is there once, and what has not changed is not kept again. */
class SharedMemoryTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double STEP = 1.0 / 60;
    private static final int BODIES = 100;

    private static PhysicsWorld world(TriangleMesh ground) {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(ground));
        for (int i = 0; i < BODIES; i++) {
            Box box = Box.cubeOfHalfExtent(0.4);
            world.add(Body.dynamic().shape(box).at(i % 10 * 2 - 9, 3, i / 10 * 2 - 9));
        }
        for (int t = 0; t < 60; t++) {
            world.step(STEP);
        }
        return world;
    }

    /** A level of 80 000 triangles is not copied, nor walked over. */
    @Test
    void aForkSharesItsLevel() {
        TriangleMesh ground = Grounds.regular(40, 200);
        PhysicsWorld.builder().workers(1).build().close(); // classes are loaded
        try (PhysicsWorld world = world(ground)) {
            world.fork().close();
            long before = THREADS.getCurrentThreadAllocatedBytes();
            PhysicsWorld fork = world.fork();
            long took = THREADS.getCurrentThreadAllocatedBytes() - before;
            assertSame(ground, fork.bodies().get(0).shape());
            assertSame(world.bodies().get(5).shape(), fork.bodies().get(5).shape());
            long state = world.save().byteCount();
            assertTrue(state < 6000L * BODIES, "a state takes " + state + " bytes");
            // the state on the way, twice as it grows, and columns with room to grow
            assertTrue(took < 12 * state, "a fork takes " + took + " bytes, a state " + state);
            fork.step(STEP);
            world.step(STEP);
            assertEquals(world.digest(), fork.digest());
            fork.close();
        }
    }

    /** Branches of one moment in which one body moves, kept as deltas from it. */
    @Test
    void manyBranchesOfOneMomentCostWhatChanges() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(99, 1, 99)).at(0, -1, 0));
            for (int i = 0; i < BODIES; i++) {
                Box box = Box.cubeOfHalfExtent(0.4);
                world.add(Body.dynamic().shape(box).at(i % 10 * 9 - 45, 0.4, i / 10 * 9 - 45));
            }
            for (int t = 0; t < 120; t++) {
                world.step(STEP);
            }
            WorldState moment = world.save();
            List<StateDelta> branches = new ArrayList<>();
            List<Long> digests = new ArrayList<>();
            long bytes = 0;
            for (int b = 0; b < 50; b++) {
                world.restore(moment);
                BodyRef body = world.bodies().get(1 + b);
                body.applyImpulse(0, 4000, 100 * b);
                for (int t = 0; t < 10; t++) {
                    world.step(STEP);
                }
                digests.add(world.digest());
                branches.add(StateDelta.between(moment, world.save()));
                bytes += branches.getLast().byteCount();
            }
            assertTrue(bytes / 50 < moment.byteCount() / 20, bytes / 50 + " bytes to a branch");
            WorldState state = new WorldState();
            for (int b = 0; b < 50; b++) {
                state.set(moment);
                branches.get(b).apply(state);
                world.restore(state);
                assertEquals(digests.get(b), world.digest(), "branch " + b);
            }
        }
    }
}
