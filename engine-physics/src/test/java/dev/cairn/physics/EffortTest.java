package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.shape.Box;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Sub-steps for whom they help: thin cards beside towers of cubes. */
class EffortTest {
    private static final double LEAN = StrictMath.toRadians(25);

    private static PhysicsWorld world(int effort, int workers, int lanes) {
        return PhysicsWorld.builder()
                .settings(PhysicsSettings.DEFAULT.withEffort(effort).withLanes(lanes))
                .sleeping(false)
                .workers(workers)
                .build();
    }

    /** Two cards of 2 mm that lean against each other, and one on two such peaks. */
    static void cards(PhysicsWorld world, int tents) {
        double half = .2;
        double thin = .001;
        double wide = half * StrictMath.sin(LEAN) + thin * StrictMath.cos(LEAN);
        double high = half * StrictMath.cos(LEAN) + thin * StrictMath.sin(LEAN);
        double pitch = 4 * wide + .002;
        Material rough = new Material(.7, 0, 1000);
        for (int i = 0; i < tents; i++) {
            for (int side = -1; side <= 1; side += 2) {
                world.add(
                        Body.dynamic()
                                .shape(Box.of(thin, half, .1))
                                .at(10 + pitch * i + side * wide, high, 0)
                                .rotationAbout(0, 0, 1, side * LEAN)
                                .material(rough));
            }
            if (i > 0) {
                world.add(
                        Body.dynamic()
                                .shape(Box.of(.5 * pitch - .0005, thin, .1))
                                .at(10 + pitch * (i - .5), 2 * high + thin, 0)
                                .material(rough));
            }
        }
    }

    static double[] places(List<BodyRef> bodies) {
        double[] all = new double[3 * bodies.size()];
        for (int i = 0; i < bodies.size(); i++) {
            Vector3d at = bodies.get(i).position();
            all[3 * i] = at.x;
            all[3 * i + 1] = at.y;
            all[3 * i + 2] = at.z;
        }
        return all;
    }

    private static int most(PhysicsWorld world, int from, int to) {
        BodyStore b = world.physics.table.bodies;
        int most = 0;
        for (int i = from; i < to; i++) {
            most = Math.max(most, b.effort[i]);
        }
        return most;
    }

    /** The reason for it all: who needs no more does not pay, and does not even know. */
    @Test
    void theRestDoesNotKnow() {
        try (PhysicsWorld alone = world(0, 1, 1);
                PhysicsWorld both = world(3, 1, 1)) {
            List<BodyRef> towerAlone = Scenes.stack(alone, 10);
            List<BodyRef> tower = Scenes.stack(both, 10);
            int first = both.physics.table.bodies.slotCount;
            cards(both, 3);
            int largest = 0;
            for (int tick = 0; tick < 60; tick++) {
                alone.step(Scenes.STEP);
                both.step(Scenes.STEP);
                assertEquals(0, most(both, 0, first), "effort of the tower");
                int house = most(both, first, both.physics.table.bodies.slotCount);
                // it is put up in balance, so that it needs less from half a second on
                assertTrue(house > 0, "effort of the house in tick " + tick);
                largest = Math.max(largest, house);
            }
            assertEquals(3, largest);
            assertArrayEquals(places(towerAlone), places(tower), 0.0);
        }
    }

    /** Worlds that will go on differently have other digests. */
    @Test
    void theDigestTellsTheEffort() {
        try (PhysicsWorld world = world(2, 1, 1)) {
            Scenes.ground(world);
            cards(world, 1);
            for (int tick = 0; tick < 3; tick++) {
                world.step(Scenes.STEP);
            }
            BodyStore b = world.physics.table.bodies;
            long before = world.digest();
            b.idleTicks[1]++;
            long waited = world.digest();
            b.idleTicks[1]--;
            b.effort[1] ^= 1;
            assertEquals(3, Set.of(before, waited, world.digest()).size());
        }
    }

    /**
     * Sub-steps go back when offsets have learnt of the load, and nothing jolts: what moves at 1e-7
     * m/s goes on so (4e-6 if offsets do not take over what the contacts lose of their stiffness).
     */
    @Test
    void itGoesBackWithoutAJolt() {
        try (PhysicsWorld world = world(2, 1, 1)) {
            Scenes.ground(world);
            cards(world, 4);
            BodyStore b = world.physics.table.bodies;
            int tick = 0;
            int before = 2;
            List<Integer> steps = new ArrayList<>();
            while (before > 0 && tick < 3000) {
                world.step(Scenes.STEP);
                tick++;
                int now = most(world, 0, b.slotCount);
                if (now != before) {
                    steps.add(tick);
                    before = now;
                }
                if (tick > 600) {
                    for (BodyRef body : world.bodies()) {
                        double speed = body.velocity().length();
                        assertTrue(speed < 1e-6, "tick " + tick + ": " + speed + " m/s");
                    }
                }
            }
            assertEquals(2, steps.size(), "down twice: " + steps);
        }
    }

    /** Heaps that land get more, too; all of it together in lockstep where something bounces. */
    @Test
    void theSameBitsForAnyWorkersAndLanes() {
        for (double restitution : new double[] {0, .5}) {
            long digest = 0;
            for (int workers = 1; workers <= 4; workers++) {
                for (int lanes = 1; lanes <= (workers == 2 ? 4 : 1); lanes += 3) {
                    try (PhysicsWorld world = world(2, workers, lanes)) {
                        Scenes.drop(world, 40, 7);
                        cards(world, 12);
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cube(.5))
                                        .at(-20, 3, 0)
                                        .material(new Material(.5, restitution, 1000)));
                        for (int tick = 0; tick < 90; tick++) {
                            world.step(Scenes.STEP);
                        }
                        if (digest == 0) {
                            digest = world.digest();
                        }
                        assertEquals(digest, world.digest(), workers + " workers, lanes " + lanes);
                    }
                }
            }
        }
    }

    @Test
    void aBadNumberIsRefused() {
        for (int wrong : new int[] {-1, 5}) {
            String why =
                    assertThrows(
                                    IllegalArgumentException.class,
                                    () -> PhysicsSettings.DEFAULT.withEffort(wrong))
                            .getMessage();
            assertTrue(why.contains("effort") && why.contains("" + wrong), why);
        }
    }
}
