package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Layers;
import dev.cairn.physics.collider.Mix;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.List;

/** All that a body can be goes into a scene file, and comes back to the same bits. */
class SceneBodiesTest {
    private static final String HEAD = "{\"format\": \"cairn-scene\", \"version\": 1, ";
    private static final int TICKS = 60;

    /** One of each, near enough to one another to be felt within a second. */
    private static void each(SceneBuilder scene) {
        Layers layers = Layers.of("ground", "crate", "ghost").apart("ghost", "crate");
        Material icy =
                Material.DEFAULT
                        .withFriction(.05)
                        .withRestitution(.5)
                        .withMix(Mix.MINIMUM, Mix.AVERAGE);
        Collider plank = Collider.of(Box.ofHalfExtents(9, .5, 9)).material(icy);
        scene.addParts(
                List.of(
                        plank.at(-9, -.5, 0),
                        plank.at(9, -.5, 0).surfaceVelocity(1.5, 0, .25).userData("belt"),
                        Collider.of(Box.ofHalfExtents(1, 1, 1)).at(0, 2, 0).sensor(true)),
                0x808080,
                Body.fixed().filter(layers.filter("ground")).name("floor"));
        scene.addParts(
                List.of(Collider.of(Box.ofHalfExtents(1, .1, 1)).userData("platform")),
                0x336699,
                Body.kinematic()
                        .at(-4, .2, 0)
                        .velocity(.5, 0, 0)
                        .angularVelocity(0, .3, 0)
                        .filter(new Filter(1, -1, 7)));
        Quaterniond turned = new Quaterniond().rotateXYZ(.3, .2, .1);
        for (int i = 0; i < 4; i++) {
            scene.addParts(
                    List.of(
                            Collider.of(Box.ofHalfExtents(.4, .1, .3)).at(0, .3, .01),
                            Collider.of(Capsule.of(.1, .3)).at(.2, 0, 0).rotation(turned),
                            Collider.of(Sphere.of(.2))
                                    .at(-.2, -.1, 0)
                                    .material(icy.withDensity(7000))
                                    .filter(layers.filter("ghost"))),
                    0x993333,
                    Body.dynamic().at(-4 + 3.1 * i, .8, .1 * i).filter(layers.filter("crate")));
        }
        double[] heights = {0, .3, .1, .2, 0, .4, .1, .2, .3, .7, .1, 0};
        scene.add(
                HeightField.of(4, 3, 1.5, 2, heights)
                        .withThickness(.7)
                        .withHole(1, 1, 2, 1, true)
                        .withHole(0, 0, 1, 1, true),
                7,
                Body.fixed().at(20, 0, 0));
        scene.add(Sphere.of(.4), 8, Body.dynamic().at(22, .9, .6));
        scene.add(Sphere.of(.4), 9, Body.dynamic().at(22.3, .9, 3.1));
        Box box = Box.cubeOfHalfExtent(.25);
        scene.add(box, 1, Body.dynamic().at(3, .4, 2).mass(3).inertia(.3, .2, .25).material(icy));
        scene.add(box, 2, Body.dynamic().at(3, .9, 2).gravityScale(.25).damping(.1, .7));
        scene.add(box, 3, Body.dynamic().at(3, 2, 0).speedLimit(1.25).velocity(-2, 0, 1));
        scene.add(
                box,
                4,
                Body.dynamic()
                        .at(3, .24, -2)
                        .angularVelocity(1, 2, 3)
                        .lock(Lock.MOVE_Z, Lock.TURN_X, Lock.TURN_Y));
        scene.add(box, 5, Body.dynamic().at(0, 3, 0).filter(Filter.ALL.neverWith(3)));
        scene.add(box, 6, Body.dynamic().at(.1, 3.2, 0).filter(Filter.ALL.neverWith(3)));
        scene.add(box, 7, Body.dynamic().at(-6, .5, 2).centreOfMass(.1, -.05, 0).userData("die"));
        Material runs = Material.WOOD.withSurfaceVelocity(.5, 0, -.25);
        scene.add(Box.ofHalfExtents(2, .25, 2), 8, Body.fixed().at(30, 0, 0).material(runs));
        scene.add(box, 9, Body.dynamic().at(30, .5, 0));
        scene.addParts(
                List.of(
                        Collider.of(Box.ofHalfExtents(2, .25, 2)),
                        Collider.of(Box.ofHalfExtents(2, .25, 2))
                                .at(4, 0, 0)
                                .surfaceVelocity(0, 0, 0)),
                0x808080,
                Body.fixed().material(runs).at(40, 0, 0));
        scene.add(box, 10, Body.dynamic().at(40, .5, 0));
        scene.add(box, 11, Body.dynamic().at(44, .5, 0));
    }

    private static final SampleScene SCENE =
            new SampleScene(
                    "each",
                    "Each",
                    "One of each.",
                    "test",
                    List.of(),
                    60,
                    0,
                    SceneBodiesTest::each);

    private static long digest(SampleScene scene, int workers, int lanes) {
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(workers)
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .sleeping(false)
                        .build()) {
            scene.build(new SceneBuilder(world, options));
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(SampleScene.STEP_SECONDS);
            }
            world.validate();
            return world.digest();
        }
    }

    private static SampleScene again(SampleScene scene, Path folder) {
        Path file = folder.resolve(scene.id() + ".json");
        SceneFile exported = SceneExport.of(scene, SceneOptions.defaults(scene), 4, folder);
        SceneWriter.write(exported, file);
        assertEquals(exported, SceneReader.read(file));
        return SceneLoader.sample(file, SceneReader.read(file));
    }

    /** What a file can't hold (systems, hooks, objects of a program) is told in its description. */
    @Test
    void whatIsLeftOutIsTold(@TempDir Path folder) {
        for (String id : List.of("one-way", "buoyancy")) {
            String told = exported(SceneRegistry.get(id), folder);
            assertTrue(told.contains(SceneExport.LEFT_OUT), id + ": " + told);
        }
        SampleScene plain = SceneRegistry.get("stack-4");
        assertEquals(plain.description(), exported(plain, folder));
        for (boolean onCollider : new boolean[] {false, true}) {
            SampleScene carrying =
                    new SampleScene(
                            "carrying",
                            "Carrying",
                            "A ball with an object.",
                            "collisions",
                            List.of(),
                            1,
                            0,
                            scene -> {
                                BodyRef ball = scene.add(Sphere.of(1), 0xffffff, Body.dynamic());
                                if (onCollider) {
                                    ball.add(Collider.of(Sphere.of(1)).userData(List.of(1)));
                                } else {
                                    ball.setUserData(List.of(1));
                                }
                            });
            assertTrue(exported(carrying, folder).contains(SceneExport.NO_DATA));
        }
    }

    private static String exported(SampleScene scene, Path folder) {
        return SceneExport.of(scene, SceneOptions.defaults(scene), 4, folder).description();
    }

    /** Words and numbers go through a file, on bodies and on colliders, and who may sleep. */
    @Test
    void wordsNumbersAndWakefulnessComeBack(@TempDir Path folder) {
        SampleScene scene =
                new SampleScene(
                        "data",
                        "Data",
                        "Two balls.",
                        "test",
                        List.of(),
                        1,
                        0,
                        built -> {
                            Collider ball = Collider.of(Sphere.of(1)).userData(-2.5);
                            built.addParts(
                                    List.of(ball, ball.at(2, 0, 0).userData("right")),
                                    1,
                                    Body.dynamic().userData(7).canSleep(false));
                            built.add(Sphere.of(1), 2, Body.dynamic().userData("loose"));
                        });
        SampleScene read = again(scene, folder);
        assertEquals(scene.description(), read.description());
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            read.build(new SceneBuilder(world, SceneOptions.defaults(read)));
            BodyRef pair = world.bodies().get(0);
            assertEquals(7.0, pair.userData());
            assertEquals(-2.5, pair.colliders().get(0).userData());
            assertEquals("right", pair.colliders().get(1).userData());
            assertFalse(pair.canSleep());
            BodyRef single = world.bodies().get(1);
            assertEquals("loose", single.userData());
            assertTrue(single.canSleep());
        }
    }

    @Tag("compiled")
    @Test
    void whatIsWrittenAndReadGoesOnWithTheSameBits(@TempDir Path folder) {
        SampleScene read = again(SCENE, folder);
        long truth = digest(SCENE, 1, 1);
        assertEquals(truth, digest(read, 1, 1));
        assertEquals(truth, digest(read, 2, 4));
        // and whatever is lost would have been felt
        SceneFile file = SceneReader.read(folder.resolve("each.json"));
        for (int i = 1; i < file.entities().size(); i++) {
            SceneFile poorer =
                    SceneEdit.change(file, i, e -> e.withPhysics(e.physics().withParts(List.of())))
                            .withLayers(List.of());
            EntitySpec entity = file.entities().get(i);
            if (!entity.physics().parts().isEmpty() && entity.body() == BodyKind.DYNAMIC) {
                Path at = folder.resolve("p.json");
                assertNotEquals(truth, digest(SceneLoader.sample(at, poorer), 1, 1), "entity " + i);
            }
        }
    }

    /** What these do from tick to tick is code; without it both are the same. */
    @ParameterizedTest
    @ValueSource(strings = {"compound-pile", "conveyor", "platform", "lift", "turntable"})
    void scenesOfBodiesAreExportedWhole(String id, @TempDir Path folder) {
        SampleScene scene = SceneRegistry.get(id);
        assertEquals(digest(scene, 1, 1), digest(again(scene, folder), 1, 1));
    }

    @Test
    void whatIsReadIsInTheWorld() {
        String text =
                HEAD
                        + "\"layers\": [\"ground\", \"crate\", \"ghost\"], \"entities\": [{"
                        + "\"name\": \"door\", \"body\": \"fixed\", \"scale\": [2, 2, 2],"
                        + " \"filter\": {\"category\": [\"ghost\"], \"except\": [\"crate\", 5],"
                        + " \"group\": -4}, \"colliders\": [{\"shape\": {\"type\": \"sphere\","
                        + " \"radius\": 1}, \"position\": [0, 1, 0], \"sensor\": true,"
                        + " \"userData\": \"gate\"}, {\"shape\": {\"type\": \"box\","
                        + " \"halfExtents\": [1, 1, 1]}, \"surfaceVelocity\": [3, 0, 0],"
                        + " \"filter\": {\"mask\": [0]}, \"material\": {\"friction\": 0.9,"
                        + " \"frictionMix\": \"multiply\"}}]},"
                        + " {\"material\": {\"surfaceVelocity\": [0, 2, 1]},"
                        + " \"shape\": {\"type\": \"sphere\", \"radius\": 1}, \"position\":"
                        + " [0, 9, 0], \"mass\": 2, \"inertia\": [1, 1, 1.5], \"gravityScale\":"
                        + " -1, \"damping\": {\"angular\": 2}, \"speedLimit\": 5, \"locks\":"
                        + " [\"turnY\", \"moveX\"]}]}";
        SceneFile scene = SceneReader.parse("t", text);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            SceneOptions none = SceneOptions.defaults(SCENE);
            SceneLoader.build(scene, Path.of(""), new SceneBuilder(world, none));
            BodyRef door = world.bodies().get(0);
            ColliderRef gate = door.colliders().get(0);
            assertTrue(gate.isSensor());
            assertEquals("gate", gate.userData());
            assertTrue(gate.shape() instanceof Sphere sphere && sphere.radius() == 2);
            assertEquals(new Vector3d(0, 2, 0), gate.description().localPosition(new Vector3d()));
            assertEquals(new Filter(4, ~(2L | 32L), -4), gate.filter());
            ColliderRef belt = door.colliders().get(1);
            assertEquals(new Filter(1, 1), belt.filter());
            assertEquals(Mix.MULTIPLY, belt.material().frictionMix());
            assertEquals(new Vector3d(3, 0, 0), belt.description().surfaceVelocity(new Vector3d()));
            BodyRef ball = world.bodies().get(1);
            Material runs = ball.colliders().get(0).material();
            assertEquals(new Vector3d(0, 2, 1), runs.surfaceVelocity(new Vector3d()));
            assertEquals(2, ball.statedMass());
            assertEquals(new Vector3d(1, 1, 1.5), ball.statedInertia(new Vector3d()));
            assertEquals(-1, ball.gravityScale());
            assertEquals(0, ball.linearDamping());
            assertEquals(2, ball.angularDamping());
            assertEquals(5, ball.speedLimit());
            assertEquals(List.of(Lock.MOVE_X, Lock.TURN_Y), List.of(ball.locks()));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\u0001',
            value = {
                "SPHERE, \"colliders\": [] | $.entities[0] | a field \"colliders\" | both",
                "\"colliders\": [] | $.entities[0].colliders | at least one | none",
                "\"colliders\": [{\"position\": [0,0,0]}] | $.entities[0].colliders[0] | \"shape\""
                        + " | position",
                "\"colliders\": [{SPHERE, \"sensr\": true}] | $.entities[0].colliders[0].sensr |"
                        + " did you mean sensor? | unknown",
                "\"body\": \"fixed\", \"colliders\": [{\"shape\": {\"type\": \"half-space\"},"
                        + " \"sensor\": true}] | $.entities[0].colliders[0] | a large box |"
                        + " half-space",
                "\"scale\": [1,2,1], \"colliders\": [{SPHERE}] | $.entities[0].scale | three equal"
                        + " | 2",
                "SPHERE, \"filter\": {\"category\": [\"crte\"]} |"
                        + " $.entities[0].filter.category[0] | did you mean crate? | crte",
                "SPHERE, \"filter\": {\"mask\": [64]} | $.entities[0].filter.mask[0] | from 0 to"
                        + " 63 | 64",
                "SPHERE, \"filter\": {\"mask\": [], \"except\": []} | $.entities[0].filter |"
                        + " \"mask\" or a field \"except\" | both",
                "SPHERE, \"locks\": [\"moveY\", \"turny\"] | $.entities[0].locks[1] | turnY |"
                        + " turny",
                "SPHERE, \"damping\": {\"linear\": -1} | $.entities[0].damping.linear | at least 0"
                        + " | -1",
                "SPHERE, \"inertia\": [1,1,3] | $.entities[0].inertia | larger than the sum | 3",
                "SPHERE, \"material\": {\"frictionMix\": \"average \"} |"
                        + " $.entities[0].material.frictionMix | average | average",
            })
    void aMistakeIsToldWhereItStands(String fields, String path, String expected, String found) {
        String sphere = "\"shape\": {\"type\": \"sphere\", \"radius\": 1}";
        String text =
                HEAD
                        + "\"layers\": [\"ground\", \"crate\"],\n\"entities\": [\n{"
                        + fields.replace("SPHERE", sphere)
                        + "}]}";
        SceneFileException told =
                assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
        String message = String.valueOf(told.getMessage());
        assertEquals(path, told.path(), message);
        assertEquals(3, told.line(), message);
        assertTrue(message.contains(expected), message);
        assertTrue(message.contains(found), message);
    }
}
