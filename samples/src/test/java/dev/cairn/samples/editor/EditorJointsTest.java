package dev.cairn.samples.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;

/** Joints in the editor, without a window. */
class EditorJointsTest {
    private static final Xyz Z = new Xyz(0, 0, 1);
    @TempDir private Path folder;
    private Editor editor;
    private EditorJoints joints;

    @BeforeEach
    void open() {
        editor = new Editor(new NoStage());
        editor.open(Supply.emptyScene(), null, folder);
        joints = editor.joints();
    }

    private static EntitySpec box(String name, BodyKind body, double x, double y, double z) {
        return EntitySpec.of(name, body, new BoxShape(new Xyz(0.2, 0.3, 0.4)))
                .at(new Xyz(x, y, z), Turn.NONE);
    }

    /** A box at entity 1 that hangs beside a point of the world. */
    private void hang(String kind) {
        editor.place(box("box", BodyKind.DYNAMIC, 1, 3, 0));
        joints.begin(kind, Z, true);
        joints.click(Editor.NOTHING, new Xyz(0, 3, 0));
        assertFalse(editor.isWrong(), editor.message());
    }

    private void inAWorld(SceneFile scene, Consumer<PhysicsWorld> look) {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            SceneOptions options = new SceneOptions(Map.of(), 1, null);
            SceneLoader.build(scene, folder, new SceneBuilder(world, options));
            look.accept(world);
        }
    }

    /** What was put together by clicks is a pendulum of the length that was clicked. */
    @Test
    void aBoxThatHangsOnTheWorldSwings() {
        SceneFile before = editor.scene();
        hang("hinge");
        JointSpec hinge = joints.selectedJoint();
        assertEquals(new Xyz(0, 3, 0), hinge.place().anchorA());
        assertEquals("anchor", editor.scene().entities().get(hinge.a()).name());
        assertEquals(1, hinge.b());
        assertEquals(Editor.NOTHING, editor.selected());
        inAWorld(
                editor.scene(),
                world -> {
                    JointRef joint = world.joints().all().get(0);
                    BodyRef box = world.bodyOf(joint.entityB());
                    double lowest = 3;
                    for (int tick = 0; tick < 120; tick++) {
                        world.step(1.0 / 60);
                        assertEquals(1, box.position().distance(0, 3, 0), 1e-9);
                        assertEquals(0, box.position().z, 1e-9);
                        lowest = Math.min(lowest, box.position().y);
                    }
                    assertEquals(2, lowest, 0.01);
                });
        editor.undo();
        assertEquals(2, editor.scene().entities().size(), "anchor and joint are one step");
        assertTrue(editor.scene().joints().isEmpty());
        editor.undo();
        assertEquals(before, editor.scene());
        editor.redo();
        editor.redo();
        assertEquals(1, editor.scene().joints().size());
    }

    @Test
    void allThatAJointIsCanBeChangedSavedAndTakenBack() {
        editor.place(box("frame", BodyKind.FIXED, 0, 3, 0));
        editor.place(box("door", BodyKind.DYNAMIC, 0.5, 3, 0));
        editor.select(1);
        joints.begin("hinge", new Xyz(0, 1, 0), false);
        joints.click(2, new Xyz(0.25, 3, 0));
        JointSpec plain = joints.selectedJoint();
        AxisState wanted =
                new AxisState(false, true, -0.5, 2, true, 1.5, 40, true, 0.25, 3, 0.7, false, 90);
        joints.change("twist of", j -> j.withAxis(JointAxis.TWIST, wanted));
        joints.change("strength of", j -> j.bearing(5000, 800, false, true));
        joints.change("name of", j -> j.withName("hinge of the door"));
        assertFalse(editor.isWrong(), editor.message());
        SceneFile edited = editor.scene();
        editor.files().save("door.json");
        assertEquals(edited, SceneReader.read(folder.resolve("door.json")));
        inAWorld(
                SceneReader.read(folder.resolve("door.json")),
                world -> {
                    JointRef made = world.joints().all().get(0);
                    assertEquals(wanted, made.settings(JointAxis.TWIST));
                    assertEquals(5000, made.breakForce(), 0.0);
                    assertEquals(800, made.breakTorque(), 0.0);
                    assertTrue(made.collides());
                    assertFalse(made.isEnabled());
                    assertEquals("hinge of the door", made.name());
                });
        for (int i = 0; i < 3; i++) {
            editor.undo();
        }
        assertEquals(plain, joints.selectedJoint(), "it stays selected");
        joints.changeKind("rod");
        // from the middle of the frame to where the hinge was
        assertEquals(new Xyz(0, 3, 0), joints.selectedJoint().place().anchorA());
        assertEquals(new Xyz(0.25, 3, 0), joints.selectedJoint().place().anchorB());
        editor.delete();
        assertTrue(editor.scene().joints().isEmpty());
        assertEquals(3, editor.scene().entities().size(), "its bodies stay");
        editor.undo();
        assertEquals("rod", joints.selectedJoint().kind(), "what came back is selected");
    }

    /** What is fixed to a body goes with it: the place in the body's frame is the same. */
    @Test
    void jointsGoWithTheirBodies() {
        editor.place(box("frame", BodyKind.FIXED, 0, 3, 0));
        editor.place(box("door", BodyKind.DYNAMIC, 1, 3, 0));
        editor.select(1);
        joints.begin("hinge", new Xyz(0, 1, 0), false);
        joints.click(2, new Xyz(0.5, 3, 0));
        joints.begin("rod", Z, false);
        editor.select(1);
        joints.begin("rod", Z, false);
        joints.click(2, new Xyz(1, 3.3, 0));
        editor.select(2);
        editor.change("move", e -> e.at(new Xyz(1, 5, 0), e.rotation()));
        assertEquals(new Xyz(0.5, 3, 0), place(0).anchorB(), "a hinge is the frame's");
        assertEquals(new Xyz(0, 3, 0), place(1).anchorA());
        assertEquals(new Xyz(1, 5.3, 0), place(1).anchorB(), "a rod's end is the door's");
        editor.select(1);
        // a right angle about z: x becomes y, y becomes -x
        editor.change("turn", e -> e.at(new Xyz(7, 7, 7), Turn.about(Z, 90)));
        assertEquals(new Xyz(7, 7.5, 7), place(0).anchorA());
        assertEquals(new Xyz(7, 7.5, 7), place(0).anchorB());
        assertEquals(-1, place(0).axis().x(), 1e-12);
        assertEquals(0, place(0).axis().y(), 1e-12);
        editor.select(1);
        editor.delete();
        assertTrue(editor.scene().joints().isEmpty(), "nothing holds what is gone");
        editor.undo();
        assertEquals(2, editor.scene().joints().size());
    }

    private JointSpec.Place place(int joint) {
        return editor.scene().joints().get(joint).place();
    }

    @Test
    void mistakesAreALineAndChangeNothing() {
        joints.begin("ball", Z, true);
        refused("nothing is selected");
        hang("ball");
        SceneFile good = editor.scene();
        int steps = editor.history().steps();
        editor.select(1);
        joints.begin("ball", Z, false);
        joints.click(1, Xyz.ZERO);
        refused("same twice");
        assertEquals(EditorJoints.Click.PARTNER, joints.awaited(), "another click may be better");
        joints.click(Editor.NOTHING, Xyz.ZERO);
        refused("no body");
        editor.select(0);
        joints.begin("ball", Z, false);
        joints.click(2, Xyz.ZERO);
        refused("two fixed bodies");
        joints.select(0);
        AxisState twice = new AxisState(false, true, 2, 1, false, 0, 0, false, 0, 0, 0, false, 0);
        joints.change("cone of", j -> j.withAxis(JointAxis.CONE, twice));
        refused("must not be above");
        AxisState still = new AxisState(false, false, 0, 0, false, 0, 0, true, 0, 0, 1, false, 9);
        joints.change("cone of", j -> j.withAxis(JointAxis.CONE, still));
        refused("hertz");
        joints.change(
                "place of",
                j -> j.withPlace(new JointSpec.Place(Xyz.ZERO, Xyz.ZERO, Xyz.ZERO, null)));
        refused("axis");
        joints.changeKind("gear");
        editor.undo();
        assertEquals(good, editor.scene());
        assertEquals(steps, editor.history().steps());
        editor.play();
        editor.delete();
        refused("the scene runs");
    }

    private void refused(String why) {
        assertTrue(editor.isWrong(), why);
        assertTrue(editor.message().contains(why), editor.message());
    }

    /** Whatever is done by chance: the file is the scene, a world can be made, and undo ends it. */
    @Test
    void whateverIsDoneCanBeSavedBuiltAndTakenBack() {
        long seed = 20_260_719L;
        SplittableRandom random = new SplittableRandom(seed);
        SceneFile start = editor.scene();
        int made = 0;
        for (int round = 0; round < 300; round++) {
            List<EntitySpec> entities = editor.scene().entities();
            int some = random.nextInt(entities.size());
            Xyz at =
                    new Xyz(
                            random.nextDouble(-9, 9),
                            random.nextDouble(0, 9),
                            random.nextDouble(-9, 9));
            switch (random.nextInt(8)) {
                case 0 -> editor.place(box("box", BodyKind.DYNAMIC, at.x(), at.y(), at.z()));
                case 1, 2 -> {
                    editor.select(some);
                    String kind = JointSpec.KINDS.get(random.nextInt(JointSpec.KINDS.size()));
                    joints.begin(kind, Z, random.nextInt(4) == 0);
                    joints.click(random.nextInt(entities.size()), at);
                }
                case 3 -> {
                    editor.select(some);
                    double degrees = random.nextDouble(360);
                    editor.change("move", e -> e.at(at, Turn.about(Xyz.ONE, degrees)));
                }
                case 4 -> {
                    joints.select(random.nextInt(editor.scene().joints().size() + 1));
                    editor.delete();
                }
                case 5 -> {
                    joints.select(random.nextInt(editor.scene().joints().size() + 1));
                    joints.changeKind(JointSpec.KINDS.get(random.nextInt(JointSpec.KINDS.size())));
                }
                case 6 -> {
                    editor.select(random.nextInt(3) == 0 && entities.size() > 6 ? some : -1);
                    editor.delete();
                }
                default -> {
                    if (random.nextBoolean()) {
                        editor.undo();
                    } else {
                        editor.redo();
                    }
                }
            }
            made = Math.max(made, editor.scene().joints().size());
            String text = SceneWriter.text(editor.scene());
            assertEquals(editor.scene(), SceneReader.parse("seed " + seed, text));
            if (round % 10 == 0) {
                int wanted = editor.scene().joints().size();
                inAWorld(
                        editor.scene(),
                        world -> assertEquals(wanted, world.joints().count(), "seed " + seed));
            }
        }
        assertTrue(made > 3, "joints: " + made);
        while (editor.history().steps() > 0) {
            editor.undo();
        }
        assertEquals(start, editor.scene());
    }
}
