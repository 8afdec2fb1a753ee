package dev.cairn.physics.island;

import dev.cairn.physics.Body;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Locale;

/** Prints what a step costs beside bodies that sleep; the table of {@code docs}. No test. */
final class SleepCost {
    private static final int ROUNDS = 5;
    private static final int TICKS = 200;

    private SleepCost() {}

    /** Takes no arguments. */
    public static void main(String[] args) {
        for (int asleep : new int[] {0, 1000, 10_000, 40_000}) {
            for (int awake : new int[] {0, 10, 1000}) {
                measure(asleep, awake);
            }
        }
    }

    /** Stacks of ten, and balls that roll. */
    private static void measure(int asleep, int awake) {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(4000, 1, 4000)).at(0, -1, 0));
            int side = (int) Math.ceil(Math.sqrt(0.1 * asleep)) + 1;
            for (int i = 0; i < asleep; i++) {
                int stack = i / 10;
                Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(0.5));
                world.add(box.at(2 * (stack % side), 0.5 + i % 10, 2 * (stack / side)));
            }
            for (int i = 0; i < awake; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Sphere.of(0.5))
                                .at(-100 - 2 * (i % 40), 0.5, -2 * (i / 40))
                                .velocity(0, 0, -1)
                                .angularVelocity(-2, 0, 0));
            }
            int ticks = 0;
            while (world.sleepEvents().asleepCount() < asleep && ticks < 600) {
                world.step(Scenes.STEP);
                ticks++;
            }
            ThreadMXBean threads = ManagementFactory.getThreadMXBean();
            double best = Double.MAX_VALUE;
            for (int round = 0; round < 2 + ROUNDS; round++) {
                long start = threads.getCurrentThreadCpuTime();
                for (int tick = 0; tick < TICKS; tick++) {
                    world.step(Scenes.STEP);
                }
                best = Math.min(best, 1e-3 * (threads.getCurrentThreadCpuTime() - start) / TICKS);
            }
            System.out.printf(
                    Locale.ROOT,
                    "%d asleep after %d ticks, %d awake: %.2f us a step%n",
                    world.sleepEvents().asleepCount(),
                    ticks,
                    awake,
                    best);
        }
    }
}
