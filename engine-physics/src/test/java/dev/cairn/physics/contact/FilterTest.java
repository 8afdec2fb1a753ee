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
import dev.cairn.physics.Inside;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Layers;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

class FilterTest {
    private static final Layers LAYERS =
            Layers.of("scenery", "crate", "ghost").apart("ghost", "crate").apart("ghost", "ghost");

    private static BodyRef box(PhysicsWorld world, double y, Filter filter) {
        return world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, y, 0).filter(filter));
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(Scenes.STEP);
            world.validate();
        }
    }

    /** No pair is asked about, and no row has a column for what the scene does not use. */
    @Test
    void aSceneWithoutFiltersPaysNothing() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Scenes.stack(world, 3);
            step(world, 10);
            assertFalse(Inside.filtersPairs(world));
            ContactStore rows = Inside.contacts(world);
            assertFalse(rows.hooked || rows.belts || rows.compounds || rows.hits || rows.grouped);
            world.bodies().get(1).setFilter(new Filter(1, 1));
            assertTrue(Inside.filtersPairs(world));
        }
    }

    @Test
    void theRuleOfTwoFiltersIsSymmetricAndGroupsRule() {
        Filter a = new Filter(1, 2);
        Filter b = new Filter(2, 1);
        Filter c = new Filter(2, 4);
        assertTrue(a.meets(b) && b.meets(a));
        assertFalse(a.meets(c) || c.meets(a), "both must want it");
        assertTrue(a.alwaysWith(7).meets(c.alwaysWith(7)));
        assertFalse(a.neverWith(7).meets(b.neverWith(7)));
        assertTrue(a.neverWith(7).meets(b.neverWith(8)), "another group: bits decide");
        assertFalse(Filter.NOTHING.meets(Filter.ALL));
        assertThrows(IllegalArgumentException.class, () -> a.alwaysWith(0));
        assertThrows(IllegalArgumentException.class, () -> LAYERS.filter("air"));
        assertThrows(IllegalArgumentException.class, () -> Layers.of("a", "a"));
        assertFalse(LAYERS.filter("ghost").meets(LAYERS.filter("crate")));
        assertTrue(LAYERS.filter("ghost").meets(LAYERS.filter("scenery")));
    }

    /** A refused pair has no row: nothing is collided, though the boxes overlap all the time. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aRefusedPairIsNeverCollided(int workers) {
        try (PhysicsWorld world = Scenes.awake().workers(workers).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).filter(LAYERS.filter("scenery")));
            BodyRef crate = box(world, .5, LAYERS.filter("crate"));
            List<BodyRef> ghosts = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                ghosts.add(box(world, .6 + .1 * i, LAYERS.filter("ghost")));
            }
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
                assertTrue(Inside.contacts(world).count <= 6);
            }
            // five ghosts and a crate, each with the ground alone
            assertEquals(6, Inside.contacts(world).count);
            for (BodyRef ghost : ghosts) {
                assertEquals(.5, ghost.position().y, 5e-3);
            }
            assertEquals(.5, crate.position().y, 5e-3);
        }
    }

    /** Closed form: a body that nothing holds falls by g t (t + dt) / 2, as the step sums it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aLiveChangeEndsAContactAndBeginsOne(boolean sleeping) {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(sleeping).workers(1).build()) {
            BodyRef ground =
                    world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
            BodyRef low = box(world, .5, Filter.ALL);
            BodyRef high = box(world, 1.5, Filter.ALL);
            step(world, 200);
            assertEquals(sleeping, low.isAsleep());
            low.setFilter(new Filter(2, 2));
            world.step(Scenes.STEP);
            assertEquals(2, world.contacts().ended().count());
            assertEquals(0, world.contacts().count());
            assertFalse(low.isAsleep() || high.isAsleep());
            step(world, 29);
            assertEquals(.5 - .5 * 9.81 * .5 * .5, low.position().y, .1);
            assertEquals(.5, high.position().y, .02, "on the ground, through the other one");
            low.teleport(0, -.7, 0);
            low.setVelocity(0, 0, 0);
            world.step(Scenes.STEP);
            assertEquals(0, world.contacts().began().count());
            low.setFilter(Filter.ALL);
            world.step(Scenes.STEP);
            assertTrue(world.contacts().began().count() > 0, "it is in the ground");
            assertSame(ground, world.contacts().began().bodyA(0));
        }
    }

    @Test
    void whoWasTakenApartStaysSoUntilTheLastReasonIsGone() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef a = box(world, 0, Filter.ALL);
            BodyRef b = box(world, .9, Filter.ALL);
            world.collisions().exclude(a, b);
            world.collisions().exclude(b, a);
            step(world, 2);
            assertEquals(0, world.contacts().count());
            world.collisions().include(a, b);
            step(world, 2);
            assertEquals(0, world.contacts().count());
            world.collisions().include(a, b);
            step(world, 1);
            assertEquals(1, world.contacts().count());
            world.collisions().exclude(a, b);
            step(world, 1);
            assertEquals(0, world.contacts().count());
            assertEquals(1, world.contacts().ended().count());
            a.remove();
            step(world, 1);
            BodyRef heir = box(world, 0, Filter.ALL);
            assertEquals(Inside.slot(a), Inside.slot(heir));
            heir.teleport(0, b.position().y - .9, 0);
            step(world, 1);
            assertEquals(1, world.contacts().count(), "another body in the slot collides");
            assertThrows(IllegalArgumentException.class, () -> world.collisions().exclude(b, b));
        }
    }

    /** The order in which a user is asked is that of the pairs, whatever the workers. */
    @Test
    void theUserIsAskedInAFixedOrder() {
        List<List<String>> told = new ArrayList<>();
        List<Long> digests = new ArrayList<>();
        for (int workers = 1; workers <= 3; workers++) {
            try (PhysicsWorld world = Scenes.awake().workers(workers).build()) {
                List<String> asked = new ArrayList<>();
                world.collisions()
                        .setPairFilter((a, b) -> {
                            asked.add(a + " " + b);
                            return Inside.slot(a.body()) % 3 != 1 || Inside.slot(b.body()) % 3 != 1;
                        });
                Scenes.everyKindOnEveryKind(world);
                for (int i = 0; i < 60; i++) {
                    world.step(Scenes.STEP);
                }
                world.validate();
                for (int i = 0; i < world.contacts().count(); i++) {
                    assertFalse(
                            Inside.slot(world.contacts().bodyA(i)) % 3 == 1
                                    && Inside.slot(world.contacts().bodyB(i)) % 3 == 1);
                }
                world.collisions().setPairFilter(null);
                world.step(Scenes.STEP);
                world.validate();
                told.add(asked);
                digests.add(world.digest());
            }
        }
        assertTrue(told.get(0).size() > 20);
        assertEquals(told.get(0), told.get(1));
        assertEquals(told.get(0), told.get(2));
        assertEquals(digests.get(0), digests.get(1));
        assertEquals(digests.get(0), digests.get(2));
    }

    @Test
    void queriesTakeTheSameFilters() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef ghost =
                    world.add(
                            Body.fixed()
                                    .shape(Sphere.of(1))
                                    .at(3, 0, 0)
                                    .filter(LAYERS.filter("ghost")));
            BodyRef crate =
                    world.add(
                            Body.fixed()
                                    .shape(Sphere.of(1))
                                    .at(6, 0, 0)
                                    .filter(LAYERS.filter("crate")));
            WorldQueries queries = world.queries();
            Hit hit = new Hit();
            assertSame(ghost, queries.rayCast(0, 0, 0, 1, 0, 0, 99, hit));
            queries.withFilter(LAYERS.filter("crate"));
            assertSame(crate, queries.rayCast(0, 0, 0, 1, 0, 0, 99, hit));
            queries.withFilter(LAYERS.only("ghost"));
            assertSame(ghost, queries.rayCast(9, 0, 0, -1, 0, 0, 99, hit));
            queries.withFilter(LAYERS.only("scenery"));
            assertNull(queries.rayCast(0, 0, 0, 1, 0, 0, 99, hit));
            assertNotNull(queries.withFilter(null).rayCast(0, 0, 0, 1, 0, 0, 99, hit));
        }
    }
}
