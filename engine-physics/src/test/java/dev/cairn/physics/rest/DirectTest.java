package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.tuning.Tunable;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** Long and slender islands, whose contacts are solved together. */
class DirectTest {
    private static final long SEED = 20261123;
    private static final int DEFAULT = PhysicsSettings.DEFAULT.tuning().count(Tunable.DIRECT_FROM);

    private static PhysicsWorld world(int directFrom, int substeps, int workers, int lanes) {
        return PhysicsWorld.builder()
                .gravity(0, -9.81, 0)
                .settings(
                        PhysicsSettings.DEFAULT
                                .with(Tunable.DIRECT_FROM, directFrom)
                                .withSubsteps(substeps)
                                .withLanes(lanes))
                .sleeping(false)
                .workers(workers)
                .build();
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(Scenes.STEP);
        }
    }

    /** Largest way aside from where it was put. */
    private static double drift(List<BodyRef> boxes, double[] before) {
        double[] now = Scenes.places(boxes);
        double most = 0;
        for (int i = 0; i < now.length; i += 3) {
            most = Math.max(most, Math.hypot(now[i] - before[i], now[i + 2] - before[i + 2]));
        }
        return most;
    }

    /** It stands where it was put; swept only, it leans by centimetres, or falls. */
    @ParameterizedTest
    @CsvSource({"50, 1", "50, 2", "100, 4"})
    void aTallColumnStands(int height, int substeps) {
        System.out.println("seed " + SEED);
        try (PhysicsWorld with = world(DEFAULT, substeps, 1, 1);
                PhysicsWorld without = world(0, substeps, 1, 1)) {
            double[] drifts = new double[2];
            for (PhysicsWorld world : List.of(with, without)) {
                Scenes.ground(world);
                List<BodyRef> boxes = Scenes.column(world, height, 0);
                double[] before = Scenes.places(boxes);
                run(world, 1200);
                drifts[world == with ? 0 : 1] = drift(boxes, before);
            }
            assertTrue(drifts[0] < 1e-4, "drift " + drifts[0] + " m");
            assertTrue(drifts[1] > 10 * drifts[0], "swept only: " + drifts[1] + " m");
        }
    }

    /** Each contact carries what stands on it, and all are at rest. */
    @Test
    void contactsCarryWhatStandsOnThem() {
        int height = 40;
        try (PhysicsWorld world = world(DEFAULT, 4, 1, 1)) {
            Scenes.ground(world);
            List<BodyRef> boxes = Scenes.column(world, height, 0);
            run(world, 1200);
            Contacts contacts = world.contacts();
            assertEquals(height, contacts.count());
            for (int c = 0; c < contacts.count(); c++) {
                int below = boxes.indexOf(contacts.bodyA(c));
                int above = boxes.indexOf(contacts.bodyB(c));
                double sum = 0;
                for (int p = 0; p < contacts.pointCount(c); p++) {
                    sum += contacts.normalImpulse(c, p);
                }
                double weight = 1000 * 9.81 * (height - Math.max(below, above));
                assertEquals(1, sum / (weight * Scenes.STEP), 1e-6, "on box " + below);
            }
            for (BodyRef box : boxes) {
                assertEquals(0, box.velocity().length(), 1e-7, "m/s");
            }
        }
    }

    /** What is short, wide or in motion has the bits that it has without. */
    @Test
    void theRestDoesNotKnow() {
        long[] digests = new long[2];
        for (int k = 0; k < 2; k++) {
            try (PhysicsWorld world = world(k == 0 ? 0 : DEFAULT, 4, 2, 4)) {
                Scenes.stack(world, DEFAULT - 1);
                Scenes.drop(world, 60, 3);
                for (int i = 0; i < 30; i++) {
                    // a column in flight
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(40, 20 + i, 0));
                }
                run(world, 60);
                digests[k] = world.digest();
            }
        }
        assertEquals(digests[0], digests[1]);
    }

    /** The same bits for any number of workers and lanes, in batches and in lockstep. */
    @Tag("compiled")
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void bitsDependOnTheSceneAlone(boolean bounces) {
        long expected = 0;
        for (int workers = 1; workers <= 3; workers += 2) {
            for (int lanes : new int[] {1, workers == 1 ? 8 : 4}) {
                try (PhysicsWorld world = world(DEFAULT, 4, workers, lanes)) {
                    scene(world, bounces);
                    run(world, 90);
                    long digest = world.digest();
                    expected = expected == 0 ? digest : expected;
                    assertEquals(expected, digest, workers + " workers, " + lanes + " lanes");
                }
            }
        }
        try (PhysicsWorld world = world(0, 4, 1, 1)) {
            scene(world, bounces);
            run(world, 90);
            assertNotEquals(expected, world.digest(), "swept only");
        }
    }

    private static List<BodyRef> scene(PhysicsWorld world, boolean bounces) {
        Scenes.ground(world);
        List<BodyRef> boxes = Scenes.column(world, 30, 0);
        boxes.addAll(Scenes.column(world, 40, 5));
        if (bounces) {
            Body ball = Body.dynamic().shape(Sphere.of(.5)).at(-10, 3, 0);
            world.add(ball.material(new Material(.5, .9, 1000)));
        }
        return boxes;
    }

    /** A ball that bounces elsewhere, so that all is solved in lockstep, changes no bit. */
    @Test
    void aColumnDoesNotKnowWhatBouncesElsewhere() {
        try (PhysicsWorld alone = world(DEFAULT, 4, 2, 1);
                PhysicsWorld both = world(DEFAULT, 4, 2, 1)) {
            List<BodyRef> first = scene(alone, false);
            List<BodyRef> second = scene(both, true);
            run(alone, 90);
            run(both, 90);
            assertArrayEquals(Scenes.places(first), Scenes.places(second), 0.0);
        }
    }

    /**
     * Springs under a column lengthen by what it weighs, as those of one that is only swept, and no
     * further: it stands as high as it was put up.
     */
    @Test
    void aTallColumnDoesNotSag() {
        try (PhysicsWorld world = world(DEFAULT, 4, 1, 1)) {
            Scenes.ground(world);
            List<BodyRef> boxes = Scenes.column(world, 50, 0);
            run(world, 3600);
            for (int i = 0; i < boxes.size(); i++) {
                assertEquals(.5 + i, boxes.get(i).position().y, 1e-4, "height of box " + i);
            }
        }
    }

    /** What falls onto each other sways, and comes to rest. */
    @Test
    void aColumnThatWasDroppedComesToRest() {
        try (PhysicsWorld world = world(DEFAULT, 4, 1, 1)) {
            Scenes.ground(world);
            List<BodyRef> boxes = new ArrayList<>();
            for (int i = 0; i < 40; i++) {
                boxes.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(.5))
                                        .at(.001 * (i % 3), .52 + 1.02 * i, -.001 * (i % 2))));
            }
            run(world, 3600);
            for (BodyRef box : boxes) {
                assertEquals(0, box.velocity().length(), 1e-4, "m/s");
            }
        }
    }

    /** Motion under gravity does not know the unit of mass: not by one bit. */
    @Test
    void theUnitOfMassDoesNotMatter() {
        double[][] places = new double[2][];
        for (int k = 0; k < 2; k++) {
            try (PhysicsWorld world = world(DEFAULT, 4, 1, 1)) {
                Scenes.ground(world);
                Material material = new Material(.6, 0, k == 0 ? 1000 : 1000 * 0x1p-20);
                List<BodyRef> boxes = new ArrayList<>();
                for (int i = 0; i < 30; i++) {
                    double aside = .001 * (i % 3);
                    Body box =
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.5))
                                    .at(aside, .5 + i, -aside);
                    boxes.add(world.add(box.material(material)));
                }
                run(world, 60);
                places[k] = Scenes.places(boxes);
            }
        }
        assertArrayEquals(places[0], places[1], 0.0);
    }

    /** Bodies that may only move and turn in a plane stay there, and stand. */
    @Test
    void aFlatColumnStands() {
        try (PhysicsWorld world = world(DEFAULT, 2, 1, 1)) {
            Scenes.ground(world);
            List<BodyRef> boxes = new ArrayList<>();
            for (int i = 0; i < 50; i++) {
                Body box =
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(.5))
                                .at(.001 * (i % 3), .5 + i, .25);
                boxes.add(world.add(box.lock(Lock.MOVE_Z, Lock.TURN_X, Lock.TURN_Y)));
            }
            double[] before = Scenes.places(boxes);
            run(world, 600);
            assertTrue(drift(boxes, before) < 1e-4, "drift " + drift(boxes, before) + " m");
            for (BodyRef box : boxes) {
                assertEquals(.25, box.position().z);
            }
        }
    }

    /** A column that is pushed falls as one that is only swept. */
    @Test
    void whatIsPushedOverFalls() {
        double[] heights = new double[2];
        for (int k = 0; k < 2; k++) {
            try (PhysicsWorld world = world(k == 0 ? 0 : DEFAULT, 8, 1, 1)) {
                Scenes.ground(world);
                List<BodyRef> boxes = Scenes.column(world, 30, 0);
                run(world, 60);
                for (int i = 0; i < 30; i++) {
                    boxes.get(i).setVelocity(.05 * i, 0, 0);
                }
                run(world, 360);
                heights[k] = boxes.get(29).position().y;
            }
        }
        assertTrue(heights[1] < 15, "height of the top " + heights[1] + ", swept " + heights[0]);
    }
}
