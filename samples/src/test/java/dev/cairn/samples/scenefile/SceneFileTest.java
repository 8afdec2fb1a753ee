package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.camera.Light;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.SceneFile.TickSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** What is written is what is read, bit for bit; what is wrong is told where it stands. */
class SceneFileTest {
    private static final String HEAD = "{\n\"format\": \"cairn-scene\",\n\"version\": 1,\n";
    private static final SceneOptions NO_OPTIONS =
            SceneOptions.defaults(SceneRegistry.get("pyramid"));

    /** Any finite double, of any magnitude, signed zeros and subnormals too. */
    private static double any(SplittableRandom random) {
        return switch (random.nextInt(6)) {
            case 0 -> -0.0;
            case 1 -> random.nextInt(-5, 5);
            case 2 -> Double.MIN_VALUE * random.nextInt(1, 1000);
            case 3 -> random.nextDouble(-1e9, 1e9);
            default -> {
                double value = Double.longBitsToDouble(random.nextLong());
                yield Double.isFinite(value) ? value : Double.MAX_VALUE;
            }
        };
    }

    private static Xyz xyz(SplittableRandom random) {
        return new Xyz(any(random), any(random), any(random));
    }

    private static Xyz positive(SplittableRandom random) {
        return new Xyz(
                random.nextDouble(0.01, 9), random.nextDouble(0.01, 9), random.nextDouble(0.01, 9));
    }

    private static EntitySpec entity(SplittableRandom random) {
        double factor = random.nextDouble(0.01, 9);
        boolean round = random.nextBoolean();
        List<Xyz> points = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            points.add(
                    new Xyz(
                            random.nextDouble(-1, 1) + (i == 0 ? 5 : 0),
                            random.nextDouble(-1, 1) + (i == 1 ? 5 : 0),
                            random.nextDouble(-1, 1) + (i == 2 ? 5 : 0)));
        }
        ShapeSpec shape =
                round
                        ? new SphereShape(random.nextDouble(0.01, 100))
                        : switch (random.nextInt(3)) {
                            case 0 -> new BoxShape(positive(random));
                            case 1 -> new HullShape(points);
                            default -> new MeshShape("a folder/ünïcode \"" + factor + "\".obj");
                        };
        BodyKind[] kinds = BodyKind.values();
        return EntitySpec.of(
                        random.nextBoolean() ? "" : "name \\ \n \"" + random.nextInt(),
                        kinds[random.nextInt(kinds.length)],
                        shape)
                .at(xyz(random), Turn.about(positive(random), random.nextDouble(-900, 900)))
                .withScale(round ? new Xyz(factor, factor, factor) : positive(random))
                .withMaterial(
                        new Material(
                                Math.abs(any(random)) + 0.0,
                                random.nextDouble(),
                                Math.max(Double.MIN_NORMAL, Math.abs(any(random))),
                                random.nextBoolean() ? 0 : Math.abs(any(random)) + 0.0),
                        random.nextBoolean() ? null : (Double) random.nextDouble(1e-9, 1e9))
                .moving(xyz(random), xyz(random))
                .withLook(
                        new LookSpec(
                                random.nextBoolean(),
                                random.nextBoolean() ? null : (Integer) random.nextInt(1 << 24),
                                random.nextBoolean() ? null : "builtin:grid",
                                random.nextBoolean() ? 0 : random.nextDouble(9),
                                random.nextBoolean() ? null : "x.obj",
                                positive(random)))
                .withDriven(driven(random));
    }

    private static EntitySpec.Driven driven(SplittableRandom random) {
        List<Control> controls = new ArrayList<>();
        for (int i = random.nextInt(3); i > 0; i--) {
            boolean byKey = random.nextBoolean();
            controls.add(
                    new Control(
                            byKey ? Key.values()[random.nextInt(Key.values().length)] : null,
                            byKey ? null : MouseButton.values()[random.nextInt(3)],
                            Control.Effect.values()[random.nextInt(3)],
                            Control.Axes.values()[random.nextInt(3)],
                            any(random),
                            any(random),
                            any(random)));
        }
        return new EntitySpec.Driven(
                controls,
                random.nextBoolean()
                        ? null
                        : new CameraMount(random.nextDouble(1, 9), 2, -0.0, random.nextBoolean()));
    }

    private static SceneFile scene(SplittableRandom random) {
        List<EntitySpec> entities = new ArrayList<>();
        for (int i = random.nextInt(8); i > 0; i--) {
            entities.add(entity(random));
        }
        return new SceneFile(
                "scene " + random.nextInt(),
                random.nextBoolean() ? "" : "a \u2028 description\t\u0001",
                xyz(random),
                new TickSpec(
                        random.nextDouble(1e-6, 1),
                        random.nextInt(1, 65),
                        random.nextInt(100, 1000),
                        random.nextInt(100)),
                new CameraSpec(xyz(random), xyz(random), random.nextDouble(2, 170)),
                Light.DAYLIGHT
                        .from(random.nextDouble(), 1, -0.0)
                        .strengths(random.nextDouble(), random.nextDouble())
                        .haze(random.nextDouble())
                        .background(random.nextInt(1 << 24), random.nextInt(1 << 24))
                        .shadows(random.nextBoolean()),
                entities,
                joints(random, entities.size()));
    }

    private static List<JointSpec> joints(SplittableRandom random, int entities) {
        List<JointSpec> joints = new ArrayList<>();
        for (int i = entities > 0 ? random.nextInt(4) : 0; i > 0; i--) {
            List<JointSpec.Axis> axes = new ArrayList<>();
            for (JointAxis axis : JointAxis.values()) {
                if (random.nextInt(3) == 0) {
                    axes.add(new JointSpec.Axis(axis, state(random)));
                }
            }
            Xyz at = random.nextBoolean() ? xyz(random) : null;
            String kind = JointSpec.KINDS.get(random.nextInt(JointSpec.KINDS.size()));
            List<Double> parameters = new ArrayList<>();
            while (parameters.size() < JointSpec.parameters(kind)) {
                parameters.add(any(random));
            }
            joints.add(
                    new JointSpec(
                            kind,
                            random.nextBoolean() ? "" : "joint " + i,
                            random.nextInt(entities),
                            random.nextInt(entities),
                            parameters,
                            new JointSpec.Place(
                                    at,
                                    at == null || random.nextBoolean() ? at : xyz(random),
                                    xyz(random),
                                    random.nextBoolean() ? null : xyz(random)),
                            axes,
                            random.nextBoolean() ? 0 : random.nextDouble(1, 2),
                            random.nextBoolean(),
                            random.nextBoolean() ? Double.POSITIVE_INFINITY : 1e3,
                            random.nextBoolean() ? Double.POSITIVE_INFINITY : 1e-3,
                            random.nextBoolean()));
        }
        return joints;
    }

    private static AxisState state(SplittableRandom random) {
        boolean limits = random.nextBoolean();
        boolean motor = random.nextBoolean();
        boolean spring = random.nextBoolean();
        return new AxisState(
                random.nextBoolean(),
                limits,
                limits ? Double.NEGATIVE_INFINITY : 0,
                limits ? random.nextDouble(3) : 0,
                motor,
                motor ? any(random) : 0,
                motor ? 7 : 0,
                spring,
                spring ? any(random) : 0,
                spring ? random.nextDouble(1, 9) : 0,
                spring ? random.nextDouble() : 0,
                spring && random.nextBoolean(),
                spring ? Double.POSITIVE_INFINITY : 0);
    }

    @Test
    void whatIsWrittenIsReadBitForBit() {
        for (long seed = 1; seed <= 300; seed++) {
            SceneFile scene = scene(new SplittableRandom(seed));
            String text = SceneWriter.text(scene);
            SceneFile again = SceneReader.parse("test", text);
            assertEquals(scene, again, "seed " + seed);
            assertEquals(text, SceneWriter.text(again), "seed " + seed);
        }
    }

    @Test
    void whatIsLeftOutHasItsDefault() {
        SceneFile scene =
                SceneReader.parse(
                        "test",
                        HEAD
                                + "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\":"
                                + " 2}, \"rotation\": {\"axis\": [0, 3, 0], \"degrees\": 90}}]}");
        Turn quarter = Turn.about(new Xyz(0, 1, 0), 90);
        assertEquals(
                SceneFile.empty("")
                        .withEntities(
                                List.of(
                                        EntitySpec.of("", BodyKind.DYNAMIC, new SphereShape(2))
                                                .at(Xyz.ZERO, quarter))),
                scene);
        assertEquals(Math.sqrt(0.5), quarter.w(), 1e-15);
        assertEquals(Math.sqrt(0.5), quarter.y(), 1e-15);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\u0001',
            value = {
                "\"gravty\": [0,0,0], | 4 | $.gravty | did you mean gravity? | unknown field"
                        + " \"gravty\"",
                "\"gravity\": [0,0], | 4 | $.gravity | three numbers | a list of 2",
                "\"gravity\": [0,\"x\",0], | 4 | $.gravity[1] | a number | \"x\"",
                "\"gravity\": [0,1e999,0], | 4 | $.gravity[1] | within | 1e999",
                "\"gravity\": [0,NaN,0], | 4 | $.gravity[1] | JSON | malformed",
                "\"camera\": {\"fieldOfViewDegrees\": 0}, | 4 | $.camera.fieldOfViewDegrees | from"
                        + " 2 to 170 | 0",
                "\"tick\": {\"seconds\": 0}, | 4 | $.tick.seconds | above 0 | 0",
                "\"tick\": {\"substeps\": 1.5}, | 4 | $.tick.substeps | whole number from 1 to 64 |"
                        + " 1.5",
                "\"tick\": {\"ticks\": 5, \"pictureTick\": 6}, | 4 | $.tick.pictureTick | from 0 to"
                        + " 5 | 6",
                "\"light\": {\"horizon\": \"blue\"}, | 4 | $.light.horizon | #RRGGBB | \"blue\"",
                "\"light\": {\"sun\": [0,-1,0]}, | 4 | $.light.sun | at least 0 | -1",
                "\"light\": {\"sunDirection\": [0,0,0]}, | 4 | $.light.sunDirection | a direction |"
                        + " [0, 0, 0]",
                "\"name\": null, | 4 | $.name | in quotes | null",
                "\"name\": \"a\", \"name\": \"b\", | 4 | $.name | each field once | again",
                "\"name\": \"a\" | 5 | $.name | JSON | Unterminated",
            })
    void aMistakeInTheHeadIsToldWhereItStands(
            String lines, int line, String path, String expected, String found) {
        refuses(HEAD + lines + "\n\"entities\": []}", line, path, expected, found);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\u0001',
            value = {
                "\"shape\": {\"type\": \"sphere\"} | $.entities[0].shape | \"radius\" | type",
                "\"shape\": {\"type\": \"ball\", \"radius\": 1} | $.entities[0].shape.type | one of"
                        + " the shapes | \"ball\"",
                "\"shape\": {\"type\": \"spere\", \"radius\": 1} | $.entities[0].shape.type | did"
                        + " you mean sphere? | \"spere\"",
                "\"shape\": {\"type\": \"box\", \"radius\": 1} | $.entities[0].shape.radius |"
                        + " halfExtents | unknown",
                "\"shape\": {\"type\": \"box\", \"halfExtents\": [1,0,1]} | $.entities[0].shape |"
                        + " half | 0",
                "\"shape\": {\"type\": \"sphere\", \"radius\": -1} | $.entities[0].shape.radius |"
                        + " above 0 | -1",
                "\"shape\": {\"type\": \"hull\", \"points\": [[0,0,0],[1,0,0],[0,1,0]]} |"
                        + " $.entities[0].shape | point | ",
                "\"shape\": {\"type\": \"moved\", \"shape\": {\"type\": \"mesh\", \"file\":"
                        + " \"a.obj\"}, \"position\": [0,0,0], \"rotation\": [0,0,0,1]} |"
                        + " $.entities[0].shape.shape | no mesh | mesh",
                "\"name\": \"x\" | $.entities[0] | \"shape\" | name",
                "SPHERE, \"body\": \"static\" | $.entities[0].body | \"dynamic\", \"fixed\","
                        + " \"kinematic\" or \"none\" | \"static\"",
                "SPHERE, \"mass\": 0 | $.entities[0].mass | above 0 | 0",
                "SPHERE, \"scale\": [1,2,1] | $.entities[0].shape | three equal | 2",
                "SPHERE, \"scale\": [1,1,0] | $.entities[0].scale | above 0 | 0",
                "SPHERE, \"rotation\": [0,0,0,2] | $.entities[0].rotation | 1 +- | 2",
                "SPHERE, \"rotation\": [0,0,1] | $.entities[0].rotation | [x, y, z, w] | a list of"
                        + " 3",
                "SPHERE, \"rotation\": {\"axis\": [0,0,0], \"degrees\": 1} | $.entities[0].rotation"
                        + " | axis | 0",
                "SPHERE, \"material\": {\"restitution\": 1.1} | $.entities[0].material.restitution"
                        + " | from 0 to 1 | 1.1",
                "SPHERE, \"material\": {\"friction\": \"high\"} | $.entities[0].material.friction |"
                        + " at least 0 | \"high\"",
                "SPHERE, \"material\": {\"colour\": 1} | $.entities[0].material.colour | friction,"
                        + " restitution, density | unknown",
                "SPHERE, \"look\": {\"texture\": \"builtin:wood\"} | $.entities[0].look.texture |"
                        + " builtin:grid | builtin:wood",
                "SPHERE, \"controls\": [{\"does\": \"push\", \"along\": [0,0,1]}] |"
                    + " $.entities[0].controls[0] | a field \"key\" or a field \"mouse\" | does",
                "SPHERE, \"controls\": [{\"key\": \"up\", \"does\": \"push\", \"along\":"
                        + " [0,0,1]}] | $.entities[0].controls[0].key | did you mean UP? | \"up\"",
                "SPHERE, \"controls\": [{\"key\": \"UP\", \"does\": \"pull\", \"along\": [0,0,1]}]"
                        + " | $.entities[0].controls[0].does | push, turn, kick | \"pull\"",
                "SPHERE, \"camera\": {\"offset\": [0,0,0]} | $.entities[0].camera | distance |"
                        + " (0, 0, 0)",
                "SPHERE, \"look\": {\"visible\": 1} | $.entities[0].look.visible | true or false |"
                        + " 1",
            })
    void aMistakeInAnEntityIsToldWhereItStands(
            String fields, String path, String expected, String found) {
        String sphere = "\"shape\": {\"type\": \"sphere\", \"radius\": 1}";
        String text = HEAD + "\"entities\": [\n{" + fields.replace("SPHERE", sphere) + "}]}";
        refuses(text, 5, path, expected, found);
    }

    private static void refuses(String text, int line, String path, String expected, String found) {
        SceneFileException told =
                assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
        String message = String.valueOf(told.getMessage());
        assertTrue(message.startsWith("a.json:" + line + ": "), message);
        assertEquals(line, told.line(), message);
        assertEquals(path, told.path(), message);
        assertTrue(message.contains(expected), message);
        assertTrue(found == null || message.contains(found), message);
        assertEquals(1, message.lines().count(), message);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "[]",
                "7",
                "{}",
                "{\"format\": \"other\"}",
                "{\"format\": \"cairn-scene\", \"version\": 2, \"entities\": []}",
                "{\"format\": \"cairn-scene\", \"version\": 1}",
                "{\"format\": \"cairn-scene\", \"version\": 1, \"entities\": []} {}",
                "// comment\n{\"format\": \"cairn-scene\"}"
            })
    void whatIsNoSceneIsRefused(String text) {
        assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
    }

    @Test
    void deepNestingIsRefusedAndNoCrash() {
        String text = "[".repeat(100_000);
        assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
    }

    @Test
    void aMissingFileAndAFolderAreTold(@TempDir Path folder) {
        assertTrue(message(folder.resolve("no.json")).contains("nothing there"));
        assertTrue(message(folder).contains("a folder"));
    }

    private static String message(Path file) {
        return String.valueOf(
                assertThrows(SceneFileException.class, () -> SceneReader.read(file)).getMessage());
    }

    static List<String> idsWithoutHooks() {
        List<String> ids = new ArrayList<>();
        for (SampleScene scene : SceneRegistry.all()) {
            SceneOptions options = SceneOptions.defaults(scene);
            EcsSystem[] systems = scene.systems(options);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).systems(systems).build()) {
                boolean acts = scene.build(new SceneBuilder(world, options)).actsBeforeTicks();
                if (!acts) {
                    ids.add(scene.id());
                }
            }
        }
        return ids;
    }

    @ParameterizedTest
    @MethodSource("idsWithoutHooks")
    void anExportedSceneRunsToTheSameDigest(String id, @TempDir Path folder) {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        Path file = folder.resolve(id + ".json");
        SceneWriter.write(SceneExport.of(scene, options, 4, folder), file);
        SampleScene again = SceneLoader.sample(file, SceneReader.read(file));
        assertEquals(id, again.id());
        assertEquals(run(scene).digest(), run(again).digest());
    }

    @Test
    void jointsThatCannotBeAreTold() {
        String two =
                HEAD
                        + "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1}},"
                        + " {\"body\": \"%s\", \"shape\": {\"type\": \"sphere\", \"radius\": 1}}],"
                        + " \"joints\": [{%s}]}";
        for (String[] wrong :
                new String[][] {
                    {"\"type\": \"hing\", \"a\": 0, \"b\": 1", "$.joints[0].type"},
                    {"\"type\": \"hinge\", \"a\": 0, \"b\": 2", "$.joints[0].b"},
                    {"\"type\": \"hinge\", \"a\": 0", "b"},
                    {
                        "\"type\": \"hinge\", \"a\": 0, \"b\": 1, \"lengt\": 1",
                        "did you mean length?"
                    }
                }) {
            SceneFileException told =
                    assertThrows(
                            SceneFileException.class,
                            () -> SceneReader.parse("t", two.formatted("fixed", wrong[0])));
            assertTrue(String.valueOf(told.getMessage()).contains(wrong[1]), told.getMessage());
        }
        for (String[] wrong :
                new String[][] {
                    {"none", "\"at\": [0, 0, 0]", "only drawn"},
                    {"fixed", "\"name\": \"pin\"", "no place"},
                    {"fixed", "\"axes\": {\"twist\": {\"limits\": [1, 0]}}", "above"}
                }) {
            SceneFile scene =
                    SceneReader.parse(
                            "t",
                            two.formatted(
                                    wrong[0],
                                    "\"type\": \"hinge\", \"a\": 0, \"b\": 1, " + wrong[1]));
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                SceneBuilder into = new SceneBuilder(world, NO_OPTIONS);
                IllegalArgumentException told =
                        assertThrows(
                                IllegalArgumentException.class,
                                () -> SceneLoader.build(scene, Path.of(""), into));
                assertTrue(String.valueOf(told.getMessage()).startsWith("$.joints[0]"));
                assertTrue(String.valueOf(told.getMessage()).contains(wrong[2]), told.toString());
            }
        }
    }

    /** What a joint is made of is in the file: all kinds with all they can have. */
    @Test
    void joinedEntitiesAreJoinedAgain() {
        String ball =
                "{\"shape\": {\"type\": \"sphere\", \"radius\": 0.2}, \"position\": [%d, 0, 0]}";
        SceneFile scene =
                SceneReader.parse(
                        "t",
                        HEAD
                                + "\"entities\": ["
                                + ball.formatted(0)
                                + ","
                                + ball.formatted(2)
                                + ","
                                + ball.formatted(4)
                                + "], \"joints\": [{\"type\": \"rod\", \"a\": 0, \"b\": 2},"
                                + " {\"type\": \"hinge\", \"a\": 2, \"b\": 1, \"at\": [3, 0, 0],"
                                + " \"on\": false, \"axes\": {\"twist\": {\"limits\": [-1,"
                                + " \"none\"], \"motor\": {\"speed\": 3}}}}]}");
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            SceneLoader.build(scene, Path.of(""), new SceneBuilder(world, NO_OPTIONS));
            List<JointRef> joints = world.joints().all();
            assertEquals(2, joints.size());
            assertEquals(4, joints.get(0).length(), 1e-12);
            assertFalse(joints.get(1).isEnabled());
            assertEquals(-1, joints.get(1).settings(JointAxis.TWIST).lower());
            assertEquals(3, joints.get(1).settings(JointAxis.TWIST).speed());
        }
        SceneFile less = SceneEdit.delete(scene, 0);
        assertEquals(1, less.joints().size(), "joints go with their entities");
        assertEquals(1, less.joints().get(0).a());
        assertEquals(0, less.joints().get(0).b());
    }

    private static SceneReport run(SampleScene scene) {
        return new SceneRun(scene, SceneOptions.defaults(scene), 20, 1, 4).run(() -> {});
    }

    @Test
    void brokenFilesBecomePlaceholdersAndAreTold(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("broken.obj"), "v 0 0 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("no.png"), "this is no picture");
        String good = "\"shape\": {\"type\": \"sphere\", \"radius\": 1}";
        String mesh = "\"shape\": {\"type\": \"mesh\", \"file\": \"%s\"}";
        String text =
                HEAD
                        + "\"entities\": [{"
                        + String.join(
                                "}, {",
                                good + ", \"position\": [0, 9, 0]",
                                mesh.formatted("broken.obj"),
                                mesh.formatted("flat.obj") + ", \"position\": [3, 0, 0]",
                                mesh.formatted("missing.obj") + ", \"position\": [6, 0, 0]",
                                mesh.formatted("missing.obj") + ", \"position\": [8, 0, 0]",
                                good
                                        + ", \"position\": [0, 20, 0], \"look\": {\"texture\":"
                                        + " \"no.png\"}")
                        + "}]}";
        Path file = Files.writeString(folder.resolve("scene.json"), text);
        SceneReport report = run(SceneLoader.sample(file, SceneReader.read(file)));
        assertEquals(6, report.bodies());
        String told = String.join("\n", report.remarks());
        assertEquals(4, report.remarks().size(), told);
        assertTrue(told.contains("broken.obj:2: expected"), told);
        assertTrue(told.contains("flat.obj: no convex hull"), told);
        assertTrue(told.contains("missing.obj: expected an .obj file"), told);
        assertTrue(told.contains("no.png: expected a picture"), told);
    }

    @Test
    void anEntityOutsideThePhysicsIsDrawnAndClearedAway(@TempDir Path folder) {
        String text =
                HEAD
                        + "\"gravity\": [0, -1, 0],\n"
                        + "\"entities\": [{\"body\": \"none\", \"shape\": {\"type\": \"box\","
                        + " \"halfExtents\": [1,1,1]}},{\"body\": \"fixed\", \"shape\": {\"type\":"
                        + " \"sphere\", \"radius\": 1}}]}";
        SampleScene scene =
                SceneLoader.sample(folder.resolve("s.json"), SceneReader.parse("s", text));
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            assertEquals(1, world.bodyCount());
            assertEquals(2, world.ecs().entityCount());
            assertEquals(-1, world.gravity(new org.joml.Vector3d()).y);
            built.clear();
            assertEquals(0, world.ecs().entityCount());
            assertEquals(-9.81, world.gravity(new org.joml.Vector3d()).y);
        }
    }

    @Test
    void savingReplacesTheFile(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.json");
        SceneWriter.write(SceneFile.empty("first"), file);
        SceneWriter.write(SceneFile.empty("second"), file);
        assertEquals("second", SceneReader.read(file).name());
        assertFalse(Files.exists(folder.resolve("a.json.part")));
    }

    /** A name is a stranger's text: the message is one line of a terminal, and no book. */
    @Test
    void messageIsOneShortLineWhateverTheFileHolds() {
        String name = "\\u001b[31m\\n" + "x".repeat(1_000_000);
        for (String wrong :
                List.of(
                        HEAD + "\"entities\": [{\"" + name + "\": {\"a\": 1}}]}",
                        HEAD + "\"entities\": [{\"" + name + "\": 1, \"" + name + "\": 1}]}",
                        HEAD + "\"entities\": [{\"" + name + "\": tru}]}",
                        HEAD + "\"entities\": [{\"shape\": \"" + name + "\"}]}")) {
            String told =
                    assertThrows(
                                    SceneFileException.class,
                                    () -> SceneReader.parse("a\u001b[2Jb.json", wrong))
                            .getMessage();
            assertTrue(told.length() < 1000, () -> told.length() + " characters");
            assertTrue(told.chars().noneMatch(Character::isISOControl), told);
            assertFalse(told.contains("JsonReader"), told);
        }
    }

    /** A second a million values, not a minute: the place is looked up for what is wrong only. */
    @Test
    void longListIsReadInProportion() {
        String list = HEAD + "\"entities\": [" + "0,\n".repeat(3_000_000) + "0]}";
        SceneFileException told =
                assertThrows(SceneFileException.class, () -> SceneReader.parse("long", list));
        assertEquals(4, told.line());
        assertEquals("$.entities[0]", told.path());
        SceneFileException many =
                assertThrows(
                        SceneFileException.class,
                        () -> SceneReader.parse("many", "[" + "0,".repeat(4_000_000) + "0]"));
        assertTrue(many.getMessage().contains("at most 4000000 values"), many.getMessage());
    }
}
