package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/** The same bits for any number of lanes and workers. */
@Tag("compiled")
class LanesTest {
    private static void sameForAll(int ticks, int leastContacts, Consumer<PhysicsWorld> scene) {
        long[] reference = null;
        for (int lanes : new int[] {1, 4, 8, 16}) {
            for (int workers = 1; workers <= 4; workers++) {
                boolean more = lanes == 16 ? workers != 2 : lanes * workers % 3 == 1;
                if (more && lanes * workers > 1) {
                    continue;
                }
                PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(lanes);
                try (PhysicsWorld world =
                        PhysicsWorld.builder()
                                .workers(workers)
                                .settings(settings)
                                .sleeping(false)
                                .build()) {
                    scene.accept(world);
                    long[] digests = new long[ticks];
                    int contacts = 0;
                    for (int tick = 0; tick < ticks; tick++) {
                        world.step(Scenes.STEP);
                        digests[tick] = world.digest();
                        contacts = Math.max(contacts, world.contacts().count());
                    }
                    assertTrue(contacts >= leastContacts, "contacts: " + contacts);
                    if (reference == null) {
                        reference = digests;
                    }
                    assertEquals(
                            -1,
                            Arrays.mismatch(reference, digests),
                            "first tick that differs, lanes " + lanes + ", workers " + workers);
                }
            }
        }
    }

    /** All pairs of kinds, and that they do touch. */
    @Test
    void everyKindOnEveryKind() {
        Set<String> met = new TreeSet<>();
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).build()) {
            Scenes.everyKindOnEveryKind(world);
            for (int tick = 0; tick < 90; tick++) {
                world.step(Scenes.STEP);
                Contacts contacts = world.contacts();
                for (int i = 0; i < contacts.count(); i++) {
                    if (contacts.touching(i)) {
                        met.add(pair(contacts.bodyA(i), contacts.bodyB(i)));
                    }
                }
            }
        }
        // Seven kinds with a half-space; six kinds and the moved one with each other.
        assertEquals(7 + 28, met.size(), met::toString);
        sameForAll(90, 49, Scenes::everyKindOnEveryKind);
    }

    private static String pair(BodyRef a, BodyRef b) {
        String one = a.shape().getClass().getSimpleName();
        String two = b.shape().getClass().getSimpleName();
        return one.compareTo(two) < 0 ? one + " " + two : two + " " + one;
    }

    @Test
    void aHeapThatFalls() {
        sameForAll(60, 200, world -> Scenes.drop(world, 200, 4711));
    }

    @Test
    void aWallInThePlaneOfItsAxes() {
        // exact zeros of both signs are everywhere
        sameForAll(
                40,
                140,
                world -> {
                    Scenes.ground(world);
                    for (int row = 0; row < 10; row++) {
                        for (int i = 0; i < 10 - row; i++) {
                            double x = 0.5 * row - 5 + i;
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.cubeOfHalfExtent(0.5))
                                            .at(x, row + 0.5, 0));
                        }
                    }
                });
    }

    @Test
    void aPlateWithAHundredNeighbours() {
        Random random = new Random(5);
        double[] yaw = random.doubles(121).toArray();
        sameForAll(
                30,
                122,
                world -> {
                    Scenes.ground(world);
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(6, 0.25, 6)).at(0, 0.25, 0));
                    for (int i = 0; i < 121; i++) {
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.3))
                                        .at(i % 11 - 5, 0.8, i / 11 - 5)
                                        .rotationAbout(0, 1, 0, yaw[i]));
                    }
                });
    }

    @Test
    void bouncingBodies() {
        sameForAll(
                120,
                60,
                world -> {
                    Random random = new Random(3);
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(50, 1, 50))
                                    .at(0, -1, 0)
                                    .material(new Material(0.4, 0.7, 1000)));
                    for (int i = 0; i < 80; i++) {
                        world.add(Scenes.any(random, i).material(new Material(0.4, 0.7, 1000)));
                    }
                });
    }
}
