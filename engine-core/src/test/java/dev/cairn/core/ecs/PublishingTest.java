package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.access.SchedulingException;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** What in, out and next show, what a commit exchanges, and what checked mode notices. */
class PublishingTest {
    @Test
    void aColumnThatNothingWroteIsOneArrayOnBothSides() {
        List<Object> seen = new ArrayList<>();
        ChunkSystem writer =
                chunks(
                        "writer",
                        a -> a.out(POSITION),
                        (chunk, tick) -> {
                            if (tick.number() == 2) {
                                chunk.out(X)[0] = 7;
                            }
                        });
        ChunkSystem reader =
                chunks(
                        "reader",
                        a -> a.in(POSITION).next(POSITION),
                        (chunk, tick) -> {
                            seen.add(chunk.in(X));
                            seen.add(chunk.next(X));
                            seen.add(chunk.in(Y));
                            seen.add(chunk.next(Y));
                        });
        try (World world = World.builder().systems(writer, reader).workers(1).build()) {
            long entity = world.spawn(new Position(1, 2));
            Chunk chunk = world.query(POSITION).chunk(0);
            world.step(1);
            assertSame(seen.get(0), seen.get(1));
            assertEquals(0, chunk.version(X));
            seen.clear();
            world.step(1);
            assertNotSame(seen.get(0), seen.get(1), "written in tick 2");
            assertSame(seen.get(2), seen.get(3), "y was not");
            assertSame(seen.get(1), chunk.in(X), "commit publishes the written array itself");
            assertEquals(new Position(7, 2), world.get(entity, POSITION));
            assertEquals(2, chunk.version(X));
            assertEquals(0, chunk.version(Y));
            world.step(1);
            assertEquals(2, chunk.version(X));
            world.set(entity, new Position(0, 0));
            assertEquals(3, chunk.version(Y), "set after tick 3");
        }
    }

    @Test
    void twoArraysTakeTurns() {
        List<double[]> written = new ArrayList<>();
        ChunkSystem writer =
                chunks("w", a -> a.out(POSITION), (chunk, tick) -> written.add(chunk.out(X)));
        try (World world = World.builder().systems(writer).workers(1).build()) {
            world.spawn(new Position(1, 2));
            for (int i = 0; i < 4; i++) {
                world.step(1);
            }
            assertSame(written.get(0), written.get(2));
            assertSame(written.get(1), written.get(3));
            assertNotSame(written.get(0), written.get(1));
        }
    }

    @Test
    void inShowsTheLastTickAndOutStartsFromIt() {
        ChunkSystem swap =
                chunks(
                        "swap",
                        a -> a.out(POSITION),
                        (chunk, tick) -> {
                            double[] x = chunk.out(X);
                            assertEquals(chunk.in(X)[0], x[0], "pre-filled");
                            x[0] = -1;
                            assertEquals(tick.number() == 1 ? 5 : -1, chunk.in(X)[0]);
                            assertSame(x, chunk.out(X), "asking twice gives the same array");
                            assertEquals(-1, chunk.out(X)[0], "and does not fill it again");
                        });
        try (World world = World.builder().systems(swap).workers(1).build()) {
            world.spawn(new Position(5, 0));
            world.step(1);
            world.step(1);
        }
    }

    @Test
    void aWorldSystemReadsAndWritesItsChunks() {
        WorldSystem sum =
                world(
                        "sum",
                        a -> a.writesAll(POSITION).exclude(TAG),
                        tick -> {
                            tick.jobs()
                                    .run(
                                            (block, worker) -> {
                                                Chunk chunk = tick.chunk(block);
                                                double[] x = chunk.out(X);
                                                for (int r = 0; r < chunk.size(); r++) {
                                                    x[r] = chunk.in(X)[r] + 1;
                                                }
                                            },
                                            tick.chunkCount());
                            assertThrows(
                                    IndexOutOfBoundsException.class,
                                    () -> tick.chunk(tick.chunkCount()));
                        });
        try (World world = World.builder().systems(sum).workers(2).build()) {
            long[] entities = world.spawnMany(3000, new Position(1, 0));
            long other = world.spawn(new Position(1, 0), new Tag());
            world.step(1);
            assertEquals(2, world.get(entities[2999], POSITION).x());
            assertEquals(1, world.get(other, POSITION).x());
        }
    }

    @Test
    void inPlaceWritesThePublishedArrayItself() {
        ChunkSystem system =
                chunks(
                        "s",
                        a -> a.inPlace(POSITION),
                        (chunk, tick) -> {
                            double[] x = chunk.out(X);
                            x[0] += tick.number();
                        });
        List<Double> seen = new ArrayList<>();
        ChunkSystem reader =
                chunks("r", a -> a.next(POSITION), (chunk, tick) -> seen.add(chunk.next(X)[0]));
        for (boolean checked : new boolean[] {false, true}) {
            try (World world =
                    World.builder().systems(system, reader).workers(1).checked(checked).build()) {
                seen.clear();
                long entity = world.spawn(new Position(0, 0));
                Chunk chunk = world.query(POSITION).chunk(0);
                double[] before = chunk.in(X);
                world.step(1);
                world.step(1);
                assertSame(before, chunk.in(X));
                assertEquals(3, world.get(entity, POSITION).x());
                assertEquals(2, chunk.version(X));
                assertEquals(0, chunk.version(Y));
                assertEquals(List.of(1.0, 3.0), seen);
            }
        }
        assertFails(true, a -> a.inPlace(POSITION), c -> c.out(X)[0] = Double.NaN, "NaN");
        assertTeaches(
                SchedulingException.class,
                () -> World.builder().systems(system, publishedReader()).build(),
                "Position",
                "'s'",
                "'reader'",
                "next in the second");
        assertTeaches(
                SchedulingException.class,
                () ->
                        World.builder()
                                .systems(chunks("x", a -> a.inPlace(FORCE).in(FORCE), (c, t) -> {}))
                                .build(),
                "'x'",
                "Force");
    }

    private static ChunkSystem publishedReader() {
        return chunks("reader", a -> a.in(POSITION), (chunk, tick) -> {});
    }

    @Test
    void whatWasNotDeclaredIsRefusedByName() {
        assertFails(false, a -> a.in(POSITION), c -> c.out(X), "'s'", "Position.x", "access.out(");
        assertFails(false, a -> a.with(POSITION), c -> c.in(X), "'s'", "Position.x", "access.in(");
        assertFails(false, a -> a.in(POSITION), c -> c.next(X), "'s'", "Position.x", "next");
        assertFails(false, a -> a.in(POSITION), c -> c.in(VX), "'s'", "Velocity.vx", "has none");
    }

    @Test
    void checkedModeNoticesWhatIsWrittenThroughIn() {
        assertFails(
                true,
                a -> a.in(POSITION),
                c -> c.in(X)[0] = 3,
                "'s'",
                "Position.x",
                "out(Position)");
        assertFails(true, a -> a.next(POSITION), c -> c.next(X)[0] = 3, "'s'", "Position.x");
        assertFails(
                true, a -> a.out(POSITION), c -> c.in(X)[0] = 3, "'s'", "Position.x", "published");
    }

    @Test
    void checkedModeNoticesNanAndForgottenRows() {
        assertFails(
                true,
                a -> a.out(POSITION),
                c -> c.out(X)[0] = Double.NaN,
                "'s'",
                "Position.x",
                "0v1",
                "NaN");
        assertFails(true, a -> a.writesAll(POSITION), c -> c.out(X), "Position.x", "writesAll");
    }

    @Test
    void checkedModeLetsRightSystemsPass() {
        try (World world = World.builder().systems(move()).checked(true).workers(2).build()) {
            long entity = world.spawn(new Position(0, 0), new Velocity(1, 0));
            world.step(1);
            assertEquals(1, world.get(entity, POSITION).x());
        }
    }

    private static void assertFails(
            boolean checked,
            java.util.function.Consumer<Access> access,
            java.util.function.Consumer<Chunk> body,
            String... words) {
        for (boolean whole : new boolean[] {false, true}) {
            EcsSystem system =
                    whole
                            ? world("s", access, tick -> body.accept(tick.chunk(0)))
                            : chunks("s", access, (chunk, tick) -> body.accept(chunk));
            try (World world =
                    World.builder().systems(system).checked(checked).workers(1).build()) {
                world.spawn(new Position(1, 2));
                WorldFailedException failure =
                        assertTeaches(WorldFailedException.class, () -> world.step(1), words);
                assertTrue(failure.getCause() instanceof AccessException);
            }
        }
    }
}
