package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/**
 * Far from the origin the same happens as at the origin: the laws know no place. What can be read
 * of a position is rounded to half a unit of its last place, and no more than that is lost.
 */
class FarTest {
    private static final Vector3d HERE = new Vector3d();
    private static final Vector3d FAR = new Vector3d(3e6, 1e7, -8e4);

    /** Half a unit of the last place of 1e7, and what the two runs differ by in last digits. */
    private static final double READ = 0.5 * Math.ulp(1e7) + 1e-12;

    private record Run(double[] places, double[] speeds, long digest, boolean far) {}

    private static PhysicsWorldBuilder world(int workers, int lanes) {
        return Scenes.awake()
                .workers(workers)
                .settings(PhysicsSettings.DEFAULT.withSubsteps(4).withLanes(lanes));
    }

    /** Ten cubes and a ball that rolls past them; coordinates are multiples of 2^-10 m. */
    private static Run stack(Vector3d at, int workers, int lanes) {
        try (PhysicsWorld world = world(workers, lanes).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(64, 1, 64)).at(at.x, at.y - 1, at.z));
            List<BodyRef> bodies = new ArrayList<>();
            for (int i = 0; i < 10; i++) {
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.5))
                                        .at(
                                                at.x + 0.0078125 * (i % 3),
                                                at.y + 0.5 + i,
                                                at.z + 0.00390625 * (i % 2))));
            }
            bodies.add(
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.25))
                                    .at(at.x + 2, at.y + 1.25, at.z)
                                    .velocity(0.5, 0, 0.25)));
            for (int tick = 0; tick < 300; tick++) {
                world.step(Scenes.STEP);
            }
            double[] places = new double[3 * bodies.size()];
            double[] speeds = new double[places.length];
            for (int i = 0; i < bodies.size(); i++) {
                Vector3d p = bodies.get(i).position().sub(at);
                places[3 * i] = p.x;
                places[3 * i + 1] = p.y;
                places[3 * i + 2] = p.z;
                Vector3d v = bodies.get(i).velocity();
                speeds[3 * i] = v.x;
                speeds[3 * i + 1] = v.y;
                speeds[3 * i + 2] = v.z;
            }
            return new Run(places, speeds, world.digest(), world.physics.table.bodies.isFar);
        }
    }

    @Test
    void aStackAndABallTenThousandKilometresAway() {
        Run here = stack(HERE, 1, 1);
        Run far = stack(FAR, 1, 1);
        assertTrue(far.far && !here.far);
        for (int i = 0; i < here.places.length; i++) {
            assertEquals(here.places[i], far.places[i], READ, "coordinate " + i);
            // a gap that is off by half a unit of 1e7 would be closed at 5e-8 m/s
            assertEquals(here.speeds[i], far.speeds[i], 1e-11, "speed " + i);
        }
    }

    @Tag("compiled")
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4})
    void theSameBitsThereForAnyWorkersAndLanes(int workers) {
        long digest = stack(FAR, 1, 1).digest;
        assertEquals(digest, stack(FAR, workers, 1).digest);
        assertEquals(digest, stack(FAR, workers, 4).digest);
    }

    /** What lies near keeps its bits when somebody is far away. */
    @Test
    void aBodyFarAwayIsNoMatterToThoseNear() {
        assertEquals(near(false), near(true));
    }

    private static List<Vector3d> near(boolean withFar) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            List<BodyRef> stack = Scenes.stack(world, 5);
            if (withFar) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(8, 1, 8)).at(1e7, -1, 0));
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(1e7 + 0.3, 0.5, 0.1));
            }
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(withFar, world.physics.table.bodies.isFar);
            return stack.stream().map(BodyRef::position).toList();
        }
    }

    /** A body in flight there, and one that has come home, or was put elsewhere, lacks nothing. */
    @Test
    void whatAPositionLacksGoesWithIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            BodyRef body =
                    world.add(Body.dynamic().shape(Sphere.of(1)).at(1e7, 0, 0).velocity(0.1, 0, 0));
            BodyStore b = world.physics.table.bodies;
            world.step(Scenes.STEP);
            assertNotEquals(0.0, b.positionLow[0]);
            // 0.1/60 m more than 1e7, to the last digit of the sum of both parts
            assertEquals(0.1 / 60, b.positionX[0] - 1e7 + b.positionLow[0], 1e-18);
            body.teleport(1, 0, 0);
            assertEquals(0.0, b.positionLow[0]);
            world.step(Scenes.STEP);
            assertEquals(1 + 0.1 / 60, b.positionX[0], 1e-15);
            assertEquals(0.0, b.positionLow[0]);
        }
    }

    /** Who goes out there keeps his bits whether somebody is there already or not. */
    @Test
    void whoCrossesTheBoundIsNoMatterOfOthers() {
        assertEquals(leaves(false), leaves(true));
    }

    private static List<Double> leaves(boolean withFar) {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            double bound = BodyStore.FAR;
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(1))
                                    .at(bound - 0.0101, 0, 0)
                                    .velocity(0.3, 0, 0)
                                    .damping(0.1, 0));
            if (withFar) {
                world.add(Body.dynamic().shape(Sphere.of(1)).at(1e7, 0, 0).velocity(0.1, 0, 0));
            }
            BodyStore b = world.physics.table.bodies;
            List<Double> path = new ArrayList<>();
            for (int tick = 0; tick < 6; tick++) {
                world.step(Scenes.STEP);
                path.add(body.position().x);
                path.add(b.positionLow[0]);
            }
            assertTrue(path.getFirst() < bound && path.get(10) > bound, path.toString());
            return path;
        }
    }
}
