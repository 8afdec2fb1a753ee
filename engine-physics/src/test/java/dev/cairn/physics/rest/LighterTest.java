package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What lies at rest goes on to do so when it becomes lighter: its weight is carried, whatever it
 * is.
 */
class LighterTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorld world(int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes);
        return PhysicsWorld.builder().workers(workers).settings(settings).build();
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(STEP);
        }
    }

    /** Bodies of 1000 kg, each on the one before, that have come to rest. */
    private static BodyRef[] stack(PhysicsWorld world, Shape shape, int count) {
        world.add(Body.fixed().shape(HalfSpace.of()));
        BodyRef[] bodies = new BodyRef[count];
        for (int i = 0; i < count; i++) {
            bodies[i] = world.add(Body.dynamic().shape(shape).at(0, 0.5 + i, 0));
            bodies[i].setMass(1000);
        }
        run(world, 100);
        return bodies;
    }

    /** From 1000 kg: alone, with one below and above; digests for workers and lanes. */
    @ParameterizedTest
    @ValueSource(doubles = {500, 1, 1e-3})
    void whatBecomesLighterStays(double kilograms) {
        Shape[] shapes = {Box.cubeOfHalfExtent(0.5), Sphere.of(0.5), Cylinder.of(0.5, 0.5)};
        for (Shape shape : shapes) {
            for (int count = 1; count <= 3; count += 2) {
                assertEquals(
                        stays(shape, count, kilograms, 1, 1), stays(shape, count, kilograms, 3, 4));
            }
        }
    }

    private static long stays(Shape shape, int count, double kilograms, int workers, int lanes) {
        try (PhysicsWorld world = world(workers, lanes)) {
            BodyRef[] bodies = stack(world, shape, count);
            bodies[count / 2].setMass(kilograms);
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                for (int i = 0; i < count; i++) {
                    // a sag of 2.6e-5 m of what carries less comes up again, alone; nobody falls:
                    // in one tick that would be 2.7e-3 m
                    assertEquals(0.5 + i, bodies[i].position().y, 3e-4, shape + ", tick " + t);
                }
            }
            return world.digest();
        }
    }

    /** The same for what gravity pulls less; a scale of 0.001 is a weight of a thousandth. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void whatGravityPullsLessStays(int count) {
        try (PhysicsWorld world = world(1, 1)) {
            BodyRef[] bodies = stack(world, Box.cubeOfHalfExtent(0.5), count);
            bodies[count - 1].setGravityScale(0.001);
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                for (int i = 0; i < count; i++) {
                    assertEquals(0.5 + i, bodies[i].position().y, 5e-4, "tick " + t);
                    // contacts farther down learn of it from tick to tick; a tenth of g h
                    assertEquals(0, bodies[i].velocity().length(), 4e-3, "tick " + t);
                }
            }
        }
    }

    /** On a slope of 20 degrees friction is a part of what carries it. */
    @Test
    void whatBecomesLighterOnASlopeStays() {
        try (PhysicsWorld world = world(1, 1)) {
            Quaterniond turn = new Quaterniond().rotateZ(Math.toRadians(20));
            Material rough = Material.DEFAULT.withFriction(0.8);
            world.add(Body.fixed().shape(HalfSpace.of()).rotation(turn).material(rough));
            Vector3d up = turn.transform(new Vector3d(0, 0.5, 0));
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(up)
                                    .rotation(turn)
                                    .material(rough));
            box.setMass(1000);
            run(world, 100);
            Vector3d before = box.position();
            box.setMass(1);
            run(world, 60);
            assertEquals(0, box.position().distance(before), 1e-4);
        }
    }

    /** Without weight there is nothing that moves a stack: it stays where it is. */
    @ParameterizedTest
    @ValueSource(doubles = {-1, 0})
    void aStackWhoseGravityIsTurnedDownStays(double gravity) {
        try (PhysicsWorld world = world(1, 1)) {
            BodyRef[] bodies = stack(world, Box.cubeOfHalfExtent(0.5), 8);
            world.setGravity(0, gravity, 0);
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                for (int i = 0; i < 8; i++) {
                    // what it was pressed together by is 2e-4 m
                    assertEquals(0.5 + i, bodies[i].position().y, 1e-3, "tick " + t);
                    assertEquals(0, bodies[i].velocity().length(), 1e-2, "tick " + t);
                }
            }
        }
    }

    /**
     * A lorry that is unloaded bit by bit: each load that goes leaves all others where they are.
     */
    @Test
    void whatLosesMassInEachTickStays() {
        try (PhysicsWorld world = world(1, 1)) {
            BodyRef[] bodies = stack(world, Box.cubeOfHalfExtent(0.5), 10);
            for (int t = 0; t < 300; t++) {
                bodies[9].setMass(bodies[9].mass() * 0.98);
                world.step(STEP);
                for (int i = 0; i < 10; i++) {
                    assertEquals(0.5 + i, bodies[i].position().y, 1e-3, "tick " + t);
                }
            }
        }
    }
}
