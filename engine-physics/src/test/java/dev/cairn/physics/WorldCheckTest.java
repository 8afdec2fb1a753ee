package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

/** {@link PhysicsWorld#validate}: silent about what a step leaves, and tells what was corrupted. */
final class WorldCheckTest {
    private final PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
    private final BodyStore bodies = world.physics.table.bodies;
    private final ContactStore contacts = world.physics.contacts;

    private BodyRef stack(int steps) {
        world.add(Body.fixed().shape(HalfSpace.of()).name("ground"));
        BodyRef crate = null;
        for (int i = 0; i < 3; i++) {
            crate = world.add(Body.dynamic().shape(Box.cube(0.5)).at(0, 0.5 + i, 0).name("crate"));
        }
        run(steps);
        return crate;
    }

    private void run(int steps) {
        for (int i = 0; i < steps; i++) {
            world.step(1.0 / 60);
            world.validate();
        }
    }

    private void tells(String... parts) {
        String message =
                assertThrows(IllegalStateException.class, world::validate, parts[0]).getMessage();
        for (String part : parts) {
            assertTrue(message.contains(part), message);
        }
        assertTrue(message.contains("must be"), message);
        assertTrue(message.contains("report"), message);
    }

    private int slot(BodyRef ref) {
        for (int s = 0; s < bodies.slotCount; s++) {
            if (bodies.entity[s] == ref.entity()) {
                return s;
            }
        }
        throw new AssertionError(ref);
    }

    @Test
    void aWorldThatIsRunIsValid() {
        BodyRef top = stack(30);
        BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.3)).at(0.2, 6, 0));
        world.validate();
        run(120);
        top.teleport(5, 3, 0);
        world.validate();
        run(10);
        ball.remove();
        world.validate();
        run(300);
        assertTrue(top.isAsleep());
        top.remove();
        run(5);
    }

    @Test
    void velocity() {
        int s = slot(stack(3));
        bodies.velocityX[s] = Double.NaN;
        tells("crate", "slot " + s, "velocity x is NaN", "finite");
    }

    @Test
    void orientation() {
        int s = slot(stack(3));
        bodies.orientationW[s] *= 1.01;
        tells("crate", "length of the orientation is 1.01", "1 within 1e-9");
    }

    @Test
    void entity() {
        int s = slot(stack(3));
        bodies.entity[s] = bodies.entity[s - 1];
        tells("number of bodies is 2");
    }

    @Test
    void boxOfSleeper() {
        BodyRef top = stack(240);
        assertTrue(top.isAsleep());
        bodies.positionX[slot(top)] += 7;
        tells("crate", "upper end along x is", "at most");
    }

    @Test
    void island() {
        BodyRef top = stack(240);
        bodies.kind[slot(top)] = BodyStore.DYNAMIC;
        tells("crate", "island of an awake body", "must be -1");
    }

    @Test
    void impulse() {
        stack(3);
        contacts.normalImpulse[0] = -0.25;
        tells("contact row 0 of ", "ground", "crate", "normal impulse of point 0 is -0.25");
    }

    @Test
    void contactOfAFreedBody() {
        int s = slot(stack(3));
        bodies.kind[s] = BodyStore.FREE;
        tells("contact row ", "slot of a body is " + s);
    }

    @Test
    void onlyBetweenSteps() {
        world.close();
        assertThrows(IllegalStateException.class, world::validate);
        assertDoesNotThrow(world::close);
    }
}
