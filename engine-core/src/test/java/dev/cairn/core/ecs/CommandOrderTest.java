package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.SchedulingException;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;

/** Whose commands come first follows from declarations, or is asked for; no name decides. */
class CommandOrderTest {
    private static ChunkSystem idle(String name, Consumer<Access> access) {
        return chunks(name, access, (chunk, tick) -> {});
    }

    private static Schedule schedule(EcsSystem... systems) {
        return Schedule.builder().stage("s", systems).build();
    }

    @Test
    void twoThatGiveCommandsNeedAnOrder() {
        assertTeaches(
                SchedulingException.class,
                () ->
                        schedule(
                                idle("births", a -> a.in(POSITION).commands()),
                                idle("deaths", a -> a.in(FORCE).commands())),
                "'births' (stage 's')",
                "'deaths' (stage 's')",
                "both give commands",
                "access.before(\"deaths\") or access.after(\"deaths\") in 'births'");
        // Apart or not: ids and rows follow from the order in any case.
        assertTeaches(
                SchedulingException.class,
                () ->
                        schedule(
                                idle("births", a -> a.with(TAG).commands()),
                                world("deaths", a -> a.exclude(TAG).commands(), tick -> {})),
                "both give commands");
        assertEquals(
                List.of("births", "deaths"),
                schedule(
                                idle("deaths", a -> a.commands()),
                                idle("births", a -> a.commands().before("deaths")))
                        .systems());
        assertEquals(
                List.of("z", "a"),
                schedule(
                                idle("a", a -> a.next(FORCE).commands()),
                                idle("z", a -> a.out(FORCE).commands()))
                        .systems(),
                "an order that follows");
        assertEquals(
                List.of("z", "m", "a"),
                schedule(
                                idle("a", a -> a.after("m").commands()),
                                idle("m", a -> a.after("z")),
                                idle("z", a -> a.commands()))
                        .systems(),
                "by a third");
        assertEquals(
                3,
                schedule(
                                idle("a", a -> a.in(FORCE)),
                                idle("b", a -> a.in(FORCE)),
                                idle("z", a -> a.commands()))
                        .systems()
                        .size(),
                "one that gives commands needs none");
    }

    @Test
    void commandsAreDeclared() {
        for (EcsSystem system :
                List.of(
                        chunks("s", a -> a.in(TAG), (chunk, tick) -> tick.commands().spawn()),
                        world("s", a -> {}, tick -> tick.commands().spawn()))) {
            try (World world = World.builder().systems(system).workers(1).build()) {
                world.spawn(new Tag());
                assertTeaches(
                        WorldFailedException.class,
                        () -> world.step(1),
                        "'s'",
                        "access.commands()",
                        "describe");
                assertEquals(1, world.entityCount());
            }
        }
        assertTrue(
                schedule(idle("s", a -> a.in(TAG).commands()))
                        .levels()
                        .getFirst()
                        .getFirst()
                        .access()
                        .toString()
                        .endsWith("commands"));
    }

    /** What the system of a number does to entities: another thing for each number. */
    private static void act(int number, long entity, Tick tick) {
        Commands commands = tick.commands();
        switch ((int) (number + entity + tick.number()) % 6) {
            case 0 -> commands.set(entity, new Position(number, tick.number()));
            case 1 -> commands.add(entity, new Force(number));
            case 2 -> commands.remove(entity, FORCE);
            case 3 -> commands.spawn(new Position(number, 7), new Tag());
            case 4 -> commands.delete(entity);
            default -> commands.clear(entity);
        }
    }

    private static long digest(List<String> names, int workers) {
        List<EcsSystem> systems = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            int number = i;
            systems.add(
                    chunks(
                            names.get(i),
                            a -> {
                                a.in(POSITION).commands();
                                if (number > 0) {
                                    a.after(names.get(number - 1));
                                }
                            },
                            (chunk, tick) -> {
                                for (int row = number; row < chunk.size(); row += 5) {
                                    act(number, chunk.entity(row), tick);
                                }
                            }));
        }
        Collections.shuffle(systems, new Random(workers));
        try (World world =
                World.builder()
                        .systems(systems.toArray(EcsSystem[]::new))
                        .workers(workers)
                        .build()) {
            world.spawnMany(3000, new Position(1, 2));
            for (int tick = 0; tick < 12; tick++) {
                world.step(1);
                if (tick % 3 == 0) {
                    world.spawnMany(500, new Position(tick, 2), new Force(1));
                }
            }
            assertTrue(world.skippedCommands() > 0, "commands met on the same entities");
            return world.digest();
        }
    }

    /** The same systems in the same order, under other names: the same world. */
    @Test
    void namesDecideNothing() {
        long seed = 25_03;
        Random random = new Random(seed);
        List<String> names = new ArrayList<>(List.of("a", "k", "m", "x", "z"));
        Set<Long> digests = new HashSet<>();
        for (int i = 0; i < 12; i++) {
            Collections.shuffle(names, random);
            digests.add(digest(List.copyOf(names), 1 + i % 3));
        }
        assertEquals(1, digests.size(), "seed " + seed);
        assertFalse(digests.contains(0L));
    }
}
