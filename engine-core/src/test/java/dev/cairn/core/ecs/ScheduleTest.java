package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.SchedulingException;
import dev.cairn.core.ecs.component.Component;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;

/** The graph that follows from declarations, its messages, and its switches. */
class ScheduleTest {
    private static ChunkSystem idle(String name, Consumer<Access> access) {
        return chunks(name, access, (chunk, tick) -> {});
    }

    private static String graph(EcsSystem... systems) {
        StringBuilder text = new StringBuilder();
        Schedule.builder().stage("s", systems).build().printGraph(text);
        return text.toString();
    }

    @Test
    void twoWritersOfAComponentAreNamed() {
        assertTeaches(
                SchedulingException.class,
                () ->
                        Schedule.builder()
                                .stage("forces", idle("drag", a -> a.out(FORCE)))
                                .stage("after", idle("wind", a -> a.in(TAG).out(FORCE)))
                                .build(),
                "Force",
                "(columns f)",
                "'drag' (stage 'forces')",
                "'wind' (stage 'after')",
                "access.before(\"wind\") or access.after(\"wind\") in 'drag'",
                "next(",
                "exclude");
    }

    /** The later one goes on from what the earlier one wrote, whichever name comes first. */
    @ParameterizedTest
    @CsvSource({"a,z", "z,a"})
    void twoWritersInTheOrderThatWasAskedFor(String first, String second) {
        ChunkSystem add =
                chunks(
                        first,
                        a -> a.out(FORCE),
                        (chunk, tick) -> {
                            for (int row = 0; row < chunk.size(); row++) {
                                chunk.out(F)[row] += 1;
                            }
                        });
        ChunkSystem multiply =
                chunks(
                        second,
                        a -> a.out(FORCE).after(first),
                        (chunk, tick) -> {
                            for (int row = 0; row < chunk.size(); row++) {
                                chunk.out(F)[row] *= 3;
                            }
                        });
        ChunkSystem read =
                chunks(
                        "m",
                        a -> a.next(FORCE).out(POSITION),
                        (chunk, tick) -> {
                            for (int row = 0; row < chunk.size(); row++) {
                                chunk.out(X)[row] = chunk.next(F)[row];
                            }
                        });
        for (boolean checked : new boolean[] {false, true}) {
            try (World world =
                    World.builder()
                            .systems(read, multiply, add)
                            .checked(checked)
                            .workers(2)
                            .build()) {
                long last = 0;
                for (int i = 0; i < 3000; i++) {
                    last = world.spawn(new Force(0), new Position(0, 0));
                }
                world.step(1);
                assertEquals(3, world.get(last, POSITION).x());
                world.step(1);
                assertEquals(12, world.get(last, FORCE).f());
                world.schedule().setEnabled(first, false);
                world.step(1);
                assertEquals(36, world.get(last, POSITION).x(), "goes on from what is published");
            }
        }
    }

    @Test
    void theOrderOfTwoWritersMayFollowFromAThird() {
        assertEquals(
                """
                level 0, chunks in parallel
                  z [s] out{Force, Position}
                level 1, chunks in parallel
                  m [s] out{Velocity} next{Position} after z (Position)
                level 2, chunks in parallel
                  a [s] out{Force} next{Velocity} after m (Velocity)
                """,
                graph(
                        idle("a", a -> a.next(VELOCITY).out(FORCE)),
                        idle("z", a -> a.out(FORCE, POSITION)),
                        idle("m", a -> a.next(POSITION).out(VELOCITY))));
    }

    @Test
    void whatTheLaterWriterWouldLoseIsRefused() {
        assertTeaches(
                SchedulingException.class,
                () ->
                        graph(
                                idle("a", a -> a.out(FORCE).before("b")),
                                idle("b", a -> a.writesAll(FORCE))),
                "'a'",
                "'b'",
                "writesAll",
                "declare out in the second");
        graph(idle("a", a -> a.writesAll(FORCE).before("b")), idle("b", a -> a.out(FORCE)));
        assertTeaches(
                SchedulingException.class,
                () ->
                        graph(
                                idle("a", a -> a.inPlace(FORCE).before("b")),
                                idle("b", a -> a.out(FORCE))),
                "inPlace",
                "only writer");
    }

    /** Who reads the last tick and who writes the next do not meet; two readers never do. */
    @Test
    void readersOfTheLastTickAreOrderedByNothing() {
        assertEquals(
                """
                level 0, chunks in parallel
                  a [s] in{Force} out{Position}
                  b [s] in{Position} out{Force}
                  c [s] in{Force, Position}
                """,
                graph(
                        idle("c", a -> a.in(FORCE, POSITION)),
                        idle("b", a -> a.in(POSITION).out(FORCE)),
                        idle("a", a -> a.in(FORCE).out(POSITION))));
    }

    /** What world systems do to objects is not declared, so their names would decide. */
    @Test
    void twoWorldSystemsNeedAnOrder() {
        assertTeaches(
                SchedulingException.class,
                () ->
                        graph(
                                world("referee", a -> a.in(POSITION), tick -> {}),
                                world("physics", a -> a.out(POSITION), tick -> {})),
                "'referee' (stage 's')",
                "'physics' (stage 's')",
                "world systems",
                "access.before(\"referee\") or access.after(\"referee\") in 'physics'");
        graph(
                world("referee", a -> a.next(POSITION), tick -> {}),
                world("physics", a -> a.out(POSITION), tick -> {}));
    }

    @Test
    void writersOfDisjointEntitiesMayShareAComponent() {
        graph(idle("a", a -> a.out(FORCE).with(TAG)), idle("b", a -> a.out(FORCE).exclude(TAG)));
    }

    @Test
    void onlyNextOrdersSystems() {
        assertEquals(
                """
                level 0, chunks in parallel
                  a [s] in{Force} out{Position}
                  z [s] in{Position} out{Force}
                level 1, simulation thread
                  m [s] next{Force, Position} after z (Force), a (Position)
                """,
                graph(
                        world("m", a -> a.next(FORCE, POSITION), tick -> {}),
                        idle("z", a -> a.in(POSITION).out(FORCE)),
                        idle("a", a -> a.in(FORCE).out(POSITION))));
    }

    @Test
    void worldSystemsAreLevelsOfTheirOwn() {
        assertEquals(
                """
                level 0, chunks in parallel
                  c [s] out{Tag}
                level 1, simulation thread
                  a [s] out{Force}
                level 2, simulation thread
                  b [s] out{Position} after a (asked for)
                """,
                graph(
                        world("b", a -> a.out(POSITION), tick -> {}),
                        world("a", a -> a.out(FORCE).before("b"), tick -> {}),
                        idle("c", a -> a.out(TAG))));
        assertEquals("(no systems)\n", graph());
    }

    @Test
    void registrationOrderDoesNotMatter() {
        List<EcsSystem> systems = new ArrayList<>();
        systems.add(idle("a", a -> a.out(POSITION).in(VELOCITY)));
        systems.add(idle("b", a -> a.next(POSITION).out(VELOCITY)));
        systems.add(idle("c", a -> a.next(VELOCITY).out(FORCE)));
        systems.add(world("d", a -> a.next(FORCE).out(TAG), tick -> {}));
        String expected = graph(systems.toArray(EcsSystem[]::new));
        Random random = new Random(5);
        for (int i = 0; i < 20; i++) {
            Collections.shuffle(systems, random);
            assertEquals(expected, graph(systems.toArray(EcsSystem[]::new)));
        }
    }

    @Test
    void aCircleIsShown() {
        assertTeaches(
                SchedulingException.class,
                () ->
                        graph(
                                idle("a", a -> a.next(POSITION).out(VELOCITY)),
                                idle("b", a -> a.next(VELOCITY).out(FORCE)),
                                idle("c", a -> a.next(FORCE).out(POSITION)),
                                idle("outside", a -> a.next(POSITION))),
                "circle",
                "'a' (stage 's') reads next(Position) of 'c'",
                "in, which is the state before");
    }

    @Test
    void contradictionsOfOneSystemTeach() {
        assertTeaches(
                SchedulingException.class,
                () -> graph(idle("a", a -> a.out(FORCE).next(FORCE))),
                "'a'",
                "Force",
                "drop next");
        assertTeaches(
                SchedulingException.class,
                () -> graph(idle("a", a -> a.in(FORCE).exclude(FORCE))),
                "'a'",
                "Force",
                "never run");
        assertTeaches(
                SchedulingException.class,
                () -> graph(idle("a", a -> {}), idle("a", a -> {})),
                "'a'",
                "unique");
        assertTeaches(SchedulingException.class, () -> graph(idle(" ", a -> {})), "blank");
        assertTeaches(
                NullPointerException.class,
                () -> graph(idle("a", a -> a.in((Component<?>) null))),
                "'a'",
                "in");
        assertTeaches(NullPointerException.class, () -> graph((EcsSystem) null), "system");
        Access[] kept = new Access[1];
        graph(idle("a", a -> kept[0] = a));
        assertTeaches(IllegalStateException.class, () -> kept[0].in(FORCE), "'a'", "describe");
    }

    @Test
    void aDisabledWriterLeavesItsValuesAndTheOthersRun() {
        ChunkSystem count =
                chunks(
                        "count",
                        a -> a.next(POSITION).out(FORCE),
                        (chunk, tick) -> chunk.out(F)[0] = (float) chunk.next(X)[0]);
        try (World world = World.builder().systems(count, move()).workers(1).build()) {
            long entity = world.spawn(new Position(0, 0), new Velocity(1, 0), new Force(0));
            world.step(1);
            assertEquals(1, world.get(entity, FORCE).f());
            world.schedule().setEnabled("move", false);
            assertFalse(world.schedule().isEnabled("move"));
            world.step(1);
            assertEquals(1, world.get(entity, POSITION).x());
            assertEquals(1, world.get(entity, FORCE).f(), "next is the published value then");
            world.schedule().setEnabled("move", true);
            world.step(1);
            assertEquals(2, world.get(entity, FORCE).f());
            assertTrue(world.schedule().systems().contains("move"));
            assertTeaches(
                    SchedulingException.class,
                    () -> world.schedule().setEnabled("mvoe", true),
                    "mvoe",
                    "move");
        }
    }
}
