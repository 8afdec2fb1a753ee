package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.Layers;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Everyday programs around colliders, as a user would write them. */
final class EverydayCollisionsTest {
    private static void seconds(PhysicsWorld world, double seconds) {
        for (int i = 0; i < 60 * seconds; i++) {
            world.step(1 / 60.0);
        }
    }

    /** A door that counts who comes in. */
    @Test
    void trigger() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).build()) {
            world.add(
                    Body.fixed()
                            .collider(
                                    Collider.of(Box.ofHalfExtents(.1, 1, 1))
                                            .sensor(true)
                                            .userData("door")));
            world.add(Body.dynamic().shape(Sphere.of(.3)).at(-2, 0, 0).velocity(2, 0, 0));
            List<Object> seen = new ArrayList<>();
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void entered(ColliderRef sensor, ColliderRef visitor) {
                                    seen.add(sensor.userData());
                                }
                            });
            seconds(world, 3);
            assertEquals(List.of("door"), seen);
        }
    }

    /** Ghosts go through crates, and stand on the ground. */
    @Test
    void layers() {
        Layers layers = Layers.of("ground", "crate", "ghost").apart("ghost", "crate");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(9, 1, 9))
                            .at(0, -1, 0)
                            .filter(layers.filter("ground")));
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(.5))
                            .at(0, .5, 0)
                            .filter(layers.filter("crate")));
            BodyRef ghost =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(.5))
                                    .at(0, 3, 0)
                                    .filter(layers.filter("ghost")));
            seconds(world, 3);
            assertEquals(.5, ghost.position().y, .01);
        }
    }

    /** A table is a top and four legs. */
    @Test
    void compound() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            Body table =
                    Body.dynamic()
                            .collider(Collider.of(Box.ofHalfExtents(.8, .05, .5)).at(0, .75, 0));
            for (int leg = 0; leg < 4; leg++) {
                double x = leg < 2 ? -.7 : .7;
                double z = leg % 2 == 0 ? -.4 : .4;
                table.collider(Collider.of(Box.ofHalfExtents(.05, .35, .05)).at(x, .35, z));
            }
            BodyRef standing = world.add(table.at(0, .2, 0));
            BodyRef vase =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.1, .2, .1)).at(0, 1.4, 0));
            seconds(world, 3);
            assertEquals(0, standing.position().y, .01);
            assertEquals(1, vase.position().y, .01);
        }
    }

    /** A crate on a conveyor belt goes as fast as the belt. */
    @Test
    void conveyor() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(
                    Body.fixed()
                            .collider(
                                    Collider.of(Box.ofHalfExtents(20, .5, 1))
                                            .at(0, -.5, 0)
                                            .surfaceVelocity(1.5, 0, 0)));
            BodyRef crate = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.3)).at(-9, .3, 0));
            seconds(world, 12);
            assertEquals(1.5, crate.velocity().x, 1e-9);
        }
    }

    /** Solid for who comes from above, open for who comes from below. */
    @Test
    void oneWay() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.collisions()
                    .setHook(contact -> {
                        double up = contact.normalY();
                        if ("one-way".equals(contact.userDataB())) {
                            up = -up;
                        } else if (!"one-way".equals(contact.userDataA())) {
                            return;
                        }
                        boolean stood = contact.memory() == 1;
                        boolean solid = up > .7 && (stood || contact.separation() > -.005);
                        contact.remember(solid ? 1 : 0);
                        if (!solid) {
                            contact.disable();
                        }
                    });
            world.add(
                    Body.fixed()
                            .collider(
                                    Collider.of(Box.ofHalfExtents(2, .1, 2)).userData("one-way")));
            BodyRef jumper =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.3))
                                    .at(0, -1, 0)
                                    .velocity(0, 8, 0));
            double highest = 0;
            for (int i = 0; i < 180; i++) {
                world.step(1 / 60.0);
                highest = Math.max(highest, jumper.position().y);
            }
            assertTrue(highest > 2, "it jumped through");
            assertEquals(.4, jumper.position().y, .01, "and stands on it");
        }
    }
}
