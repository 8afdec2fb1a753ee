package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class FreeMotionTest {
    private static final double STEP = 1.0 / 60.0;

    @Test
    void freeFallIsTheParabola() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, -9.81, 0).workers(1).build()) {
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.25))
                                    .at(1, 200, -3)
                                    .velocity(2, 5, -1));
            for (int tick = 1; tick <= 300; tick++) {
                world.step(STEP);
                double t = tick * STEP;
                Vector3d p = ball.position();
                assertEquals(1 + 2 * t, p.x, 1e-9);
                assertEquals(200 + 5 * t - 0.5 * 9.81 * t * t, p.y, 1e-9);
                assertEquals(-3 - t, p.z, 1e-9);
                assertEquals(5 - 9.81 * t, ball.velocity().y, 1e-9);
            }
        }
    }

    @Test
    void publishesPoseAndVelocityColumns() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 50, 0)
                                    .velocity(1, 0, 0));
            assertEquals(50, world.ecs().get(box.entity(), Pose.COMPONENT).y());
            for (int tick = 0; tick < 30; tick++) {
                world.step(STEP);
            }
            Pose pose = world.ecs().get(box.entity(), Pose.COMPONENT);
            Velocity velocity = world.ecs().get(box.entity(), Velocity.COMPONENT);
            assertEquals(box.position(), new Vector3d(pose.x(), pose.y(), pose.z()));
            assertEquals(box.velocity(), new Vector3d(velocity.vx(), velocity.vy(), velocity.vz()));
            assertEquals(0, pose.jumps());
        }
    }

    @Test
    void theShapeFrameIsWhereTheUserPutItThoughTheCentreOfMassIsElsewhere() {
        double[] corner = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            Quaterniond turned = new Quaterniond().rotationXYZ(0.3, -0.7, 1.1);
            BodyRef tetrahedron =
                    world.add(
                            Body.dynamic()
                                    .shape(ConvexHull.of(corner))
                                    .at(3, 4, 5)
                                    .rotation(turned));
            assertTrue(tetrahedron.position().distance(3, 4, 5) < 1e-12);
            Vector3d expected = turned.transform(new Vector3d(0.25)).add(3, 4, 5);
            Vector3d com = tetrahedron.centreOfMass(new Vector3d());
            assertTrue(com.distance(expected) < 1e-12, com.toString());
            world.step(STEP);
            assertTrue(tetrahedron.position().distance(3, 4, 5) < 1e-12);
            assertTrue(tetrahedron.orientation().equals(turned, 1e-12));
        }
    }

    @Test
    void aForceActsForOneStepAndIsThenForgotten() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body = world.add(Body.dynamic().shape(Sphere.of(1)).mass(2));
            body.applyForce(3, 0, 0);
            body.applyForce(3, 0, 0);
            world.step(0.5);
            assertEquals(1.5, body.velocity().x, 1e-12);
            world.step(0.5);
            assertEquals(1.5, body.velocity().x, 1e-12);
        }
    }

    @Test
    void impulsesAndTorquesTurnByTheInertia() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body = world.add(Body.dynamic().shape(Sphere.of(1)).mass(5).at(1, 2, 3));
            double inertia = 0.4 * 5;
            body.applyImpulseAt(0, 10, 0, 2, 2, 3);
            assertEquals(2, body.velocity().y, 1e-12);
            assertEquals(10 / inertia, body.angularVelocity().z, 1e-12);
            body.applyAngularImpulse(0, 0, -10);
            assertEquals(0, body.angularVelocity().z, 1e-12);
            body.applyTorque(4, 0, 0);
            world.step(0.25);
            assertEquals(4 * 0.25 / inertia, body.angularVelocity().x, 1e-9);
            body.applyForceAt(0, 0, 6, 1, 3, 3);
            world.step(0.25);
            assertTrue(body.angularVelocity().x > 4 * 0.25 / inertia, "lever of 6 N");
        }
    }

    @Test
    void kineticsAreThoseOfTheTextbook() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(1))
                            .mass(5)
                            .at(0, 10, 0)
                            .velocity(3, 0, 0)
                            .angularVelocity(0, 0, 2));
            world.add(Body.fixed().shape(Box.cubeOfHalfExtent(1)));
            Kinetics k = world.kinetics();
            assertEquals(0.5 * 5 * 9 + 0.5 * 2 * 4, k.kineticEnergy(), 1e-12);
            assertEquals(15, k.momentumX(), 1e-12);
            assertEquals(-150 + 4, k.angularMomentumZ(), 1e-12);
            assertEquals(k.kineticEnergy(), world.kineticEnergy());
        }
    }

    @Test
    void teleportCountsAsAJumpAtOnceAndKeepsTheVelocity() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(1)).velocity(6, 0, 0));
            body.teleport(100, 0, 0);
            assertEquals(1, world.ecs().get(body.entity(), Pose.COMPONENT).jumps());
            assertEquals(100, world.ecs().get(body.entity(), Pose.COMPONENT).x());
            world.step(0.5);
            assertEquals(103, body.position().x, 1e-12);
            assertEquals(1, world.ecs().get(body.entity(), Pose.COMPONENT).jumps());
            BodyRef wall = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(1)).at(0, 50, 0));
            wall.teleport(0, 60, 0, new Quaterniond().rotationY(1));
            assertEquals(60, wall.position().y, 1e-12);
            world.step(0.5);
            assertEquals(60, world.ecs().get(wall.entity(), Pose.COMPONENT).y(), 1e-12);
        }
    }

    @Test
    void pauseStopsThePhysicsAndForgetsForces() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body = world.add(Body.dynamic().shape(Sphere.of(1)).velocity(1, 0, 0));
            world.setPaused(true);
            assertTrue(world.isPaused());
            body.applyForce(1e6, 0, 0);
            world.step(1);
            assertEquals(0, body.position().x);
            world.setPaused(false);
            world.step(1);
            assertEquals(1, body.position().x, 1e-12);
            assertEquals(1, body.velocity().x, 1e-12);
        }
    }
}
