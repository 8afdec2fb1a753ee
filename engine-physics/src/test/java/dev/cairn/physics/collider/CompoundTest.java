package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Inside;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

class CompoundTest {
    /** A box of half edges (1, 0.3, 0.5), or the two that it makes when it is cut across x. */
    private static Body brick(boolean cut) {
        Body body = Body.dynamic();
        if (!cut) {
            return body.shape(Box.ofHalfExtents(1, .3, .5));
        }
        Quaterniond half = new Quaterniond().rotateY(Math.PI);
        return body.collider(Collider.of(Box.ofHalfExtents(.3, .3, .5)).at(-.7, 0, 0))
                .collider(Collider.of(Box.ofHalfExtents(.7, .3, .5)).at(.3, 0, 0).rotation(half));
    }

    private static void near(Matrix3d a, Matrix3d b, double relative) {
        double[] one = a.get(new double[9]);
        double[] other = b.get(new double[9]);
        double most = 0;
        for (double entry : other) {
            most = Math.max(most, Math.abs(entry));
        }
        for (int i = 0; i < 9; i++) {
            assertEquals(other[i], one[i], relative * most);
        }
    }

    @Test
    void twoBoxesWeighWhatTheBoxDoesThatTheyMake() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Quaterniond turn = new Quaterniond().rotateXYZ(.3, -.7, 1.1);
            BodyRef whole = world.add(brick(false).rotation(turn).at(1, 2, 3));
            BodyRef cut = world.add(brick(true).rotation(turn).at(1, 2, 3));
            assertEquals(whole.mass(), cut.mass(), 1e-12 * whole.mass());
            Vector3d apart =
                    cut.centreOfMass(new Vector3d()).sub(whole.centreOfMass(new Vector3d()));
            assertEquals(0, apart.length(), 1e-12);
            near(cut.inverseInertia(new Matrix3d()), whole.inverseInertia(new Matrix3d()), 1e-12);
            assertEquals(2, cut.colliders().size());
        }
    }

    /** A solid ball and a rod by the parallel axes: against the sum done by hand. */
    @Test
    void partsOfDifferentDensityAreWeighedByTheirOwn() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef hammer =
                    world.add(
                            Body.dynamic()
                                    .collider(
                                            Collider.of(Sphere.of(.1))
                                                    .at(0, .4, 0)
                                                    .material(Material.STEEL))
                                    .collider(
                                            Collider.of(Box.ofHalfExtents(.02, .4, .02))
                                                    .material(Material.WOOD)));
            double ball = 7850 * 4 / 3. * Math.PI * 1e-3;
            double rod = 600 * 8 * .02 * .4 * .02;
            assertEquals(ball + rod, hammer.mass(), 1e-12 * hammer.mass());
            double y = ball * .4 / (ball + rod);
            assertEquals(y, hammer.centreOfMass(new Vector3d()).y, 1e-15);
            double about =
                    .4 * ball * .01
                            + ball * (.4 - y) * (.4 - y)
                            + rod * (4 * .4 * .4 + 4 * .02 * .02) / 12
                            + rod * y * y;
            double got = 1 / hammer.inverseInertia(new Matrix3d()).m00;
            assertEquals(about, got, 1e-12 * about);
        }
    }

    /** The material of one part changes; the mass follows with the next type, and nothing jumps. */
    @Test
    void partsStayWhereTheyAreWhenTheTypeChanges() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef body = world.add(brick(true).at(0, 5, 0));
            ColliderRef part = body.colliders().get(0);
            world.step(Scenes.STEP);
            part.setMaterial(Material.STEEL);
            double bottom = 5 - .3 - .5 * 9.81 * Scenes.STEP * Scenes.STEP;
            body.setType(BodyType.FIXED);
            for (int tick = 0; tick < 6; tick++) {
                if (tick == 3) {
                    body.colliders().get(1).setMaterial(Material.WOOD);
                    body.setMass(7);
                }
                world.step(Scenes.STEP);
                world.validate();
                Hit hit = new Hit();
                assertSame(body, world.queries().rayCast(-.7, 0, 0, 0, 1, 0, 100, hit));
                assertEquals(bottom, hit.distance(), 5e-3);
                assertSame(null, world.queries().rayCast(-1.01, 0, 0, 0, 1, 0, 100, hit));
                assertSame(body, world.queries().rayCast(-.99, 0, 0, 0, 1, 0, 100, hit));
            }
        }
    }

    /** In flight shape does not matter, only mass: the same path to rounding. */
    @Test
    void inFlightBothGoTheSameWay() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef whole = world.add(brick(false).angularVelocity(3, .2, -1).at(0, 50, 0));
            BodyRef cut = world.add(brick(true).angularVelocity(3, .2, -1).at(0, 50, 9));
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
            }
            Vector3d apart = cut.position().sub(whole.position());
            assertEquals(0, apart.sub(0, 0, 9).length(), 1e-10);
            double turned = whole.orientation().conjugate().mul(cut.orientation()).angle();
            assertEquals(0, Math.min(turned, 2 * Math.PI - turned), 1e-9);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aTowerOfThemStands(boolean cut) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, .5, 20)).at(0, -.5, 0));
            List<BodyRef> tower = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                tower.add(world.add(brick(cut).at(0, .3 + .6 * i, 0)));
            }
            for (int i = 0; i < 600; i++) {
                world.step(Scenes.STEP);
            }
            world.validate();
            for (int i = 0; i < 8; i++) {
                Vector3d p = tower.get(i).position();
                assertEquals(.3 + .6 * i, p.y, 2e-3, "height of " + i);
                assertEquals(0, Math.hypot(p.x, p.z), 1e-3, "drift of " + i);
                assertEquals(0, tower.get(i).velocity().length(), 1e-3);
            }
        }
    }

    /** Coulomb: a block that slides at v stops after v²/(2 mu g). */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSlideStopsWhereCoulombSays(boolean cut) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).at(0, -.5, 0));
            BodyRef block = world.add(brick(cut).at(0, .3, 0));
            for (int i = 0; i < 60; i++) {
                world.step(Scenes.STEP);
            }
            double from = block.position().x;
            block.setVelocity(4, 0, 0);
            for (int i = 0; i < 200; i++) {
                world.step(Scenes.STEP);
            }
            assertEquals(16 / (2 * .6 * 9.81), block.position().x - from, .01);
        }
    }

    @Test
    void theSameBitsForWorkersAndLanes() {
        Scenes.assertSameBits(world -> {
            heap(world, new Random(5));
            for (int i = 0; i < 240; i++) {
                world.step(Scenes.STEP);
            }
        });
    }

    /** Jacks, tables and dumb-bells on a floor. */
    private static void heap(PhysicsWorld world, Random random) {
        world.add(Body.fixed().shape(Box.ofHalfExtents(20, .5, 20)).at(0, -.5, 0));
        for (int i = 0; i < 40; i++) {
            Body body = Body.dynamic();
            Capsule bar = Capsule.of(.1, .4);
            switch (i % 3) {
                case 0 ->
                        body.collider(Collider.of(bar))
                                .collider(
                                        Collider.of(bar)
                                                .rotation(new Quaterniond().rotateX(Math.PI / 2)))
                                .collider(
                                        Collider.of(bar)
                                                .rotation(new Quaterniond().rotateZ(Math.PI / 2)));
                case 1 -> {
                    body.collider(Collider.of(Box.ofHalfExtents(.5, .05, .4)).at(0, .5, 0));
                    for (int leg = 0; leg < 4; leg++) {
                        body.collider(
                                Collider.of(Box.ofHalfExtents(.05, .25, .05))
                                        .at(leg % 2 * .8 - .4, .2, leg / 2 * .6 - .3));
                    }
                }
                default ->
                        body.collider(Collider.of(Sphere.of(.25)).at(-.4, 0, 0))
                                .collider(Collider.of(Sphere.of(.2)).at(.4, 0, 0))
                                .collider(Collider.of(Box.ofHalfExtents(.4, .05, .05)));
            }
            world.add(
                    body.at(2 * random.nextDouble() - 1, 1 + .6 * i, 2 * random.nextDouble() - 1)
                            .rotation(
                                    new Quaterniond()
                                            .rotateXYZ(
                                                    random.nextDouble(),
                                                    random.nextDouble(),
                                                    random.nextDouble())));
        }
    }

    /** Nothing sinks, nothing is thrown: what is left of a heap rests on the floor. */
    @Test
    void aHeapComesToRestAboveTheFloor() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            heap(world, new Random(6));
            for (int i = 0; i < 1500; i++) {
                world.step(Scenes.STEP);
            }
            world.validate();
            for (BodyRef body : world.bodies()) {
                if (!body.isFixed()) {
                    assertTrue(body.position().y > -.3, body.position().toString());
                    // jacks roll: down from 5 cm they have 1 m/s
                    assertTrue(body.velocity().length() < 1, body + " " + body.velocity());
                }
            }
            for (int i = 0; i < world.contacts().count(); i++) {
                for (int p = 0; p < world.contacts().pointCount(i); p++) {
                    assertTrue(world.contacts().separation(i, p) > -.02);
                }
            }
        }
    }

    @Test
    void partsComeGoAndChangeWhileTheBodyKeepsItsFrame() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            Quaterniond turn = new Quaterniond().rotateXYZ(.3, .4, .5);
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.5))
                                    .at(1, 2, 3)
                                    .rotation(turn)
                                    .angularVelocity(0, 0, 2)
                                    .velocity(1, 0, 0));
            ColliderRef first = body.colliders().get(0);
            final Vector3d before = body.position();
            ColliderRef second = body.add(Collider.of(Sphere.of(.5)).at(2, 0, 0).userData("ball"));
            assertEquals(0, body.position().sub(before).length(), 1e-14);
            assertTrue(first.isAlive() && second.isAlive());
            assertEquals(List.of(first, second), body.colliders());
            assertEquals("ball", second.userData());
            // each point keeps its velocity: the centre has moved by d, so v + w x d
            Vector3d d = body.centreOfMass(new Vector3d()).sub(before);
            Vector3d v = new Vector3d(0, 0, 2).cross(d).add(1, 0, 0);
            assertEquals(0, body.velocity().sub(v).length(), 1e-14);
            world.step(Scenes.STEP);
            world.validate();
            second.replace(Collider.of(Box.cubeOfHalfExtent(.25)).at(-2, 0, 0));
            world.step(Scenes.STEP);
            world.validate();
            assertTrue(second.isAlive());
            first.remove();
            assertFalse(first.isAlive());
            assertThrows(BodyRemovedException.class, first::shape);
            assertEquals(1000 * .125, body.mass(), 1e-9);
            assertEquals(List.of(second), body.colliders());
            assertThrows(IllegalStateException.class, second::remove);
            world.step(Scenes.STEP);
            world.validate();
            Vector3d centre = turnOf(body, new Vector3d(-2, 0, 0)).add(body.position());
            assertEquals(0, body.centreOfMass(new Vector3d()).sub(centre).length(), 1e-12);
        }
    }

    private static Vector3d turnOf(BodyRef body, Vector3d v) {
        return body.orientation().transform(v);
    }

    /** A ray meets the part that is there, also right after a change, between steps. */
    @Test
    void queriesSeeParts() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body =
                    world.add(
                            Body.fixed()
                                    .collider(Collider.of(Sphere.of(1)).at(0, 0, 5))
                                    .collider(Collider.of(Box.cubeOfHalfExtent(1)).at(0, 0, -5)));
            WorldQueries queries = world.queries();
            Hit hit = new Hit();
            for (int i = 0; i < 2; i++) {
                assertSame(body, queries.rayCast(-9, 0, 5, 1, 0, 0, 99, hit));
                assertEquals(8, hit.distance(), 1e-12);
                assertSame(body, queries.rayCast(-9, .9, -5, 1, 0, 0, 99, hit));
                assertEquals(8, hit.distance(), 1e-12);
                world.step(Scenes.STEP);
            }
            List<WorldQueries.Met> met = new ArrayList<>();
            assertEquals(2, queries.rayCastAll(0, 0, 9, 0, 0, -1, 99, met));
            assertEquals(3, met.get(0).hit().distance(), 1e-12);
            assertSame(body.colliders().get(0), met.get(0).collider());
            assertEquals(13, met.get(1).hit().distance(), 1e-12);
            assertSame(body.colliders().get(1), met.get(1).collider());
            Placement ball = new Placement().set(Sphere.of(.5), 0, 0, 9);
            assertEquals(2, queries.shapeCastAll(ball, 0, 0, -1, 99, met));
            assertEquals(2.5, met.get(2).hit().distance(), 1e-9);
            assertEquals(12.5, met.get(3).hit().distance(), 1e-9);
            assertEquals(1, queries.rayCastAll(0, 0, 9, 0, 0, -1, 5, met));
            body.teleport(3, 0, 0);
            assertSame(body, queries.rayCast(-9, 0, 5, 1, 0, 0, 99, hit));
            assertEquals(11, hit.distance(), 1e-12);
            List<BodyRef> all = new ArrayList<>();
            assertEquals(
                    1,
                    queries.overlaps(
                            new Placement().set(Box.ofHalfExtents(9, 9, 9), 0, 0, 0), all));
        }
    }

    /** Removal and adding of bodies with parts: slots are used again and nothing is left behind. */
    @Test
    void slotsComeBack() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Random random = new Random(3);
            heap(world, random);
            int most = 0;
            for (int i = 0; i < 200; i++) {
                List<BodyRef> bodies = world.bodies();
                BodyRef gone = bodies.get(1 + random.nextInt(bodies.size() - 1));
                gone.remove();
                world.add(brick(i % 2 == 0).at(random.nextDouble(), 4, 0));
                world.step(Scenes.STEP);
                world.validate();
                most = Math.max(most, Inside.bodies(world).slotCount);
            }
            assertEquals(41, world.bodyCount());
            assertTrue(most < 41 * 6, most + " slots");
        }
    }
}
