package dev.cairn.core.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.World;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;

/** Which two poses a reader gets for each entity, and that they are whole and never go back. */
@Timeout(60)
class SnapshotExchangeTest {
    private final World world = World.builder().workers(1).build();
    private final SnapshotExchange exchange = new SnapshotExchange();

    @AfterEach
    void close() {
        world.close();
    }

    private PoseSnapshot step() {
        world.step(0.25);
        exchange.publish(world);
        return exchange.latest();
    }

    private static int row(PoseSnapshot snapshot, long entity) {
        for (int row = 0; row < snapshot.size(); row++) {
            if (snapshot.entity(row) == entity) {
                return row;
            }
        }
        return -1;
    }

    private static void assertX(double previous, double current, PoseSnapshot s, long entity) {
        int at = row(s, entity) * PoseSnapshot.STRIDE;
        assertEquals(previous, s.previous()[at], "previous");
        assertEquals(current, s.current()[at], "current");
    }

    private void place(long entity, double x, int jumps) {
        world.set(entity, new Pose(x, 0, 0, 0, 0, 0, 1, jumps));
    }

    @Test
    void beforeTheFirstPublicationThereIsAnEmptySnapshot() {
        assertEquals(-1, exchange.latest().tick());
        assertEquals(0, exchange.latest().size());
        assertThrows(IndexOutOfBoundsException.class, () -> exchange.latest().entity(0));
    }

    @Test
    void onlyVisibleEntitiesAreInIt() {
        long visible = world.spawn(Pose.at(1, 2, 3), new Visual("ball"));
        world.spawn(Pose.at(4, 5, 6));
        world.spawn(new Visual("nowhere"));
        PoseSnapshot s = step();
        assertEquals(1, s.size());
        assertEquals(visible, s.entity(0));
        assertEquals("ball", s.model(0));
        assertEquals(1, s.tick());
        assertEquals(0.25, s.stepSeconds());
        double[] pose = java.util.Arrays.copyOf(s.current(), PoseSnapshot.STRIDE);
        assertArrayEquals(new double[] {1, 2, 3, 0, 0, 0, 1}, pose);
        assertThrows(NullPointerException.class, () -> new Visual(null));
    }

    @Test
    void previousIsTheTickBefore() {
        long entity = world.spawn(Pose.at(0, 0, 0), new Visual("m"));
        assertX(0, 0, step(), entity);
        place(entity, 1, 0);
        assertX(0, 1, step(), entity);
        place(entity, 3, 0);
        assertX(1, 3, step(), entity);
        assertX(3, 3, step(), entity);
    }

    @Test
    void entitiesAreMatchedAcrossRows() {
        long a = world.spawn(Pose.at(1, 0, 0), new Visual("a"));
        long b = world.spawn(Pose.at(2, 0, 0), new Visual("b"));
        long c = world.spawn(Pose.at(3, 0, 0), new Visual("c"));
        step();
        world.delete(a);
        place(c, 30, 0);
        PoseSnapshot s = step();
        assertEquals(0, row(s, c), "c moved into the row of a");
        assertX(3, 30, s, c);
        assertX(2, 2, s, b);
        assertEquals("c", s.model(0));
        assertEquals(2, s.size());
    }

    @Test
    void theNewbornTheReusedAndTheTeleportedDoNotSmear() {
        long entity = world.spawn(Pose.at(1, 0, 0), new Visual("m"));
        step();
        place(entity, 100, 1);
        assertX(100, 100, step(), entity);
        place(entity, 101, 1);
        assertX(100, 101, step(), entity);
        world.delete(entity);
        long reborn = world.spawn(Pose.at(7, 0, 0), new Visual("m"));
        assertX(7, 7, step(), reborn);
        world.remove(reborn, Visual.COMPONENT);
        assertEquals(0, step().size());
        world.add(reborn, new Visual("m"));
        place(reborn, 50, 0);
        assertX(50, 50, step(), reborn);
    }

    @Test
    void publishingATickTwiceKeepsThePreviousPoses() {
        long entity = world.spawn(Pose.at(1, 0, 0), new Visual("m"));
        step();
        place(entity, 2, 0);
        assertX(1, 2, step(), entity);
        exchange.publish(world);
        assertX(1, 2, exchange.latest(), entity);
        place(entity, 9, 1);
        exchange.publish(world);
        assertX(9, 9, exchange.latest(), entity);
    }

    @Test
    void aReaderKeepsItsSnapshot() {
        world.spawn(Pose.at(1, 0, 0), new Visual("m"));
        PoseSnapshot s = step();
        assertSame(s, exchange.latest());
        for (int i = 0; i < 5; i++) {
            world.step(1);
            exchange.publish(world);
            assertEquals(1, s.tick());
        }
        assertNotEquals(s, exchange.latest());
        assertEquals(6, exchange.latest().tick());
    }

    @Test
    void anotherWorldStartsAnew() {
        world.spawn(Pose.at(1, 0, 0), new Visual("m"));
        step();
        try (World other = World.builder().workers(1).build()) {
            long entity = other.spawn(Pose.at(5, 0, 0), new Visual("m"));
            other.step(1);
            exchange.publish(other);
            assertX(5, 5, exchange.latest(), entity);
        }
    }

    @Test
    void aReaderSeesWholeTicksThatNeverGoBack() throws InterruptedException {
        int entities = 200;
        int ticks = 3000;
        long[] ids = new long[entities];
        for (int i = 0; i < entities; i++) {
            ids[i] = world.spawn(Pose.at(0, 0, 0), new Visual("m"));
        }
        AtomicBoolean done = new AtomicBoolean();
        AtomicReference<String> wrong = new AtomicReference<>();
        long[] seen = new long[1];
        Thread reader =
                new Thread(() -> {
                    long last = -1;
                    boolean end;
                    do {
                        end = done.get();
                        PoseSnapshot s = exchange.latest();
                        if (s.tick() < last) {
                            wrong.set(last + " was followed by " + s.tick());
                        }
                        seen[0] += s.tick() == last ? 0 : 1;
                        last = s.tick();
                        check(s, wrong);
                    } while (!end && wrong.get() == null);
                    if (last != ticks && wrong.get() == null) {
                        wrong.set("the last seen was " + last);
                    }
                });
        reader.start();
        for (int tick = 1; tick <= ticks; tick++) {
            for (long id : ids) {
                place(id, tick, 0);
            }
            world.step(1);
            exchange.publish(world);
        }
        done.set(true);
        reader.join();
        assertNull(wrong.get());
        assertTrue(seen[0] > 1, "saw " + seen[0] + " ticks");
    }

    private static void check(PoseSnapshot s, AtomicReference<String> wrong) {
        for (int row = 0; row < s.size(); row++) {
            double current = s.current()[row * PoseSnapshot.STRIDE];
            double previous = s.previous()[row * PoseSnapshot.STRIDE];
            if (current != s.tick() || previous != Math.max(1, s.tick() - 1)) {
                wrong.set("tick " + s.tick() + " row " + row + ": " + previous + ", " + current);
                return;
            }
        }
    }
}
