package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;
import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.component.FloatField;
import dev.cairn.core.state.WorldState;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/** Observers: told of every add, set and remove, in the order in which the changes are made. */
class ObserverTest {
    private static final FloatField FORCE_F = FORCE.floatField("f");

    /** Writes down what it is told. */
    private static class Log<T extends Record> implements Observer<T> {
        final String name;
        final List<String> lines;

        Log(String name, List<String> lines) {
            this.name = name;
            this.lines = lines;
        }

        @Override
        public void added(Change<T> change) {
            lines.add(name + " add " + Entities.toString(change.entity()) + " " + change.value());
        }

        @Override
        public void set(Change<T> change) {
            lines.add(
                    name
                            + " set "
                            + Entities.toString(change.entity())
                            + " "
                            + change.previous()
                            + " to "
                            + change.value());
        }

        @Override
        public void removed(Change<T> change) {
            lines.add(
                    name + " remove " + Entities.toString(change.entity()) + " " + change.value());
        }
    }

    /** Changes in the order of the commands; one change to its observers as they registered. */
    @Test
    void theOrderIsAContract() {
        long[] e = new long[1];
        List<String> lines = new ArrayList<>();
        WorldSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> {
                            Commands commands = tick.commands();
                            commands.set(e[0], new Force(2));
                            commands.spawn(new Position(7, 8), new Force(9));
                            commands.add(e[0], new Force(3));
                            commands.delete(e[0]);
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            world.observe(FORCE, new Log<>("1F", lines));
            world.observe(POSITION, new Log<>("2P", lines));
            world.observe(FORCE, new Log<>("3F", lines));
            e[0] = world.spawn(new Position(0, 0), new Force(1));
            String old = Entities.toString(e[0]);
            world.step(1);
            String young = Entities.toString(e[0] + 1);
            assertEquals(
                    List.of(
                            "1F add " + old + " Force[f=1.0]",
                            "2P add " + old + " Position[x=0.0, y=0.0]",
                            "3F add " + old + " Force[f=1.0]",
                            "1F set " + old + " Force[f=1.0] to Force[f=2.0]",
                            "3F set " + old + " Force[f=1.0] to Force[f=2.0]",
                            "1F add " + young + " Force[f=9.0]",
                            "2P add " + young + " Position[x=7.0, y=8.0]",
                            "3F add " + young + " Force[f=9.0]",
                            "1F set " + old + " Force[f=2.0] to Force[f=3.0]",
                            "3F set " + old + " Force[f=2.0] to Force[f=3.0]",
                            "1F remove " + old + " Force[f=3.0]",
                            "2P remove " + old + " Position[x=0.0, y=0.0]",
                            "3F remove " + old + " Force[f=3.0]"),
                    lines);
        }
    }

    /** On each of the three, the same. */
    private static <T extends Record> Observer<T> each(BiConsumer<String, Change<T>> body) {
        return new Observer<>() {
            @Override
            public void added(Change<T> change) {
                body.accept("add", change);
            }

            @Override
            public void set(Change<T> change) {
                body.accept("set", change);
            }

            @Override
            public void removed(Change<T> change) {
                body.accept("remove", change);
            }
        };
    }

    @Test
    void anObserverAsksAndDoesNotChange() {
        try (World world = World.builder().workers(1).build()) {
            Query all = world.query();
            long other = world.spawn(new Tag());
            List<Runnable> refused =
                    List.of(
                            () -> world.spawn(new Tag()),
                            () -> world.add(other, new Force(1)),
                            () -> world.set(other, new Tag()),
                            () -> world.remove(other, TAG),
                            () -> world.clear(other),
                            () -> world.delete(other),
                            () -> all.chunkCount(),
                            () -> world.step(1),
                            () -> world.save(),
                            world::close,
                            () -> world.unobserve(TAG, new Log<>("", List.of())));
            int[] count = new int[1];
            world.observe(
                    POSITION,
                    each((what, change) -> {
                        for (Runnable call : refused) {
                            assertTeaches(
                                    IllegalStateException.class,
                                    call::run,
                                    "observer",
                                    "change.commands()");
                            count[0]++;
                        }
                    }));
            long digest = world.digest();
            long entity = world.spawn(new Position(1, 1));
            world.set(entity, new Position(2, 2));
            world.delete(entity);
            assertEquals(3 * refused.size(), count[0]);
            assertEquals(1, world.entityCount());
            assertTrue(world.isAlive(other) && digest != 0);
        }
    }

    /** What observers ask for comes after the tick's own commands, and is told in turn. */
    @Test
    void whatIsAskedForIsMadeAndTold() {
        List<String> lines = new ArrayList<>();
        long[] handle = new long[1];
        WorldSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> {
                            tick.commands().spawn(new Position(1, 0));
                            tick.commands().spawn(new Position(2, 0));
                        });
        try (World world = World.builder().systems(system).workers(1).build()) {
            world.observe(
                    POSITION,
                    each((what, change) -> {
                        lines.add(what + " position " + change.value(X));
                        handle[0] = change.commands().spawn(new Force((float) change.value(X)));
                        change.commands().add(change.entity(), new Tag());
                    }));
            world.observe(
                    FORCE,
                    each((what, change) -> {
                        lines.add(what + " force " + change.value(FORCE_F));
                        if (change.value(FORCE_F) < 10) {
                            change.commands().set(change.entity(), new Force(11));
                        }
                    }));
            world.observe(TAG, each((what, change) -> lines.add(what + " tag")));
            world.step(1);
            assertEquals(
                    List.of(
                            "add position 1.0",
                            "add position 2.0",
                            "add force 1.0",
                            "add tag",
                            "add force 2.0",
                            "add tag",
                            "set force 11.0",
                            "set force 11.0"),
                    lines);
            assertEquals(new Force(11), world.get(world.resolve(handle[0]), FORCE));
            lines.clear();
            long direct = world.spawn(new Position(3, 0));
            assertEquals(
                    List.of("add position 3.0", "add force 3.0", "add tag", "set force 11.0"),
                    lines);
            assertTrue(world.has(direct, TAG), "made before spawn returns");
        }
    }

    @Test
    void aCircleOfObserversEnds() {
        try (World world = World.builder().workers(1).build()) {
            world.observe(
                    FORCE,
                    each((what, change) -> change.commands().set(change.entity(), new Force(1))));
            assertTeaches(
                    IllegalStateException.class, () -> world.spawn(new Force(0)), "1000", "Force");
            assertEquals(1, world.entityCount());
        }
    }

    @Test
    void anObserverThatThrowsKeepsNobodyElse() {
        WorldSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> tick.commands().spawn(new Tag(), new Force(1)));
        List<String> lines = new ArrayList<>();
        try (World world = World.builder().systems(system).workers(1).build()) {
            WorldState before = world.save();
            world.observe(
                    TAG,
                    each((what, change) -> {
                        throw new ArithmeticException("seven");
                    }));
            world.observe(FORCE, new Log<>("F", lines));
            assertTeaches(
                    IllegalStateException.class,
                    () -> world.spawn(new Tag(), new Force(2)),
                    "ObserverTest",
                    "Tag",
                    "seven");
            assertEquals(1, world.entityCount(), "made");
            Exception failed = assertThrows(WorldFailedException.class, () -> world.step(1));
            assertTrue(failed.getMessage().contains("tick 1"), failed.getMessage());
            assertTrue(failed.getMessage().contains("observer"), failed.getMessage());
            assertTrue(failed.getMessage().contains("seven"), failed.getMessage());
            assertSame(ArithmeticException.class, failed.getCause().getClass());
            assertEquals(2, lines.size(), lines::toString);
            assertTrue(world.hasFailed());
            assertEquals(2, world.entityCount(), "all commands of the tick are made");
            assertTeaches(WorldFailedException.class, () -> world.step(1), "tick 1");
            world.restore(before);
            assertFalse(world.hasFailed());
        }
    }

    /** A restored state has what observers had asked for; they hear nothing of it. */
    @Test
    void restoringTellsNobody() {
        List<String> lines = new ArrayList<>();
        Observer<Position> leaves =
                each((what, change) -> {
                    lines.add(what);
                    if (what.equals("add")) {
                        change.commands().add(change.entity(), new Tag());
                    }
                });
        WorldSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> tick.commands().spawn(new Position(tick.number(), 0)));
        try (World world = World.builder().systems(system).workers(1).build();
                World fork = World.builder().systems(system).workers(1).build();
                World without = World.builder().systems(system).workers(1).build()) {
            world.observe(POSITION, leaves);
            world.step(1);
            WorldState state = world.save();
            assertEquals(List.of("add"), lines);
            List<Long> one = future(world);
            lines.clear();
            world.restore(state);
            fork.putObserversOf(world);
            fork.restore(state);
            without.restore(state);
            assertEquals(List.of(), lines, "restoring tells nobody");
            assertEquals(1, world.query(TAG).entityCount());
            assertEquals(one, future(world), "observers stay");
            assertEquals(one, future(fork), "a fork has the same");
            assertFalse(one.equals(future(without)), "they are no part of the state");
            assertTrue(world.unobserve(POSITION, leaves));
            assertFalse(world.unobserve(POSITION, leaves));
            lines.clear();
            world.step(1);
            assertEquals(List.of(), lines);
        }
    }

    private static List<Long> future(World world) {
        List<Long> digests = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            world.step(1);
            digests.add(world.digest());
        }
        return digests;
    }

    @Test
    void aChangeTeaches() {
        List<Change<Position>> kept = new ArrayList<>();
        try (World world = World.builder().workers(1).build()) {
            Observer<Position> observer =
                    each((what, change) -> {
                        kept.add(change);
                        assertTeaches(
                                ComponentException.class,
                                () -> change.value(F),
                                "Force.f",
                                "Position",
                                "get");
                        if (!what.equals("set")) {
                            assertTeaches(
                                    IllegalStateException.class,
                                    () -> change.previous(X),
                                    "previous",
                                    "value");
                        }
                    });
            world.observe(POSITION, observer);
            assertTeaches(
                    IllegalStateException.class,
                    () -> world.observe(POSITION, observer),
                    "already",
                    "twice");
            world.delete(world.spawn(new Position(1, 2)));
            assertEquals(2, kept.size());
            for (Runnable call :
                    List.<Runnable>of(
                            () -> kept.get(0).entity(),
                            () -> kept.get(0).value(X),
                            () -> kept.get(0).value(),
                            () -> kept.get(0).commands())) {
                assertTeaches(IllegalStateException.class, call::run, "over", "Position");
            }
            assertThrows(NullPointerException.class, () -> world.observe(POSITION, null));
        }
    }

    /** Told of sets, adds and removes, reading values and asking for more: no garbage. */
    @Test
    void callsAllocateNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long[] entities = new long[50];
        Record[] forces = {new Force(1), new Force(2)};
        Record position = new Position(3, 4);
        Record tag = new Tag();
        double[] sum = new double[1];
        WorldSystem system =
                world(
                        "s",
                        a -> a.commands(),
                        tick -> {
                            for (int i = 0; i < entities.length; i++) {
                                tick.commands().set(entities[i], forces[i & 1]);
                                if ((tick.number() & 1) == 0) {
                                    tick.commands().add(entities[i], tag);
                                } else {
                                    tick.commands().remove(entities[i], TAG);
                                }
                            }
                        });
        Observer<Force> observer =
                new Observer<>() {
                    @Override
                    public void set(Change<Force> change) {
                        sum[0] += change.value(FORCE_F) + change.previous(FORCE_F);
                        change.commands().set(change.entity(), position);
                    }
                };
        Observer<Tag> tags =
                new Observer<>() {
                    @Override
                    public void added(Change<Tag> change) {
                        sum[0]++;
                    }

                    @Override
                    public void removed(Change<Tag> change) {
                        sum[0] += change.entity();
                    }
                };
        try (World world = World.builder().systems(system).workers(1).build()) {
            world.observe(FORCE, observer);
            world.observe(TAG, tags);
            for (int i = 0; i < entities.length; i++) {
                entities[i] = world.spawn(new Position(0, 0), new Force(0), new Tag());
            }
            boolean quiet = false;
            List<Long> seen = new ArrayList<>();
            steps(world, 2000);
            for (int i = 0; !quiet && i < 5; i++) {
                long first = threads.getCurrentThreadAllocatedBytes();
                long before = threads.getCurrentThreadAllocatedBytes();
                steps(world, 1000);
                long bytes = threads.getCurrentThreadAllocatedBytes() - before - (before - first);
                quiet = bytes == 0;
                seen.add(bytes);
            }
            assertTrue(quiet, "bytes in each thousand ticks: " + seen);
            assertTrue(sum[0] > 0);
        }
    }

    private static void steps(World world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(1);
        }
    }
}
