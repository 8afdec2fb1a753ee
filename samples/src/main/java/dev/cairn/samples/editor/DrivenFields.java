package dev.cairn.samples.editor;

import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Controllable;
import dev.cairn.render.input.Key;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.EntitySpec.Driven;

import org.jspecify.annotations.Nullable;

import java.util.List;

/** Who drives an entity: keys with their strengths, and the camera that rides on it. */
final class DrivenFields {
    private static final List<String> NAMES =
            List.of("nobody", "arrow keys", "I J K L", "W A S D", "keys of its own");
    private static final int NOBODY = 0;
    private static final int OWN = 4;
    private static final Key[][] SETS = {
        {},
        {Key.UP, Key.DOWN, Key.LEFT, Key.RIGHT, Key.RIGHT_CONTROL},
        {Key.I, Key.K, Key.J, Key.L, Key.U},
        {Key.W, Key.S, Key.A, Key.D, Key.E}
    };
    private static final double PUSH = 12;
    private static final double JUMP = 5;

    private final Editor editor;

    /** The controls that were shown last, which set they are, and what is written of them. */
    private List<Control> known = List.of();

    private int knownSet = NOBODY;
    private String[] triggers = {};
    private String[] effects = {};

    DrivenFields(Editor editor) {
        this.editor = editor;
    }

    @SuppressWarnings("ReferenceEquality") // each change makes another list
    void draw(Ui ui, EntitySpec entity) {
        ui.heading("Driven by");
        List<Control> controls = entity.driven().controls();
        if (controls != known) {
            learn(controls);
        }
        int present = knownSet;
        int chosen = ui.choice("keys", NAMES, present);
        if (chosen != present && chosen != OWN) {
            change(make(chosen, PUSH, JUMP), entity.driven().camera());
            return;
        }
        if (present != NOBODY && present != OWN) {
            double push = -controls.get(0).z();
            double jump = controls.get(4).y();
            double newPush = ui.slider("push", push, 0, 60, 1, "acceleration, m/s²");
            double newJump = ui.slider("jump", jump, 0, 20, 0.5, "by the last key, m/s");
            if (newPush != push || newJump != jump) {
                change(make(present, newPush, newJump), entity.driven().camera());
                return;
            }
        } else if (present == OWN) {
            for (int i = 0; i < triggers.length; i++) {
                ui.value(triggers[i], effects[i]);
            }
        }
        CameraMount camera = entity.driven().camera();
        boolean rides = ui.checkbox("the camera rides on it", camera != null);
        if (rides != (camera != null)) {
            change(controls, rides ? new CameraMount(0, 2, 6, true) : null);
        }
    }

    private void learn(List<Control> controls) {
        known = controls;
        knownSet = set(controls);
        triggers = controls.stream().map(Control::trigger).toArray(String[]::new);
        effects = controls.stream().map(c -> c.effect().word()).toArray(String[]::new);
    }

    private void change(List<Control> controls, @Nullable CameraMount camera) {
        Driven driven = new Driven(controls, camera);
        editor.change("driver of", e -> e.withDriven(driven));
    }

    static List<Control> make(int set, double push, double jump) {
        if (set == NOBODY) {
            return List.of();
        }
        Key[] k = SETS[set];
        return Controllable.of(k[0], k[1], k[2], k[3], k[4], push, jump).controls();
    }

    /** Which of the sets these are, whatever their strengths. */
    static int set(List<Control> controls) {
        if (controls.isEmpty()) {
            return NOBODY;
        }
        for (int set = 1; set < SETS.length; set++) {
            if (controls.size() == 5
                    && controls.equals(make(set, -controls.get(0).z(), controls.get(4).y()))) {
                return set;
            }
        }
        return OWN;
    }
}
