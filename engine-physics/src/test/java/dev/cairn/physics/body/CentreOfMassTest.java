package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A centre of mass that is given instead of that of the shapes. */
class CentreOfMassTest {
    private static final double G = 9.81;

    /** In flight the centre follows the parabola, and the frame goes round it. */
    @Test
    void theCentreThatIsGivenFliesTheParabola() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Body body = Body.dynamic().shape(Box.ofHalfExtents(.5, .1, .2)).at(0, 9, 0);
            BodyRef box =
                    world.add(
                            body.centreOfMass(.4, .05, -.1)
                                    .velocity(1, 5, 0)
                                    .angularVelocity(0, 0, 3));
            assertEquals(new Vector3d(.4, .05, -.1), box.statedCentreOfMass(new Vector3d()));
            Vector3d start = box.centreOfMass(new Vector3d());
            assertEquals(0, start.distance(.4, 9.05, -.1), 1e-12);
            for (int tick = 1; tick <= 60; tick++) {
                world.step(Scenes.STEP);
                double t = tick * Scenes.STEP;
                Vector3d at = box.centreOfMass(new Vector3d());
                assertEquals(start.x + t, at.x, 1e-11);
                assertEquals(start.y + 5 * t - G * t * t / 2, at.y, 1e-11);
                Vector3d frame = at.sub(box.orientation().transform(new Vector3d(.4, .05, -.1)));
                assertEquals(0, frame.distance(box.position()), 1e-11);
            }
        }
    }

    /** A tumbler rolls to and fro with T = 2 pi sqrt((I + m (r - d)²)/(m g d)). */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 8"})
    void aTumblerSwingsWithItsPeriod(int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder().settings(settings).workers(workers).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).at(0, 0, 0));
            double r = .5;
            double d = .2;
            double m = 3;
            double inertia = .2;
            Body egg = Body.dynamic().shape(Sphere.of(r)).mass(m).inertia(.2, .2, inertia);
            double tilt = .01;
            BodyRef ball =
                    world.add(
                            egg.centreOfMass(0, -d, 0)
                                    .at(0, r, 0)
                                    .rotation(new Quaterniond().rotateZ(tilt)));
            double period =
                    2 * Math.PI * Math.sqrt((inertia + m * (r - d) * (r - d)) / (m * G * d));
            double before = tilt;
            int crossings = 0;
            double last = 0;
            for (int tick = 1; crossings < 9; tick++) {
                world.step(Scenes.STEP);
                double now = 2 * ball.orientation().z;
                if (before * now < 0) {
                    crossings++;
                    last = (tick - now / (now - before)) * Scenes.STEP;
                }
                before = now;
                assertTrue(tick < 2000, "it does not swing");
            }
            // the ninth passage is after two periods and a quarter, nine halves less a quarter
            assertEquals(1, last / (4.25 * period), 2e-3);
            world.validate();
        }
    }

    /** A block over an edge falls by where its centre is, not by where its middle is. */
    @ParameterizedTest
    @CsvSource({"-.3, true", ".1, false"})
    void aBlockOverAnEdgeStandsByItsCentre(double centre, boolean stands) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(2, .5, 2)).at(-2, -.5, 0));
            Body block = Body.dynamic().shape(Box.ofHalfExtents(.5, .1, .2));
            BodyRef box = world.add(block.at(.1, .1, 0).centreOfMass(centre, 0, 0));
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(stands, box.position().y > .09);
        }
    }

    /** The middle, given as a centre, is what a box has anyway; a change keeps frame and motion. */
    @Test
    void aChangeKeepsTheFrameAndThePointsVelocities() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(1, 2, 3);
            BodyRef box = world.add(body.angularVelocity(0, 0, 2).velocity(1, 0, 0));
            assertTrue(Double.isNaN(box.statedCentreOfMass(new Vector3d()).x));
            ColliderRef collider = box.colliders().get(0);
            box.setCentreOfMass(.25, 0, 0);
            assertEquals(new Vector3d(1, 2, 3), box.position());
            // w x d = (0, 0, 2) x (1/4, 0, 0)
            assertEquals(0, box.velocity().distance(1, .5, 0), 1e-12);
            assertEquals(collider, box.colliders().get(0));
            WorldState saved = world.save();
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(0, box.centreOfMass(new Vector3d()).distance(1.75, 2.25, 3), 1e-12);
            long digest = world.digest();
            box.setCentreOfMass(0, 0, 0);
            world.restore(saved);
            assertEquals(new Vector3d(.25, 0, 0), box.statedCentreOfMass(new Vector3d()));
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(digest, world.digest());
            box.add(Collider.of(Sphere.of(.1)).at(0, 1, 0));
            box.colliders().get(1).remove();
            assertEquals(.25, box.statedCentreOfMass(new Vector3d()).x, 0.0);
            world.step(Scenes.STEP);
            world.validate();
        }
    }

    @Test
    void whatCannotBeIsRefused() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(.5));
            assertThrows(IllegalArgumentException.class, () -> body.centreOfMass(0, Double.NaN, 0));
            Body ground = Body.fixed().shape(HalfSpace.of()).centreOfMass(1, 0, 0);
            assertThrows(IllegalArgumentException.class, () -> world.add(ground));
            assertEquals(0, world.bodyCount());
            BodyRef box = world.add(body);
            assertThrows(
                    IllegalArgumentException.class,
                    () -> box.setCentreOfMass(Double.POSITIVE_INFINITY, 0, 0));
            assertTrue(Double.isNaN(box.statedCentreOfMass(new Vector3d()).y));
        }
    }

    /** One that may not sleep wakes, and falls asleep once it may. */
    @Test
    void whoMaySleepCanBeAskedAndChanged() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
            Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, .5, 0);
            BodyRef box = world.add(body.canSleep(false));
            assertFalse(box.canSleep());
            for (int change = 0; change < 3; change++) {
                for (int tick = 0; tick < 120; tick++) {
                    world.step(Scenes.STEP);
                }
                assertEquals(box.canSleep(), box.isAsleep());
                box.setCanSleep(!box.canSleep());
                assertEquals(change % 2 == 0, box.canSleep());
                assertFalse(box.isAsleep() && !box.canSleep());
            }
        }
    }
}
