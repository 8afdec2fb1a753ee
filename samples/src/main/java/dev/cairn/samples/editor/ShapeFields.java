package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Xyz;

import java.util.ArrayList;
import java.util.List;

/** The sizes of a shape as fields; the points of a hull one by one. Window thread. */
final class ShapeFields {
    /** Points of a hull that have fields; more would be a list without an end. */
    private static final int MOST_POINTS = 24;

    private final Editor editor;
    private final Fields fields;

    ShapeFields(Editor editor, Fields fields) {
        this.editor = editor;
        this.fields = fields;
    }

    void draw(Ui ui, EntitySpec entity) {
        ShapeSpec wanted =
                switch (entity.shape()) {
                    case BoxShape(Xyz half) -> new BoxShape(fields.xyz(ui, "half", half));
                    case SphereShape(double radius) ->
                            new SphereShape(fields.number(ui, "radius, m", radius));
                    case TurnedShape(String type, double radius, double half) ->
                            new TurnedShape(
                                    type,
                                    fields.number(ui, "radius, m", radius),
                                    fields.number(ui, "half height, m", half));
                    case HullShape hull -> hull(ui, hull);
                    case MeshShape(String file) -> new MeshShape(ui.textField("file", file));
                    case GroundShape ground -> ground;
                    case MovedShape moved -> moved;
                };
        if (!wanted.equals(entity.shape())) {
            change(entity, wanted);
        }
    }

    private HullShape hull(Ui ui, HullShape hull) {
        List<Xyz> points = new ArrayList<>(hull.points());
        ui.columns(2);
        if (ui.button("Add a point")) {
            Xyz last = points.getLast();
            points.add(new Xyz(last.x(), last.y() + 0.25, last.z()));
        }
        if (ui.button("Remove the last")) {
            points.removeLast();
        }
        if (points.size() != hull.points().size()) {
            fields.forget();
            return new HullShape(points);
        }
        if (points.size() > MOST_POINTS) {
            ui.text(points.size() + " points; the first " + MOST_POINTS + " have fields.");
        }
        for (int i = 0; i < Math.min(points.size(), MOST_POINTS); i++) {
            points.set(i, fields.xyz(ui, "p" + i, points.get(i)));
        }
        return points.equals(hull.points()) ? hull : new HullShape(points);
    }

    /** A shape that cannot be, such as a flat hull, is told and not taken over. */
    private void change(EntitySpec entity, ShapeSpec wanted) {
        editor.change(
                "shape of",
                e -> {
                    if (!(wanted instanceof MeshShape)) {
                        wanted.collider(entity.scale());
                    }
                    return e.withShape(wanted);
                });
    }
}
