package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.tuning.Precision;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashSet;
import java.util.Set;

class ConveyorTest {
    private static Collider belt(double speed) {
        return Collider.of(Box.ofHalfExtents(40, .5, 2)).at(0, -.5, 0).surfaceVelocity(speed, 0, 0);
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(Scenes.STEP);
        }
        world.validate();
    }

    /** Coulomb: it is dragged with mu g, and so reaches u after u/(mu g), u²/(2 mu g) behind. */
    @ParameterizedTest
    @ValueSource(doubles = {.5, 1, 3})
    void aBoxReachesTheSpeedOfTheBelt(double speed) {
        for (int boxes = 1; boxes <= 3; boxes++) {
            try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
                world.add(Body.fixed().collider(belt(speed)));
                BodyRef box =
                        world.add(
                                Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(-9, .2, 0));
                for (int i = 1; i < boxes; i++) {
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(.3, .2, .3))
                                    .at(-9, .2 + .4 * i, 0));
                }
                step(world, 840);
                assertEquals(speed, box.velocity().x, 1e-9, boxes + " boxes");
                assertEquals(0, box.velocity().z, 1e-9);
                assertEquals(.2, box.position().y, 2e-3);
                if (boxes == 1) {
                    double lag = speed * speed / (2 * .6 * 9.81);
                    assertEquals(-9 + speed * 14 - lag, box.position().x, .02 * speed);
                }
            }
        }
    }

    /** A solid ball that is dragged from rest rolls at last at 2/7 of the belt's speed. */
    @Test
    void aBallRollsOnIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().collider(belt(2)));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(.25)).at(0, .25, 0));
            step(world, 240);
            assertEquals(2 * 2 / 7., ball.velocity().x, 1e-3);
            // what touches goes with the belt
            double touching = ball.velocity().x + ball.angularVelocity().z * .25;
            assertEquals(2, touching, 1e-6);
        }
    }

    /** A belt drags and pushes nothing away: at its end face it does nothing along the normal. */
    @Test
    void itsEndPushesNothing() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            world.add(Body.fixed().collider(belt(5)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.4)).at(40.4, -.5, 0));
            step(world, 120);
            assertEquals(0, box.velocity().length(), 1e-9);
        }
    }

    @Test
    void aTurnedBeltRunsAlongItself() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().collider(belt(1)).rotation(new Quaterniond().rotateY(.5)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(0, .2, 0));
            step(world, 600);
            Vector3d along = new Vector3d(1, 0, 0).rotateY(.5);
            assertEquals(0, box.velocity().sub(along).length(), 1e-9);
        }
    }

    /** A belt on a cart that moves: what lies on it goes with the sum of the two. */
    @ParameterizedTest
    @ValueSource(doubles = {-.75, 0, .5})
    void aBeltOnAMovingCartAddsItsSpeed(double cartSpeed) {
        Vector3d along = new Vector3d(1.25, 0, 0).rotateY(.5).add(cartSpeed, 0, .25);
        Set<Long> digests = new HashSet<>();
        for (int lanes : new int[] {1, 4, 8}) {
            for (boolean target : new boolean[] {false, true}) {
                try (PhysicsWorld world =
                        Scenes.awake()
                                .settings(
                                        PhysicsSettings.DEFAULT
                                                .withSleeping(false)
                                                .withLanes(lanes))
                                .workers(1 + lanes / 4)
                                .build()) {
                    Quaterniond turn = new Quaterniond().rotateY(.5);
                    BodyRef cart =
                            world.add(
                                    Body.kinematic()
                                            .collider(belt(1.25))
                                            .rotation(turn)
                                            .velocity(cartSpeed, 0, .25));
                    BodyRef box =
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.ofHalfExtents(.4, .2, .4))
                                            .at(0, .2, 0));
                    for (int tick = 1; tick <= 600; tick++) {
                        if (target) {
                            double t = tick * Scenes.STEP;
                            cart.moveTo(cartSpeed * t, 0, .25 * t, turn);
                        }
                        world.step(Scenes.STEP);
                    }
                    assertEquals(0, box.velocity().sub(along).length(), 1e-9, "lanes " + lanes);
                    assertEquals(10 * cartSpeed, cart.position().x, 1e-9, "it drives nobody");
                    if (!target) {
                        digests.add(world.digest());
                    }
                }
            }
        }
        assertEquals(1, digests.size());
    }

    /**
     * A dynamic conveyor on ice: what lies on it comes to the belt's speed against it, both keep
     * their common momentum, so the conveyor has -m u/(m + M) and the crate M u/(m + M).
     */
    @ParameterizedTest
    @CsvSource({"1, false", "1, true", "4, false", "8, false"})
    void aDynamicBeltKeepsTheMomentumOfBoth(int lanes, boolean single) {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 2; workers++) {
            PhysicsSettings settings =
                    PhysicsSettings.DEFAULT
                            .withSleeping(false)
                            .withLanes(lanes)
                            .withPrecision(single ? Precision.SINGLE : Precision.AUTO);
            try (PhysicsWorld world = Scenes.awake().settings(settings).workers(workers).build()) {
                Material ice = Material.DEFAULT.withFriction(0);
                world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).material(ice));
                Collider running =
                        Collider.of(Box.ofHalfExtents(9, .25, 1))
                                .surfaceVelocity(.5, 0, 0)
                                .material(Material.DEFAULT);
                Collider skid =
                        Collider.of(Box.ofHalfExtents(9, .05, 1)).at(0, -.3, 0).material(ice);
                Body cart = Body.dynamic().collider(running).collider(skid).mass(300);
                // crates that move on would tilt it a little, by w r = 1e-5 m/s
                cart.lock(Lock.TURN_X, Lock.TURN_Y, Lock.TURN_Z);
                BodyRef conveyor = world.add(cart.at(0, .85, 0));
                Body crate = Body.dynamic().shape(Box.cubeOfHalfExtent(.25)).mass(50);
                BodyRef[] crates = new BodyRef[3];
                for (int i = 0; i < crates.length; i++) {
                    crates[i] = world.add(crate.at(i - 4, 1.35, 0));
                }
                for (int tick = 0; tick < 900; tick++) {
                    world.step(Scenes.STEP);
                    Kinetics k = world.kinetics();
                    double scale = single ? 3e-3 : 1e-10;
                    assertEquals(0, k.momentumX(), scale, "tick " + tick);
                    assertEquals(0, k.momentumZ(), scale);
                }
                world.validate();
                double precision = single ? 1e-5 : 1e-9;
                double mine = -150 * .5 / 450;
                assertEquals(mine, conveyor.velocity().x, precision);
                for (BodyRef one : crates) {
                    assertEquals(mine + .5, one.velocity().x, precision);
                    assertEquals(0, one.velocity().z, precision);
                }
                digests.add(world.digest());
            }
        }
        assertEquals(1, digests.size());
    }

    /** On a floor that holds it a body drives: its tracks run back at u, it runs on at -u. */
    @ParameterizedTest
    @ValueSource(ints = {1, 8})
    void tracksDriveABodyOverTheFloor(int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(lanes);
        try (PhysicsWorld world = Scenes.awake().settings(settings).workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).at(0, -.5, 0));
            Body hull = Body.dynamic();
            for (int side = -1; side <= 1; side += 2) {
                hull.collider(
                        Collider.of(Box.ofHalfExtents(1, .2, .2))
                                .at(0, 0, .6 * side)
                                .surfaceVelocity(-2, 0, 0));
            }
            BodyRef tank = world.add(hull.at(0, .2, 0).velocity(0, 0, 0));
            step(world, 840);
            // one side may have slipped longer than the other: it has turned a little
            Vector3d ahead = tank.orientation().transform(new Vector3d(2, 0, 0));
            assertEquals(0, tank.velocity().distance(ahead), 1e-8);
            assertEquals(2, ahead.x, 1e-4);
            assertFalse(tank.isAsleep());
        }
    }

    /** Two tracks of opposite speeds turn it on the spot: w b = u, less what their spin rubs. */
    @Test
    void tracksThatRunApartTurnIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).at(0, -.5, 0));
            Body hull = Body.dynamic();
            for (int side = -1; side <= 1; side += 2) {
                hull.collider(
                        Collider.of(Box.cubeOfHalfExtent(.05))
                                .at(0, 0, .6 * side)
                                .surfaceVelocity(-.6 * side, 0, 0));
            }
            BodyRef tank = world.add(hull.at(0, .05, 0));
            step(world, 300);
            // the surface at z runs at v_x = w z, against -u of the track
            assertEquals(.975, tank.angularVelocity().y, .025);
            assertEquals(0, tank.velocity().length(), 1e-3);
        }
    }

    /** A ball dragged by a loose belt keeps the momentum of both and is not let go of. */
    @Test
    void whatBouncesOnADynamicBeltKeepsTheMomentum() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            Material rubber = Material.RUBBER.withRestitution(.5);
            Collider running = Collider.of(Box.ofHalfExtents(2, .25, 1)).surfaceVelocity(3, 0, 0);
            world.add(Body.dynamic().collider(running).material(rubber));
            Body ball = Body.dynamic().shape(Sphere.of(.2)).material(rubber);
            world.add(ball.at(0, 1, 0).velocity(0, -4, 0));
            Kinetics start = world.kinetics();
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
                Kinetics k = world.kinetics();
                assertEquals(start.momentumX(), k.momentumX(), 1e-9);
                assertEquals(start.momentumY(), k.momentumY(), 1e-9);
            }
            world.validate();
        }
    }

    @Test
    void aBeltThatStartsWakesWhoIsOnIt() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef line = world.add(Body.fixed().collider(belt(0)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(0, .2, 0));
            step(world, 120);
            assertTrue(box.isAsleep());
            line.colliders().get(0).replace(belt(1));
            step(world, 600);
            assertFalse(box.isAsleep());
            assertEquals(1, box.velocity().x, 1e-9);
            line.colliders().get(0).replace(belt(0));
            step(world, 200);
            assertEquals(0, box.velocity().x, 1e-6);
        }
    }

    /**
     * A material that runs along makes belts of all that is of it; a collider may say otherwise.
     */
    @Test
    void aMaterialRunsAlong() {
        Material rubber = Material.DEFAULT.withSurfaceVelocity(new Vector3d(1.5, 9, .25));
        Vector3d u = new Vector3d(1.5, 0, .25);
        assertEquals(new Vector3d(1.5, 9, .25), rubber.surfaceVelocity(new Vector3d()));
        assertEquals(rubber, rubber.withFriction(1).withRollingArm(0).withFriction(.6));
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            Collider plank = Collider.of(Box.ofHalfExtents(40, .5, 9));
            BodyRef line =
                    world.add(
                            Body.fixed()
                                    .material(rubber)
                                    .shape(plank.shape())
                                    .collider(plank.at(0, 0, 20).surfaceVelocity(0, 0, -.5))
                                    .collider(plank.at(0, 0, -20).material(Material.DEFAULT))
                                    .at(0, -.5, 0));
            Body box = Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4));
            BodyRef[] on = new BodyRef[3];
            for (int i = 0; i < 3; i++) {
                on[i] = world.add(box.at(-9, .2, i == 0 ? 0 : i == 1 ? 27 : -20));
            }
            step(world, 600);
            assertEquals(0, on[0].velocity().distance(u), 1e-9);
            assertEquals(0, on[1].velocity().distance(0, 0, -.5), 1e-9);
            assertTrue(on[2].isAsleep());
            // live: it stops, another one starts and wakes who sleeps there
            line.colliders().get(0).setMaterial(Material.DEFAULT);
            line.colliders().get(2).setMaterial(rubber);
            step(world, 600);
            assertEquals(0, on[0].velocity().length(), 1e-9);
            assertEquals(0, on[1].velocity().distance(0, 0, -.5), 1e-9);
            assertEquals(0, on[2].velocity().distance(u), 1e-9);
            Vector3d told = line.colliders().get(2).description().surfaceVelocity(new Vector3d());
            assertEquals(new Vector3d(1.5, 9, .25), told);
        }
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        Scenes.assertSameBits(world -> {
            world.add(Body.fixed().collider(belt(2)));
            for (int i = 0; i < 60; i++) {
                Shape shape = i % 3 == 0 ? Sphere.of(.3) : Box.ofHalfExtents(.3, .2, .4);
                // some of them run along themselves
                Collider piece = Collider.of(shape).surfaceVelocity(i % 7 == 3 ? 1 : 0, 0, 0);
                world.add(
                        Body.dynamic()
                                .collider(piece)
                                .at(.5 * (i % 12) - 3, .4 + .7 * (i / 12), .2 * (i % 5)));
            }
            step(world, 180);
        });
    }
}
