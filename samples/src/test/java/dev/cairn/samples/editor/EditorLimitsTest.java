package dev.cairn.samples.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.camera.Camera;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;

/** What the editor does not take, and what it bears. */
class EditorLimitsTest {
    private final Editor editor = new Editor(new NoStage());

    @BeforeEach
    void open() {
        editor.open(Supply.emptyScene(), null, Path.of(""));
    }

    private static EntitySpec box(String name) {
        return EntitySpec.of(name, BodyKind.DYNAMIC, new BoxShape(new Xyz(0.5, 0.5, 0.5)));
    }

    /** What the reader would refuse is refused before it is saved. */
    @Test
    void whatNoFileCanHoldIsNotEdited() {
        MeshShape level = new MeshShape("level.obj", As.LEVEL, 4, 0.1);
        MeshShape parts = new MeshShape("level.obj", As.PARTS, 4, 0.1);
        editor.place(box("crate"));
        refused("a solid shape for a dynamic body", e -> e.withShape(level));
        refused("a file or one of", e -> e.withLook(e.look().withTexture("builtin:wood", 0)));
        editor.change("body of", e -> e.withBody(BodyKind.FIXED).withShape(level));
        assertFalse(editor.isWrong(), editor.message());
        refused("a solid shape for a dynamic body", e -> e.withBody(BodyKind.DYNAMIC));
        editor.change(
                "parts", e -> e.withPhysics(e.physics().withParts(List.of(PartSpec.of(level)))));
        refused("a collider of one shape", e -> e.withShape(parts));
        SceneFile scene = editor.scene();
        assertEquals(scene, SceneReader.parse("again", SceneWriter.text(scene)));
    }

    private void refused(String why, UnaryOperator<EntitySpec> change) {
        SceneFile before = editor.scene();
        editor.change("try", change);
        assertTrue(editor.isWrong() && editor.message().contains(why), editor.message());
        assertSame(before, editor.scene());
    }

    @Test
    void thingsAtTheEndOfNumbersAreOutlinedAndFramed() {
        double most = Double.MAX_VALUE;
        EntitySpec far = box("far").at(new Xyz(most, -most, 1), Turn.about(Xyz.ONE, 25));
        EntitySpec large = box("large").withScale(new Xyz(most, 1, 1e200));
        for (EntitySpec each : List.of(far, large)) {
            for (Vector3d corner : Sizes.of(each).corners(each.position(), each.rotation())) {
                assertTrue(corner.isFinite(), each + ": " + corner);
            }
            Camera camera = new Camera();
            Sizes.around(List.of(each)).frame(camera);
            assertTrue(camera.position(new Vector3d()).isFinite(), each.name());
        }
        EntitySpec floor = editor.scene().entities().get(0).at(new Xyz(0, most, 0), Turn.NONE);
        assertTrue(Ground.under(box("box"), Xyz.ZERO, List.of(floor)).y() > 1e9);
        editor.place(box("two\nlines"));
        editor.undo();
        assertEquals("undone: place two lines", editor.message());
    }
}
