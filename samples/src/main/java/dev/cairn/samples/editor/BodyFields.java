package dev.cairn.samples.editor;

import dev.cairn.physics.Material;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.BodySpec;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * What a body has beside shape, substance and motion: its colliders, whom it meets, what slows and
 * holds it. Sections that are closed at first. Window thread.
 */
@SuppressWarnings("ReferenceEquality") // what nobody typed into is the same object
final class BodyFields {
    private static final List<String> MIXES =
            List.of("as usual", "average", "minimum", "multiply", "maximum");
    private static final Lock[] LOCKS = Lock.values();
    private static final String[] LOCK_NAMES = {
        "no way along x",
        "no way along y",
        "no way along z",
        "no turn about x",
        "no turn about y",
        "no turn about z"
    };

    private final Editor editor;
    private final Fields fields;
    private final PartFields partFields;

    /** Labels of the layers that were shown last. */
    private List<String> known = List.of();

    private String[] inLayer = {};
    private String[] meetsLayer = {};
    private String layerText = "";

    /** The entity that was shown last, and its colliders. */
    private @Nullable EntitySpec shown;

    private List<PartSpec> parts = List.of();

    BodyFields(Editor editor, Fields fields) {
        this.editor = editor;
        this.fields = fields;
        partFields = new PartFields(fields);
    }

    void draw(Ui ui, EntitySpec entity) {
        if (ui.section("Colliders", false)) {
            colliders(ui, entity);
            ui.endSection();
        }
        if (entity.body() == BodyKind.NONE) {
            return;
        }
        if (ui.section("Layers", false)) {
            layers(ui, entity.physics());
            ui.endSection();
        }
        if (ui.section("Mixing", false)) {
            mixing(ui, entity.material());
            ui.endSection();
        }
        if (entity.body() == BodyKind.DYNAMIC && ui.section("Held and slowed", false)) {
            held(ui, entity.physics());
            ui.endSection();
        }
    }

    private void change(String label, BodySpec wanted) {
        editor.change(label, e -> e.withPhysics(wanted));
    }

    private void colliders(Ui ui, EntitySpec entity) {
        if (entity != shown) {
            shown = entity;
            parts = entity.parts();
        }
        ui.columns(2);
        boolean adds = ui.button("Add a collider");
        boolean removes = ui.button("Remove the last");
        if (adds || (removes && parts.size() > 1)) {
            List<PartSpec> changed = new ArrayList<>(parts);
            PartSpec last = changed.getLast();
            if (adds) {
                Xyz at = last.position();
                changed.add(last.at(new Xyz(at.x() + 1, at.y(), at.z())));
            } else {
                changed.removeLast();
            }
            fields.forget();
            // Scales of three factors are for one plain shape.
            double scale = entity.scale().x();
            editor.change(
                    "colliders of",
                    e ->
                            e.withScale(new Xyz(scale, scale, scale))
                                    .withPhysics(e.physics().withParts(changed)));
            return;
        }
        partFields.show(parts, editor.scene().layers());
        Filter filter = entity.physics().filter();
        for (int i = 0; i < Math.min(parts.size(), PartFields.MOST); i++) {
            PartSpec old = parts.get(i);
            PartSpec typed = partFields.draw(ui, old, i, entity.material(), filter);
            if (typed != old) {
                List<PartSpec> changed = new ArrayList<>(parts);
                changed.set(i, typed);
                change("collider of", entity.physics().withParts(changed));
                return;
            }
        }
    }

    private void layers(Ui ui, BodySpec body) {
        List<String> names = editor.scene().layers();
        if (names != known) {
            known = names;
            layerText = String.join(", ", names);
            inLayer = names.stream().map(name -> "is " + name).toArray(String[]::new);
            meetsLayer = names.stream().map(name -> "meets " + name).toArray(String[]::new);
        }
        String typed = ui.textField("names", layerText);
        if (!typed.equals(layerText)) {
            List<String> wanted = new ArrayList<>();
            for (String name : typed.split(",", -1)) {
                if (!name.isBlank() && !wanted.contains(name.strip())) {
                    wanted.add(name.strip());
                }
            }
            editor.layers(wanted);
            known = editor.scene().layers();
            inLayer = known.stream().map(name -> "is " + name).toArray(String[]::new);
            meetsLayer = known.stream().map(name -> "meets " + name).toArray(String[]::new);
            layerText = typed;
            return;
        }
        Filter filter = body.filter();
        long category = filter.category();
        long mask = filter.mask();
        for (int i = 0; i < inLayer.length; i++) {
            category =
                    PartFields.bit(category, i, ui.checkbox(inLayer[i], (category >>> i & 1) != 0));
            mask = PartFields.bit(mask, i, ui.checkbox(meetsLayer[i], (mask >>> i & 1) != 0));
        }
        int number = PartFields.group(fields.number(ui, "group", filter.group()), filter.group());
        if (category != filter.category() || mask != filter.mask() || number != filter.group()) {
            change("layers of", body.withFilter(new Filter(category, mask, number)));
        }
    }

    private void mixing(Ui ui, Material old) {
        int friction = ui.choice("mix of friction", MIXES, old.frictionMix().strength());
        int bounce = ui.choice("mix of restitution", MIXES, old.restitutionMix().strength());
        if (friction != old.frictionMix().strength() || bounce != old.restitutionMix().strength()) {
            Mix[] all = Mix.values();
            editor.change(
                    "mixing of",
                    e ->
                            e.withMaterial(
                                    e.material().withMix(all[friction], all[bounce]), e.mass()));
            return;
        }
        Xyz before = PartFields.run(old);
        Xyz run = fields.xyz(ui, "surface runs, m/s", before);
        if (run != before) {
            editor.change(
                    "surface of",
                    e ->
                            e.withMaterial(
                                    e.material().withSurfaceVelocity(run.x(), run.y(), run.z()),
                                    e.mass()));
        }
    }

    private void held(Ui ui, BodySpec body) {
        double gravity = fields.number(ui, "share of gravity", body.gravityScale());
        double linear = fields.number(ui, "damping, 1/s", body.linearDamping());
        double angular = fields.number(ui, "of its spin, 1/s", body.angularDamping());
        double top = Double.isInfinite(body.speedLimit()) ? 0 : body.speedLimit();
        double typed = fields.number(ui, "top speed, m/s", top);
        double limit =
                typed == top ? body.speedLimit() : typed > 0 ? typed : Double.POSITIVE_INFINITY;
        if (gravity != body.gravityScale()
                || linear != body.linearDamping()
                || angular != body.angularDamping()
                || limit != body.speedLimit()) {
            change("motion of", body.moving(gravity, linear, angular, limit));
            return;
        }
        boolean own = ui.checkbox("an inertia of its own", body.inertia() != null);
        if (own != (body.inertia() != null)) {
            change("inertia of", body.withInertia(own ? Xyz.ONE : null));
            return;
        }
        Xyz inertia = body.inertia();
        if (inertia != null) {
            Xyz wanted = fields.xyz(ui, "kg m²", inertia);
            if (wanted != inertia) {
                change("inertia of", body.withInertia(wanted));
                return;
            }
        }
        if (heart(ui, body)) {
            return;
        }
        for (int i = 0; i < LOCKS.length; i++) {
            boolean is = body.locks().contains(LOCKS[i]);
            if (ui.checkbox(LOCK_NAMES[i], is) != is) {
                List<Lock> wanted = new ArrayList<>(body.locks());
                if (is) {
                    wanted.remove(LOCKS[i]);
                } else {
                    wanted.add(LOCKS[i]);
                }
                change("locks of", body.withLocks(wanted));
                return;
            }
        }
    }

    /** Centre of mass and sleep; whether one was changed. */
    private boolean heart(Ui ui, BodySpec body) {
        Xyz centre = body.centre();
        boolean own = ui.checkbox("a centre of mass of its own", centre != null);
        if (own != (centre != null)) {
            change("centre of", body.withCentre(own ? Xyz.ZERO : null));
            return true;
        }
        Xyz wanted = centre == null ? null : fields.xyz(ui, "centre", centre);
        if (wanted != centre) {
            change("centre of", body.withCentre(wanted));
            return true;
        }
        boolean sleeps = ui.checkbox("may fall asleep", body.canSleep());
        if (sleeps != body.canSleep()) {
            change("sleep of", body.withSleep(sleeps));
            return true;
        }
        return false;
    }
}
