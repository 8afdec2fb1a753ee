package dev.cairn.samples.scenefile.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Material;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Going back and forth among edits gives the values that were there, bit for bit. */
class SceneHistoryTest {
    private static Xyz xyz(SplittableRandom random) {
        return new Xyz(
                random.nextInt(4) == 0 ? -0.0 : random.nextDouble(-1e3, 1e3),
                random.nextDouble(-1, 1),
                Math.scalb(random.nextDouble(), random.nextInt(-60, 60)));
    }

    private static EntitySpec entity(SplittableRandom random, int number) {
        ShapeSpec shape =
                switch (random.nextInt(4)) {
                    case 0 -> new SphereShape(random.nextDouble(0.1, 3));
                    case 1 -> new TurnedShape("cylinder", random.nextDouble(0.1, 3), 0.5);
                    case 2 -> new MeshShape("thing.obj");
                    default -> new BoxShape(new Xyz(1, random.nextDouble(0.1, 3), 2));
                };
        return EntitySpec.of("thing " + number, BodyKind.values()[random.nextInt(3)], shape)
                .at(xyz(random), Turn.about(new Xyz(1, 2, 3), random.nextDouble(-180, 180)));
    }

    /** An edit that changes the scene, whatever is in it. */
    private static SceneFile anyEdit(SceneFile scene, SplittableRandom random, int number) {
        int n = scene.entities().size();
        if (n == 0 || random.nextInt(5) == 0) {
            return SceneEdit.add(scene, entity(random, number));
        }
        int i = random.nextInt(n);
        return switch (random.nextInt(9)) {
            case 0 -> SceneEdit.delete(scene, i);
            case 1 -> SceneEdit.duplicate(scene, i, xyz(random));
            case 2 -> SceneEdit.move(scene, i, xyz(random));
            case 3 ->
                    SceneEdit.turn(
                            scene, i, Turn.about(new Xyz(0, 1, 0.5), random.nextDouble(180)));
            case 4 -> {
                double s = random.nextDouble(0.1, 4);
                yield SceneEdit.change(scene, i, e -> e.withScale(new Xyz(s, s, s)));
            }
            case 5 -> {
                Material other = Material.DEFAULT.withFriction(random.nextDouble());
                Double mass = random.nextBoolean() ? (Double) random.nextDouble(1, 9) : null;
                yield SceneEdit.change(scene, i, e -> e.withMaterial(other, mass));
            }
            case 6 -> {
                Xyz v = xyz(random);
                yield SceneEdit.change(scene, i, e -> e.moving(v, Xyz.ONE));
            }
            case 7 -> {
                int rgb = random.nextInt(1 << 24);
                yield SceneEdit.change(scene, i, e -> e.withLook(e.look().withRgb(rgb)));
            }
            default -> SceneEdit.change(scene, i, e -> e.withName("renamed " + number));
        };
    }

    /** Against a list of all values with a finger on one of them. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 20_261_121, 77})
    void undoAndRedoGiveTheValuesBack(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        SceneHistory history = new SceneHistory(SceneFile.empty("start"));
        List<SceneFile> values = new ArrayList<>(List.of(history.current()));
        List<String> texts = new ArrayList<>(List.of(SceneWriter.text(history.current())));
        int at = 0;
        for (int step = 0; step < 400; step++) {
            int what = random.nextInt(10);
            if (what < 5) {
                SceneFile next = anyEdit(history.current(), random, step);
                if (history.edit("step " + step, next, false)) {
                    values.subList(at + 1, values.size()).clear();
                    texts.subList(at + 1, texts.size()).clear();
                    values.add(next);
                    texts.add(SceneWriter.text(next));
                    at++;
                }
            } else if (what < 8) {
                assertEquals(at > 0, history.undo() != null);
                at = Math.max(0, at - 1);
            } else {
                assertEquals(at < values.size() - 1, history.redo() != null);
                at = Math.min(values.size() - 1, at + 1);
            }
            assertEquals(values.get(at), history.current(), "seed " + seed + ", step " + step);
            assertEquals(texts.get(at), SceneWriter.text(history.current()));
            assertEquals(at, history.steps());
        }
        assertTrue(at > 20, "the walk went somewhere");
    }

    @Test
    void editsOfOneKindAreOneStepUntilSealed() {
        SceneFile start =
                SceneEdit.add(SceneFile.empty("drag"), entity(new SplittableRandom(4), 0));
        SceneHistory history = new SceneHistory(start);
        for (int x = 1; x <= 5; x++) {
            history.edit("drag", SceneEdit.move(start, 0, new Xyz(x, 0, 0)), true);
        }
        SceneFile dragged = history.current();
        assertEquals(1, history.steps());
        history.seal();
        history.edit("drag", SceneEdit.move(start, 0, new Xyz(9, 0, 0)), true);
        history.edit("raise", SceneEdit.move(start, 0, new Xyz(9, 1, 0)), true);
        assertEquals(3, history.steps());
        assertEquals("raise", history.undo());
        assertEquals("drag", history.undo());
        assertEquals(dragged, history.current());
        assertEquals("drag", history.undo());
        assertEquals(start, history.current());
        assertNull(history.undo());
        assertEquals("drag", history.redoLabel());
    }

    @Test
    void whatChangesNothingIsNoStep() {
        SceneFile start =
                SceneEdit.add(SceneFile.empty("same"), entity(new SplittableRandom(5), 0));
        SceneHistory history = new SceneHistory(start);
        Xyz place = start.entities().get(0).position();
        assertFalse(history.edit("move", SceneEdit.move(start, 0, place), false));
        assertNull(history.undoLabel());
        // -0 is another value than 0.
        history.edit("to zero", SceneEdit.move(start, 0, Xyz.ZERO), false);
        assertTrue(history.edit("sign", SceneEdit.move(start, 0, new Xyz(-0.0, 0, 0)), false));
    }

    @Test
    void theOldestStepsAreForgottenFirst() {
        SceneHistory steps = new SceneHistory(SceneFile.empty("many"), 3, Long.MAX_VALUE);
        SplittableRandom random = new SplittableRandom(6);
        List<SceneFile> values = new ArrayList<>(List.of(steps.current()));
        for (int i = 0; i < 10; i++) {
            steps.edit("add " + i, SceneEdit.add(steps.current(), entity(random, i)), false);
            values.add(steps.current());
        }
        assertEquals(3, steps.steps());
        while (steps.undo() != null) {}
        assertEquals(values.get(7), steps.current());

        // Scenes of 0, 1, 2, 3, ... entities: the last two steps weigh 8 + 9 = 17 of at most 20.
        SceneHistory weight = new SceneHistory(values.get(0), 100, 20);
        for (int i = 1; i <= 10; i++) {
            weight.edit("add " + i, values.get(i), false);
        }
        assertEquals(2, weight.steps());
    }

    @Test
    void whatCannotBeBuiltIsRefusedAndNothingChanges() {
        SceneFile scene =
                SceneEdit.add(
                        SceneFile.empty("ball"),
                        EntitySpec.of("ball", BodyKind.DYNAMIC, new SphereShape(1)));
        IllegalArgumentException squashed =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> SceneEdit.change(scene, 0, e -> e.withScale(new Xyz(1, 2, 1))));
        assertTrue(squashed.getMessage().contains("round shape"), squashed.getMessage());
        assertThrows(
                IllegalArgumentException.class,
                () ->
                        SceneEdit.add(
                                scene,
                                EntitySpec.of("flat", BodyKind.FIXED, new BoxShape(Xyz.ZERO))));
        assertEquals(1, scene.entities().size());
    }

    @Test
    void pathsFollowTheFileToAnotherFolder() {
        EntitySpec mesh =
                EntitySpec.of("rock", BodyKind.DYNAMIC, new MeshShape("models/rock.obj"))
                        .withLook(LookSpec.DEFAULT.withTexture("../sand.png", 0));
        EntitySpec plain =
                EntitySpec.of("box", BodyKind.DYNAMIC, new BoxShape(Xyz.ONE))
                        .withLook(LookSpec.DEFAULT.withTexture("builtin:grid", 1));
        SceneFile scene = SceneFile.empty("two").withEntities(List.of(mesh, plain));
        Path home = Path.of("scenes/a").toAbsolutePath();
        SceneFile moved = SceneEdit.rebase(scene, home, home.resolve("../b"));
        assertEquals(new MeshShape("../a/models/rock.obj"), moved.entities().get(0).shape());
        assertEquals("../sand.png", moved.entities().get(0).look().texture());
        assertEquals(plain, moved.entities().get(1));
        assertEquals(scene, SceneEdit.rebase(moved, home.resolve("../b"), home));
    }
}
