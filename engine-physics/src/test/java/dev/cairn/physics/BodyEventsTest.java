package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;

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
            BodyRef floor =
                    world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
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
}
