package dev.cairn.samples.editor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Material;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.BodySpec;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/** What the editor does, without a window. */
class EditorTest {
    @TempDir private Path folder;
    private final List<String> seen = new ArrayList<>();
    private SceneFile shown;
    private Editor editor;

    /** Keeps what it is told. */
    private final Stage stage =
            new Stage() {
                @Override
                public void rest(SceneFile scene, Path from, boolean places) {
                    seen.add("rest");
                    shown = scene;
                }

                @Override
                public void play(SceneFile scene, Path from) {
                    seen.add("play");
                    shown = scene;
                }

                @Override
                public void leave() {
                    seen.add("leave");
                }
            };

    @BeforeEach
    void open() {
        editor = new Editor(stage);
        editor.open(Supply.emptyScene(), null, folder);
    }

    private static EntitySpec box(String name) {
        return EntitySpec.of(name, BodyKind.DYNAMIC, new BoxShape(new Xyz(0.5, 0.5, 0.5)));
    }

    @Test
    void whatIsPlacedIsSelectedShownAndCanBeTakenBack() {
        SceneFile before = editor.scene();
        editor.place(box("crate"));
        assertEquals("crate", editor.selectedEntity().name());
        assertSame(editor.scene(), shown);
        editor.group().duplicate();
        // One metre wide, with 0.1 m between: the copy is 1.1 m along x.
        assertEquals(new Xyz(1.1, 0, 0), editor.selectedEntity().position());
        assertEquals(3, editor.scene().entities().size());
        editor.delete();
        assertEquals(Editor.NOTHING, editor.selected());
        editor.undo();
        editor.undo();
        editor.undo();
        assertEquals(before, editor.scene());
        assertFalse(editor.isChanged());
        editor.undo();
        assertTrue(editor.isWrong());
        editor.redo();
        assertEquals("crate", editor.scene().entities().get(1).name());
        assertSame(editor.scene(), shown);
    }

    @Test
    void undoingACopySelectsTheOriginalAndDoingItAgainTheCopy() {
        editor.place(box("crate"));
        editor.group().duplicate();
        editor.undo();
        assertArrayEquals(new int[] {1}, editor.selection());
        editor.redo();
        assertArrayEquals(new int[] {2}, editor.selection());
        // Two at once, and both come back after they were deleted.
        editor.select(1);
        editor.toggle(2);
        editor.group().duplicate();
        assertArrayEquals(new int[] {3, 4}, editor.selection());
        editor.undo();
        assertArrayEquals(new int[] {1, 2}, editor.selection());
        editor.redo();
        assertArrayEquals(new int[] {3, 4}, editor.selection());
        editor.delete();
        assertArrayEquals(new int[] {}, editor.selection());
        editor.undo();
        assertArrayEquals(new int[] {3, 4}, editor.selection());
        editor.undo();
        // What was chosen since is kept.
        editor.select(2);
        editor.redo();
        assertArrayEquals(new int[] {2}, editor.selection());
        editor.undo();
        assertArrayEquals(new int[] {2}, editor.selection());
    }

    /** An entity is called by its shape alone, unless its name says more. */
    @Test
    void theListSaysNoNameTwice() {
        assertEquals("1  box", Titles.title(1, box("box")));
        assertEquals("1  box", Titles.title(1, box("")));
        assertEquals("1  crate, box", Titles.title(1, box("crate")));
    }

    /** Unit boxes with 0.1 m between: 1.1 m apart, then the next multiple of 0.25 m. */
    @Test
    void newThingsStandBesideWhatIsThereOrOnTop() {
        Xyz wanted = new Xyz(0, 0.5, 0);
        for (double x : new double[] {0, 1.25, -1.25, 2.5, -2.5, 3.75}) {
            Xyz free = FreePlace.near(box("box"), wanted, editor.scene().entities(), true, 0.25);
            assertEquals(new Xyz(x, 0.5, 0), free);
            editor.place(box("box").at(free, Turn.NONE));
        }
        Xyz deep = FreePlace.near(box("box"), wanted, editor.scene().entities(), false, 0);
        assertEquals(new Xyz(0, 0.5, 1.1), deep);
        // The floor is 40 m wide; a box that is half in it goes up, not to its edge.
        Xyz top = FreePlace.near(box("box"), new Xyz(9, 0, 9), editor.scene().entities(), true, 0);
        assertEquals(new Xyz(9, 0.5, 9), top);
    }

    @Test
    void playingGoesBackToWhatWasEdited() {
        editor.place(box("crate"));
        SceneFile edited = editor.scene();
        editor.play();
        assertSame(edited, shown);
        editor.delete();
        editor.place(box("late"));
        editor.undo();
        assertTrue(editor.isWrong(), "a scene that runs is not edited");
        assertSame(edited, editor.scene());
        editor.stop();
        assertSame(edited, shown);
        editor.close();
        editor.open();
        assertSame(edited, shown);
        assertEquals(List.of("rest", "rest", "play", "rest", "leave", "rest"), seen);
    }

    /** What the editor has no field for is in the file afterwards too. */
    @Test
    void nothingOfABodyIsLostByEditing() {
        PartSpec gate =
                new PartSpec(
                        new BoxShape(Xyz.ONE),
                        new Xyz(0, 1, 0),
                        Turn.about(Xyz.ONE, 25),
                        Material.ICE.withMix(Mix.MINIMUM, Mix.AVERAGE),
                        new Filter(4, 3, -2),
                        true,
                        new Xyz(1, 0, 0),
                        "gate");
        BodySpec all =
                new BodySpec(
                        List.of(gate, PartSpec.of(new SphereShape(0.5))),
                        new Filter(2, ~4L, 7),
                        new Xyz(1, 2, 2),
                        new Xyz(0.1, 0.2, -0.3),
                        new Xyz(0, -0.1, 0),
                        0.5,
                        0.1,
                        0.2,
                        9,
                        List.of(Lock.MOVE_X, Lock.TURN_Z),
                        false,
                        7.5);
        editor.place(box("all").withPhysics(all));
        editor.layers(List.of("ground", "crate"));
        editor.change("rename", e -> e.withName("other"));
        editor.change("move", e -> e.at(new Xyz(5, 6, 7), Turn.about(Xyz.ONE, 30)));
        editor.change("scale", e -> e.withScale(new Xyz(2, 2, 2)));
        editor.change("shape of", e -> e.withShape(new SphereShape(3)));
        editor.camera(editor.scene().camera());
        editor.group().duplicate();
        editor.files().save("all.json");
        assertFalse(editor.isWrong(), editor.message());
        SceneFile read = SceneReader.read(folder.resolve("all.json"));
        assertEquals(List.of("ground", "crate"), read.layers());
        BodySpec kept =
                all.withParts(List.of(gate.withShape(new SphereShape(3)), all.parts().get(1)));
        for (int i = 1; i <= 2; i++) {
            assertEquals("other", read.entities().get(i).name());
            assertEquals(kept, read.entities().get(i).physics());
        }
        editor.change("scale", e -> e.withScale(new Xyz(1, 2, 1)));
        assertTrue(editor.isWrong(), "a body of several shapes is scaled alike");
    }

    @Test
    void savedAndLoadedIsTheSame() {
        editor.place(box("crate").at(new Xyz(0.1, 1.0 / 3, -0.0), Turn.about(Xyz.ONE, 25)));
        SceneFile edited = editor.scene();
        editor.files().save("mine.json");
        assertFalse(editor.isWrong(), editor.message());
        assertFalse(editor.isChanged());
        assertEquals(edited, SceneReader.read(folder.resolve("mine.json")));
        editor.delete();
        assertTrue(editor.isChanged());
        editor.files().load("mine.json");
        assertTrue(editor.isWrong(), "unsaved changes");
        assertNotEquals(edited, editor.scene());
        editor.files().load("mine.json");
        assertFalse(editor.isWrong(), editor.message());
        assertEquals(edited, editor.scene());
    }

    @Test
    void anotherFileIsReplacedOnTheSecondCallOnly() throws IOException {
        Files.writeString(folder.resolve("theirs.json"), "precious");
        editor.files().save("theirs.json");
        assertTrue(editor.isWrong());
        assertEquals("precious", Files.readString(folder.resolve("theirs.json")));
        editor.files().save("theirs.json");
        assertFalse(editor.isWrong(), editor.message());
        assertEquals(editor.scene(), SceneReader.read(folder.resolve("theirs.json")));
    }

    @Test
    void whereASceneCannotBeWrittenIsToldAndNothingIsLeft() throws IOException {
        Files.createDirectory(folder.resolve("empty.json"));
        Files.createDirectories(folder.resolve("full.json/within"));
        refuses("empty.json", "it is a folder");
        refuses("full.json", "it is a folder");
        refuses("none/x.json", "there is no such folder");
        refuses("x".repeat(300) + ".json", "File name too long");
        refuses("nul\0.json", "Nul");
        if (Files.isDirectory(Path.of("/sys"))) {
            refuses("/sys/scene.json", "it may not be written there"); // by nobody
        }
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(2, left.count(), "the two folders");
        }
    }

    private void refuses(String name, String why) {
        editor.files().save(name);
        assertTrue(editor.isWrong(), name);
        assertTrue(editor.message().contains(why), editor.message());
    }

    @Test
    void mistakesAreTold() throws IOException {
        SceneFile before = editor.scene();
        Files.writeString(
                folder.resolve("broken.json"),
                "{\"format\": \"cairn-scene\", \"version\": 1,\n \"entities\": [{\"shape\": 3}]}");
        editor.files().load("broken.json");
        assertTrue(editor.isWrong());
        assertTrue(
                editor.message().contains("broken.json:2: $.entities[0].shape: expected"),
                editor.message());
        editor.files().load("absent.json");
        assertTrue(editor.message().contains("nothing there"), editor.message());
        editor.files().save("no-ending");
        assertTrue(editor.message().contains(".json"), editor.message());
        editor.files().save("no/such/folder/x.json");
        assertTrue(editor.message().contains("not saved"), editor.message());
        editor.placeMesh("absent.obj", Xyz.ZERO);
        assertTrue(editor.message().contains("absent.obj"), editor.message());
        editor.place(EntitySpec.of("ball", BodyKind.DYNAMIC, new SphereShape(1)));
        editor.change("scale", e -> e.withScale(new Xyz(1, 2, 1)));
        assertTrue(editor.message().contains("round shape"), editor.message());
        editor.undo();
        assertEquals(before, editor.scene());
    }

    @Test
    void aSceneSavedElsewhereFindsItsMeshes() throws IOException {
        Files.writeString(
                folder.resolve("tetra.obj"),
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        editor.placeMesh("tetra.obj", Xyz.ZERO);
        assertFalse(editor.isWrong(), editor.message());
        Files.createDirectory(folder.resolve("sub"));
        editor.files().save("sub/there.json");
        assertFalse(editor.isWrong(), editor.message());
        assertEquals(new MeshShape("../tetra.obj"), editor.scene().entities().get(1).shape());
    }

    /** The ray to where the point is wanted, from random eyes, finds the wanted place. */
    @Test
    void aDraggedPointStaysUnderTheCursor() {
        long seed = 9;
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 200; i++) {
            Xyz taken = new Xyz(random.nextDouble(-5, 5), random.nextDouble(0, 2), -3);
            Xyz from = new Xyz(1, 0.5, -2);
            Vector3d wanted =
                    new Vector3d(random.nextDouble(-20, 20), taken.y(), random.nextDouble(-20, 20));
            Vector3d eye = new Vector3d(random.nextDouble(-9, 9), random.nextDouble(3, 9), 14);
            Vector3d along = new Vector3d(wanted).sub(eye).normalize();
            Xyz to =
                    new GroundDrag(taken, from)
                            .to(
                                    new Xyz(eye.x, eye.y, eye.z),
                                    new Xyz(along.x, along.y, along.z),
                                    from,
                                    0);
            assertEquals(from.x() + wanted.x - taken.x(), to.x(), 1e-9, "seed " + seed);
            assertEquals(from.y(), to.y());
            assertEquals(from.z() + wanted.z - taken.z(), to.z(), 1e-9, "seed " + seed);
        }
        GroundDrag drag = new GroundDrag(Xyz.ZERO, Xyz.ZERO);
        Xyz now = new Xyz(3, 1, 4);
        assertSame(now, drag.to(new Xyz(0, 2, 0), new Xyz(0, 0.6, -0.8), now, 0), "to the sky");
        assertSame(now, drag.to(new Xyz(0, 2, 0), new Xyz(0, 0, -1), now, 0), "level");
        Xyz snapped = drag.to(new Xyz(0.3, 2, 0.9), new Xyz(0, -1, 0), now, 0.25);
        assertEquals(new Xyz(0.25, 1, 1), snapped);
    }

    @Test
    void theOutlineHoldsTheTurnedBox() {
        EntitySpec plank =
                EntitySpec.of("plank", BodyKind.DYNAMIC, new BoxShape(new Xyz(2, 0.1, 0.5)))
                        .at(new Xyz(10, 1, 0), Turn.about(new Xyz(0, 0, 1), 90))
                        .withScale(new Xyz(2, 1, 1));
        Vector3d[] corners = Sizes.of(plank).corners(plank.position(), plank.rotation());
        // Standing upright: 8 m high, 0.2 m wide.
        for (Vector3d corner : corners) {
            assertEquals(0.1, Math.abs(corner.x - 10), 1e-12);
            assertEquals(4, Math.abs(corner.y - 1), 1e-12);
            assertEquals(0.5, Math.abs(corner.z), 1e-12);
        }
    }

    @Test
    void numbersAreReadAndWritten() {
        assertEquals(-2.5, Fields.parse(" -2.5 "));
        assertEquals(null, Fields.parse("1e"));
        assertEquals(null, Fields.parse("NaN"));
        assertEquals(null, Fields.parse("1e999"));
        assertEquals(null, Fields.parse(""));
        assertEquals(null, Fields.parse("1\n2"));
        assertEquals(null, Fields.parse("9".repeat(100_000)), "beyond what a double holds");
        assertEquals(null, Fields.parse("-Infinity"));
        assertEquals(null, Fields.parse("1f"));
        assertEquals(null, Fields.parse("0x1p3"));
        assertEquals(null, Fields.parse("1.000,5"));
        assertEquals(null, Fields.parse("\u0661\u0662"), "Arabic digits");
        assertEquals(null, Fields.parse("\ud83d\ude00"));
        assertEquals(1.5, Fields.parse("1,5"));
        assertEquals(0.0, Fields.parse("-0"), "no sign");
        assertEquals(0.0, Fields.parse("1e-999"));
        assertEquals(0xC8553D, Fields.parseRgb("#c8553D"));
        assertEquals(null, Fields.parseRgb("#C8553"));
        assertEquals("0.333333", Fields.text(1.0 / 3));
        assertEquals("12", Fields.text(12));
        assertEquals("0.5", Fields.text(0.5));
        assertEquals("1.0E-7", Fields.text(1e-7));
    }

    @Test
    void aNameIsOneStepHoweverManyLettersItHas() {
        editor.place(box("crate"));
        int before = editor.history().steps();
        String name = "\u05e9\u05dc\u05d5\u05dd \ud83d\ude00 \u202e " + "x".repeat(100_000);
        for (int end = 1; end < 100; end++) {
            editor.rename(name.substring(0, end));
        }
        editor.rename(name);
        assertEquals(before + 1, editor.history().steps());
        editor.files().save("scene.json");
        editor.files().load("scene.json");
        assertFalse(editor.isWrong(), editor.message());
        assertEquals(name, editor.scene().entities().getLast().name(), "as it was typed");
    }

    @Test
    void undoAndRedoKeepWhatIsSelectedOrSelectWhatComesBack() {
        editor.place(box("first"));
        editor.place(box("second"));
        editor.place(box("third"));
        editor.select(2);
        editor.change("raise", e -> e.at(new Xyz(0, 2, 0), Turn.NONE));
        editor.undo();
        assertEquals("second", editor.selectedEntity().name());
        editor.redo();
        assertEquals("second", editor.selectedEntity().name());
        assertEquals(2, editor.selectedEntity().position().y());
        editor.select(1);
        editor.delete();
        editor.select(1);
        editor.undo();
        assertEquals("second", editor.selectedEntity().name(), "it has moved up by one");
        editor.select(Editor.NOTHING);
        editor.redo();
        assertEquals(Editor.NOTHING, editor.selected());
        editor.undo();
        assertEquals("first", editor.selectedEntity().name(), "it came back");
    }

    @Test
    void thingsStandOnTheHighestGroundUnderThem() {
        EntitySpec crate = box("crate");
        EntitySpec floor =
                EntitySpec.of("floor", BodyKind.FIXED, new BoxShape(new Xyz(20, 0.5, 20)))
                        .at(new Xyz(0, -3, 0), Turn.NONE);
        assertTrue(Ground.is(floor));
        assertFalse(Ground.is(crate));
        // The floor's upper side is at -3 + 0.5, the crate's half height 0.5.
        assertEquals(-2, Ground.under(crate, new Xyz(1, 9, 1), List.of(floor)).y(), 1e-6);
        // Beside the floor there is nothing but y = 0.
        assertEquals(0.5, Ground.under(crate, new Xyz(30, 9, 0), List.of(floor)).y(), 1e-6);
        // A half-space whose normal (-3, 4, 0)/5 is turned from y about z: at x = 0.5, the
        // crate's right edge, it is 0.75 * 0.5 high, and the crate's lower side is there.
        double half = Math.atan2(3, 4) / 2;
        EntitySpec slope =
                EntitySpec.of("slope", BodyKind.FIXED, new GroundShape())
                        .at(new Xyz(0, 0, 0), new Turn(0, 0, Math.sin(half), Math.cos(half)));
        assertEquals(0.375 + 0.5, Ground.under(crate, new Xyz(0, 0, 0), List.of(slope)).y(), 1e-6);
        // Looking down at 45 degrees from (0, 0, 10) meets the upper side of the floor, 2.5 m
        // below the eye, 2.5 m ahead.
        Vector3d along = new Vector3d(0, -1, -1).normalize();
        Xyz ahead = Ground.ahead(new Vector3d(0, 0, 10), along, List.of(floor, slope));
        assertEquals(7.5, ahead.z(), 1e-9);
    }
}
