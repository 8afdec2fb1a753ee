package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ObjIntConsumer;

/**
 * A world may be saved at any moment of its life: at every second tick around an event it is saved,
 * and goes on from there as it did, in itself and in a new world of other workers and lanes.
 */
@Tag("compiled")
class EveryMomentTest {
    private static final double STEP = 1.0 / 60;
    private static final int AHEAD = 8;

    private static PhysicsWorld world() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
        return world;
    }

    private static BodyRef box(PhysicsWorld world, double x, double y) {
        return world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(x, y, 0));
    }

    /**
     * Compares all futures.
     *
     * @param event what the user does to a world before a tick; finds what it needs in the world
     */
    private static void holds(PhysicsWorld world, int ticks, ObjIntConsumer<PhysicsWorld> event) {
        List<Long> digests = new ArrayList<>();
        List<WorldState> states = new ArrayList<>();
        for (int t = 0; t < ticks; t++) {
            states.add(world.save());
            digests.add(world.digest());
            event.accept(world, t);
            world.step(STEP);
        }
        PhysicsSettings wide = world.settings().withLanes(4);
        for (int saved = 0; saved < ticks; saved += 2) {
            try (PhysicsWorld other = PhysicsWorld.builder().workers(2).settings(wide).build()) {
                for (PhysicsWorld each : List.of(world, other)) {
                    each.restore(states.get(saved));
                    for (int t = saved; t < Math.min(ticks, saved + AHEAD); t++) {
                        String where = "saved at " + saved + ", tick " + t;
                        assertEquals(digests.get(t), each.digest(), where);
                        event.accept(each, t);
                        each.step(STEP);
                    }
                }
            }
        }
    }

    private static BodyRef body(PhysicsWorld world, int index) {
        return world.bodies().get(index);
    }

    @Test
    void whileAStackFallsAsleepAndIsWoken() {
        boolean[] slept = new boolean[1];
        try (PhysicsWorld world = world()) {
            for (int i = 0; i < 3; i++) {
                box(world, 0.1 * i, 0.5 + i);
            }
            holds(
                    world,
                    180,
                    (each, t) -> {
                        slept[0] |= body(each, 3).isAsleep();
                        if (t == 150) {
                            assertTrue(body(each, 3).isAsleep(), "it sleeps by now");
                            body(each, 3).applyImpulse(500, 0, 0);
                        }
                    });
        }
        assertTrue(slept[0]);
    }

    @Test
    void whileBodiesAreRemovedAndAdded() {
        try (PhysicsWorld world = world()) {
            for (int i = 0; i < 5; i++) {
                box(world, 0, 0.5 + i);
            }
            holds(
                    world,
                    60,
                    (each, t) -> {
                        if (t % 9 == 4) {
                            body(each, 2).remove();
                        } else if (t % 9 == 7) {
                            box(each, 0.1, 8);
                        }
                    });
        }
    }

    @Test
    void whileJointsBreakAndOthersAreAdded() {
        try (PhysicsWorld world = world()) {
            BodyRef last = world.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 9, 0));
            for (int i = 0; i < 5; i++) {
                BodyRef link = world.add(Body.dynamic().shape(Sphere.of(0.2)).at(i + 1, 9, 0));
                world.add(Joint.ball(last, link).at(i + 0.5, 9, 0).breakAt(1400 - 150 * i, 1e9));
                last = link;
            }
            int[] broken = new int[1];
            holds(
                    world,
                    90,
                    (each, t) -> {
                        broken[0] += each.joints().brokenCount();
                        if (t == 60) { // grows what was restored
                            each.add(Joint.ball(body(each, 1), body(each, 5)).at(0, 9, 0));
                        }
                    });
            assertTrue(broken[0] > 0, "a joint broke");
        }
    }

    @Test
    void whileBodiesLandOnAMesh() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            Grounds.drop(world, 8, 5);
            holds(world, 120, (each, t) -> {});
        }
    }

    /** Sub-steps are changed; a long column is solved directly, and stops being one. */
    @Test
    void whileTheEffortChanges() {
        try (PhysicsWorld world = world()) {
            for (int i = 0; i < 24; i++) {
                box(world, 0, 0.5 + i);
            }
            holds(
                    world,
                    60,
                    (each, t) -> {
                        if (t % 12 == 3) {
                            each.setSubsteps(2 + t / 12);
                        }
                        if (t == 40) {
                            body(each, 12).remove();
                        }
                    });
        }
    }

    /** A ball rolls from slab to slab, and a fast one is swept. */
    @Test
    void whileContactsBeginAndEndAtSeams() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            for (int i = 0; i < 8; i++) {
                Box slab = Box.ofHalfExtents(0.5, 0.5, 2);
                world.add(Body.fixed().shape(slab).at(i, -0.5, 0));
            }
            world.add(Body.dynamic().shape(Sphere.of(0.3)).at(0, 0.3, 0).velocity(4, 0, 0));
            world.add(Body.dynamic().shape(Sphere.of(0.1)).at(-60, 0.4, 1).velocity(900, 0, 0));
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.01, 1, 1)).at(6, 0.5, 1));
            holds(world, 90, (each, t) -> {});
        }
    }
}
