package dev.cairn.samples.editor;

import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** The panel with the selected joint: every property as a field. Window thread. */
@SuppressWarnings("ReferenceEquality") // what nobody typed into is the same object
final class JointPanel {
    private static final String[] PARAMETERS = {
        "over a, x", "over a, y", "over a, z", "over b, x", "over b, y", "over b, z", "ratio"
    };
    private static final String[] TEETH = {"teeth of a", "teeth of b"};
    private static final JointAxis[] AXES = JointAxis.values();
    private static final int ROWS_BELOW = 6;
    private static final int MOST_POINTS = 24;
    private static final String[] POINTS = new String[3 * MOST_POINTS];

    static {
        for (int i = 0; i < POINTS.length; i++) {
            POINTS[i] = "p" + i / 3 + " " + "xyz".charAt(i % 3);
        }
    }

    private final Editor editor;
    private final Fields fields = new Fields();
    private final AxisFields axisFields = new AxisFields(fields);
    private int shown = Editor.NOTHING;

    /** The joint that was shown last, what it does about axes, and who it holds. */
    private @Nullable JointSpec known;

    private AxisState[] states = {};
    private String nameA = "";
    private String nameB = "";

    JointPanel(Editor editor) {
        this.editor = editor;
    }

    private void change(String what, UnaryOperator<JointSpec> change) {
        editor.joints().change(what, change);
    }

    void draw(Ui ui, double left, double top, double width, double height) {
        if (editor.joints().selected() != shown) {
            shown = editor.joints().selected();
            fields.forget();
        }
        JointSpec joint = editor.joints().selectedJoint();
        if (joint == null) {
            return;
        }
        if (joint != known) {
            learn(joint);
        }
        if (ui.panel("Joint", left, top, width, height)) {
            ui.columns(2);
            if (ui.button("Move its point...")) {
                editor.joints().beginPoint();
            }
            boolean deletes = ui.button("Delete (Del)");
            if (!identity(ui, joint) && !axes(ui) && !sizes(ui, joint) && !load(ui, joint)) {
                place(ui, joint);
            }
            if (deletes) {
                editor.joints().delete();
            }
            for (int i = 0; i < ROWS_BELOW; i++) {
                ui.label("");
            }
        }
        ui.endPanel();
    }

    private void learn(JointSpec joint) {
        known = joint;
        states = new AxisState[AXES.length];
        for (int i = 0; i < AXES.length; i++) {
            states[i] = joint.settings(AXES[i]);
        }
        nameA = Titles.name(editor.scene(), joint.a());
        nameB = Titles.name(editor.scene(), joint.b());
    }

    // Each says whether it has changed the joint: the rest of the frame would show an old one.

    private boolean identity(Ui ui, JointSpec joint) {
        String name = ui.textField("name", joint.name());
        if (!name.equals(joint.name())) {
            change("name of", j -> j.withName(name));
            return true;
        }
        int present = JointSpec.KINDS.indexOf(joint.kind());
        int kind = ui.choice("kind", JointSpec.KINDS, present);
        if (kind != present) {
            editor.joints().changeKind(JointSpec.KINDS.get(kind));
            return true;
        }
        ui.value("a", nameA);
        ui.value("b", nameB);
        boolean acts = ui.checkbox("acts", joint.isOn());
        boolean together = ui.checkbox("a and b collide", joint.collides());
        if (acts != joint.isOn() || together != joint.collides()) {
            double force = joint.breakForce();
            double torque = joint.breakTorque();
            change("use of", j -> j.bearing(force, torque, acts, together));
            return true;
        }
        return false;
    }

    private void place(Ui ui, JointSpec joint) {
        ui.heading("Place");
        JointSpec.Place old = joint.place();
        Xyz a = old.anchorA();
        Xyz b = old.anchorB();
        Xyz newA = a;
        Xyz newB = b;
        if (a != null && b != null) {
            if (a.equals(b)) {
                newA = fields.xyz(ui, "point", a);
                newB = newA == a ? b : newA;
            } else {
                newA = fields.xyz(ui, "point of a", a);
                newB = fields.xyz(ui, "point of b", b);
            }
        }
        Xyz axis = fields.xyz(ui, "axis", old.axis());
        int chosen =
                ui.choice("turn it", EntityPanel.AXES, EntityPanel.DIRECTIONS.indexOf(old.axis()));
        if (chosen >= 0 && axis == old.axis()) {
            Xyz direction = EntityPanel.DIRECTIONS.get(chosen);
            axis = direction.equals(axis) ? axis : direction;
        }
        Xyz second = old.secondAxis();
        boolean own = ui.checkbox("a second axis", second != null);
        Xyz newSecond = second;
        if (own != (second != null)) {
            newSecond = own ? across(old.axis()) : null;
        } else if (second != null) {
            newSecond = fields.xyz(ui, "second", second);
        }
        if (newA == a && newB == b && axis == old.axis() && newSecond == second) {
            return;
        }
        JointSpec.Place wanted = new JointSpec.Place(newA, newB, axis, newSecond);
        change("place of", j -> j.withPlace(wanted));
    }

    /** A direction that is not along another one. */
    private static Xyz across(Xyz axis) {
        boolean isUpright = Math.abs(axis.y()) > Math.max(Math.abs(axis.x()), Math.abs(axis.z()));
        return isUpright ? new Xyz(1, 0, 0) : new Xyz(0, 1, 0);
    }

    private boolean sizes(Ui ui, JointSpec joint) {
        if (joint.kind().equals("path")) {
            return path(ui, joint);
        }
        List<Double> numbers = joint.parameters();
        String[] names = joint.kind().equals("gear") ? TEETH : PARAMETERS;
        for (int i = 0; i < Math.min(numbers.size(), names.length); i++) {
            double old = numbers.get(i);
            double typed = fields.number(ui, names[i], old);
            if (typed != old) {
                List<Double> wanted = new ArrayList<>(numbers);
                wanted.set(i, typed);
                change("numbers of", j -> j.measuring(wanted, j.length()));
                return true;
            }
        }
        boolean isLong =
                joint.kind().equals("rod")
                        || joint.kind().equals("rope")
                        || joint.kind().equals("spring");
        if (isLong) {
            double length = fields.number(ui, "length, m", joint.length());
            if (length != joint.length() && length >= 0) {
                change("length of", j -> j.measuring(j.parameters(), length));
                return true;
            }
        }
        return false;
    }

    /** The points of a path, one by one; more than {@link #MOST_POINTS} have no fields. */
    private boolean path(Ui ui, JointSpec joint) {
        List<Double> numbers = joint.parameters();
        List<Double> wanted = new ArrayList<>();
        boolean isClosed = numbers.get(0) != 0;
        boolean closes = ui.checkbox("closed", isClosed);
        ui.columns(2);
        boolean adds = ui.button("Add a point");
        boolean removes = ui.button("Remove the last point");
        int last = numbers.size() - 3;
        if (closes != isClosed) {
            wanted.addAll(numbers);
            wanted.set(0, closes ? 1.0 : 0.0);
        } else if (adds) {
            wanted.addAll(numbers);
            wanted.addAll(List.of(numbers.get(last) + 1, numbers.get(last + 1)));
            wanted.add(numbers.get(last + 2));
        } else if (removes) {
            wanted.addAll(numbers.subList(0, last));
        }
        for (int i = 1; i < Math.min(numbers.size(), 3 * MOST_POINTS) && wanted.isEmpty(); i++) {
            double typed = fields.number(ui, POINTS[i - 1], numbers.get(i));
            if (typed != numbers.get(i)) {
                wanted.addAll(numbers);
                wanted.set(i, typed);
            }
        }
        if (wanted.isEmpty()) {
            return false;
        }
        change("points of", j -> j.measuring(wanted, 0));
        return true;
    }

    private boolean load(Ui ui, JointSpec joint) {
        ui.heading("Breaks at (0: never)");
        double force = AxisFields.most(ui, fields, "force, N", joint.breakForce());
        double torque = AxisFields.most(ui, fields, "torque, N m", joint.breakTorque());
        if (force != joint.breakForce() || torque != joint.breakTorque()) {
            change("strength of", j -> j.bearing(force, torque, j.isOn(), j.collides()));
            return true;
        }
        return false;
    }

    private boolean axes(Ui ui) {
        ui.heading("Limits, motors, springs");
        for (int i = 0; i < AXES.length; i++) {
            AxisState old = states[i];
            if (!ui.section(AxisFields.TITLES[i], false)) {
                continue;
            }
            AxisState wanted = axisFields.draw(ui, i, old);
            ui.endSection();
            if (wanted != old) {
                JointAxis axis = AXES[i];
                change(AxisFields.TITLES[i] + " of", j -> j.withAxis(axis, wanted));
                return true;
            }
        }
        return false;
    }
}
