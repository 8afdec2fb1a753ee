package dev.cairn.samples.editor;

import dev.cairn.physics.collider.Filter;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.JointEdit;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;

/**
 * The joints of an edited scene: which is selected, and which is being placed. A joint is placed in
 * two steps, {@link #begin} and a click, {@link #click}. Mistakes end as a line in {@link
 * Editor#message}. The window's thread.
 */
public final class EditorJoints {
    /** What the next click into the picture means. */
    public enum Click {
        /** Selecting and dragging, as ever. */
        NONE,
        /** The other body of a new joint, and its point. */
        PARTNER,
        /** A point of the world where the selected body hangs. */
        WORLD,
        /** A new point for the selected joint. */
        POINT
    }

    /** Kinds whose two points are apart: what they hold together is not one place. */
    private static final Set<String> TWO_POINTS =
            Set.of("rod", "rope", "spring", "gear", "rack", "pulley");

    /** Radius of the ball that stands for the world, m. */
    private static final double ANCHOR = 0.05;

    /** How far above its bodies a new pulley's rope turns, m. */
    private static final double OVER = 2;

    private final Editor editor;
    private int selected = Editor.NOTHING;
    private Click awaited = Click.NONE;
    private String kind = "hinge";
    private Xyz axis = new Xyz(0, 0, 1);

    EditorJoints(Editor editor) {
        this.editor = editor;
    }

    private List<JointSpec> all() {
        return editor.scene().joints();
    }

    /**
     * Which joint is selected.
     *
     * @return its place in the scene's list, or {@link Editor#NOTHING}
     */
    public int selected() {
        return selected;
    }

    /**
     * What is selected.
     *
     * @return the joint, or null
     */
    public @Nullable JointSpec selectedJoint() {
        return selected == Editor.NOTHING ? null : all().get(selected);
    }

    /**
     * What the next click means.
     *
     * @return what is awaited
     */
    public Click awaited() {
        return awaited;
    }

    /**
     * Selects a joint.
     *
     * @param index its place in the list, or {@link Editor#NOTHING}
     */
    public void select(int index) {
        editor.seal();
        editor.letGo();
        selected = index >= 0 && index < all().size() ? index : Editor.NOTHING;
    }

    void letGo() {
        selected = Editor.NOTHING;
        awaited = Click.NONE;
    }

    /** The history went a step; what is selected stays selected. */
    void travelled(List<JointSpec> before) {
        boolean isOther = !before.equals(all());
        selected =
                isOther
                        ? Selection.after(before, selected, all())
                        : selected < all().size() ? selected : Editor.NOTHING;
    }

    // Placing ----------------------------------------------------------------------------------

    /**
     * Begins a joint at the selected entity; the next {@link #click} ends it.
     *
     * @param newKind one of {@link JointSpec#KINDS}
     * @param newAxis its axis, world
     * @param toWorld whether it holds the entity to the world, not to another entity
     */
    public void begin(String newKind, Xyz newAxis, boolean toWorld) {
        if (editor.selectedEntity() == null) {
            editor.fail("nothing is selected; choose the first of the two bodies of a joint");
            return;
        }
        kind = newKind;
        axis = newAxis;
        awaited = toWorld ? Click.WORLD : Click.PARTNER;
        editor.say(
                toWorld
                        ? "Click on the point where it shall hang on the world. Escape ends this."
                        : "Click on the point of the other body. Escape ends this.");
    }

    /** The next click gives the selected joint another point. */
    public void beginPoint() {
        if (selectedJoint() != null) {
            awaited = Click.POINT;
            editor.say("Click on the new point of the joint. Escape ends this.");
        }
    }

    /** Gives up what was begun. */
    public void cancel() {
        if (awaited != Click.NONE) {
            awaited = Click.NONE;
            editor.say("");
        }
    }

    /**
     * A click into the picture while one is awaited.
     *
     * @param entity what is there, by its place in the list, or {@link Editor#NOTHING}
     * @param point where, world, m
     */
    public void click(int entity, Xyz point) {
        Click what = awaited;
        Xyz at = rounded(point);
        switch (what) {
            case NONE -> {}
            case PARTNER -> partner(editor.selected(), entity, at);
            case WORLD -> world(editor.selected(), at);
            case POINT -> {
                change("point of", joint -> joint.withPlace(moved(joint.place(), at)));
                awaited = Click.NONE;
            }
        }
    }

    /** To a tenth of a millimetre, which is more than a mouse can tell. */
    private static Xyz rounded(Xyz p) {
        return new Xyz(
                Math.rint(p.x() * 1e4) / 1e4,
                Math.rint(p.y() * 1e4) / 1e4,
                Math.rint(p.z() * 1e4) / 1e4);
    }

    /** One point for both, or the second one's own. */
    private static JointSpec.Place moved(JointSpec.Place place, Xyz at) {
        Xyz pa = place.anchorA();
        boolean isOne = pa == null || pa.equals(place.anchorB());
        return new JointSpec.Place(isOne ? at : pa, at, place.axis(), place.secondAxis());
    }

    private void partner(int a, int b, Xyz at) {
        if (b == Editor.NOTHING) {
            editor.fail("there is no body; click on the one that the joint shall hold");
            return;
        }
        EntitySpec first = editor.scene().entities().get(a);
        EntitySpec second = editor.scene().entities().get(b);
        JointSpec made = made(a, b, ends(kind, first.position(), second.position(), at));
        String label = "%s %s and %s".formatted(kind, first.name(), second.name());
        finish(editor.edit(label, scene -> JointEdit.add(scene, made), false));
    }

    /** The world is a small ball that is fixed where the joint is, and that nothing touches. */
    private void world(int b, Xyz at) {
        EntitySpec held = editor.scene().entities().get(b);
        EntitySpec ball =
                EntitySpec.of("anchor", BodyKind.FIXED, new SphereShape(ANCHOR)).at(at, Turn.NONE);
        EntitySpec anchor = ball.withPhysics(ball.physics().withFilter(new Filter(1, 0, 0)));
        int a = editor.scene().entities().size();
        JointSpec made = made(a, b, ends(kind, at, held.position(), null));
        String label = "%s %s and the world".formatted(kind, held.name());
        finish(
                editor.edit(
                        label, scene -> JointEdit.add(SceneEdit.add(scene, anchor), made), false));
    }

    private void finish(boolean isDone) {
        if (isDone) {
            select(all().size() - 1);
        }
    }

    /** The points of a joint on its two bodies. */
    private record Ends(Xyz a, Xyz b) {}

    /**
     * Where a joint of a kind is.
     *
     * @param a where the first body is
     * @param b where the second one is
     * @param at the point that was clicked on, on the second one; null if that is {@code a}
     */
    private static Ends ends(String kind, Xyz a, Xyz b, @Nullable Xyz at) {
        boolean isByCentres = kind.equals("gear") || kind.equals("rack") || at == null;
        Xyz point = at == null ? a : at;
        return TWO_POINTS.contains(kind)
                ? new Ends(a, isByCentres ? b : point)
                : new Ends(point, point);
    }

    private JointSpec made(int a, int b, Ends ends) {
        Xyz second = kind.equals("wheel") ? new Xyz(0, 1, 0) : null;
        return JointSpec.of(
                kind,
                a,
                b,
                parameters(kind, ends),
                new JointSpec.Place(ends.a, ends.b, axis, second));
    }

    private List<Double> parameters(String kind, Ends ends) {
        Xyz from = ends.a;
        Xyz to = ends.b;
        return switch (kind) {
            case "gear" -> List.of(20.0, 20.0);
            case "pulley" ->
                    List.of(
                            from.x(),
                            from.y() + OVER,
                            from.z(),
                            to.x(),
                            to.y() + OVER,
                            to.z(),
                            1.0);
            // a straight wire along the axis, to be bent in the panel
            case "path" ->
                    List.of(
                            0.0,
                            to.x() - axis.x(),
                            to.y() - axis.y(),
                            to.z() - axis.z(),
                            to.x(),
                            to.y(),
                            to.z(),
                            to.x() + axis.x(),
                            to.y() + axis.y(),
                            to.z() + axis.z());
            default -> List.of();
        };
    }

    // Edits ------------------------------------------------------------------------------------

    /** Deletes the selected joint; its bodies stay. */
    public void delete() {
        JointSpec gone = selectedJoint();
        if (gone == null) {
            editor.fail("no joint is selected; choose one to delete");
            return;
        }
        int index = selected;
        if (editor.edit("delete " + gone.kind(), s -> JointEdit.delete(s, index), false)) {
            letGo();
        }
    }

    /**
     * Changes the selected joint. Changes of one kind to one joint become one step of the history
     * until {@link Editor#seal}.
     *
     * @param what the kind of change, a word
     * @param change from the joint as it is to what it shall be
     */
    public void change(String what, UnaryOperator<JointSpec> change) {
        JointSpec joint = selectedJoint();
        if (joint != null) {
            int index = selected;
            editor.edit(
                    "%s %s (%d)".formatted(what, joint.kind(), index),
                    scene -> JointEdit.change(scene, index, change),
                    true);
        }
    }

    /**
     * Makes a joint of another kind of the selected one, at its place.
     *
     * @param newKind one of {@link JointSpec#KINDS}
     */
    public void changeKind(String newKind) {
        change("kind of", joint -> ofKind(joint, newKind));
    }

    private JointSpec ofKind(JointSpec old, String newKind) {
        List<EntitySpec> entities = editor.scene().entities();
        Xyz pa = old.place().anchorA();
        Xyz pb = old.place().anchorB();
        Xyz a = entities.get(old.a()).position();
        Xyz b = entities.get(old.b()).position();
        boolean isOne = pa != null && pa.equals(pb);
        Ends ends =
                pa == null || pb == null || isOne == TWO_POINTS.contains(newKind)
                        ? ends(newKind, a, b, pb == null ? b : pb)
                        : new Ends(pa, pb);
        JointSpec.Place place = old.place();
        return JointSpec.of(
                        newKind,
                        old.a(),
                        old.b(),
                        parameters(newKind, ends),
                        new JointSpec.Place(ends.a, ends.b, place.axis(), place.secondAxis()))
                .withName(old.name())
                .bearing(old.breakForce(), old.breakTorque(), old.isOn(), old.collides());
    }
}
