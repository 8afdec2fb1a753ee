package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.state.RigidBody;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Fixed bodies are not looked at in each tick; they go with their entities all the same. */
class FixedBodiesGoTest {
    private static final double STEP = 1.0 / 60;

    /** Deletes the second one by a command in tick 20. */
    private record Deletes(List<BodyRef> plates) implements WorldSystem {
        @Override
        public String name() {
            return "deletes";
        }

        @Override
        public void describe(Access access) {
            access.commands().before(PhysicsWorld.SYSTEM);
        }

        @Override
        public void run(Tick tick) {
            if (tick.number() == 20) {
                tick.commands().delete(plates.get(1).entity());
            }
        }
    }

    /** Plates 2 m apart, each with a ball on it; a plate is gone when its entity is. */
    @Test
    void aFixedBodyGoesWithItsEntity() {
        List<BodyRef> plates = new ArrayList<>();
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).systems(new Deletes(plates)).build()) {
            List<BodyRef> balls = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                plates.add(
                        world.add(
                                Body.fixed().shape(Box.ofHalfExtents(.5, .5, .5)).at(2 * i, 0, 0)));
                balls.add(world.add(Body.dynamic().shape(Sphere.of(.25)).at(2 * i, .75, 0)));
            }
            run(world, 10);
            assertEquals(List.of(), fallen(balls));
            world.ecs().delete(plates.get(0).entity());
            run(world, 30);
            assertEquals(
                    List.of(0, 1), fallen(balls), "between steps, and by a command in tick 20");
            var state = world.save();
            world.ecs().remove(plates.get(2).entity(), RigidBody.COMPONENT);
            run(world, 30);
            assertEquals(List.of(0, 1, 2), fallen(balls), "no body any more");
            world.restore(state);
            run(world, 30);
            assertEquals(List.of(0, 1), fallen(balls), "there again");
            world.setPaused(true);
            run(world, 5);
            world.ecs().delete(plates.get(3).entity());
            run(world, 5);
            world.setPaused(false);
            run(world, 30);
            assertEquals(List.of(0, 1, 3), fallen(balls), "while the physics was paused");
        }
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(STEP);
        }
    }

    private static List<Integer> fallen(List<BodyRef> balls) {
        List<Integer> fallen = new ArrayList<>();
        for (int i = 0; i < balls.size(); i++) {
            if (balls.get(i).position().y() < .7) {
                fallen.add(i);
            }
        }
        return fallen;
    }
}
