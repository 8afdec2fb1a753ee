package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Change;
import dev.cairn.core.ecs.Observer;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Observers that throw, or take away, while a body is added: the body is whole, or gone. */
class ObservedBodiesTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorld world() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
        return world;
    }

    private static Body ball(double x) {
        return Body.dynamic().shape(Sphere.of(0.5)).at(x, 2, 0).velocity(0, 0, 1);
    }

    @Test
    void aBodyIsThereThoughAnObserverThrew() {
        try (PhysicsWorld world = world();
                PhysicsWorld plain = world()) {
            Observer<Velocity> bad =
                    new Observer<>() {
                        @Override
                        public void added(Change<Velocity> change) {
                            throw new ArithmeticException("seven");
                        }
                    };
            world.ecs().observe(Velocity.COMPONENT, bad);
            IllegalStateException told =
                    assertThrows(IllegalStateException.class, () -> world.add(ball(0)));
            assertTrue(told.getMessage().contains("seven"), told.getMessage());
            assertTrue(told.getMessage().contains("is made"), told.getMessage());
            assertEquals(2, world.bodyCount());
            BodyRef first = world.bodies().getLast();
            assertEquals(new Vector3d(0, 2, 0), first.position(new Vector3d()));
            assertEquals(first, world.bodyOf(first.entity()));
            world.ecs().unobserve(Velocity.COMPONENT, bad);
            BodyRef second = world.add(ball(3));
            plain.add(ball(0));
            plain.add(ball(3));
            for (int tick = 0; tick < 90; tick++) {
                world.step(STEP);
                plain.step(STEP);
                assertEquals(plain.digest(), world.digest(), "tick " + tick);
            }
            assertTrue(first.isAlive() && second.isAlive());
        }
    }

    @Test
    void aBodyThatAnObserverDeletesIsGone() {
        try (PhysicsWorld world = world()) {
            Observer<Velocity> strict =
                    new Observer<>() {
                        @Override
                        public void added(Change<Velocity> change) {
                            change.commands().delete(change.entity());
                        }
                    };
            world.ecs().observe(Velocity.COMPONENT, strict);
            BodyRef ref = world.add(ball(0));
            assertFalse(ref.isAlive());
            world.step(STEP);
            assertEquals(List.of(1), List.of(world.bodyCount()));
            world.ecs().unobserve(Velocity.COMPONENT, strict);
            BodyRef next = world.add(ball(1));
            world.step(STEP);
            assertNotNull(world.bodyOf(next.entity()));
            assertTrue(next.isAlive());
            assertEquals(2, world.bodyCount());
        }
    }
}
