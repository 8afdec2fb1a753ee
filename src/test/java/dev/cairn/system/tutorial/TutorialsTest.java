package dev.cairn.system.tutorial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.FloatField;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.input.Key;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** The chapters of docs/tutorials.md; what they say comes out is asserted below each. */
class TutorialsTest {
    private static final double STEP = 1.0 / 60;

    @Test
    void firstScene() {
        // chapter: first scene
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).workers(2).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            Box box = Box.cubeOfHalfExtent(0.5);
            List<BodyRef> tower = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                Body crate = Body.dynamic().shape(box).material(Material.WOOD);
                tower.add(world.add(crate.at(0, 0.5 + i, 0)));
            }
            for (int tick = 0; tick < 120; tick++) {
                world.step(1.0 / 60);
            }
            // chapter: end
            // Each box is 1 m high: the centre of the fifth rests at 4.5 m.
            assertEquals(4.5, tower.get(4).position().y, 0.002);
            assertEquals(6, world.bodyCount());
        }
    }

    // chapter: a system of your own
    /** The wind at an entity, m/s along x. */
    public record Wind(float x) {}

    static final Component<Wind> WIND = Component.of(Wind.class);
    static final FloatField WIND_X = WIND.floatField("x");

    /** Lets the wind fall by a tenth in each tick. */
    static final class Calming implements ChunkSystem {
        @Override
        public void describe(Access access) {
            access.in(WIND).out(WIND);
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            float[] now = chunk.in(WIND_X);
            float[] next = chunk.out(WIND_X);
            for (int row = 0; row < chunk.size(); row++) {
                next[row] = 0.9f * now[row];
            }
        }
    }

    // chapter: end

    @Test
    void aSystemOfYourOwn() {
        // chapter: a system of your own, 2
        try (PhysicsWorld world = PhysicsWorld.builder().systems(new Calming()).build()) {
            BodyRef sail = world.add(Body.dynamic().shape(Sphere.of(1)).with(new Wind(10)));
            world.step(1.0 / 60);
            Wind wind = world.ecs().get(sail.entity(), WIND);
            // chapter: end
            assertEquals(9, wind.x(), 1e-6);
        }
    }

    @Test
    void events() {
        List<String> told = new ArrayList<>();
        // chapter: events
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, 1, 5)).at(0, -1, 0).name("floor"));
            Collider gate = Collider.of(Box.ofHalfExtents(1, 0.1, 1)).sensor(true);
            world.add(Body.fixed().collider(gate).at(0, 2, 0).name("gate"));
            world.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 4, 0).name("ball"));
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void began(ColliderRef a, ColliderRef b) {
                                    told.add(a.body().name() + " meets " + b.body().name());
                                }

                                @Override
                                public void entered(ColliderRef sensor, ColliderRef visitor) {
                                    told.add(
                                            visitor.body().name()
                                                    + " is in the "
                                                    + sensor.body().name());
                                }
                            });
            for (int tick = 0; tick < 120; tick++) {
                world.step(1.0 / 60);
            }
            // chapter: end
        }
        assertEquals("ball is in the gate", told.get(0));
        assertTrue(
                told.contains("floor meets ball") || told.contains("ball meets floor"),
                told.toString());
    }

    @Test
    void joints() {
        // chapter: joints
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            BodyRef post =
                    world.add(Body.fixed().shape(Box.ofHalfExtents(0.1, 1, 0.1)).at(0, 1, 0));
            Body leaf = Body.dynamic().shape(Box.ofHalfExtents(0.5, 1, 0.05)).mass(20);
            BodyRef door = world.add(leaf.at(0.6, 1, 0));
            JointRef hinge =
                    world.add(Joint.hinge(post, door).at(0.1, 1, 0).axis(0, 1, 0).limits(0, 1.5));
            hinge.motor(JointAxis.TWIST, 1, 100); // 1 rad/s, with at most 100 N m
            BodyRef lamp = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(2).at(-1, 0.5, 0));
            JointRef rope = world.add(Joint.rope(post, lamp).anchors(-1, 2, 0, -1, 0.5, 0));
            for (int tick = 0; tick < 120; tick++) {
                world.step(1.0 / 60);
            }
            double angle = hinge.value(JointAxis.TWIST);
            double pull = rope.force(new Vector3d()).length();
            // chapter: end
            assertEquals(1.5, angle, 1e-6, "rad, at its limit");
            assertEquals(2 * 9.81, pull, 1e-3, "N, the lamp's weight");
            assertEquals(0.5, lamp.position().y, 1e-6, "m, it hangs where it was put");
        }
    }

    @Test
    void aLevelThatIsSavedAndLoaded(@TempDir Path folder) {
        // chapter: a level
        String level =
                """
                {"format": "cairn-scene", "version": 1, "name": "steps", "entities": [
                  {"name": "floor", "body": "fixed", "position": [0, -1, 0],
                   "shape": {"type": "box", "halfExtents": [9, 1, 9]}},
                  {"name": "step", "body": "fixed", "position": [0, 0.2, 0],
                   "shape": {"type": "box", "halfExtents": [1, 0.2, 1]}}
                ]}
                """;
        SceneFile scene = SceneReader.parse("steps.json", level);
        SceneWriter.write(scene, folder.resolve("steps.json"));
        SceneFile again = SceneReader.read(folder.resolve("steps.json"));
        // chapter: end
        assertEquals(scene, again);
        assertEquals(2, again.entities().size());
    }

    @Test
    void ensembles() {
        // chapter: ensembles
        double[] heights =
                IntStream.range(0, 16)
                        .parallel()
                        .mapToDouble(member -> {
                            try (PhysicsWorld world =
                                    PhysicsWorld.builder()
                                            .gravity(0, -9.81, 0)
                                            .workers(1)
                                            .build()) {
                                Material rubber = Material.DEFAULT.withRestitution(0.05 * member);
                                world.add(
                                        Body.fixed()
                                                .shape(Box.ofHalfExtents(5, 1, 5))
                                                .at(0, -1, 0));
                                BodyRef ball =
                                        world.add(
                                                Body.dynamic()
                                                        .shape(Sphere.of(0.5))
                                                        .at(0, 2, 0)
                                                        .material(rubber));
                                double highest = 0;
                                for (int tick = 0; tick < 120; tick++) {
                                    world.step(1.0 / 120);
                                    boolean rises = ball.velocity().y > 0;
                                    double y = ball.position().y;
                                    highest = rises ? Math.max(highest, y) : highest;
                                }
                                return highest;
                            }
                        })
                        .toArray();
        // chapter: end
        assertEquals(16, heights.length);
        // e = 0.75 against the floor's own restitution of 0: whatever the two mix to, more
        // restitution never bounces lower, and the same world twice is the same to the bit.
        for (int i = 1; i < heights.length; i++) {
            assertTrue(heights[i] >= heights[i - 1] - 1e-9, "member " + i);
        }
    }

    @Test
    void theSameBitsForAnyWorkers() {
        // chapter: the same bits
        long one = run(1);
        long two = run(2);
        // chapter: end
        assertEquals(one, two);
        assertNotNull(Long.toHexString(one));
    }

    private static long run(int workers) {
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -9.81, 0).workers(workers).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            for (int i = 0; i < 20; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .at(0.1 * i, 1 + 1.2 * i, 0));
            }
            for (int tick = 0; tick < 100; tick++) {
                world.step(STEP);
            }
            return world.digest();
        }
    }

    @Test
    void takeItBack() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            BodyRef crate =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            world.step(STEP);
            long digest = world.digest();
            // chapter: take it back
            WorldState before = world.save();
            crate.applyImpulse(3000, 0, 0);
            for (int tick = 0; tick < 60; tick++) {
                world.step(1.0 / 60);
            }
            double thrown = crate.position().x;
            world.restore(before);
            // chapter: end
            assertTrue(thrown > 0.5, "thrown " + thrown + " m");
            assertEquals(0, crate.position().x, 1e-9);
            assertEquals(digest, world.digest());
        }
    }

    // chapter: your own window
    /** A ball that J or a button throws up; the panel says how high it was. */
    static final class Juggler extends Application {
        private BodyRef ball;
        private volatile double highest;

        @Override
        protected void initScene(Scene scene) {
            Box floor = Box.ofHalfExtents(20, 1, 20);
            scene.add(Body.fixed().shape(floor).at(0, -1, 0), Model.ground(floor));
            ball = scene.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 0.5, 0).velocity(0, 5, 0));
            scene.bindings().onKey(Key.J, "throw", this::up);
            scene.camera().lookAt(0, 3, 9, 0, 1, 0);
        }

        private void up() {
            ball.setVelocity(0, 5, 0);
        }

        @Override
        protected void updated(double seconds) {
            highest = Math.max(highest, ball.position().y);
        }

        @Override
        protected void panels(Ui ui, View view) {
            if (ui.panel("Juggler", 10, 10, 220, 100)) {
                ui.value("highest", "%.2f m".formatted(highest));
                if (ui.button("Throw (J)")) {
                    post(this::up);
                }
            }
            ui.endPanel();
        }
    }

    // chapter: end

    @Test
    void yourOwnWindow(@TempDir Path folder) throws IOException {
        assumeTrue(Offscreen.unavailableReason() == null, "no OpenGL here");
        Path picture = folder.resolve("juggler.png");
        Juggler juggler = new Juggler();
        juggler.size(160, 90).headless(picture, 60).start();
        // v²/(2 g) above the place that it is thrown from
        assertEquals(0.5 + 25 / (2 * 9.81), juggler.highest, 2e-3);
        assertTrue(Files.size(picture) > 500);
    }
}
