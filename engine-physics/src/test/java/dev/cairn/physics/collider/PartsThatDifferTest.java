package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Two halves of a box, which make one convex shape and are solved as that, until something treats
 * one of them otherwise: a filter, the user's question, a hook, a material, a sensor. Then each is
 * solved by itself, and it does not matter which of the ways told them apart.
 */
class PartsThatDifferTest {
    private static final Material SLIDING = Material.DEFAULT.withFriction(.1);
    private static final Material PLAIN = Material.DEFAULT.withFriction(.4);

    /** The left one is from -1.2 to 0, the right one from 0 to 1. */
    private static Collider half(String name) {
        double reach = "left".equals(name) ? .6 : .5;
        return Collider.of(Box.ofHalfExtents(reach, .2, .3))
                .at("left".equals(name) ? -reach : reach, 0, 0)
                .material(PLAIN)
                .userData(name);
    }

    private static Body brick(Collider left, Collider right) {
        return Body.dynamic().collider(left).collider(right).at(0, .2, 0).canSleep(false);
    }

    private static Body brick() {
        return brick(half("left"), half("right"));
    }

    /** Where the brick is after each of 60 ticks: place and orientation. */
    private static List<double[]> way(
            Body brick, Consumer<PhysicsWorld> rules, Consumer<BodyRef> change) {
        List<double[]> way = new ArrayList<>();
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            rules.accept(world);
            Body floor = Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).material(PLAIN);
            world.add(floor.at(0, -1, 0).name("floor"));
            BodyRef ref = world.add(brick);
            for (int tick = 0; tick < 60; tick++) {
                if (tick == 10) {
                    change.accept(ref);
                }
                world.step(Scenes.STEP);
                world.validate();
                Vector3d p = ref.position();
                way.add(new double[] {p.x, p.y, p.z, ref.orientation().z, ref.orientation().y});
            }
        }
        return way;
    }

    private static void none(Object unused) {}

    private static void assertSame(List<double[]> expected, List<double[]> actual, String what) {
        for (int tick = 0; tick < expected.size(); tick++) {
            for (int k = 0; k < expected.get(tick).length; k++) {
                String at = what + " in tick " + tick;
                assertEquals(expected.get(tick)[k], actual.get(tick)[k], 1e-12, at);
            }
        }
    }

    private static boolean isLeft(ColliderRef part) {
        return "left".equals(part.userData());
    }

    /** The left half stands on nothing: the brick turns over to it, in whichever way it is told. */
    @Test
    void aHalfThatMeetsNobody() {
        Filter nobody = Filter.NOTHING;
        List<double[]> byFilter =
                way(
                        brick(half("left").filter(nobody), half("right")),
                        PartsThatDifferTest::none,
                        PartsThatDifferTest::none);
        List<double[]> byQuestion =
                way(
                        brick(),
                        world ->
                                world.collisions()
                                        .setPairFilter((a, b) -> !isLeft(a) && !isLeft(b)),
                        PartsThatDifferTest::none);
        List<double[]> byHook =
                way(
                        brick(),
                        world -> world.collisions().setHook(ofLeft(ContactHook.Change::disable)),
                        PartsThatDifferTest::none);
        double[] end = byFilter.get(59);
        assertTrue(end[3] > .2, "it turns over its middle: " + end[3]);
        assertSame(byFilter, byQuestion, "question");
        assertSame(byFilter, byHook, "hook");
    }

    /** Changes the contacts of the left half. */
    private static ContactHook ofLeft(ContactHook change) {
        return contact -> {
            if ("left".equals(contact.userDataA()) || "left".equals(contact.userDataB())) {
                change.change(contact);
            }
        };
    }

    /**
     * With friction .4 and .1 under its halves it turns as it slides, and goes on to do so to the
     * end: contacts of what hardly moves may be those of the tick before.
     */
    @Test
    void aHalfOfOtherFriction() {
        Consumer<BodyRef> push = brick -> brick.setVelocity(0, 0, 2.5);
        List<double[]> alike = way(brick(), PartsThatDifferTest::none, push);
        List<double[]> byMaterial =
                way(
                        brick(half("left").material(SLIDING), half("right")),
                        PartsThatDifferTest::none,
                        push);
        double mixed = Math.sqrt(.4 * .1);
        List<double[]> byHook =
                way(
                        brick(),
                        world ->
                                world.collisions()
                                        .setHook(ofLeft(contact -> contact.surface(mixed, 0))),
                        push);
        assertEquals(0, alike.get(59)[4], 1e-7, "as a whole it slides straight");
        assertTrue(Math.abs(byMaterial.get(59)[4]) > .05, "turn " + byMaterial.get(59)[4]);
        assertSame(byMaterial, byHook, "hook");
    }

    /** A hook that says of all parts what they are anyway changes nothing but who is solved. */
    @Test
    void aHookThatTreatsAllAlike() {
        Consumer<BodyRef> push = brick -> brick.setVelocity(1, 0, 2);
        List<double[]> plain = way(brick(), PartsThatDifferTest::none, push);
        List<double[]> hooked =
                way(
                        brick(),
                        world -> world.collisions().setHook(contact -> contact.surface(.4, 0)),
                        push);
        assertSame(plain, hooked, "hook");
    }

    /**
     * What is told apart while it rests, and alike again, is the box again: it stays where it is.
     */
    @Test
    void liveChangesThereAndBack() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            BodyRef brick = world.add(brick());
            for (int tick = 0; tick < 120; tick++) {
                ColliderRef left = brick.colliders().get(0);
                switch (tick) {
                    case 10 -> left.setMaterial(SLIDING);
                    case 20 -> left.setMaterial(PLAIN);
                    case 30 -> left.setFilter(Filter.ALL.alwaysWith(7));
                    case 40 -> left.setFilter(Filter.ALL);
                    case 50 -> brick.add(Collider.of(Box.cubeOfHalfExtent(.2)).sensor(true));
                    case 60 -> brick.colliders().get(2).remove();
                    default -> {}
                }
                world.step(Scenes.STEP);
                world.validate();
                int touching = 0;
                for (int c = 0; c < world.contacts().count(); c++) {
                    touching += world.contacts().pointCount(c) > 0 ? 1 : 0;
                }
                assertEquals(2, touching, "each half touches, tick " + tick);
            }
            assertEquals(.2, brick.position().y, 1e-4);
            assertEquals(0, brick.orientation().z, 1e-5);
        }
    }

    /** What is added to two that make a whole is replaced and removed by itself; masses tell. */
    @Test
    void whatIsBesideAWholeIsReplacedAndRemoved() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef brick = world.add(brick());
            double mass = brick.mass();
            ColliderRef first = brick.add(Collider.of(Box.cubeOfHalfExtent(.5)).at(0, 2, 0));
            ColliderRef second = brick.add(Collider.of(Box.cubeOfHalfExtent(.5)).at(0, 4, 0));
            assertEquals(mass + 2000, brick.mass(), 1e-9);
            second.replace(Collider.of(Box.cubeOfHalfExtent(1)).at(0, 4, 0));
            assertEquals(mass + 9000, brick.mass(), 1e-9);
            first.replace(Collider.of(Box.cubeOfHalfExtent(1)).at(0, 2, 0));
            assertEquals(mass + 16000, brick.mass(), 1e-9);
            world.step(Scenes.STEP);
            world.validate();
            first.remove();
            assertEquals(mass + 8000, brick.mass(), 1e-9);
            second.remove();
            assertEquals(mass, brick.mass(), 1e-9);
            world.step(Scenes.STEP);
            world.validate();
        }
    }
}
