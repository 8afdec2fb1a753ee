package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.DebugData;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** What the engine tells about islands, colours and bodies for drawing. */
class DebugDataTest {
    private static final double STEP = 1.0 / 60;
    private static final int STACKS = 3;
    private static final int HIGH = 4;

    /** Stacks far from each other: each is an island. The name tells the stack. */
    private static PhysicsWorld stacks(boolean sleeping) {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(sleeping).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
        for (int i = 0; i < STACKS * HIGH; i++) {
            // Level by level, so that slots of a stack are no neighbours.
            int stack = i % STACKS;
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.5))
                            .at(4 * stack, 0.5 + i / STACKS, 0)
                            .name("" + stack));
        }
        return world;
    }

    private static void checkIslands(PhysicsWorld world, DebugData data) {
        Map<String, Integer> islandOfStack = new HashMap<>();
        for (int i = 0; i < data.bodyCount(); i++) {
            BodyRef body = world.bodyOf(data.entities()[i]);
            if (body.isFixed()) {
                assertEquals(DebugData.NONE, data.islands()[i]);
            } else {
                int island = data.islands()[i];
                assertNotEquals(DebugData.NONE, island);
                Integer known = islandOfStack.putIfAbsent(body.name(), island);
                assertTrue(known == null || known == island, "stack " + body.name());
            }
        }
        assertEquals(STACKS, new HashSet<>(islandOfStack.values()).size());
    }

    @Test
    void bodiesThatTouchAreOneIslandAwakeOrAsleep() {
        try (PhysicsWorld world = stacks(true)) {
            for (int i = 0; i < 5; i++) {
                world.step(STEP);
            }
            DebugData data = world.capture(new DebugData());
            checkIslands(world, data);
            for (int i = 0; i < 300 && data.states()[1] == DebugData.AWAKE; i++) {
                world.step(STEP);
                world.capture(data);
            }
            assertEquals(DebugData.ASLEEP, data.states()[1], "after five seconds");
            checkIslands(world, data);
        }
    }

    @Test
    void noTwoContactsOfAColourMoveTheSameBody() {
        try (PhysicsWorld world = stacks(false)) {
            for (int i = 0; i < 5; i++) {
                world.step(STEP);
            }
            DebugData data = world.capture(new DebugData());
            Set<Long> seen = new HashSet<>();
            Set<Integer> colours = new HashSet<>();
            for (int i = 0; i < data.pointCount(); i++) {
                int a = data.firstBodies()[i];
                int b = data.secondBodies()[i];
                int colour = data.colours()[i];
                assertTrue(colour >= 0, "point " + i + " has no colour");
                colours.add(colour);
                boolean firstOfContact =
                        i == 0 || a != data.firstBodies()[i - 1] || b != data.secondBodies()[i - 1];
                for (int body : new int[] {a, b}) {
                    if (data.states()[body] != DebugData.FIXED && firstOfContact) {
                        assertTrue(
                                seen.add((long) colour << 32 | body),
                                "colour " + colour + " moves body " + body + " twice");
                    }
                }
            }
            // Four boxes on a floor: a chain wants two colours, and the floor one of its own.
            assertTrue(colours.size() >= 3, "colours " + colours);
            assertEquals(STACKS * HIGH * 4, data.pointCount());
        }
    }

    @Test
    void capturingAgainAllocatesNothing() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (PhysicsWorld world = stacks(false)) {
            DebugData data = new DebugData();
            long least = Long.MAX_VALUE;
            for (int round = 0; round < 5; round++) {
                long bytes = 0;
                for (int i = 0; i < 20; i++) {
                    world.step(STEP);
                    long before = threads.getCurrentThreadAllocatedBytes();
                    world.capture(data);
                    bytes += threads.getCurrentThreadAllocatedBytes() - before;
                }
                least = Math.min(least, bytes);
            }
            assertEquals(0, least, "bytes of 20 captures, the quietest round of five");
        }
    }
}
