package dev.cairn.samples.editor;

import dev.cairn.physics.Material;
import dev.cairn.physics.collider.Filter;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * The fields of one collider: place, turn, sensor, run of its surface, and what of substance and
 * layers is its own. Window thread; makes no garbage while nothing is typed.
 */
@SuppressWarnings("ReferenceEquality") // what nobody typed into is the same object
final class PartFields {
    /** Colliders that have fields; more would be a list without an end. */
    static final int MOST = 12;

    private static final String[] PART = names("collider");
    private static final String[] AT = names("at");
    private static final String[] TURN = names("degrees");
    private static final String[] SENSOR = names("sensor");
    private static final String[] RUN = names("runs");
    private static final String[] SUBSTANCE = names("own substance");
    private static final String[] FRICTION = names("friction of");
    private static final String[] BOUNCE = names("restitution of");
    private static final String[] DENSITY = names("density of");
    private static final String[] LAYERS = names("own layers");
    private static final String[] GROUP = names("group of");

    private final Fields fields;

    /** Angles about x, y and z of the colliders that were shown last, degrees. */
    private final List<Xyz> degrees = new ArrayList<>();

    private List<PartSpec> shown = List.of();
    private List<String> known = List.of();

    /** By collider and layer. */
    private String[][] isIn = {};

    private String[][] meets = {};

    PartFields(Fields fields) {
        this.fields = fields;
    }

    private static String[] names(String word) {
        String[] names = new String[MOST];
        for (int i = 0; i < MOST; i++) {
            names[i] = word + " " + i;
        }
        return names;
    }

    /** Before the fields of an entity's colliders. */
    void show(List<PartSpec> parts, List<String> layers) {
        if (parts != shown) {
            shown = parts;
            degrees.clear();
            for (PartSpec part : parts) {
                Turn q = part.rotation();
                Vector3d a = new Vector3d();
                new Quaterniond(q.x(), q.y(), q.z(), q.w()).normalize().getEulerAnglesYXZ(a);
                degrees.add(new Xyz(Math.toDegrees(a.x), Math.toDegrees(a.y), Math.toDegrees(a.z)));
            }
        }
        if (layers != known) {
            known = layers;
            isIn = labels(" is ");
            meets = labels(" meets ");
        }
    }

    private String[][] labels(String verb) {
        String[][] labels = new String[MOST][known.size()];
        for (int i = 0; i < MOST; i++) {
            for (int bit = 0; bit < known.size(); bit++) {
                labels[i][bit] = i + verb + known.get(bit);
            }
        }
        return labels;
    }

    /** Returns the same object if nothing was typed. */
    PartSpec draw(Ui ui, PartSpec old, int i, Material material, Filter filter) {
        ui.value(PART[i], old.shape().type());
        Xyz at = fields.xyz(ui, AT[i], old.position());
        Xyz turn = fields.xyz(ui, TURN[i], degrees.get(i));
        boolean sensor = ui.checkbox(SENSOR[i], old.sensor());
        Material whole = old.material() == null ? material : old.material();
        Xyz before = old.surfaceVelocity() == null ? run(whole) : old.surfaceVelocity();
        Xyz run = fields.xyz(ui, RUN[i], before);
        PartSpec part = at == old.position() ? old : old.at(at);
        part = turn == degrees.get(i) ? part : part.turned(turn(turn));
        part = sensor == old.sensor() ? part : part.withSensor(sensor);
        part = run == before ? part : part.withSurfaceVelocity(run.equals(run(whole)) ? null : run);
        return layers(ui, substance(ui, part, i, material), i, filter);
    }

    /** At which velocity a material lets its surface run along, m/s. */
    static Xyz run(Material material) {
        return new Xyz(material.surfaceX(), material.surfaceY(), material.surfaceZ());
    }

    private static Turn turn(Xyz degrees) {
        Quaterniond q =
                new Quaterniond()
                        .rotationYXZ(
                                Math.toRadians(degrees.y()),
                                Math.toRadians(degrees.x()),
                                Math.toRadians(degrees.z()));
        return new Turn(q.x, q.y, q.z, q.w);
    }

    private PartSpec substance(Ui ui, PartSpec old, int i, Material whole) {
        boolean own = ui.checkbox(SUBSTANCE[i], old.material() != null);
        if (own != (old.material() != null)) {
            return old.withMaterial(own ? whole : null);
        }
        Material m = old.material();
        if (m == null) {
            return old;
        }
        double friction = fields.number(ui, FRICTION[i], m.friction());
        double bounce = fields.number(ui, BOUNCE[i], m.restitution());
        double density = fields.number(ui, DENSITY[i], m.density());
        boolean same =
                friction == m.friction() && bounce == m.restitution() && density == m.density();
        boolean possible = friction >= 0 && bounce >= 0 && bounce <= 1 && density > 0;
        return same || !possible
                ? old
                : old.withMaterial(
                        m.withFriction(friction).withRestitution(bounce).withDensity(density));
    }

    private PartSpec layers(Ui ui, PartSpec old, int i, Filter whole) {
        boolean own = ui.checkbox(LAYERS[i], old.filter() != null);
        if (own != (old.filter() != null)) {
            return old.withFilter(own ? whole : null);
        }
        Filter f = old.filter();
        if (f == null) {
            return old;
        }
        long category = f.category();
        long mask = f.mask();
        for (int k = 0; k < known.size(); k++) {
            category = bit(category, k, ui.checkbox(isIn[i][k], (category >>> k & 1) != 0));
            mask = bit(mask, k, ui.checkbox(meets[i][k], (mask >>> k & 1) != 0));
        }
        int group = group(fields.number(ui, GROUP[i], f.group()), f.group());
        return category == f.category() && mask == f.mask() && group == f.group()
                ? old
                : old.withFilter(new Filter(category, mask, group));
    }

    /** A group is a whole number; what is none changes nothing. */
    static int group(double typed, int before) {
        boolean isGroup = typed == Math.rint(typed) && Math.abs(typed) < Integer.MAX_VALUE;
        return isGroup ? (int) typed : before;
    }

    static long bit(long bits, int bit, boolean on) {
        return on ? bits | 1L << bit : bits & ~(1L << bit);
    }
}
