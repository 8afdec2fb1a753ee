package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;

/** The last ticks are all there, those before now and then, and memory has a bound. */
class MomentsTest {
    private static final double STEP = 1.0 / 60;
    private final com.sun.management.ThreadMXBean threads =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void denseThenSparseThenForgottenAndAtLastWithoutGarbage() {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).build()) {
            world.add(Body.dynamic().shape(Sphere.of(0.5)));
            Moments moments = new Moments(20, 10, 30, Long.MAX_VALUE);
            for (int tick = 0; tick < 2000; tick++) {
                moments.add(world, tick);
                world.step(STEP);
            }
            int newest = moments.count() - 1;
            for (int i = 0; i < 20; i++) {
                assertEquals(1999 - i, moments.tick(newest - i));
            }
            for (int i = 1; i < moments.count() - 20; i++) {
                assertEquals(10, moments.tick(i) - moments.tick(i - 1), "moment " + i);
            }
            assertTrue(moments.tick(0) <= 1999 - 20 - 29 * 10, "the first is " + moments.tick(0));
            long before = threads.getCurrentThreadAllocatedBytes();
            long reading = threads.getCurrentThreadAllocatedBytes() - before;
            before = threads.getCurrentThreadAllocatedBytes();
            for (int tick = 2000; tick < 2100; tick++) {
                moments.add(world, tick);
            }
            assertEquals(0, threads.getCurrentThreadAllocatedBytes() - before - reading);

            // Back to a tick that is long gone leads to the last one before it.
            int at = moments.indexAt(moments.tick(5) + 3);
            assertEquals(moments.tick(5), moments.tick(at));
            moments.forgetAfter(at);
            assertEquals(6, moments.count());
            moments.add(world, moments.tick(5) + 1);
            assertEquals(7, moments.count());
        }
    }

    /** With gaps in proportion to age n moments reach back by a power of n. */
    @Test
    void whereMemoryIsShortThePastIsTheCoarserTheLongerAgoItIs() {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).build()) {
            for (int i = 0; i < 50; i++) {
                world.add(Body.dynamic().shape(Sphere.of(0.5)).at(2 * i, 0, 0));
            }
            long one = world.save().byteCount();
            Moments moments = new Moments(120, 15, 480, 40 * one);
            for (int tick = 0; tick < 1000; tick++) {
                moments.add(world, tick);
                assertTrue(moments.byteCount() <= 40 * one, "bytes " + moments.byteCount());
            }
            assertEquals(40, moments.count());
            assertEquals(0, moments.tick(0), "the beginning is remembered");
            assertEquals(999, moments.tick(39));
            assertEquals(998, moments.tick(38));
            for (int i = 1; i < 40; i++) {
                long gap = moments.tick(i) - moments.tick(i - 1);
                long age = 999 - moments.tick(i - 1);
                assertTrue(gap <= Math.max(2, 0.4 * age), gap + " ticks, " + age + " ago");
            }
        }
    }
}
