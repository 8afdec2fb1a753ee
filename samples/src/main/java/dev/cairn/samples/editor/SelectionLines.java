package dev.cairn.samples.editor;

import dev.cairn.render.app.View;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * What is selected, drawn over the scene: the box around an entity; a joint's points, its axis, and
 * the way to its two bodies. Window thread; makes no garbage while the same is selected.
 */
@SuppressWarnings("ReferenceEquality") // a changed entity is another object
final class SelectionLines {
    private static final int CHOSEN = 0xFFE082;
    private static final int ALSO = 0xE0A458;

    /** Half the length of the line for a joint's axis, m. */
    private static final double AXIS = 0.4;

    /** The edges of a box, as pairs of corners; see {@link Sizes#corners}. */
    private static final int[] EDGES = {
        0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7
    };

    /** Whose boxes are drawn, and their corners. */
    private @Nullable EntitySpec[] known = new EntitySpec[4];

    private Vector3d[][] corners = new Vector3d[4][];

    void draw(View view, Editor editor) {
        int[] chosen = editor.selection();
        if (known.length < chosen.length) {
            known = Arrays.copyOf(known, 2 * chosen.length);
            corners = Arrays.copyOf(corners, 2 * chosen.length);
        }
        for (int i = 0; i < chosen.length; i++) {
            outline(view, i, editor.scene().entities().get(chosen[i]), i == chosen.length - 1);
        }
        JointSpec joint = editor.joints().selectedJoint();
        if (joint != null) {
            joint(
                    view,
                    joint,
                    editor.scene().entities().get(joint.a()).position(),
                    editor.scene().entities().get(joint.b()).position());
        }
    }

    private void outline(View view, int place, EntitySpec chosen, boolean isLast) {
        if (chosen != known[place]) {
            known[place] = chosen;
            corners[place] = Sizes.of(chosen).corners(chosen.position(), chosen.rotation());
        }
        Vector3d[] c = corners[place];
        for (int i = 0; i < EDGES.length; i += 2) {
            Vector3d a = c[EDGES[i]];
            Vector3d b = c[EDGES[i + 1]];
            view.line(a.x, a.y, a.z, b.x, b.y, b.z, isLast ? CHOSEN : ALSO, 1.5);
        }
    }

    private static void joint(View view, JointSpec joint, Xyz bodyA, Xyz bodyB) {
        Xyz a = joint.place().anchorA();
        Xyz b = joint.place().anchorB();
        a = a == null ? bodyA : a;
        b = b == null ? bodyB : b;
        line(view, bodyA, a, 2);
        line(view, a, b, 2);
        line(view, b, bodyB, 2);
        line(view, a, a, 9);
        line(view, b, b, 9);
        Xyz d = joint.place().axis();
        double length = Math.sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
        double s = AXIS / Math.max(length, 1e-9);
        view.line(
                a.x() - s * d.x(),
                a.y() - s * d.y(),
                a.z() - s * d.z(),
                a.x() + s * d.x(),
                a.y() + s * d.y(),
                a.z() + s * d.z(),
                CHOSEN,
                3);
    }

    private static void line(View view, Xyz a, Xyz b, double width) {
        view.line(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), CHOSEN, width);
    }
}
