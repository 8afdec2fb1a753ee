package dev.cairn.samples.editor;

import dev.cairn.render.app.Pick;
import dev.cairn.render.app.View;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.Pointer;
import dev.cairn.samples.editor.gizmo.Gizmo;
import dev.cairn.samples.editor.gizmo.Orbit;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.GroupEdit;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** What the mouse does to the picture of a scene that rests. Window thread. */
final class EditorMouse {
    /** Where a click over the sky is while nothing is selected, m. */
    private static final double AHEAD = 8;

    /** What places are multiples of while the grid is on, m. */
    private static final double GRID = 0.25;

    /**
     * How far the cursor goes before a click becomes a drag, as a share of the picture's height.
     */
    private static final double STRAY = 0.008;

    private final Editor editor;
    private final Gizmo gizmo = new Gizmo();
    private final Orbit orbit = new Orbit();
    private final Vector3d pivot = new Vector3d();
    private boolean orbits;
    private @Nullable GroundDrag drag;

    /** Whether the cursor has gone far enough from where the button went down. */
    private boolean drags;

    /** What alone is selected if the button goes up without a drag. */
    private int clickedOne = Editor.NOTHING;

    /** The entity under the cursor when it was taken. */
    private int held = Editor.NOTHING;

    private double pressedX;
    private double pressedY;
    private boolean snaps = true;

    EditorMouse(Editor editor) {
        this.editor = editor;
    }

    Gizmo gizmo() {
        return gizmo;
    }

    boolean snaps() {
        return snaps;
    }

    void snaps(boolean value) {
        snaps = value;
    }

    private double grid() {
        return snaps ? GRID : 0;
    }

    /** Whether something is being dragged. */
    boolean isBusy() {
        return drag != null || gizmo.isHeld();
    }

    void frame(View view, long[] entities) {
        Pointer pointer = view.pointer();
        orbit(view, pointer);
        boolean handles = gizmo.aim(view, editor);
        boolean down = pointer.isDown(MouseButton.LEFT);
        if (pointer.wasPressed(MouseButton.LEFT)) {
            take(view, entities);
        } else if (gizmo.isHeld()) {
            // Also in the frame of the release: the way up to it belongs to the drag.
            gizmo.drag(editor, grid());
            if (!down) {
                gizmo.release();
                editor.seal();
            }
        } else if (drag != null) {
            drags |=
                    Math.hypot((pointer.x() - pressedX) * view.aspect(), pointer.y() - pressedY)
                            > STRAY;
            if (drags) {
                move(view, drag);
            }
            if (!down) {
                letGo();
            }
        }
        if (handles && editor.selected() != Editor.NOTHING) {
            gizmo.aim(view, editor);
            gizmo.draw(view);
        }
    }

    /** The middle button takes the camera around what is selected, else what is in the middle. */
    private void orbit(View view, Pointer pointer) {
        if (pointer.wasPressed(MouseButton.MIDDLE)) {
            if (editor.selected() != Editor.NOTHING) {
                editor.group().middle(pivot);
            } else {
                Pick pick = view.pick(0, 0);
                double far = pick == null ? AHEAD : pick.distance();
                Vector3d ahead = view.camera().forward(new Vector3d());
                view.camera().position(pivot).fma(far, ahead);
            }
            orbit.begin(pivot, pointer.x(), pointer.y());
            orbits = true;
        } else if (orbits) {
            // Also in the frame of the release, as with a drag.
            orbit.go(view.camera(), pointer.x(), pointer.y(), view.aspect());
            orbits = pointer.isDown(MouseButton.MIDDLE);
        }
    }

    private void letGo() {
        drag = null;
        editor.seal();
        if (!drags && clickedOne != Editor.NOTHING) {
            editor.select(clickedOne);
        }
    }

    private void take(View view, long[] entities) {
        Pointer pointer = view.pointer();
        boolean waits = editor.joints().awaited() != EditorJoints.Click.NONE;
        if (!waits && gizmo.take(editor)) {
            editor.seal();
            return;
        }
        Pick pick = view.pick(pointer.across(), pointer.upwards());
        int index = pick == null ? Editor.NOTHING : indexOf(pick.entity(), entities);
        if (waits) {
            editor.joints().click(index, clicked(view, pick));
            return;
        }
        if (index != Editor.NOTHING && Ground.is(editor.scene().entities().get(index))) {
            index = Editor.NOTHING; // A click beside all things: the floor is chosen in the list.
        }
        clickedOne = Editor.NOTHING;
        if (pointer.isWithShift() || pointer.isWithControl()) {
            if (index != Editor.NOTHING) {
                editor.toggle(index);
            }
            return;
        }
        if (editor.isSelected(index)) {
            clickedOne = index;
        } else {
            editor.select(index);
        }
        if (pick != null && index != Editor.NOTHING) {
            EntitySpec taken = editor.scene().entities().get(index);
            Vector3d at = view.camera().position(new Vector3d()).fma(pick.distance(), ray(view));
            drag = new GroundDrag(new Xyz(at.x, at.y, at.z), taken.position());
            held = index;
            drags = false;
            pressedX = pointer.x();
            pressedY = pointer.y();
        }
    }

    /** The point under the cursor; over the sky one as far away as what is selected. */
    private Xyz clicked(View view, @Nullable Pick pick) {
        Vector3d eye = view.camera().position(new Vector3d());
        Vector3d along = ray(view);
        EntitySpec near = editor.selectedEntity();
        double far = AHEAD;
        if (pick != null) {
            far = pick.distance();
        } else if (near != null) {
            Xyz at = near.position();
            Vector3d forward = view.camera().forward(new Vector3d());
            double depth = new Vector3d(at.x(), at.y(), at.z()).sub(eye).dot(forward);
            far = Math.max(0, depth) / along.dot(forward);
        }
        Vector3d at = eye.fma(far, along);
        return new Xyz(at.x, at.y, at.z);
    }

    private void move(View view, GroundDrag by) {
        Vector3d eye = view.camera().position(new Vector3d());
        Vector3d along = ray(view);
        Xyz now = editor.scene().entities().get(held).position();
        Xyz to =
                by.to(
                        new Xyz(eye.x, eye.y, eye.z),
                        new Xyz(along.x, along.y, along.z),
                        now,
                        grid());
        Xyz shift = new Xyz(to.x() - now.x(), to.y() - now.y(), to.z() - now.z());
        editor.group().changeAll("drag", (scene, which) -> GroupEdit.move(scene, which, shift));
    }

    private static int indexOf(long wanted, long[] entities) {
        for (int i = 0; i < entities.length; i++) {
            if (entities[i] == wanted) {
                return i;
            }
        }
        return Editor.NOTHING;
    }

    private static Vector3d ray(View view) {
        Pointer pointer = view.pointer();
        return view.camera()
                .ray(pointer.across(), pointer.upwards(), view.aspect(), new Vector3d());
    }

    /** Takes a file that was dropped where the cursor is. */
    void dropped(View view, long[] entities, Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (name.endsWith(".json")) {
            editor.files().load(file.toString());
        } else if (name.endsWith(".obj")) {
            Vector3d eye = view.camera().position(new Vector3d());
            Xyz there = Ground.ahead(eye, ray(view), editor.scene().entities());
            Xyz at = Ground.under(Supply.ANY_MESH, there, editor.scene().entities());
            editor.placeMesh(editor.files().relative(file), at);
        } else if (name.endsWith(".png") || name.endsWith(".jpg")) {
            if (!Files.isRegularFile(file)) {
                editor.fail(file + ": expected a picture; there is none");
                return;
            }
            Pick pick = view.pick(view.pointer().across(), view.pointer().upwards());
            int index = pick == null ? Editor.NOTHING : indexOf(pick.entity(), entities);
            if (index == Editor.NOTHING) {
                editor.fail(name + ": drop a picture onto the thing that shall wear it");
                return;
            }
            editor.select(index);
            String picture = editor.files().relative(file);
            editor.change(
                    "picture",
                    e -> e.withLook(e.look().withTexture(picture, e.look().tileMetres())));
        } else {
            editor.fail(name + ": expected a scene .json, a mesh .obj or a picture .png, .jpg");
        }
    }

    /** On the ground in the middle of the picture, beside what stands there. */
    Xyz free(View view, EntitySpec made) {
        Vector3d eye = view.camera().position(new Vector3d());
        Vector3d along = view.camera().forward(new Vector3d());
        List<EntitySpec> all = editor.scene().entities();
        Xyz ahead = Ground.ahead(eye, along, all);
        double grid = grid() > 0 ? GRID : 0.001;
        Xyz wanted = new Xyz(GroundDrag.snap(ahead.x(), grid), 0, GroundDrag.snap(ahead.z(), grid));
        Xyz standing = Ground.under(made, wanted, all);
        Xyz aside =
                FreePlace.near(
                        made,
                        standing,
                        all.stream().filter(other -> !Ground.is(other)).toList(),
                        Math.abs(along.z) >= Math.abs(along.x),
                        grid());
        boolean isOnTop = aside.x() == standing.x() && aside.z() == standing.z();
        return isOnTop ? aside : Ground.under(made, aside, all);
    }
}
