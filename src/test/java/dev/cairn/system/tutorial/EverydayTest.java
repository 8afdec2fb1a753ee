package dev.cairn.system.tutorial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.collider.Layers;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.time.Ensemble;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/**
 * Ten programs as a user writes them on the first day, from easy to less easy, each of less than 30
 * lines ({@code DocsTest} counts). What each asserts is known from outside the engine.
 */
final class EverydayTest {
    private static final double STEP = 1 / 60.0;

    private static void seconds(PhysicsWorld world, double seconds) {
        for (int i = 0; i < Math.round(seconds / STEP); i++) {
            world.step(STEP);
        }
    }

    /** A box falls by g t²/2, and comes to rest on the ground. */
    @Test
    void fallingBox() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(0, 4, 0));
            seconds(world, .5);
            assertEquals(4 - 9.81 * .5 * .5 / 2, box.position().y, 1e-12);
            seconds(world, 2);
            assertEquals(.5, box.position().y, 1e-3);
        }
    }

    /** A system blows at what has a Force: F = c (u - v), so u - v falls by c h/m in each tick. */
    @Test
    void wind() {
        DoubleField speed = Velocity.COMPONENT.doubleField("vx");
        DoubleField force = Force.COMPONENT.doubleField("x");
        class Wind implements ChunkSystem {
            @Override
            public void describe(Access access) {
                access.in(Velocity.COMPONENT).writesAll(Force.COMPONENT);
            }

            @Override
            public void run(Chunk chunk, Tick tick) {
                for (int row = 0; row < chunk.size(); row++) {
                    chunk.out(force)[row] = 2 * (5 - chunk.in(speed)[row]);
                }
            }
        }
        try (PhysicsWorld world = PhysicsWorld.builder().systems(new Wind()).build()) {
            Body balloon = Body.dynamic().shape(Sphere.of(.5)).mass(4).gravityScale(0);
            BodyRef blown = world.add(balloon.with(Force.ZERO));
            seconds(world, 2);
            double calm = StrictMath.pow(1 - 2 * STEP / 4, 120);
            assertEquals(5 * (1 - calm), blown.velocity().x, 1e-12);
        }
    }

    /** A door, 20 cm thick, tells who comes in and who goes out: a ball of 60 cm at 2 m/s. */
    @Test
    void trigger() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).build()) {
            Collider door = Collider.of(Box.ofHalfExtents(.1, 1, 1)).sensor(true);
            world.add(Body.fixed().collider(door));
            world.add(Body.dynamic().shape(Sphere.of(.3)).at(-2, 0, 0).velocity(2, 0, 0));
            List<Double> seen = new ArrayList<>();
            ContactListener porter =
                    new ContactListener() {
                        @Override
                        public void entered(ColliderRef sensor, ColliderRef visitor) {
                            seen.add(visitor.body().position().x);
                        }

                        @Override
                        public void left(ColliderRef sensor, ColliderRef visitor) {
                            seen.add(visitor.body().position().x);
                        }
                    };
            world.contacts().listen(porter);
            seconds(world, 3);
            assertEquals(2, seen.size());
            assertEquals(-.4, seen.get(0), 2 * STEP, "came in");
            assertEquals(.4, seen.get(1), 2 * STEP, "went out");
        }
    }

    /** Ghosts go through crates, and stand on the ground. */
    @Test
    void layers() {
        Layers layers = Layers.of("ground", "crate", "ghost").apart("ghost", "crate");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Body ground = Body.fixed().shape(Box.ofHalfExtents(9, 1, 9));
            world.add(ground.at(0, -1, 0).filter(layers.filter("ground")));
            Body cube = Body.dynamic().shape(Box.cubeOfHalfExtent(.5));
            world.add(cube.at(0, .5, 0).filter(layers.filter("crate")));
            BodyRef crate = world.add(cube.at(0, 2, 0));
            BodyRef ghost = world.add(cube.at(0, 4, 0).filter(layers.filter("ghost")));
            seconds(world, 3);
            assertEquals(1.5, crate.position().y, .01);
            assertEquals(.5, ghost.position().y, .01);
        }
    }

    /** A platform goes its way, and who stands on it goes along: 2 m in 4 s. */
    @Test
    void platform() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Body plate = Body.kinematic().shape(Box.ofHalfExtents(2, .1, 2));
            BodyRef platform = world.add(plate.velocity(.5, 0, 0));
            Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(.5));
            BodyRef rider = world.add(box.at(0, .6, 0).velocity(.5, 0, 0));
            world.add(Body.fixed().shape(Box.cubeOfHalfExtent(.5)).at(3, 0, 0));
            seconds(world, 4);
            assertEquals(2, platform.position().x, 1e-9, "no wall stops it");
            assertEquals(2, rider.position().x, 1e-9);
        }
    }

    /** A table is a top and four legs. It weighs what they weigh, stands, and bears a vase. */
    @Test
    void compound() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            Collider top = Collider.of(Box.ofHalfExtents(.8, .05, .5));
            Collider leg = Collider.of(Box.ofHalfExtents(.05, .35, .05));
            Body table = Body.dynamic().collider(top.at(0, .75, 0));
            for (double x : new double[] {-.7, .7}) {
                table.collider(leg.at(x, .35, -.4)).collider(leg.at(x, .35, .4));
            }
            BodyRef standing = world.add(table.at(0, .2, 0));
            Body vase = Body.dynamic().shape(Box.ofHalfExtents(.1, .2, .1));
            BodyRef onIt = world.add(vase.at(0, 1.4, 0));
            seconds(world, 3);
            assertEquals(1000 * (1.6 * .1 + 4 * .1 * .1 * .7), standing.mass(), 1e-9);
            assertEquals(0, standing.position().y, .01);
            assertEquals(1, onIt.position().y, .01);
        }
    }

    /** A crate on a conveyor belt comes to the speed of the belt. */
    @Test
    void conveyor() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Collider belt = Collider.of(Box.ofHalfExtents(20, .5, 1));
            world.add(Body.fixed().collider(belt.surfaceVelocity(1.5, 0, 0)));
            BodyRef crate = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.3)).at(-9, .8, 0));
            seconds(world, 12);
            assertEquals(1.5, crate.velocity().x, 1e-9);
        }
    }

    /** Solid for who comes from above, open for who comes from below. */
    @Test
    void oneWay() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Collider plank = Collider.of(Box.ofHalfExtents(2, .1, 2)).userData("one-way");
            world.add(Body.fixed().collider(plank));
            world.collisions()
                    .setHook(contact -> {
                        boolean isA = "one-way".equals(contact.userDataA());
                        if (isA || "one-way".equals(contact.userDataB())) {
                            double up = isA ? contact.normalY() : -contact.normalY();
                            boolean stood = contact.memory() == 1;
                            boolean solid = up > .7 && (stood || contact.separation() > -.005);
                            contact.remember(solid ? 1 : 0);
                            if (!solid) {
                                contact.disable();
                            }
                        }
                    });
            Body cube = Body.dynamic().shape(Box.cubeOfHalfExtent(.3));
            BodyRef jumper = world.add(cube.at(0, -1, 0).velocity(0, 8, 0));
            seconds(world, .75);
            double free = -1 + 8 * .75 - 9.81 * .75 * .75 / 2;
            assertEquals(free, jumper.position().y, 1e-9, "as if there were nothing");
            seconds(world, 3);
            assertEquals(.4, jumper.position().y, .01, "stands on it");
        }
    }

    /** What is under the mouse: the nearest body on a ray from the eye. */
    @Test
    void picking() {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.dynamic().shape(Sphere.of(.5)).at(0, 0, -9).name("far"));
            world.add(Body.dynamic().shape(Sphere.of(.5)).at(0, 0, -6).name("near"));
            world.add(Body.dynamic().shape(Sphere.of(.5)).at(2, 0, -3).name("beside"));
            WorldQueries queries = world.queries();
            Hit hit = new Hit();
            BodyRef picked = queries.rayCast(0, .3, 0, 0, 0, -1, 100, hit);
            assertTrue(picked != null && picked.name().equals("near"));
            // half a chord of the sphere at height .3 is the root of .25 - .09
            assertEquals(6 - Math.sqrt(.25 - .09), hit.distance(), 1e-12);
            picked.applyImpulse(0, 5 * picked.mass(), 0);
            world.step(STEP);
            assertEquals(5 - 9.81 * STEP, picked.velocity().y, 1e-12);
        }
    }

    /** Many worlds beside each other try all angles of a throw: it goes v² sin(2a)/g far. */
    @Test
    void ensembleOfWorlds() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(2).build()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(.1)));
            List<Double> ranges =
                    Ensemble.run(
                            world,
                            90,
                            (fork, degrees) -> {
                                BodyRef own = fork.bodies().get(0);
                                double a = StrictMath.toRadians(degrees);
                                own.setVelocity(10 * StrictMath.cos(a), 10 * StrictMath.sin(a), 0);
                                do {
                                    fork.step(STEP);
                                } while (own.position().y > 0);
                                double late = own.position().y / own.velocity().y;
                                return own.position().x - late * own.velocity().x;
                            });
            for (int degrees = 15; degrees < 90; degrees += 15) {
                double truth = 10 * 10 * StrictMath.sin(StrictMath.toRadians(2 * degrees)) / 9.81;
                assertEquals(truth, ranges.get(degrees), 1e-2);
            }
            assertEquals(0, ball.position().x, "the world itself has not moved");
        }
    }
}
