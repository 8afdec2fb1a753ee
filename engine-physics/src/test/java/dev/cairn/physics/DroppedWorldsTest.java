package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.Set;

/** Worlds that are forgotten instead of closed do not keep their threads. */
class DroppedWorldsTest {
    private static Set<Thread> helpers() {
        Set<Thread> found = new HashSet<>();
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().startsWith("cairn-job-")) {
                found.add(thread);
            }
        }
        return found;
    }

    private static void dropOne() {
        PhysicsWorld world = PhysicsWorld.builder().workers(3).build();
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.9, 0));
        world.step(1.0 / 60);
    }

    @Test
    void theirThreadsEnd() throws InterruptedException {
        Set<Thread> before = helpers();
        for (int i = 0; i < 50; i++) {
            dropOne();
        }
        Set<Thread> dropped = helpers();
        dropped.removeAll(before);
        for (int round = 0; round < 100; round++) {
            System.gc();
            for (Thread thread : dropped) {
                thread.join(1);
            }
            dropped.removeIf(thread -> !thread.isAlive());
        }
        assertEquals(Set.of(), dropped);
    }

    @Test
    void oneThatIsUsedKeepsThem() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(2).build()) {
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
            for (int tick = 0; tick < 20; tick++) {
                world.step(1.0 / 60);
                System.gc();
            }
            assertEquals(-0.5 * 9.81 / 9, box.position().y, 1e-12);
        }
    }
}
