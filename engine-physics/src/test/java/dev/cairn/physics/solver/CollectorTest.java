package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.BouncingContacts;
import dev.cairn.physics.solver.graph.Collector;
import dev.cairn.physics.solver.graph.Colouring;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.Random;

/** What the collector keeps from tick to tick is what it would make anew. */
final class CollectorTest {
    private static final int BODIES = 400;
    private static final int ROWS = 1500;

    /** Some of the islands have as many contacts. */
    private static final int FLOATS_FROM = 120;

    private final Random random = new Random(20261122);
    private final BodyStore bodies = new BodyStore();
    private final ContactStore contacts = new ContactStore();

    private final Jobs jobs = Jobs.of(2);

    @AfterEach
    void close() {
        jobs.close();
    }

    @Test
    void whatPersistsIsAFunctionOfThePresentContacts() {
        System.out.println("seed 20261122");
        bodies.ensureCapacity(BODIES);
        bodies.slotCount = BODIES;
        for (int i = 0; i < BODIES; i++) {
            bodies.kind[i] = i < 5 ? BodyStore.STATIC : BodyStore.DYNAMIC;
        }
        contacts.ensureCapacity(ROWS);
        contacts.count = ROWS;
        contacts.activateAll();
        for (int row = 0; row < ROWS; row++) {
            meet(row);
        }
        Made kept = new Made();
        for (int round = 0; round < 60; round++) {
            // every other round nothing, one kind of change, or several at once
            int changes = round % 2 == 0 ? 0 : 1 + random.nextInt(15);
            for (int n = 0; n < 20; n++) {
                int row = random.nextInt(ROWS);
                if ((changes & 1) != 0) {
                    press(row);
                }
                if ((changes & 2) != 0 && contacts.pointCount[row] > 0) {
                    contacts.pointCount[row] = 1 + random.nextInt(ContactStore.POINTS);
                }
                if ((changes & 4) != 0) {
                    meet(row);
                }
                if ((changes & 8) != 0) {
                    contacts.restitution[row] = random.nextInt(round % 8 == 1 ? 2 : 1);
                }
            }
            Made fresh = new Made();
            fresh.run();
            kept.run();
            fresh.assertSame(kept, "round " + round + ", changes " + changes);
        }
    }

    private void meet(int row) {
        // islands of forty bodies
        int first = random.nextInt(BODIES / 40) * 40;
        int a = first + random.nextInt(40);
        int b = first + random.nextInt(40);
        boolean held = a < 5 && b < 5;
        contacts.bodyA[row] = a;
        contacts.bodyB[row] = held || a == b ? first + (a - first + 7) % 40 : b;
        contacts.pointCount[row] = random.nextInt(ContactStore.POINTS + 1);
        press(row);
    }

    private void press(int row) {
        int p = ContactStore.POINTS * row;
        Arrays.fill(
                contacts.normalImpulse,
                p,
                p + ContactStore.POINTS,
                random.nextBoolean() ? 0 : random.nextDouble());
    }

    /** A collector with what it fills. */
    private final class Made {
        final Colouring colouring = new Colouring();
        final Batches batches = new Batches();
        final Collector collector =
                new Collector(colouring, batches, new Assemblies(new EdgeList()), true);
        final EdgeList list = new EdgeList(8, 8, 4, 4);
        final int[] guide = new int[BODIES];

        void run() {
            collector.run(bodies, contacts, list, guide, 2, FLOATS_FROM, jobs);
        }

        void assertSame(Made other, String where) {
            assertEquals(list.count, other.list.count, where);
            same(list.source, other.list.source, list.count, where + ", source");
            same(list.place, other.list.place, list.count, where + ", place");
            for (int m = 0; m < list.count; m++) {
                assertEquals(list.isSingle[m], other.list.isSingle[m], where + ", precision");
            }
            same(list.floats, other.list.floats, where + ", floats");
            same(list.doubles, other.list.doubles, where + ", doubles");
            same(guide, other.guide, BODIES, where + ", guide");
            assertEquals(colouring.colours, other.colouring.colours, where);
            same(colouring.kind, other.colouring.kind, colouring.colours, where + ", kind");
            same(colouring.start, other.colouring.start, colouring.colours, where + ", start");
            same(colouring.end, other.colouring.end, colouring.colours, where + ", end");
            same(colouring.size, other.colouring.size, colouring.colours, where + ", size");
            assertEquals(batches.count, other.batches.count, where);
            same(
                    colouring.firstColour,
                    other.colouring.firstColour,
                    batches.count + 1,
                    where + ", first colour");
            for (int b = 0; b < batches.count; b++) {
                BouncingContacts mine = collector.bouncing;
                BouncingContacts theirs = other.collector.bouncing;
                assertEquals(mine.from(b), theirs.from(b), where + ", bouncing");
                assertEquals(mine.to(b), theirs.to(b), where + ", bouncing");
                for (int k = mine.from(b); k < mine.to(b); k++) {
                    assertEquals(mine.row[k], theirs.row[k], where + ", bouncer");
                }
            }
            int bound = batches.firstBody[batches.count];
            same(batches.order, other.batches.order, bound, where + ", order");
        }

        private void same(ConstraintRows expected, ConstraintRows actual, String where) {
            assertEquals(expected.places, actual.places, where);
            int links = expected.places * ConstraintRows.LINK;
            same(expected.link, actual.link, links, where + ", link");
        }

        private void same(int[] expected, int[] actual, int n, String where) {
            assertArrayEquals(Arrays.copyOf(expected, n), Arrays.copyOf(actual, n), where);
        }
    }
}
