package dev.cairn.samples.editor;

import dev.cairn.physics.Material;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.panel.Places;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/** The panel with what is selected: every property as a field or a slider. Window thread. */
final class EntityPanel {
    private static final List<BodyKind> KINDS =
            List.of(BodyKind.DYNAMIC, BodyKind.FIXED, BodyKind.KINEMATIC, BodyKind.NONE);
    private static final List<String> KIND_NAMES =
            List.of("moves", "fixed", "moves as told", "only drawn");
    private static final List<String> COLOURS =
            List.of("by its place", "red", "orange", "green", "blue", "purple", "white", "grey");
    private static final int[] RGB = {
        0, 0xC8553D, 0xE0A458, 0x6A994E, 0x3D5A80, 0x8F6593, 0xF2F2F2, 0x8A8A8A
    };

    private static final List<String> TEXTURE_NAMES = textureNames();
    static final List<String> AXES = List.of("along x", "along y", "along z");
    static final List<Xyz> DIRECTIONS =
            List.of(new Xyz(1, 0, 0), new Xyz(0, 1, 0), new Xyz(0, 0, 1));
    private static final int FROM_FILE = 1 + LookSpec.TEXTURES.size();
    private static final int ROWS_BELOW = 6;

    private final Editor editor;
    private final Fields fields = new Fields();
    private final ShapeFields shapes;
    private final DrivenFields driven;
    private final BodyFields bodies;
    private int jointKind = JointSpec.KINDS.indexOf("hinge");
    private int jointAxis = 2;
    private final Quaterniond rotation = new Quaterniond();
    private final Vector3d angles = new Vector3d();
    private int shown = Editor.NOTHING;

    EntityPanel(Editor editor) {
        this.editor = editor;
        this.shapes = new ShapeFields(editor, fields);
        this.driven = new DrivenFields(editor);
        this.bodies = new BodyFields(editor, fields);
    }

    void draw(Ui ui, double left, double top, double width, double height) {
        if (editor.selected() != shown) {
            shown = editor.selected();
            fields.forget();
        }
        EntitySpec entity = editor.selectedEntity();
        if (entity == null) {
            if (ui.panel("Entity", left, top, width, 190)) {
                ui.text(
                        "Nothing is selected. Click on something, or choose it in the list. Drag"
                                + " it with the left button to move it over the ground; the wheel"
                                + " raises and lowers it. The right button looks around, W A S D"
                                + " fly.");
            }
            ui.endPanel();
            return;
        }
        if (ui.panel("Entity", left, top, width, height)) {
            ui.columns(2);
            if (ui.button("Duplicate (C)")) {
                editor.group().duplicate();
            }
            if (ui.button("Delete (Del)")) {
                editor.delete();
            }
            if (Places.isNarrow(ui)) {
                ui.columns(1);
                if (ui.button("Back (Esc)")) {
                    editor.select(Editor.NOTHING);
                }
            }
            if (entity.body() != BodyKind.NONE) {
                newJoint(ui);
            }
            // One kind of change in a frame: what is shown below is what was there before it.
            identity(ui, entity);
            place(ui, entity);
            substance(ui, entity);
            motion(ui, entity);
            bodies.draw(ui, entity);
            driven.draw(ui, entity);
            // So that the list of choices above can be scrolled to where it fits the window.
            for (int i = 0; i < ROWS_BELOW; i++) {
                ui.label("");
            }
        }
        ui.endPanel();
    }

    private void identity(Ui ui, EntitySpec entity) {
        String name = ui.textField("name", entity.name());
        if (!name.equals(entity.name())) {
            editor.rename(name);
        }
        ui.value("shape", entity.shape().type());
        shapes.draw(ui, entity);
        int present = KINDS.indexOf(entity.body());
        int kind = ui.choice("body", KIND_NAMES, present);
        if (kind != present) {
            editor.change("body of", e -> e.withBody(KINDS.get(kind)));
        }
        LookSpec look = entity.look();
        Integer rgb = look.rgb();
        int known = 0;
        for (int i = 1; i < RGB.length; i++) {
            known = rgb != null && rgb == RGB[i] ? i : known;
        }
        int colour = ui.choice("colour", COLOURS, known);
        if (colour != known) {
            editor.change(
                    "colour",
                    e -> e.withLook(e.look().withRgb(colour == 0 ? null : (Integer) RGB[colour])));
        }
        texture(ui, look);
        Integer typed = fields.rgb(ui, "colour #", rgb);
        if (typed != null && !typed.equals(rgb)) {
            editor.change("colour", e -> e.withLook(e.look().withRgb(typed)));
        }
    }

    /** That of the shape, the built-in ones, a file. */
    private static List<String> textureNames() {
        List<String> names = new ArrayList<>(List.of("of the shape"));
        for (String name : LookSpec.TEXTURES) {
            names.add(name.substring(LookSpec.BUILT_IN.length()).replace('-', ' '));
        }
        names.add("a file");
        return List.copyOf(names);
    }

    /** The place of a texture in {@link #TEXTURE_NAMES}; null is that of the shape. */
    private static int textureChoice(@Nullable String texture) {
        if (texture == null) {
            return 0;
        }
        int builtIn = LookSpec.TEXTURES.indexOf(texture);
        return builtIn < 0 ? FROM_FILE : 1 + builtIn;
    }

    private void texture(Ui ui, LookSpec look) {
        String texture = look.texture();
        int known = textureChoice(texture);
        int chosen = ui.choice("texture", TEXTURE_NAMES, known);
        if (chosen != known) {
            String wanted =
                    chosen == 0
                            ? null
                            : chosen == FROM_FILE
                                    ? "picture.png"
                                    : LookSpec.TEXTURES.get(chosen - 1);
            editor.change(
                    "texture of", e -> e.withLook(e.look().withTexture(wanted, look.tileMetres())));
        }
        if (texture == null) {
            return;
        }
        if (known == FROM_FILE) {
            String file = ui.textField("picture (.png)", texture);
            if (!file.equals(texture) && !file.isBlank()) {
                editor.change(
                        "texture of",
                        e -> e.withLook(e.look().withTexture(file, look.tileMetres())));
            }
        }
        double tile = fields.number(ui, "tile, m", look.tileMetres());
        if (tile != look.tileMetres() && tile >= 0) {
            editor.change("texture of", e -> e.withLook(e.look().withTexture(texture, tile)));
        }
    }

    private void place(Ui ui, EntitySpec entity) {
        ui.heading("Place and size");
        Xyz position = fields.xyz(ui, "position", entity.position());
        if (!position.equals(entity.position())) {
            editor.change("move", e -> e.at(position, e.rotation()));
        }
        Turn turn = entity.rotation();
        rotation.set(turn.x(), turn.y(), turn.z(), turn.w()).normalize().getEulerAnglesYXZ(angles);
        double yaw = degrees(ui, "yaw", angles.y, 180, "about the upward axis, degrees");
        double pitch = degrees(ui, "pitch", angles.x, 90, "about the sideward axis, degrees");
        double roll = degrees(ui, "roll", angles.z, 180, "about the forward axis, degrees");
        if (yaw != angles.y || pitch != angles.x || roll != angles.z) {
            Quaterniond q = new Quaterniond().rotateYXZ(yaw, pitch, roll).normalize();
            editor.change("turn", e -> e.at(e.position(), new Turn(q.x, q.y, q.z, q.w)));
        }
        Xyz scale = entity.scale();
        if (entity.shape() instanceof GroundShape) {
            return;
        }
        double all = ui.slider("scale", scale.x(), 0.02, 50, 0, "of all three axes");
        if (all != scale.x()) {
            double factor = all / scale.x();
            editor.change(
                    "scale",
                    e ->
                            e.withScale(
                                    new Xyz(
                                            all,
                                            scale.y() == scale.x() ? all : scale.y() * factor,
                                            scale.z() == scale.x() ? all : scale.z() * factor)));
        }
        if (!entity.physics().parts().isEmpty()) {
            return; // three equal factors
        }
        Xyz each = fields.xyz(ui, "scale", scale);
        if (!each.equals(scale)) {
            editor.change("scale", e -> e.withScale(each));
        }
    }

    private static double degrees(Ui ui, String label, double radians, double most, String hint) {
        // A turn about two axes leaves rounding in the third, which is not worth to be read.
        double before = Math.rint(Math.toDegrees(radians) * 1e9) / 1e9;
        double after = ui.slider(label, before, -most, most, 1, hint);
        return after == before ? radians : Math.toRadians(after);
    }

    private void substance(Ui ui, EntitySpec entity) {
        if (entity.body() == BodyKind.NONE) {
            return;
        }
        ui.heading("Substance");
        Material old = entity.material();
        double friction = ui.slider("friction", old.friction(), 0, 1.5, 0.05, "Coulomb's");
        double bounce = ui.slider("restitution", old.restitution(), 0, 1, 0.05, "0 to 1");
        double millimetres = 1e3 * old.rollingArm();
        double arm =
                ui.slider("rolling arm, mm", millimetres, 0, 50, 0.5, "torque over force, N m/N");
        if (friction != old.friction() || bounce != old.restitution() || arm != millimetres) {
            double metres = arm == millimetres ? old.rollingArm() : 1e-3 * arm;
            editor.change(
                    "material of",
                    e ->
                            e.withMaterial(
                                    e.material()
                                            .withFriction(friction)
                                            .withRestitution(bounce)
                                            .withRollingArm(metres),
                                    e.mass()));
        }
        if (entity.body() != BodyKind.DYNAMIC) {
            return;
        }
        Double mass = entity.mass();
        boolean own = ui.checkbox("a mass instead of a density", mass != null);
        if (own != (mass != null)) {
            double start = own ? massOf(entity) : 1;
            editor.change(
                    "mass of", e -> e.withMaterial(e.material(), own ? (Double) start : null));
        } else if (mass != null) {
            double typed = fields.number(ui, "mass, kg", mass);
            if (typed != mass && typed > 0) {
                editor.change("mass of", e -> e.withMaterial(e.material(), typed));
            }
        } else {
            double density = fields.number(ui, "density, kg/m³", old.density());
            if (density != old.density() && density > 0) {
                editor.change(
                        "density of",
                        e -> e.withMaterial(e.material().withDensity(density), e.mass()));
            }
        }
    }

    private static double massOf(EntitySpec entity) {
        double sum = 0;
        for (PartSpec part : entity.parts()) {
            if (part.shape() instanceof MeshShape || part.shape().isSurface()) {
                return entity.material().density();
            }
            Material own = part.material();
            double density = (own == null ? entity.material() : own).density();
            sum +=
                    part.sensor()
                            ? 0
                            : part.shape().collider(entity.scale()).massProperties(density).mass();
        }
        return sum > 0 ? sum : 1;
    }

    private void motion(Ui ui, EntitySpec entity) {
        if (entity.body() != BodyKind.DYNAMIC && entity.body() != BodyKind.KINEMATIC) {
            return;
        }
        ui.heading("Motion at the beginning");
        Xyz velocity = fields.xyz(ui, "velocity", entity.velocity());
        Xyz spin = fields.xyz(ui, "spin", entity.angularVelocity());
        if (!velocity.equals(entity.velocity()) || !spin.equals(entity.angularVelocity())) {
            editor.change("motion of", e -> e.moving(velocity, spin));
        }
    }

    /** Begins a joint at the selected entity. */
    private void newJoint(Ui ui) {
        if (!ui.section("New joint", false)) {
            return;
        }
        jointKind = ui.choice("kind of joint", JointSpec.KINDS, jointKind);
        jointAxis = ui.choice("its axis", AXES, jointAxis);
        ui.columns(2);
        boolean toBody = ui.button("To a body...");
        boolean toWorld = ui.button("To the world...");
        if (toBody || toWorld) {
            editor.joints()
                    .begin(JointSpec.KINDS.get(jointKind), DIRECTIONS.get(jointAxis), toWorld);
        }
        ui.endSection();
    }
}
