package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/** Saving into a state that has room, and restoring it, leave no garbage. */
class StateAllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private static final int ROUNDS = 40;

    /** A thousand boxes, awake, in piles of two; some hang on joints, one of which has broken. */
    private static PhysicsWorld world(boolean sleeping) {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(sleeping).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
        BodyRef last = null;
        for (int i = 0; i < 1000; i++) {
            double x = i % 25 * 1.5 - 18;
            double z = i / 25 % 20 * 1.5 - 18;
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.4))
                                    .at(x, 0.4 + i / 500 * 0.8, z));
            if (last != null && i % 20 == 5) {
                world.add(Joint.ball(last, box).breakAt(i == 105 ? 1e-9 : 1e9, 1e9).at(x, 1, z));
            }
            last = box;
        }
        for (int tick = 0; tick < 10; tick++) {
            world.step(1.0 / 60);
        }
        return world;
    }

    @Test
    void aThousandBodiesAwake() {
        measure(false);
    }

    @Test
    void aThousandBodiesOfWhichManySleep() {
        measure(true);
    }

    private static void measure(boolean sleeping) {
        try (PhysicsWorld world = world(sleeping)) {
            for (int tick = 0; sleeping && tick < 60; tick++) {
                world.step(1.0 / 60);
            }
            WorldState state = world.save();
            world.restore(state);
            long digest = world.digest();
            long[] saving = new long[ROUNDS];
            long[] restoring = new long[ROUNDS];
            for (int round = 0; round < ROUNDS; round++) {
                long before = THREADS.getCurrentThreadAllocatedBytes();
                world.save(state);
                long saved = THREADS.getCurrentThreadAllocatedBytes();
                world.restore(state);
                long restored = THREADS.getCurrentThreadAllocatedBytes();
                saving[round] = saved - before;
                restoring[round] = restored - saved;
            }
            // a round in which the machine compiles or links something is no round of ours
            Arrays.sort(saving);
            Arrays.sort(restoring);
            assertEquals(0, saving[ROUNDS / 2], "bytes to save");
            assertEquals(0, restoring[ROUNDS / 2], "bytes to restore");
            assertEquals(digest, world.digest());
        }
    }
}
