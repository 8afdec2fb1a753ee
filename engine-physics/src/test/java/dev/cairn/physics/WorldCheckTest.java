package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.Random;

/** {@link PhysicsWorld#validate}: silent about what a step leaves, and tells what was corrupted. */
final class WorldCheckTest {
    private final PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
    private final BodyStore bodies = world.physics.table.bodies;
    private final ContactStore contacts = world.physics.contacts;

    private BodyRef stack(int steps) {
        world.add(Body.fixed().shape(HalfSpace.of()).name("ground"));
        BodyRef crate = null;
        for (int i = 0; i < 3; i++) {
            crate =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 0.5 + i, 0)
                                    .name("crate"));
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
    void aWorldOfEveryKindOfShapeIsValid() {
        Scenes.everyKindOnEveryKind(world);
        world.validate();
        run(240);
    }

    @Test
    void bodiesThatComeGoSleepAndJumpLeaveTheWorldValid() {
        Scenes.drop(world, 30, 7);
        Random random = new Random(3);
        for (int tick = 0; tick < 300; tick++) {
            BodyRef one = world.bodies().get(random.nextInt(world.bodyCount()));
            switch (tick % 15) {
                case 0 -> world.add(Scenes.any(random, tick).at(0, 8, 0));
                case 3 -> one.teleport(random.nextDouble(), 6, random.nextDouble());
                case 6 -> one.remove();
                case 9 -> {
                    if (one.type() == BodyType.DYNAMIC) {
                        one.applyImpulse(0, 1e308, 0);
                    }
                }
                case 12 -> one.sleep();
                default -> {}
            }
            world.validate();
            run(1);
        }
        assertTrue(world.quarantined().size() > 1, "some left the range of numbers");
    }

    @Test
    void whoIsPutToSleepFastOrAtOnceIsValid() {
        world.setGravity(0, 0, 0);
        BodyRef fast =
                world.add(Body.dynamic().shape(Sphere.of(0.1)).velocity(0, 0, 0).at(0, 3, 0));
        run(2);
        world.add(Body.dynamic().shape(Sphere.of(3)).velocity(0, -200, 0).at(0, 8, 0));
        run(2);
        fast.sleep();
        world.validate();
        world.add(Body.dynamic().shape(Sphere.of(0.1)).at(50, 3, 0)).sleep();
        world.validate();
        run(1);
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
    void twoRowsOfAPair() {
        stack(3);
        contacts.move(new int[] {1}, new int[] {0}, 1);
        tells("contact row 1", "the only one of a pair");
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
