package dev.cairn.samples.editor.gizmo;

import dev.cairn.render.app.View;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.GroupEdit;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Three arrows, circles or bars at what is selected. Arrows and circles lie along the axes of the
 * world; bars along those of the entity, and scale all alike where several are selected. World
 * frame, metres. Steady frames make no garbage. Window thread.
 */
public final class Gizmo {
    /** What the handles do. */
    public enum Mode {
        /** Arrows. */
        MOVE,
        /** Circles. */
        TURN,
        /** Bars, and a dot in the middle for all axes at once. */
        SCALE
    }

    private static final int NONE = -1;
    private static final int ALL = 3;

    /** Length of a handle, by half the picture's height. */
    private static final double LENGTH = 0.3;

    /** Nearer to the middle than this share of a handle the thing itself is meant. */
    private static final double INNER = 0.35;

    /** How near the cursor has to be, in picture's heights. */
    private static final double REACH = 0.014;

    /** A handle that points at the camera, shorter than this in the picture, cannot be taken. */
    private static final double SHORTEST = 0.05;

    /** A circle seen so flatly cannot be taken: sine of the angle to its plane. */
    private static final double EDGE_ON = 0.05;

    private static final double TURN_STEP = Math.toRadians(15);
    private static final double SCALE_STEP = 0.1;
    private static final double LEAST_FACTOR = 0.05;
    private static final int SEGMENTS = 48;
    private static final int[] COLOURS = {0xE5534B, 0x7CC36A, 0x539BF5, 0xD0D7DE};
    private static final int HOVERED = 0xFFE082;
    private static final double[] COS = new double[SEGMENTS + 1];
    private static final double[] SIN = new double[SEGMENTS + 1];

    static {
        for (int i = 0; i <= SEGMENTS; i++) {
            COS[i] = Math.cos(2 * Math.PI * i / SEGMENTS);
            SIN[i] = Math.sin(2 * Math.PI * i / SEGMENTS);
        }
    }

    private final Screen screen = new Screen();
    private final Vector3d centre = new Vector3d();
    private final Vector3d[] axes = {new Vector3d(), new Vector3d(), new Vector3d()};
    private final Vector3d arm = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private Mode mode = Mode.MOVE;
    private double length;

    /** The handle under the cursor, or the one that is held. */
    private int handle = NONE;

    private @Nullable SceneFile start;
    private final Vector3d heldCentre = new Vector3d();

    /** Where the entity chosen last was: what the grid is for. */
    private final Vector3d heldPlace = new Vector3d();

    private double taken;

    /** Arrows, nothing held. */
    public Gizmo() {}

    /**
     * What the handles do.
     *
     * @return the mode
     */
    public Mode mode() {
        return mode;
    }

    /**
     * Chooses what the handles do.
     *
     * @param value the mode
     */
    public void mode(Mode value) {
        mode = value;
        release();
    }

    /**
     * Whether a handle is held.
     *
     * @return true from {@link #take} until {@link #release}
     */
    public boolean isHeld() {
        return start != null;
    }

    /** Lets go. */
    public void release() {
        start = null;
        handle = NONE;
    }

    /**
     * Finds the handle under the cursor; once a frame, before {@link #take}.
     *
     * @param view what the frame shows
     * @param editor what is selected
     * @return true if there are handles
     */
    public boolean aim(View view, Editor editor) {
        screen.look(view);
        if (!place(editor)) {
            release();
            return false;
        }
        if (!isHeld()) {
            handle = view.pointer().isOverPanel() ? NONE : underCursor();
        }
        return true;
    }

    /**
     * Takes the handle under the cursor.
     *
     * @param editor whose scene it changes
     * @return false if there is none
     */
    public boolean take(Editor editor) {
        if (handle == NONE) {
            return false;
        }
        heldCentre.set(centre);
        double now = measure(handle);
        if (Double.isNaN(now)) {
            return false;
        }
        taken = now;
        start = editor.scene();
        EntitySpec last = editor.selectedEntity();
        if (last != null) {
            heldPlace.set(last.position().x(), last.position().y(), last.position().z());
        }
        return true;
    }

    /**
     * Moves what is held to where the cursor is.
     *
     * @param editor whose scene it changes
     * @param grid places are multiples of this, angles of 15 degrees, factors of 0.1; 0 = any
     */
    public void drag(Editor editor, double grid) {
        SceneFile from = start;
        double now = measure(handle);
        if (from == null || Double.isNaN(now)) {
            return;
        }
        int axis = handle;
        Xyz pivot = new Xyz(heldCentre.x, heldCentre.y, heldCentre.z);
        switch (mode) {
            case MOVE -> {
                double place = heldPlace.get(axis);
                double to = place + now - taken;
                double by = (grid > 0 ? Math.rint(to / grid) * grid : to) - place;
                Xyz shift = along(axis, by, 0);
                editor.group().changeAll("move", (s, which) -> GroupEdit.move(from, which, shift));
            }
            case TURN -> {
                double angle = now - taken;
                angle = grid > 0 ? Math.rint(angle / TURN_STEP) * TURN_STEP : angle;
                Turn by = Turn.about(along(axis, 1, 0), Math.toDegrees(angle));
                editor.group()
                        .changeAll("turn", (s, which) -> GroupEdit.turn(from, which, pivot, by));
            }
            case SCALE -> {
                double factor = now / taken;
                factor = grid > 0 ? Math.rint(factor / SCALE_STEP) * SCALE_STEP : factor;
                factor = Math.max(LEAST_FACTOR, factor);
                boolean all = axis == ALL || editor.selection().length > 1;
                Xyz by = all ? new Xyz(factor, factor, factor) : along(axis, factor, 1);
                editor.group()
                        .changeAll("scale", (s, which) -> GroupEdit.scale(from, which, pivot, by));
            }
        }
    }

    private static Xyz along(int axis, double value, double other) {
        return new Xyz(
                axis == 0 ? value : other, axis == 1 ? value : other, axis == 2 ? value : other);
    }

    /** Middle of what is selected, and the axes of the handles; false without anything. */
    private boolean place(Editor editor) {
        EntitySpec last = editor.selectedEntity();
        if (last == null) {
            return false;
        }
        editor.group().middle(centre);
        turn.identity();
        if (mode == Mode.SCALE && editor.selection().length == 1) {
            Turn t = last.rotation();
            turn.set(t.x(), t.y(), t.z(), t.w()).normalize();
        }
        for (int i = 0; i < 3; i++) {
            turn.transform(axes[i].zero().setComponent(i, 1));
        }
        length = LENGTH * screen.halfHeight(centre);
        return length > 0;
    }

    /**
     * Where in the picture a handle can be taken, for tests and guided tours; after {@link #aim}.
     *
     * @param axis 0, 1, 2: of x, y, z
     * @param dest gets the place, as shares of width and height from the upper left corner
     * @return false if it is not in front of the camera
     */
    public boolean handleAt(int axis, double[] dest) {
        if (mode == Mode.TURN) {
            onCircle(axis, SEGMENTS / 8);
        } else {
            arm.set(centre).fma(0.9 * length, axes[axis]);
        }
        boolean seen = screen.project(arm.x, arm.y, arm.z);
        dest[0] = screen.x / screen.aspect();
        dest[1] = screen.y;
        return seen;
    }

    // Under the cursor -------------------------------------------------------------------------

    private int underCursor() {
        int nearest = NONE;
        double least = REACH;
        for (int i = 0; i < 3; i++) {
            double distance = mode == Mode.TURN ? fromCircle(i) : fromBar(i);
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        if (mode == Mode.SCALE && screen.project(centre.x, centre.y, centre.z)) {
            double x = screen.x - screen.cursorX;
            double y = screen.y - screen.cursorY;
            nearest = Math.hypot(x, y) < REACH ? ALL : nearest;
        }
        return nearest;
    }

    private double fromBar(int axis) {
        Vector3d a = axes[axis];
        double s = INNER * length;
        if (!screen.project(centre.x + s * a.x, centre.y + s * a.y, centre.z + s * a.z)) {
            return REACH;
        }
        double x = screen.x;
        double y = screen.y;
        s = length;
        boolean seen = screen.project(centre.x + s * a.x, centre.y + s * a.y, centre.z + s * a.z);
        boolean isShort = Math.hypot(screen.x - x, screen.y - y) < SHORTEST;
        return seen && !isShort ? screen.fromCursor(x, y, screen.x, screen.y) : REACH;
    }

    private double fromCircle(int axis) {
        double least = REACH;
        if (Math.abs(axes[axis].dot(screen.ray)) < EDGE_ON) {
            return least;
        }
        double x = 0;
        double y = 0;
        boolean before = false;
        for (int i = 0; i <= SEGMENTS; i++) {
            onCircle(axis, i);
            boolean seen = screen.project(arm.x, arm.y, arm.z);
            if (seen && before) {
                least = Math.min(least, screen.fromCursor(x, y, screen.x, screen.y));
            }
            before = seen;
            x = screen.x;
            y = screen.y;
        }
        return least;
    }

    private void onCircle(int axis, int i) {
        arm.set(centre)
                .fma(length * COS[i], axes[(axis + 1) % 3])
                .fma(length * SIN[i], axes[(axis + 2) % 3]);
    }

    /** How far along its way the cursor holds a handle: metres, radians; NaN where nowhere. */
    private double measure(int which) {
        if (which == ALL) {
            return screen.project(heldCentre.x, heldCentre.y, heldCentre.z)
                    ? 1 + 4 * (screen.cursorX - screen.x) + 4 * (screen.y - screen.cursorY)
                    : Double.NaN;
        }
        Vector3d a = axes[which];
        Vector3d d = screen.ray;
        double slant = a.dot(d);
        arm.set(heldCentre).sub(screen.eye);
        if (mode == Mode.TURN) {
            if (Math.abs(slant) < EDGE_ON) {
                return Double.NaN;
            }
            // The point of the ray in the circle's plane, seen from the middle.
            double t = arm.dot(a) / slant;
            arm.negate().fma(t, d);
            return Math.atan2(arm.dot(axes[(which + 2) % 3]), arm.dot(axes[(which + 1) % 3]));
        }
        // The point of the axis nearest to the ray.
        double across = 1 - slant * slant;
        return across < 0.005 ? Double.NaN : (slant * arm.dot(d) - arm.dot(a)) / across;
    }

    // Drawing ----------------------------------------------------------------------------------

    /**
     * Draws the handles over everything; after {@link #aim} said that there are some.
     *
     * @param view what the frame shows
     */
    public void draw(View view) {
        for (int i = 0; i < 3; i++) {
            int rgb = handle == i || handle == ALL ? HOVERED : COLOURS[i];
            double width = handle == i ? 3.5 : 2.5;
            if (mode == Mode.TURN) {
                circle(view, i, rgb, width);
            } else {
                bar(view, i, rgb, width);
            }
        }
        if (mode == Mode.SCALE) {
            int rgb = handle == ALL ? HOVERED : COLOURS[ALL];
            line(view, 0, 0, axes[0], rgb, 11);
        }
    }

    private void circle(View view, int axis, int rgb, double width) {
        onCircle(axis, 0);
        for (int i = 1; i <= SEGMENTS; i++) {
            double x = arm.x;
            double y = arm.y;
            double z = arm.z;
            onCircle(axis, i);
            view.lineOver(x, y, z, arm.x, arm.y, arm.z, rgb, width);
        }
    }

    private void bar(View view, int axis, int rgb, double width) {
        line(view, INNER * length, length, axes[axis], rgb, width);
        if (mode == Mode.SCALE) {
            line(view, length, length, axes[axis], rgb, 10);
            return;
        }
        for (int side = 0; side < 4; side++) {
            Vector3d u = axes[(axis + 1 + side % 2) % 3];
            double s = (side < 2 ? 0.07 : -0.07) * length;
            Vector3d a = axes[axis];
            double back = 0.82 * length;
            view.lineOver(
                    centre.x + length * a.x,
                    centre.y + length * a.y,
                    centre.z + length * a.z,
                    centre.x + back * a.x + s * u.x,
                    centre.y + back * a.y + s * u.y,
                    centre.z + back * a.z + s * u.z,
                    rgb,
                    width);
        }
    }

    private void line(View view, double from, double to, Vector3d a, int rgb, double width) {
        view.lineOver(
                centre.x + from * a.x,
                centre.y + from * a.y,
                centre.z + from * a.z,
                centre.x + to * a.x,
                centre.y + to * a.y,
                centre.z + to * a.z,
                rgb,
                width);
    }
}
