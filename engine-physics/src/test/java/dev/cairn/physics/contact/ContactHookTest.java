package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Inside;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.ContactHook;
import dev.cairn.physics.collider.Mix;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ContactHookTest {
    /** Solid for what comes from above: once it stood on it, or has not yet sunk in. */
    static final ContactHook ONE_WAY =
            contact -> {
                boolean first = "one-way".equals(contact.userDataA());
                if (!first && !"one-way".equals(contact.userDataB())) {
                    return;
                }
                double up = first ? contact.normalY() : -contact.normalY();
                boolean stands = contact.memory() == 1 || contact.separation() > -.005;
                if (up > .7 && stands) {
                    contact.remember(1);
                } else {
                    contact.remember(0);
                    contact.disable();
                }
            };

    private static Body platform() {
        return Body.fixed()
                .collider(
                        Collider.of(Box.ofHalfExtents(5, .05, 5))
                                .at(0, -.05, 0)
                                .userData("one-way"));
    }

    @ParameterizedTest
    @ValueSource(doubles = {7, 15, 40, 100})
    void aOneWayPlatformLetsThroughFromBelowOnly(double speed) {
        for (boolean ball : new boolean[] {true, false}) {
            try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
                world.collisions().setHook(ONE_WAY);
                world.add(platform());
                Body body = Body.dynamic().shape(ball ? Sphere.of(.2) : Box.cubeOfHalfExtent(.2));
                BodyRef up = world.add(body.at(0, -3, 0).velocity(0, speed, 0));
                BodyRef down = world.add(body.at(2, 3, 0).velocity(0, -speed, 0));
                for (int i = 0; i < 120; i++) {
                    world.step(Scenes.STEP);
                }
                world.validate();
                // without gravity nothing but the platform can change a velocity
                assertEquals(speed, up.velocity().y, 1e-12 * speed);
                assertTrue(down.position().y > .19, "stopped at " + down.position().y);
            }
        }
    }

    /** It jumps through, falls back and stands. */
    @Test
    void whoJumpsThroughStandsOnIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.collisions().setHook(ONE_WAY);
            world.add(platform());
            BodyRef jumper =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.2))
                                    .at(0, -1, 0)
                                    .velocity(0, 6, 0));
            for (int i = 0; i < 240; i++) {
                world.step(Scenes.STEP);
            }
            assertEquals(.2, jumper.position().y, 2e-3);
            world.collisions().setHook(null);
            world.step(Scenes.STEP);
            world.validate();
        }
    }

    /** Coulomb: a block at v stops after v²/(2 mu g), with the friction that the hook sets. */
    @Test
    void frictionOfAContactIsWhatTheHookSays() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.collisions().setHook(contact -> contact.surface(.25, 0));
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).at(0, -.5, 0));
            BodyRef block =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.5, .1, .5)).at(0, .1, 0));
            for (int i = 0; i < 30; i++) {
                world.step(Scenes.STEP);
            }
            double from = block.position().x;
            block.setVelocity(3, 0, 0);
            for (int i = 0; i < 200; i++) {
                world.step(Scenes.STEP);
            }
            assertEquals(9 / (2 * .25 * 9.81), block.position().x - from, .01);
        }
    }

    @Test
    void theSameBitsForWorkersAndLanes() {
        Scenes.assertSameBits(world -> {
            world.collisions()
                    .setHook(contact -> {
                        contact.surface(contact.friction() / 2, .3);
                        contact.remember(contact.memory() + 1);
                        if (contact.memory() % 50 == 49) {
                            contact.disable();
                        }
                    });
            Scenes.everyKindOnEveryKind(world);
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
            }
        });
    }

    @Test
    void aHookThatSetsNonsenseIsTold() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.collisions().setHook(contact -> contact.surface(-1, 0));
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
            world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, .5, 0));
            RuntimeException told =
                    assertThrows(RuntimeException.class, () -> world.step(Scenes.STEP));
            String all = told + " " + told.getCause();
            assertTrue(all.contains("friction -1.0"), all);
        }
    }

    @Test
    void theStrongerRuleWins() {
        Material a = new Material(.2, .1, 1000);
        Material b = new Material(.8, .5, 1000);
        assertEquals(.4, Material.mixFriction(a, b), 1e-15);
        assertEquals(.5, Material.mixRestitution(a, b), 0);
        Material average = b.withMix(Mix.AVERAGE, Mix.AVERAGE);
        assertEquals(.5, Material.mixFriction(a, average), 1e-15);
        assertEquals(.3, Material.mixRestitution(average, a), 1e-15);
        Material least = a.withMix(Mix.MINIMUM, Mix.MULTIPLY);
        assertEquals(.2, Material.mixFriction(average, least), 0);
        assertEquals(.05, Material.mixRestitution(least, average), 1e-15);
        Material most = average.withMix(Mix.MAXIMUM, Mix.DEFAULT);
        assertEquals(.8, Material.mixFriction(least, most), 0);
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(
                    Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0).material(least));
            world.add(
                    Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, .5, 0).material(average));
            world.step(Scenes.STEP);
            assertEquals(.2, Inside.contacts(world).friction(0), 0);
            assertEquals(.05, Inside.contacts(world).restitution[0], 1e-15);
        }
    }
}
