package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a user may do with a world between steps, and what is refused. */
class WorldTest {
    private static final Mixed VALUE =
            new Mixed(-0.0, 2.5f, Long.MIN_VALUE, -7, true, (byte) -5, (short) -600, 'ß', "text");

    private final World world = World.builder().workers(1).build();

    @AfterEach
    void close() {
        world.close();
    }

    @Test
    void everyKindOfFieldComesBackAsItWent() {
        long entity = world.spawn(VALUE);
        assertEquals(VALUE, world.get(entity, MIXED));
        Chunk chunk = world.query(MIXED).chunk(0);
        assertEquals(1, chunk.in(MIXED.intField("flag"))[0]);
        assertEquals(-5, chunk.in(MIXED.intField("small"))[0]);
        assertEquals("text", chunk.in(MIXED.objectField("text", String.class))[0]);
        assertEquals("text", chunk.in(MIXED.objectField("text"))[0]);
    }

    @Test
    void componentsCanBeAddedRemovedReplacedAndCleared() {
        long entity = world.spawn(new Position(1, 2));
        world.add(entity, new Velocity(3, 4));
        world.set(entity, new Position(5, 6));
        assertEquals(new Position(5, 6), world.get(entity, POSITION));
        assertEquals(new Velocity(3, 4), world.get(entity, VELOCITY));
        world.remove(entity, POSITION);
        assertFalse(world.has(entity, POSITION));
        assertEquals(new Velocity(3, 4), world.get(entity, VELOCITY));
        world.clear(entity);
        assertFalse(world.has(entity, VELOCITY));
        assertTrue(world.isAlive(entity));
    }

    @Test
    void anIdIsReusedUnderAnotherGeneration() {
        long first = world.spawn(new Tag());
        long second = world.spawn(new Tag());
        world.delete(first);
        world.delete(second);
        long third = world.spawn(new Tag());
        assertEquals(Entities.index(second), Entities.index(third), "last in, first out");
        assertEquals(2, Entities.generation(third));
        assertFalse(world.isAlive(second));
        assertTrue(world.isAlive(third));
        assertFalse(world.isAlive(Entities.NONE));
        assertFalse(world.isAlive(-1));
        assertEquals(1, world.entityCount());
        assertEquals("1v2", Entities.toString(third));
    }

    @Test
    void manyAtOnceFillSeveralChunks() {
        long[] entities = world.spawnMany(2500, new Position(1, 2), new Velocity(3, 4));
        Query query = world.query(POSITION, VELOCITY);
        assertEquals(3, query.chunkCount());
        assertEquals(2500, query.entityCount());
        assertEquals(entities[2499], query.chunk(2).entity(451));
        for (long entity : entities) {
            world.delete(entity);
        }
        assertEquals(0, query.chunkCount());
        assertEquals(0, world.spawnMany(0, new Tag()).length);
    }

    @Test
    void queriesIncludeAndExclude() {
        world.spawn(new Position(0, 0));
        world.spawn(new Position(0, 0), new Tag());
        world.spawn(new Tag());
        Query positions = world.query(POSITION);
        Query plain = positions.exclude(TAG);
        assertEquals(2, positions.entityCount());
        assertEquals(1, plain.entityCount());
        assertFalse(plain.chunk(0).has(TAG));
        world.spawn(new Position(0, 0), new Velocity(0, 0));
        assertEquals(2, plain.entityCount(), "a query sees tables that came later");
        assertEquals(4, world.query().entityCount());
    }

    @Test
    void aQueryEditsInPlace() {
        long entity = world.spawn(new Position(1, 2));
        Query query = world.query(POSITION);
        query.chunk(0).out(X)[0] = 9;
        assertEquals(new Position(9, 2), world.get(entity, POSITION));
    }

    @Test
    void resourcesAreFoundByClass() {
        world.putResource("text");
        world.putResource(CharSequence.class, "other");
        assertEquals("text", world.resource(String.class));
        assertEquals("other", world.resource(CharSequence.class));
        assertTeaches(
                ComponentException.class, () -> world.resource(Integer.class), "Integer", "put");
        assertTeaches(NullPointerException.class, () -> world.putResource(null), "resource");
    }

    @Test
    void badCallsTeachAndChangeNothing() {
        long entity = world.spawn(new Position(1, 2));
        long dead = world.spawn(new Tag());
        world.delete(dead);
        long before = world.digest();
        assertTeaches(DeadEntityException.class, () -> world.delete(dead), "1v1", "not alive");
        assertTeaches(DeadEntityException.class, () -> world.get(dead, TAG), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.has(dead, TAG), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.add(dead, new Tag()), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.clear(dead), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.set(dead, new Tag()), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.remove(dead, TAG), "1v1");
        assertTeaches(DeadEntityException.class, () -> world.delete(Long.MAX_VALUE), "alive");
        assertTeaches(DeadEntityException.class, () -> world.resolve(entity), "handle");
        assertTeaches(ComponentException.class, () -> world.add(entity, new Position(3, 4)), "set");
        assertTeaches(ComponentException.class, () -> world.set(entity, new Tag()), "Tag", "add");
        assertTeaches(ComponentException.class, () -> world.get(entity, TAG), "Tag", "has");
        assertTeaches(ComponentException.class, () -> world.remove(entity, TAG), "Tag");
        assertTeaches(
                ComponentException.class, () -> world.spawn(new Tag(), new Tag()), "Tag", "twice");
        assertTeaches(
                ComponentException.class,
                () -> world.spawn(new Tag(), new Force(1), new Tag()),
                "Tag",
                "twice");
        assertTeaches(NullPointerException.class, () -> world.spawn(new Tag(), null), "null");
        assertTeaches(NullPointerException.class, () -> world.spawn((Record) null), "null");
        assertTeaches(NullPointerException.class, () -> world.add(entity, null), "null");
        assertTeaches(NullPointerException.class, () -> world.get(entity, null), "null");
        assertTeaches(NullPointerException.class, () -> world.query((Component<?>) null), "null");
        assertTeaches(
                IllegalArgumentException.class, () -> world.spawnMany(-1, new Tag()), "-1", "0");
        assertEquals(before, world.digest());
        assertEquals(new Position(1, 2), world.get(entity, POSITION));
    }

    @Test
    void unknownFieldsTeach() {
        assertTeaches(ComponentException.class, () -> POSITION.doubleField("z"), "'z'", "x, y");
        assertTeaches(
                ComponentException.class, () -> POSITION.floatField("x"), "Position.x", "double");
        assertTeaches(
                ComponentException.class,
                () -> MIXED.objectField("text", Integer.class),
                "Mixed.text",
                "String");
        assertTeaches(NullPointerException.class, () -> POSITION.doubleField(null), "name");
        assertTeaches(NullPointerException.class, () -> Component.of(null), "type");
        assertTeaches(ComponentException.class, () -> TAG.intField("a"), "no fields");
        assertSame(POSITION, Component.of(Position.class));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY, -0.0})
    void aBadStepIsRefused(double step) {
        long before = world.digest();
        assertTeaches(IllegalArgumentException.class, () -> world.step(step), "" + step, "above 0");
        assertEquals(before, world.digest());
        world.step(0.5);
        assertEquals(1, world.tickNumber());
        assertEquals(0.5, world.stepSeconds());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -3, 1000})
    void aBadNumberOfWorkersIsRefused(int workers) {
        assertTeaches(
                IllegalArgumentException.class,
                () -> World.builder().workers(workers),
                "" + workers,
                "[1, " + Jobs.MAX_WORKERS + "]");
    }

    @Test
    void aClosedWorldCanBeReadAndNothingElse() {
        long entity = world.spawn(new Position(1, 2));
        world.close();
        world.close();
        assertTeaches(WorldClosedException.class, () -> world.step(1), "step", "closed");
        assertTeaches(WorldClosedException.class, () -> world.spawn(new Tag()), "closed");
        assertEquals(new Position(1, 2), world.get(entity, POSITION));
    }

    @Test
    void sharedJobsAreNotClosed() {
        try (Jobs jobs = Jobs.of(2)) {
            World.builder().jobs(jobs).build().close();
            int[] count = new int[2];
            jobs.run((block, worker) -> count[block]++, 2);
            assertArrayEquals(new int[] {1, 1}, count);
            assertThrows(
                    IllegalStateException.class,
                    () -> World.builder().jobs(jobs).workers(1).build());
        }
    }

    @Test
    void aDeletedEntityKeepsNoObjectAlive() {
        long entity = world.spawn(VALUE);
        Query query = world.query(MIXED);
        Chunk chunk = query.chunk(0);
        world.delete(entity);
        assertEquals(null, chunk.in(MIXED.objectField("text"))[0]);
    }

    static <E extends Throwable> E assertTeaches(
            Class<E> type, org.junit.jupiter.api.function.Executable call, String... words) {
        E failure = assertThrows(type, call);
        for (String word : words) {
            assertTrue(
                    String.valueOf(failure.getMessage()).contains(word),
                    () -> "'" + word + "' is missing in: " + failure.getMessage());
        }
        return failure;
    }

    @Test
    void tellsWhenAnEntityOfAKindLastWent() {
        assertEquals(-1, world.lastDeparture(POSITION), "nobody was there");
        long kept = world.spawn(new Position(1, 2));
        long gone = world.spawn(new Position(1, 2));
        world.step(0.01);
        assertEquals(-1, world.lastDeparture(POSITION), "coming is no going");
        world.set(kept, new Position(3, 4));
        world.delete(world.spawn(new Velocity(3, 4)));
        assertEquals(-1, world.lastDeparture(POSITION), "of another kind");
        assertEquals(1, world.lastDeparture(VELOCITY));
        world.step(0.01);
        world.delete(gone);
        assertEquals(2, world.lastDeparture(POSITION), "after tick 2");
        var before = world.save();
        world.step(0.01);
        world.remove(kept, POSITION);
        assertEquals(3, world.lastDeparture(POSITION), "lost its component");
        world.restore(before);
        assertEquals(2, world.lastDeparture(POSITION), "part of the state");
    }
}
