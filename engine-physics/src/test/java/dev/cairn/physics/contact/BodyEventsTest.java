package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/** Bodies begin to touch once and end once, whatever number of their shapes does. */
class BodyEventsTest {
    private static Body stool() {
        Body stool =
                Body.dynamic().collider(Collider.of(Box.ofHalfExtents(.4, .05, .4)).at(0, .6, 0));
        for (int leg = 0; leg < 3; leg++) {
            stool.collider(
                    Collider.of(Box.ofHalfExtents(.05, .3, .05))
                            .at(leg == 0 ? -.3 : .3, .3, leg == 1 ? -.3 : .3));
        }
        return stool;
    }

    /** What is told of a stool that stands, and of what is done to it then. */
    private static List<String> told(BiConsumer<PhysicsWorld, BodyRef> deed, boolean sleeping) {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(sleeping).workers(1).build()) {
            List<String> told = new ArrayList<>();
            BodyRef floor = world.add(floor());
            BodyRef stool = world.add(stool().at(0, .02, 0));
            int[] shapes = new int[1];
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void began(ColliderRef a, ColliderRef b) {
                                    shapes[0]++;
                                }

                                @Override
                                public void bodiesBegan(BodyRef a, BodyRef b) {
                                    told.add("began " + (a == floor) + (b == stool));
                                }

                                @Override
                                public void bodiesEnded(BodyRef a, BodyRef b) {
                                    told.add("ended " + (a == floor) + (b == stool));
                                }
                            });
            for (int i = 0; i < 180; i++) {
                world.step(Scenes.STEP);
                int polled =
                        world.contacts().bodiesBegan().count()
                                + world.contacts().bodiesEnded().count();
                assertTrue(polled <= 1);
            }
            assertEquals(sleeping, stool.isAsleep());
            assertTrue(shapes[0] >= 3, "three legs stand");
            assertEquals(List.of("began truetrue"), told);
            told.clear();
            deed.accept(world, stool);
            for (int i = 0; i < 3; i++) {
                world.step(Scenes.STEP);
            }
            return told;
        }
    }

    @Test
    void aStoolOfThreeLegsBeginsOnceAndEndsOnceHoweverItEnds() {
        List<String> once = List.of("ended truetrue");
        for (boolean sleeping : new boolean[] {false, true}) {
            assertEquals(List.of(), told((world, stool) -> {}, sleeping));
            assertEquals(once, told((world, stool) -> stool.remove(), sleeping));
            assertEquals(once, told((world, stool) -> stool.teleport(0, 3, 0), sleeping));
            assertEquals(once, told((world, stool) -> stool.setFilter(Filter.NOTHING), sleeping));
            assertEquals(once, told((world, stool) -> stool.setType(BodyType.FIXED), sleeping));
            assertEquals(
                    once,
                    told(
                            (world, stool) ->
                                    world.add(Joint.ball(world.bodies().get(0), stool).at(0, 0, 0)),
                            sleeping));
            assertEquals(
                    List.of(),
                    told((world, stool) -> stool.colliders().get(1).remove(), sleeping),
                    "two legs still stand");
        }
    }

    /**
     * A stool that falls on its feet hits the floor once, though each foot does: with the strongest
     * of these hits, at {@code g t} after {@code t} of free fall, along the normal from the body of
     * the lower slot, whichever came first.
     */
    @Test
    void aStoolThatFallsHitsOnceAndTheOrderOfWhatIsToldIsFixed() {
        for (boolean floorFirst : new boolean[] {true, false}) {
            try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).workers(1).build()) {
                BodyRef early = floorFirst ? world.add(floor()) : world.add(stool().at(0, .5, 0));
                BodyRef late = floorFirst ? world.add(stool().at(0, .5, 0)) : world.add(floor());
                BodyRef stool = floorFirst ? late : early;
                world.contacts().setHitSpeed(1);
                List<String> told = new ArrayList<>();
                world.contacts().listen(names(told));
                double speed = 0;
                while (told.isEmpty()) {
                    speed = -stool.velocity().y;
                    world.step(Scenes.STEP);
                }
                List<String> order = new ArrayList<>(List.of("bodies began"));
                order.addAll(List.of("began", "began", "began", "hit", "hit", "hit"));
                order.add("bodies hit");
                assertEquals(order, told);
                Contacts.Hits bodies = world.contacts().bodiesHit();
                assertEquals(1, bodies.count());
                assertEquals(early, bodies.bodyA(0));
                assertEquals(late, bodies.bodyB(0));
                assertEquals(late, bodies.colliderB(0).body());
                Vector3d up = bodies.normal(0, new Vector3d());
                assertEquals(floorFirst ? 1 : -1, up.y, 1e-9);
                assertEquals(speed, bodies.approachSpeed(0), 1e-9);
                assertEquals(0, bodies.point(0, new Vector3d()).y, .05);
                Contacts.Hits shapes = world.contacts().hits();
                double most = 0;
                for (int i = 0; i < shapes.count(); i++) {
                    most = Math.max(most, shapes.impulse(i));
                }
                assertEquals(most, bodies.impulse(0));
                assertTrue(most > 0);
            }
        }
    }

    private static Body floor() {
        return Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0);
    }

    private static ContactListener names(List<String> told) {
        return new ContactListener() {
            @Override
            public void began(ColliderRef a, ColliderRef b) {
                told.add("began");
            }

            @Override
            public void bodiesBegan(BodyRef a, BodyRef b) {
                told.add("bodies began");
            }

            @Override
            public void hit(Contacts.Hits hits, int hit) {
                told.add("hit");
            }

            @Override
            public void bodiesHit(Contacts.Hits hits, int hit) {
                told.add("bodies hit");
            }
        };
    }
}
