package dev.cairn.system.tutorial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.collider.Layers;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

/**
 * What a user changes of a body while the world runs, each in less than 30 lines ({@code DocsTest}
 * counts). What each asserts is known from outside the engine.
 */
final class LiveChangesTest {
    private static final double STEP = 1 / 60.0;

    private static void seconds(PhysicsWorld world, double seconds) {
        for (int i = 0; i < Math.round(seconds / STEP); i++) {
            world.step(STEP);
        }
    }

    /** A sledge is drawn with 30 N, and somebody sits down on it: F = m a, before and after. */
    @Test
    void mass() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).build()) {
            Body empty = Body.dynamic().shape(Box.ofHalfExtents(.5, .2, .3)).mass(10);
            BodyRef sledge = world.add(empty.with(new Force(30, 0, 0)));
            seconds(world, 1);
            assertEquals(30.0 / 10, sledge.velocity().x, 1e-12);
            sledge.setMass(60);
            assertEquals(3, sledge.velocity().x, 1e-12, "as fast as before");
            seconds(world, 1);
            assertEquals(3 + 30.0 / 60, sledge.velocity().x, 1e-12);
        }
    }

    /** A rock hangs in the air until the trap is sprung: then it falls by g t²/2, and lies. */
    @Test
    void type() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            BodyRef rock = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(.5)).at(0, 5, 0));
            seconds(world, 1);
            assertEquals(5, rock.position().y);
            rock.setType(BodyType.DYNAMIC);
            seconds(world, .5);
            assertEquals(5 - 9.81 * .5 * .5 / 2, rock.position().y, 1e-12);
            seconds(world, 2);
            rock.setType(BodyType.FIXED);
            assertEquals(.5, rock.position().y, 1e-3);
        }
    }

    /** A crate becomes a small ball while a plank lies on it: both come down, and rest. */
    @Test
    void shape() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            BodyRef crate = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, .5, 0));
            Body plank = Body.dynamic().shape(Box.ofHalfExtents(2, .1, 2)).at(0, 1.1, 0);
            BodyRef onIt = world.add(plank);
            seconds(world, 2);
            crate.setShape(Sphere.of(.2));
            assertEquals(1000 * 4 / 3.0 * Math.PI * .2 * .2 * .2, crate.mass(), 1e-9);
            seconds(world, 4);
            assertEquals(.2, crate.position().y, 2e-3);
            assertTrue(onIt.position().y < .6, "the plank lies on the ball, or beside it");
        }
    }

    /** A trapdoor: a crate stands on it, until it is of a layer that crates do not meet. */
    @Test
    void filter() {
        Layers layers = Layers.of("ground", "crate", "open").apart("open", "crate");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Body floor = Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0);
            world.add(floor.filter(layers.filter("ground")));
            Body door = Body.fixed().shape(Box.ofHalfExtents(1, .1, 1)).at(0, 3, 0);
            BodyRef trapdoor = world.add(door.filter(layers.filter("ground")));
            Body cube = Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, 3.6, 0);
            BodyRef crate = world.add(cube.filter(layers.filter("crate")));
            seconds(world, 2);
            assertEquals(3.6, crate.position().y, 1e-3);
            trapdoor.setFilter(layers.filter("open"));
            seconds(world, 2);
            assertEquals(.5, crate.position().y, 1e-3, "on the ground, through the door");
        }
    }

    /** A balloon at rest is cut loose: with -1/4 of the world's gravity it rises by g t²/8. */
    @Test
    void gravityScale() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            BodyRef balloon = world.add(Body.dynamic().shape(Sphere.of(.5)).at(0, .5, 0));
            seconds(world, 3);
            assertTrue(balloon.isAsleep());
            double start = balloon.position().y;
            balloon.setGravityScale(-.25);
            seconds(world, 2);
            assertEquals(start + 9.81 * 2 * 2 / 8, balloon.position().y, 1e-3);
        }
    }
}
