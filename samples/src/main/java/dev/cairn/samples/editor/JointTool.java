package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.Xyz;

import java.util.List;

/** Begins a joint at the selected entity. Window thread. */
final class JointTool {
    static final List<String> AXES = List.of("along x", "along y", "along z");
    static final List<Xyz> DIRECTIONS =
            List.of(new Xyz(1, 0, 0), new Xyz(0, 1, 0), new Xyz(0, 0, 1));
    private final Editor editor;
    private int kind = JointSpec.KINDS.indexOf("hinge");
    private int axis = 2;

    JointTool(Editor editor) {
        this.editor = editor;
    }

    void draw(Ui ui) {
        if (!ui.section("New joint", false)) {
            return;
        }
        kind = ui.choice("kind of joint", JointSpec.KINDS, kind);
        axis = ui.choice("its axis", AXES, axis);
        ui.columns(2);
        boolean toBody = ui.button("To a body...");
        boolean toWorld = ui.button("To the world...");
        if (toBody || toWorld) {
            editor.joints().begin(JointSpec.KINDS.get(kind), DIRECTIONS.get(axis), toWorld);
        }
        ui.endSection();
    }
}
