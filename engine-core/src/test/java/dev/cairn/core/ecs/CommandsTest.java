package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Commands: recorded per (system, chunk), made at commit in (system, chunk, sequence) order. */
class CommandsTest {
    private static WorldSystem once(String name, Consumer<Tick> body, String... after) {
        return world(
                name,
                a -> a.commands().after(after),
                tick -> {
                    if (tick.number() == 1) {
                        body.accept(tick);
                    }
                });
    }

    @Test
    void theLastSystemAndTheLastCommandWin() {
        long[] target = new long[1];
        EcsSystem b = once("b", tick -> tick.commands().set(target[0], new Position(2, 0)));
        EcsSystem a =
                once(
                        "a",
                        tick -> {
                            tick.commands().set(target[0], new Position(1, 0));
                            tick.commands().set(target[0], new Position(3, 0));
                        },
                        "b");
        for (EcsSystem[] order : new EcsSystem[][] {{a, b}, {b, a}}) {
            try (World world = World.builder().systems(order).workers(1).build()) {
                target[0] = world.spawn(new Position(0, 0));
                world.step(1);
                assertEquals(3, world.get(target[0], POSITION).x());
            }
        }
    }

    @Test
    void spawnsComeInTheOrderOfChunksWhateverTheWorkersDo() {
        ChunkSystem mother =
                chunks(
                        "mother",
                        a -> a.in(POSITION).with(TAG).commands(),
                        (chunk, tick) -> {
                            double[] x = chunk.in(X);
                            for (int row = 0; row < chunk.size(); row += 100) {
                                tick.commands().spawn(new Force((float) x[row]));
                            }
                        });
        List<Float> expected = new ArrayList<>();
        for (int seed = 0; seed < 12; seed++) {
            try (Jobs jobs = Jobs.perturbed(1 + seed % 4, seed);
                    World world = World.builder().systems(mother).jobs(jobs).build()) {
                for (int i = 0; i < 5000; i++) {
                    world.spawn(new Position(i, 0), new Tag());
                }
                world.step(1);
                List<Float> found = new ArrayList<>();
                Chunk chunk = world.query(FORCE).chunk(0);
                for (int row = 0; row < chunk.size(); row++) {
                    found.add(chunk.in(F)[row]);
                    if (row > 0) {
                        assertTrue(chunk.in(F)[row] > chunk.in(F)[row - 1]);
                        assertEquals(chunk.entity(row - 1) + 1, chunk.entity(row));
                    }
                }
                if (seed == 0) {
                    expected.addAll(found);
                }
                assertEquals(expected, found, "seed " + seed);
            }
        }
    }

    @Test
    void aHandleStandsForTheEntityThatIsToBe() {
        long[] handle = new long[2];
        EcsSystem system =
                once(
                        "s",
                        tick -> {
                            Commands commands = tick.commands();
                            handle[0] = commands.spawn(new Position(1, 2));
                            handle[1] = commands.spawn();
                            commands.add(handle[0], new Tag());
                            commands.set(handle[0], new Position(3, 4));
                            commands.delete(handle[1]);
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            world.step(1);
            long entity = world.resolve(handle[0]);
            assertEquals(new Position(3, 4), world.get(entity, POSITION));
            assertTrue(world.has(entity, TAG));
            assertFalse(world.isAlive(world.resolve(handle[1])));
            assertFalse(world.isAlive(handle[0]), "a handle is no entity");
            assertEquals(1, world.entityCount());
            assertEquals(0, world.skippedCommands());
        }
    }

    @Test
    void whatHasBecomePointlessIsSkippedAndCounted() {
        long[] e = new long[2];
        EcsSystem system =
                once(
                        "s",
                        tick -> {
                            Commands commands = tick.commands();
                            commands.delete(e[0]);
                            commands.delete(e[0]);
                            commands.set(e[0], new Tag());
                            commands.remove(e[1], TAG);
                            commands.remove(e[1], TAG);
                            commands.set(e[1], new Tag());
                            commands.add(e[1], new Force(1));
                            commands.add(e[1], new Force(2));
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            e[0] = world.spawn(new Tag());
            e[1] = world.spawn(new Tag());
            world.step(1);
            assertEquals(4, world.skippedCommands());
            assertEquals(2, world.get(e[1], FORCE).f(), "the later add replaces");
            world.step(1);
            assertEquals(0, world.skippedCommands());
        }
    }

    @Test
    void theStructureStandsDuringATick() {
        long[] e = new long[1];
        EcsSystem system =
                once(
                        "s",
                        tick -> {
                            tick.commands().delete(e[0]);
                            assertTrue(tick.isAlive(e[0]));
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            e[0] = world.spawn(new Tag());
            world.step(1);
            assertFalse(world.isAlive(e[0]));
        }
    }

    @Test
    void badCommandsFailTheirSystem() {
        refuse(tick -> tick.commands().delete(77), DeadEntityException.class, "77");
        refuse(tick -> tick.commands().add(77, new Tag()), DeadEntityException.class);
        refuse(tick -> tick.commands().spawn(new Tag(), null), NullPointerException.class);
        refuse(tick -> tick.commands().spawn(new Tag(), new Tag()), ComponentException.class);
        refuse(tick -> tick.commands().delete(Handle.of(0, 0, 9, 0)), DeadEntityException.class);
    }

    private static void refuse(
            Consumer<Tick> body, Class<? extends Throwable> cause, String... words) {
        try (World world = World.builder().systems(once("s", body)).workers(2).build()) {
            WorldFailedException failure =
                    assertTeaches(WorldFailedException.class, () -> world.step(1), words);
            assertSame(cause, failure.getCause().getClass());
            assertEquals(0, world.entityCount());
        }
    }

    @Test
    void aDirectChangeDuringAStepIsRefused() {
        World[] w = new World[1];
        EcsSystem system = once("s", tick -> w[0].spawn(new Tag()));
        try (World world = World.builder().systems(system).workers(1).build()) {
            w[0] = world;
            assertTeaches(
                    WorldFailedException.class, () -> world.step(1), "spawn", "tick.commands()");
        }
    }
}
