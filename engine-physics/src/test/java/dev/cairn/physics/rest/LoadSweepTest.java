package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Inside;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;

/** What the load sweep keeps while contacts are the same is what it would make anew. */
class LoadSweepTest {
    private static final int TICKS = 240;

    /**
     * A stack that falls by less than the margin: its contacts are there before they carry; then a
     * box that lands on it and one that slides in from the side. The same with a box far away that
     * touches the ground in every other tick, so that contacts never are those of the tick before.
     */
    @Test
    void loadsAreTheSameWhateverIsKept() {
        double[] kept = scales(false);
        double[] anew = scales(true);
        assertArrayEquals(anew, kept, 0.0);
        double most = Arrays.stream(kept).max().orElseThrow();
        // four boxes of the stack alone make 8; the one that lands is on its way to 10
        assertTrue(most > 8.2, "what has landed is no load: " + most);
    }

    /** What slips has its own inertia at once, and so have its neighbours to two contacts. */
    @Test
    void whatSlipsDisturbsItsNeighbours() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            List<BodyRef> stack = Scenes.stack(world, 8);
            for (int tick = 0; tick < 300; tick++) {
                world.step(Scenes.STEP);
            }
            BodyStore b = Inside.bodies(world);
            int top = b.slotCount - 1;
            double[] before = b.inertiaScale.clone();
            stack.get(7).setVelocity(0.5, 0, 0);
            world.step(Scenes.STEP);
            for (int down = 1; down < 8; down++) {
                double was = before[top - down];
                double now = b.inertiaScale[top - down];
                // the two that slip on each other, and two contacts further
                boolean expected = down <= 3 ? was > 1.5 && now == 1 : now > 0.99 * was;
                assertTrue(expected, down + " below the top: from " + was + " to " + now);
            }
        }
    }

    /** Scale of the inertia of each body of the stack after each tick. */
    private static double[] scales(boolean disturbed) {
        try (PhysicsWorld world = Scenes.awake().workers(2).build()) {
            Scenes.ground(world);
            Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).mass(1);
            for (int i = 0; i < 5; i++) {
                world.add(box.at(0, 0.5 + 1.004 * i, 0));
            }
            world.add(box.at(0.2, 7, 0));
            world.add(box.at(3, 0.5, 0).velocity(-4, 0, 0));
            box.velocity(0, 0, 0);
            BodyStore b = Inside.bodies(world);
            int count = b.slotCount;
            BodyRef far = world.add(box.at(30, 5, 0));
            double[] all = new double[TICKS * count];
            for (int tick = 0; tick < TICKS; tick++) {
                far.teleport(30, disturbed && tick % 2 == 0 ? 0.5 : 5, 0);
                world.step(Scenes.STEP);
                System.arraycopy(b.inertiaScale, 0, all, tick * count, count);
            }
            return all;
        }
    }
}
