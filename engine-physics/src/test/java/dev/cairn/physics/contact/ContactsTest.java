package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Inside;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.state.RigidBody;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

class ContactsTest {

    /** The snippet that the design shows to users. */
    @Test
    void aCrateFallsOnTheGroundAndRests() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, -9.81, 0).workers(2).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
            BodyRef crate =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 4, 0)
                                    .material(Material.WOOD));
            for (int tick = 0; tick < 240; tick++) {
                world.step(1.0 / 60.0);
            }
            assertEquals(0, crate.position().x, 1e-3);
            assertEquals(0.5, crate.position().y, 5e-3);
            assertEquals(0, crate.position().z, 1e-3);
            assertTrue(crate.velocity().length() < 1e-3, crate.velocity().toString());
        }
    }

    /**
     * What a contact of a body that is awake tells was written in the tick: a number that nobody
     * can mistake is put in its place before, also where bodies fall asleep, are woken, thrown, or
     * lose what they stand on.
     */
    @Test
    void aContactTellsTheImpulseOfItsOwnTick() {
        final double stale = 1e300;
        Random random = new Random(91);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(2).build()) {
            Scenes.everyKindOnEveryKind(world);
            BodyRef table =
                    world.add(Body.fixed().shape(Box.ofHalfExtents(2, .5, 2)).at(-8, .5, 0));
            List<BodyRef> boxes = new ArrayList<>();
            for (int i = 0; i < 12; i++) {
                double x = -8.6 + .6 * (i % 3);
                boxes.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(.25))
                                        .at(x, 1.3 + .5 * (i / 3), 0)));
            }
            ContactStore c = Inside.contacts(world);
            int told = 0;
            int kept = 0;
            for (int tick = 0; tick < 900; tick++) {
                BodyRef box = boxes.get(random.nextInt(boxes.size()));
                switch (tick % 150) {
                    case 100 -> table.teleport(-8, .5 - .01 * random.nextDouble(), 0);
                    case 110 -> box.setVelocity(0, 2 * random.nextDouble(), 0);
                    case 120 -> box.teleport(-8, 4, 0);
                    case 140 -> world.setGravity(0, tick < 450 ? 1e-3 : -9.81, 0);
                    default -> {}
                }
                Arrays.fill(c.totalNormalImpulse, stale);
                world.step(Scenes.STEP);
                byte[] kind = Inside.bodies(world).kind;
                for (int row = 0; row < c.count; row++) {
                    boolean awake =
                            kind[c.bodyA[row]] == BodyStore.DYNAMIC
                                    || kind[c.bodyB[row]] == BodyStore.DYNAMIC;
                    for (int p = 0; p < c.pointCount[row]; p++) {
                        double sum = c.totalNormalImpulse[ContactStore.POINTS * row + p];
                        assertTrue(!awake || sum < stale, "tick " + tick + " row " + row);
                        told += awake ? 1 : 0;
                        kept += sum < stale ? 0 : 1;
                    }
                }
            }
            assertTrue(told > 10_000 && kept > 1_000, told + " told, " + kept + " asleep");
        }
    }

    @Test
    void aRestingCrateIsCarriedByItsWeight() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef crate = Scenes.stack(world, 1).get(0);
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            Contacts contacts = world.contacts();
            assertEquals(1, contacts.count());
            assertEquals(4, contacts.pointCount(0));
            assertTrue(contacts.touching(0));
            double impulse = 0;
            for (int p = 0; p < 4; p++) {
                impulse += contacts.normalImpulse(0, p);
                Vector3d point = contacts.point(0, p, new Vector3d());
                assertEquals(0.5, Math.abs(point.x), 1e-2);
                assertEquals(0, point.y, 1e-2);
                assertEquals(0, contacts.separation(0, p), 5e-3);
            }
            double weight = crate.mass() * 9.81 * Scenes.STEP;
            assertEquals(weight, impulse, 1e-3 * weight);
            assertEquals(1, Math.abs(contacts.normal(0, new Vector3d()).y), 1e-9);
            assertThrows(IndexOutOfBoundsException.class, () -> contacts.bodyA(1));
            assertThrows(IndexOutOfBoundsException.class, () -> contacts.separation(0, 4));
        }
    }

    @Test
    void beginsOnceAndEndsOnceWhenTheBodyIsThrownUp() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef crate =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 1, 0)
                                    .name("crate"));
            BodyRef ground = Scenes.ground(world);
            int began = 0;
            int ended = 0;
            for (int tick = 0; tick < 180; tick++) {
                if (tick == 120) {
                    crate.setVelocity(0, 8, 0);
                }
                world.step(Scenes.STEP);
                began += world.contacts().began().count();
                ended += world.contacts().ended().count();
                if (tick == 119) {
                    assertEquals(1, began);
                    assertEquals(0, ended);
                }
            }
            assertEquals(1, began);
            assertEquals(1, ended);
            assertFalse(ground.toString().isEmpty());
        }
    }

    @Test
    void removingABodyEndsItsContacts() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            List<BodyRef> boxes = Scenes.stack(world, 2);
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
            }
            BodyRef upper = boxes.get(1);
            upper.remove();
            BodyRef other = world.add(Body.dynamic().shape(Sphere.of(0.1)).at(9, 9, 9));
            world.step(Scenes.STEP);
            Contacts.Events ended = world.contacts().ended();
            assertEquals(1, ended.count());
            assertTrue(ended.bodyA(0) == upper || ended.bodyB(0) == upper);
            assertFalse(upper.isAlive());
            assertTrue(other.isAlive());
        }
    }

    @Test
    void deletingTheEntityRemovesTheBodyAndNothingLeaks() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef ground = Scenes.ground(world);
            int slots = 0;
            for (int round = 0; round < 50; round++) {
                BodyRef crate =
                        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
                assertSame(crate, world.bodyOf(crate.entity()));
                world.step(Scenes.STEP);
                world.step(Scenes.STEP);
                assertEquals(1, world.contacts().count());
                world.ecs().delete(crate.entity());
                assertFalse(crate.isAlive());
                assertNull(world.bodyOf(crate.entity()));
                world.step(Scenes.STEP);
                assertEquals(0, world.contacts().count());
                assertEquals(1, world.contacts().ended().count());
                slots = Math.max(slots, Inside.slot(crate) + 1);
            }
            assertEquals(2, slots, "slots are used again");
            assertEquals(1, world.bodyCount());
            assertEquals(List.of(ground), world.bodies());
            world.ecs().delete(ground.entity());
            world.step(Scenes.STEP);
            assertEquals(0, world.bodyCount());
        }
    }

    @Test
    void takingAComponentOfTheBodyAwayEndsIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef first = world.add(Body.dynamic().shape(Sphere.of(1)).at(0, 10, 0));
            BodyRef second = world.add(Body.dynamic().shape(Sphere.of(1)).at(5, 10, 0));
            world.ecs().remove(first.entity(), RigidBody.COMPONENT);
            world.ecs().clear(second.entity());
            world.step(Scenes.STEP);
            assertFalse(first.isAlive());
            assertFalse(second.isAlive());
            assertTrue(world.ecs().isAlive(first.entity()));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {51, 52})
    void eventsArePairedThroughChurn(long seed) {
        Random random = new Random(seed);
        Set<Long> open = new HashSet<>();
        int total = 0;
        try (PhysicsWorld world = Scenes.awake().workers(2).build()) {
            Scenes.ground(world);
            List<BodyRef> bodies = new ArrayList<>();
            for (int tick = 0; tick < 300; tick++) {
                if (bodies.size() < 40) {
                    bodies.add(world.add(Scenes.any(random, tick)));
                }
                if (random.nextInt(4) == 0) {
                    bodies.remove(random.nextInt(bodies.size())).remove();
                }
                world.step(Scenes.STEP);
                String where = "seed " + seed + ", tick " + tick;
                Contacts.Events ended = world.contacts().ended();
                for (int i = 0; i < ended.count(); i++) {
                    assertTrue(open.remove(key(ended, i)), "ended without begin, " + where);
                }
                Contacts.Events began = world.contacts().began();
                for (int i = 0; i < began.count(); i++) {
                    assertTrue(open.add(key(began, i)), "began twice, " + where);
                    total++;
                }
                assertEquals(touching(world.contacts()), open, where);
            }
            world.bodies().forEach(BodyRef::remove);
            world.step(Scenes.STEP);
            Contacts.Events ended = world.contacts().ended();
            for (int i = 0; i < ended.count(); i++) {
                assertTrue(open.remove(key(ended, i)));
            }
            assertEquals(Set.of(), open, "seed " + seed);
            assertTrue(total > 50, "seed " + seed + ": only " + total + " touches");
        }
    }

    private static Set<Long> touching(Contacts contacts) {
        Set<Long> set = new HashSet<>();
        for (int i = 0; i < contacts.count(); i++) {
            if (contacts.touching(i)) {
                set.add(contacts.bodyA(i).entity() * 1_000_003L + contacts.bodyB(i).entity());
            }
        }
        return set;
    }

    private static long key(Contacts.Events events, int i) {
        assertNotNull(events.bodyA(i));
        return events.bodyA(i).entity() * 1_000_003L + events.bodyB(i).entity();
    }

    @Test
    void aFastBodyDoesNotPassThroughAWall() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.05, 5, 5)));
            BodyRef bullet =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.05))
                                    .at(-20, 0, 0)
                                    .velocity(300, 0, 0));
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
            }
            assertTrue(bullet.position().x < 0, bullet.position().toString());
        }
    }

    @Test
    void manyBodiesInOneSpotLoseNoPair() {
        int n = 120;
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(2).build()) {
            for (int i = 0; i < n; i++) {
                world.add(Body.dynamic().shape(Sphere.of(0.5)).at(1e-3 * i, 0, 0));
            }
            world.step(1e-4);
            assertEquals(n * (n - 1) / 2, world.contacts().count());
        }
    }
}
