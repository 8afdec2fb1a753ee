package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** What is put up at rest and in balance stays as it is, from the first tick on. */
class StaticStartTest {
    private static PhysicsWorld world(int substeps, int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSubsteps(substeps).withLanes(lanes);
        return PhysicsWorld.builder().settings(settings).sleeping(false).workers(workers).build();
    }

    /** Soft contacts that begin without a load give by g/w², 0.28 mm at 4 sub-steps. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8})
    void aStackStandsFromTheFirstTickOn(int substeps) {
        try (PhysicsWorld world = world(substeps, 1, 1)) {
            List<BodyRef> stack = Scenes.stack(world, 10);
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                for (int i = 0; i < stack.size(); i++) {
                    assertEquals(0.5 + i, stack.get(i).position().y, 1e-10, "tick " + tick);
                }
            }
        }
    }

    /**
     * Towers whose load takes thousands of plain sweeps to come down to the ground: each body stays
     * where it was put, with whatever is above it.
     */
    @ParameterizedTest
    @CsvSource({"30, 1", "6, 1.5", "8, 0.8"})
    void aTowerStandsFromTheFirstTickOn(int bodies, double growth) {
        try (PhysicsWorld world = world(4, 1, 1)) {
            Scenes.ground(world);
            double top = 0;
            double half = 0.5;
            double[] heights = new double[bodies];
            BodyRef[] tower = new BodyRef[bodies];
            for (int i = 0; i < bodies; i++) {
                heights[i] = top + half;
                Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(half));
                tower[i] = world.add(body.at(0, heights[i], 0));
                top += 2 * half;
                half *= growth;
            }
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                for (int i = 0; i < bodies; i++) {
                    assertEquals(heights[i], tower[i].position().y, 1e-8, "tick " + tick);
                }
            }
        }
    }

    /** A house of thin cards, which has fallen where its contacts learn of the load by and by. */
    @ParameterizedTest
    @ValueSource(ints = {2, 4})
    void aHouseOfCardsStands(int substeps) {
        try (PhysicsWorld world = world(substeps, 1, 1)) {
            Scenes.ground(world);
            Scenes.cards(world, 4);
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                for (BodyRef card : world.bodies()) {
                    double speed = card.velocity(new Vector3d()).length();
                    assertTrue(speed < 1e-6, "speed " + speed + " in tick " + tick);
                }
            }
        }
    }

    @Test
    void whatElseStartsChangesNoBit() {
        try (PhysicsWorld alone = world(4, 1, 1);
                PhysicsWorld both = world(4, 1, 1)) {
            List<BodyRef> one = Scenes.stack(alone, 5);
            List<BodyRef> other = Scenes.stack(both, 5);
            Scenes.cards(both, 3);
            both.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(-5, 0.5, 0));
            for (int tick = 0; tick < 30; tick++) {
                alone.step(Scenes.STEP);
                both.step(Scenes.STEP);
            }
            assertArrayEquals(Scenes.places(one), Scenes.places(other), 0.0);
        }
    }

    @Tag("compiled")
    @ParameterizedTest
    @CsvSource({"3, 4", "2, 8"})
    void theSameBitsForAnyWorkersAndLanes(int workers, int lanes) {
        assertEquals(digest(1, 1), digest(workers, lanes));
    }

    private static long digest(int workers, int lanes) {
        try (PhysicsWorld world = world(4, workers, lanes)) {
            Scenes.stack(world, 20);
            Scenes.cards(world, 6);
            for (int i = 0; i < 40; i++) {
                for (int k = 0; k < 1 + i % 5; k++) {
                    double aside = 0.001 * (i * 7 % 5);
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.25))
                                    .at(-20 + i % 8, 0.25 + 0.5 * k, 5 + i / 8 + aside * k));
                }
            }
            for (int tick = 0; tick < 20; tick++) {
                world.step(Scenes.STEP);
            }
            return world.digest();
        }
    }

    /** What cannot stand is let go as it is: a cube over the edge of another by more than half. */
    @Test
    void whatIsOutOfBalanceFalls() {
        try (PhysicsWorld world = world(4, 1, 1)) {
            Scenes.ground(world);
            world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            BodyRef over =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0.6, 1.5, 0));
            for (int tick = 0; tick < 6; tick++) {
                world.step(Scenes.STEP);
            }
            // about the edge, I = 2/3 m a² + ..., at first: w' = m g d/(m a²/6 + m (d² + a²/4))
            double d = 0.1;
            double rate = 9.81 * d / (1 / 6.0 + d * d + 0.25) * 0.1;
            double turned = -over.angularVelocity().z;
            assertTrue(turned > 0.8 * rate && turned < 1.3 * rate, turned + " for " + rate);
        }
    }
}
