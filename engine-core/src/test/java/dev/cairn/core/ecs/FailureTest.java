package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.storage.ChunkSizes;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.concurrent.atomic.AtomicInteger;

/** A system that throws ends the tick, not the process. */
@Timeout(60)
class FailureTest {
    private static final class Broken extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Broken(String message) {
            super(message);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void theFirstFailureIsTheCauseAndAllBlocksRun(int workers) {
        AtomicInteger ran = new AtomicInteger();
        AtomicInteger later = new AtomicInteger();
        EcsSystem a =
                chunks(
                        "a",
                        access -> access.out(POSITION).commands(),
                        (chunk, tick) -> {
                            chunk.out(X)[0] = 99;
                            ran.incrementAndGet();
                            if (tick.number() == 2 && chunk.in(Y)[0] >= 1) {
                                throw new Broken("a" + (int) chunk.in(Y)[0]);
                            }
                            tick.commands().spawn(new Force(1));
                        });
        EcsSystem b =
                chunks(
                        "b",
                        access -> access.in(POSITION),
                        (chunk, tick) -> {
                            ran.incrementAndGet();
                            if (tick.number() == 2) {
                                throw new Broken("b");
                            }
                        });
        EcsSystem c = world("c", access -> access.next(POSITION), tick -> later.incrementAndGet());
        try (Jobs jobs = Jobs.of(workers);
                World world = World.builder().systems(c, b, a).jobs(jobs).build()) {
            for (int i = 0; i < 3 * ChunkSizes.SMALLEST; i++) {
                world.spawn(new Position(0, i / ChunkSizes.SMALLEST));
            }
            world.step(1);
            assertEquals(6, ran.getAndSet(0));
            assertEquals(1, later.getAndSet(0));
            long before = world.digest();
            WorldFailedException failure =
                    assertTeaches(
                            WorldFailedException.class,
                            () -> world.step(1),
                            "tick 2",
                            "'a' (chunk 1)",
                            "a1");
            assertEquals("a1", failure.getCause().getMessage());
            assertEquals(4, failure.getSuppressed().length);
            assertEquals("a2", failure.getSuppressed()[0].getMessage());
            assertEquals("b", failure.getSuppressed()[1].getMessage());
            assertEquals(6, ran.get());
            assertEquals(0, later.get(), "a later level does not start");
            assertTrue(world.hasFailed());
            assertEquals(before, world.digest(), "nothing was published");
            Chunk chunk = world.query(POSITION).chunk(0);
            assertSame(chunk.in(X), chunk.out(X), "what the tick wrote is forgotten");
            assertEquals(1, world.tickNumber());
            assertTeaches(WorldFailedException.class, () -> world.step(1), "tick 2", "cannot");

            int[] counts = new int[64];
            jobs.run((block, worker) -> counts[block]++, counts.length);
            for (int count : counts) {
                assertEquals(1, count, "helpers live on");
            }
        }
    }

    @Test
    void anErrorOfAWorldSystemIsHandedOn() {
        Error error = new StackOverflowError();
        EcsSystem system =
                world(
                        "s",
                        a -> {},
                        tick -> {
                            throw error;
                        });
        try (World world = World.builder().systems(system).workers(2).build()) {
            assertFalse(world.hasFailed());
            WorldFailedException failure =
                    assertTeaches(WorldFailedException.class, () -> world.step(1), "'s'");
            assertSame(error, failure.getCause());
            assertTrue(world.hasFailed());
        }
    }

    @Test
    void aStepInsideAStepIsRefused() {
        World[] w = new World[1];
        EcsSystem system = world("s", a -> {}, tick -> w[0].step(1));
        try (World world = World.builder().systems(system).workers(1).build()) {
            w[0] = world;
            assertTeaches(WorldFailedException.class, () -> world.step(1), "during a step");
        }
    }

    @Test
    void commandsOfAWorldSystemBelongToTheSimulationThread() {
        EcsSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> {
                            Commands commands = tick.commands();
                            Throwable[] thrown = new Throwable[1];
                            Thread other =
                                    new Thread(() -> {
                                        try {
                                            commands.spawn();
                                        } catch (IllegalStateException expected) {
                                            thrown[0] = expected;
                                        }
                                    });
                            other.start();
                            try {
                                other.join();
                            } catch (InterruptedException interrupted) {
                                throw new AssertionError(interrupted);
                            }
                            throw new AssertionError(thrown[0]);
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            assertTeaches(
                    WorldFailedException.class, () -> world.step(1), "simulation thread only");
        }
    }
}
