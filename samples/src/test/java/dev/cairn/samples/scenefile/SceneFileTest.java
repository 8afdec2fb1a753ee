package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
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
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** What is written is what is read, bit for bit, and runs to the same bits. */
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
                            default ->
                                    new MeshShape(
                                            "a folder/ünïcode \"" + factor + "\".obj",
                                            As.HULL,
                                            random.nextInt(1, 99),
                                            random.nextDouble(.01, 1));
                        };
        BodyKind[] kinds = BodyKind.values();
        BodySpec physics = physics(random, shape);
        return EntitySpec.of(
                        random.nextBoolean() ? "" : "name \\ \n \"" + random.nextInt(),
                        kinds[random.nextInt(kinds.length)],
                        shape)
                .at(xyz(random), Turn.about(positive(random), random.nextDouble(-900, 900)))
                .withScale(
                        round || !physics.parts().isEmpty()
                                ? new Xyz(factor, factor, factor)
                                : positive(random))
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
                .withDriven(driven(random))
                .withPhysics(physics);
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
        List<String> layers = random.nextBoolean() ? List.of() : List.of("ground", "crate", "3");
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
                joints(random, entities.size()),
                layers,
                random.nextBoolean() ? null : "states/" + random.nextInt() + ".cairn");
    }

    private static Filter filter(SplittableRandom random) {
        long mask = random.nextBoolean() ? random.nextLong() : -1L << random.nextInt(3);
        return new Filter(1L << random.nextInt(64), mask, random.nextInt(-2, 3));
    }

    private static BodySpec physics(SplittableRandom random, ShapeSpec shape) {
        List<PartSpec> parts = new ArrayList<>();
        for (int i = random.nextInt(3); i > 0; i--) {
            parts.add(
                    new PartSpec(
                            shape,
                            positive(random),
                            Turn.about(positive(random), random.nextDouble(-900, 900)),
                            random.nextBoolean()
                                    ? null
                                    : Material.DEFAULT.withMix(Mix.AVERAGE, Mix.MAXIMUM),
                            random.nextBoolean() ? null : filter(random),
                            random.nextBoolean(),
                            xyz(random),
                            random.nextBoolean() ? null : "ünï \"code\""));
        }
        double most = random.nextDouble(1, 2);
        boolean hasInertia = random.nextBoolean();
        return new BodySpec(
                parts,
                random.nextBoolean() ? Filter.ALL : filter(random),
                hasInertia ? new Xyz(1, most, most) : null,
                hasInertia ? xyz(random) : Xyz.ZERO,
                random.nextBoolean() ? null : xyz(random),
                random.nextBoolean() ? 1 : any(random),
                random.nextBoolean() ? 0 : random.nextDouble(1e6),
                random.nextBoolean() ? 0 : random.nextDouble(1e6),
                random.nextBoolean() ? Double.POSITIVE_INFINITY : random.nextDouble(1, 9),
                random.nextBoolean() ? List.of() : List.of(Lock.MOVE_X, Lock.TURN_Z),
                random.nextBoolean(),
                random.nextBoolean()
                        ? null
                        : random.nextBoolean() ? "a word" : (Object) any(random));
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
            if (kind.equals("path")) {
                parameters.add(random.nextBoolean() ? 1.0 : 0.0);
                int numbers = 9 + 3 * random.nextInt(4);
                for (int k = 0; k < numbers; k++) {
                    parameters.add(any(random));
                }
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
}
