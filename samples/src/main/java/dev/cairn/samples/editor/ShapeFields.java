package dev.cairn.samples.editor;

import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.FieldShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.SurfaceShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Xyz;

import java.util.ArrayList;
import java.util.List;

/** The sizes of a shape as fields; the points of a hull one by one. Window thread. */
@SuppressWarnings("ReferenceEquality") // what nobody typed into is the same object
final class ShapeFields {
    /** Points of a hull that have fields; more would be a list without an end. */
    private static final int MOST_POINTS = 24;

    private static final String[] POINTS = new String[MOST_POINTS];

    static {
        for (int i = 0; i < MOST_POINTS; i++) {
            POINTS[i] = "p" + i;
        }
    }

    private static final List<As> KINDS = List.of(As.HULL, As.LEVEL, As.PARTS);

    private static final List<String> AS = List.of("its hull", "its triangles", "convex parts");

    private final Editor editor;
    private final Fields fields;
    private final TextBuffer text = new TextBuffer();

    ShapeFields(Editor editor, Fields fields) {
        this.editor = editor;
        this.fields = fields;
    }

    void draw(Ui ui, EntitySpec entity) {
        ShapeSpec wanted =
                switch (entity.shape()) {
                    case BoxShape box -> box(ui, box);
                    case SphereShape ball -> ball(ui, ball);
                    case TurnedShape turned -> turned(ui, turned);
                    case HullShape hull -> hull(ui, hull);
                    case MeshShape mesh -> mesh(ui, mesh);
                    case GroundShape ground -> ground;
                    case SurfaceShape surface -> surface;
                    case FieldShape field -> field;
                    case MovedShape moved -> moved;
                };
        if (wanted != entity.shape()) {
            change(entity, wanted);
        }
    }

    // Each gives back the very shape where nothing was typed: a copy would be garbage of each
    // frame.

    private BoxShape box(Ui ui, BoxShape box) {
        Xyz half = fields.xyz(ui, "half", box.halfExtents());
        return half == box.halfExtents() ? box : new BoxShape(half);
    }

    private SphereShape ball(Ui ui, SphereShape ball) {
        double radius = fields.number(ui, "radius, m", ball.radius());
        return radius == ball.radius() ? ball : new SphereShape(radius);
    }

    private TurnedShape turned(Ui ui, TurnedShape turned) {
        double radius = fields.number(ui, "radius, m", turned.radius());
        double half = fields.number(ui, "half height, m", turned.halfHeight());
        return radius == turned.radius() && half == turned.halfHeight()
                ? turned
                : new TurnedShape(turned.type(), radius, half);
    }

    private static MeshShape mesh(Ui ui, MeshShape mesh) {
        String file = ui.textField("file", mesh.file());
        As as = KINDS.get(ui.choice("collides as", AS, KINDS.indexOf(mesh.as())));
        double parts = mesh.parts();
        double error = mesh.error();
        if (mesh.as() == As.PARTS) {
            parts = ui.slider("parts", parts, 1, 64, 1, "at most");
            error = ui.slider("error", error, 0.005, 0.2, 0.005, "a share of the longest side");
        }
        boolean same =
                file.equals(mesh.file())
                        && as == mesh.as()
                        && parts == mesh.parts()
                        && error == mesh.error();
        return same ? mesh : new MeshShape(file, as, (int) parts, error);
    }

    private HullShape hull(Ui ui, HullShape hull) {
        // Closed at first: three fields a point would push all else out of sight.
        if (!ui.section("Points", false)) {
            return hull;
        }
        HullShape result = points(ui, hull);
        ui.endSection();
        return result;
    }

    private HullShape points(Ui ui, HullShape hull) {
        List<Xyz> points = hull.points();
        ui.columns(2);
        boolean adds = ui.button("Add a point");
        boolean removes = ui.button("Remove the last");
        if (adds || removes) {
            List<Xyz> changed = new ArrayList<>(points);
            Xyz last = changed.getLast();
            if (adds) {
                changed.add(new Xyz(last.x(), last.y() + 0.25, last.z()));
            } else {
                changed.removeLast();
            }
            fields.forget();
            return new HullShape(changed);
        }
        if (points.size() > MOST_POINTS) {
            text.clear().put(points.size()).put(" points; the first ").put(MOST_POINTS);
            ui.text(text.put(" have fields."));
        }
        HullShape result = hull;
        for (int i = 0; i < Math.min(points.size(), MOST_POINTS); i++) {
            Xyz old = points.get(i);
            Xyz typed = fields.xyz(ui, POINTS[i], old);
            if (typed != old) {
                List<Xyz> changed = new ArrayList<>(result.points());
                changed.set(i, typed);
                result = new HullShape(changed);
            }
        }
        return result;
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
