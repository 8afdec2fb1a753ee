package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.mesh.Meshed;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * All colliders as a structure of arrays: a collider is a shape on a body, with a surface. Broad
 * phase, pairs, narrow phase and queries speak of colliders; solver, islands, sleep and forces
 * speak of bodies. A body has one or more, in a list from {@link BodyStore#collider} on.
 *
 * <p>Colliders and bodies have slots of one space: a body's only collider has the body's slot, and
 * so its pose. The colliders of a body with several, its children, have slots that no body has;
 * their poses are composed of the body's and of where they are in it. Simulation thread, and blocks
 * of its stages, only.
 */
public final class ColliderStore implements Stateful {
    /** In place of a collider where there is none. */
    public static final int NONE = -1;

    /** The bodies that have them. */
    public final BodyStore bodies;

    /** Where the colliders are: columns that they share with the bodies. */
    public final Poses poses;

    /** One past the highest slot in use. */
    public int slotCount;

    /** Slot of the body that has it; stays until the slot is used again. */
    public int[] body = {};

    /** The body's next collider, or {@link #NONE}. */
    public int[] next = {};

    /** Its geometry is about the collider's centre. */
    public Shape[] shape = {};

    /** What it collides with. */
    public Filter[] filter = {};

    /** What the shape's surface is made of, see {@link Surface}. */
    public byte[] surface = {};

    /** Radii of the shape's inner and outer ball about its centre, m. */
    public double[] innerRadius = {}, outerRadius = {};

    /** Coulomb coefficient. */
    public double[] friction = {};

    /** Newton's coefficient of restitution, 0..1. */
    public double[] restitution = {};

    /** Rules by which friction (lower four bits) and restitution are mixed, see {@link Mix}. */
    public byte[] mixing = {};

    /** Whether any surface moves along, or did; until then {@link #belt} is empty. */
    public boolean belts;

    /** Velocity of the surface against its body, body axes, m/s; three numbers. */
    public double[] belt = {};

    /** Whether any collider is, or was, a surface of triangles. */
    public boolean surfaces;

    /** Whether any collider is, or was, a sensor. */
    public boolean sensors;

    /** Whether it only tells which bodies are in it, and pushes nothing. */
    public boolean[] sensor = {};

    /** What the user attached. */
    public @Nullable Object[] userData = {};

    /** Of surfaces with several materials. Follows from what the colliders were made of. */
    public final Palettes palettes = new Palettes();

    /** Arm of rolling friction, m. */
    public double[] rollingArm = {};

    /** Whether any body has, or had, several colliders; until then {@link #local} is empty. */
    public boolean compounds;

    /**
     * Of a child: from the body's centre of mass to the collider's centre, body axes, m, and the
     * unit quaternion body from collider; {@link #LOCAL} numbers.
     */
    public double[] local = {};

    /** Numbers of a collider in {@link #local}. */
    public static final int LOCAL = 7;

    /** Whether any body has, or had, a whole. */
    public boolean wholes;

    /**
     * Of a child that a whole stands for, and of the whole itself: one more than the slot of the
     * whole; 0 for others. A <em>whole</em> is the convex shape that several parts of a body make:
     * it is solved in place of them, see {@code WholeStage}. Users do not see it.
     */
    public int[] whole = {};

    /** By body with several colliders: one more than the whole that all of them make, or 0. */
    public int[] sole = {};

    /** Slots of the bodies with several colliders, in the order in which they became such. */
    public int[] compound = new int[16];

    /** How many there are. */
    public int compoundCount;

    private static final double[] NOTHING = {};
    private static final int[] NO_SLOTS = {};

    private final double[] turned = new double[3];
    private final Columns.Kept kept = new Columns.Kept();

    /**
     * Without colliders.
     *
     * @param bodies that will have them
     */
    public ColliderStore(BodyStore bodies) {
        this.bodies = bodies;
        poses = bodies;
    }

    /**
     * Grows every column to at least {@code capacity} slots; between phases only.
     *
     * @param capacity slots that must fit
     */
    public void ensureCapacity(int capacity) {
        if (capacity > body.length) {
            columns(
                    new Columns.Growth(
                            Math.max(capacity, Math.max(16, body.length + (body.length >> 1)))));
        }
    }

    /**
     * Declares the columns.
     *
     * @param c what is done to them
     */
    public void columns(Columns c) {
        body = c.column("body", body);
        next = c.column("next", next);
        shape = c.column("shape", shape);
        filter = c.column("filter", filter);
        surface = c.column("surface", surface);
        innerRadius = c.column("innerRadius", innerRadius);
        outerRadius = c.column("outerRadius", outerRadius);
        friction = c.column("friction", friction);
        restitution = c.column("restitution", restitution);
        mixing = c.column("mixing", mixing);
        sensor = c.column("sensor", sensor);
        userData = c.column("userData", userData);
        rollingArm = c.column("rollingArm", rollingArm);
        if (belts) {
            belt = c.column("belt", belt, 3);
        }
        if (compounds) {
            local = c.column("local", local, LOCAL);
            whole = c.column("whole", whole);
            sole = c.column("sole", sole);
        }
    }

    @Override
    public void state(StateVisitor s) {
        s.section("colliders", this);
        slotCount = s.count("slotCount", slotCount);
        belts = s.value("belts", belts);
        sensors = s.value("sensors", sensors);
        compounds = s.value("compounds", compounds);
        wholes = s.value("wholes", wholes);
        surfaces = s.value("surfaces", surfaces);
        compoundCount = s.value("compoundCount", compoundCount);
        compound = s.array("compound", compound, compoundCount);
        if (s.isRestoring()) {
            belt = belts ? belt : NOTHING;
            local = compounds ? local : NOTHING;
            whole = compounds ? whole : NO_SLOTS;
            sole = compounds ? sole : NO_SLOTS;
        }
        ensureCapacity(slotCount);
        columns(kept.of(s, slotCount, body.length, false));
    }

    /**
     * Makes the only collider of a body, about its centre of mass.
     *
     * @param slot of the body
     * @param geometry about that centre; where it is in the body's frame does not matter
     * @return the collider's slot
     */
    public int attach(int slot, Shape geometry) {
        bodies.collider[slot] = slot;
        Shape solid = Surface.aboutCentre(geometry);
        bodies.isBall[slot] = solid instanceof Sphere;
        fill(slot, slot, solid);
        return slot;
    }

    /**
     * Makes one of several colliders of a body, the last in its list. Its pose is that of the next
     * {@link #compose}.
     *
     * @param slot of the body, whose list is empty or of children
     * @param collider a slot of its own
     * @param solid neither moved nor turned
     * @param pose as in {@link #local}
     */
    public void append(int slot, int collider, Shape solid, double[] pose) {
        if (!compounds) {
            compounds = true;
            columns(new Columns.Growth(body.length));
        }
        bodies.isBall[slot] = false;
        fill(slot, collider, solid);
        int first = bodies.collider[slot];
        if (first == NONE) {
            bodies.collider[slot] = collider;
            if (compoundCount == compound.length) {
                compound = Arrays.copyOf(compound, 2 * compoundCount);
            }
            compound[compoundCount++] = slot;
        } else {
            int last = first;
            while (next[last] != NONE) {
                last = next[last];
            }
            next[last] = collider;
        }
        System.arraycopy(pose, 0, local, LOCAL * collider, LOCAL);
    }

    /**
     * Whether a collider is what parts make, and none that users know.
     *
     * @param collider its slot
     * @return false for all that users made
     */
    public boolean isWhole(int collider) {
        return wholes && whole[collider] == collider + 1;
    }

    /**
     * What is solved for a collider.
     *
     * @param collider its slot
     * @return the whole that it is a part of, or itself
     */
    public int standIn(int collider) {
        return wholes && whole[collider] > 0 ? whole[collider] - 1 : collider;
    }

    /**
     * Whether a collider has a whole that stands for it.
     *
     * @param collider its slot
     * @return false for a whole
     */
    public boolean isPart(int collider) {
        return standIn(collider) != collider;
    }

    /**
     * Whether a body is solved as several colliders.
     *
     * @param slot of the body
     * @return false for one of a single collider, and for one whose parts make one convex shape
     */
    public boolean hasParts(int slot) {
        return bodies.collider[slot] != slot && sole[slot] == 0;
    }

    /**
     * Gives a collider another shape; what contacts know of it holds no more.
     *
     * @param collider its slot
     * @param geometry about its centre
     */
    public void replace(int collider, Shape geometry) {
        int slot = body[collider];
        Shape solid = Surface.aboutCentre(geometry);
        bodies.isBall[slot] = collider == slot && solid instanceof Sphere;
        setShape(collider, solid);
    }

    private void fill(int slot, int collider, Shape solid) {
        slotCount = Math.max(slotCount, collider + 1);
        ensureCapacity(slotCount);
        body[collider] = slot;
        next[collider] = NONE;
        if (compounds) {
            whole[collider] = 0;
            sole[collider] = 0;
        }
        filter[collider] = Filter.ALL;
        setShape(collider, solid);
    }

    private void setShape(int collider, Shape solid) {
        shape[collider] = solid;
        surface[collider] = Surface.of(solid);
        Surface.revolution(solid, bodies.revolution, BodyStore.REVOLUTION * collider);
        surfaces |= Surface.isMeshed(solid);
        bodies.curved |= surface[collider] != Surface.CORNERED;
        innerRadius[collider] = solid.innerRadius();
        outerRadius[collider] = solid.outerRadius();
    }

    /**
     * Sets the velocity of a collider's surface, behind its palette.
     *
     * @param collider its slot
     * @param x body axes, m/s
     * @param y body axes, m/s
     * @param z body axes, m/s
     */
    public void setBelt(int collider, double x, double y, double z) {
        if (!belts) {
            if (x == 0 && y == 0 && z == 0 && !palettes.runs(collider)) {
                return;
            }
            belts = true;
            columns(new Columns.Growth(body.length));
        }
        belt[3 * collider] = x;
        belt[3 * collider + 1] = y;
        belt[3 * collider + 2] = z;
    }

    /** Whether a collider is a surface of triangles. */
    public boolean isSurface(int collider) {
        return Surface.isMeshed(shape[collider]);
    }

    /**
     * Where in its palette the material of a surface's triangle begins.
     *
     * @return -1 for the collider's own material
     */
    public int material(int collider, int triangle) {
        return palettes.has(collider) && Surface.unmoved(shape[collider]) instanceof Meshed mesh
                ? palettes.at(collider, mesh.material(triangle))
                : -1;
    }

    /**
     * Whether a collider has its place from {@link #local}.
     *
     * @param collider its slot
     * @return false for a body's only one
     */
    public boolean isChild(int collider) {
        return body[collider] != collider;
    }

    /**
     * Takes a child out of its body's list.
     *
     * @param slot of the body
     * @param collider slot of the child
     */
    public void remove(int slot, int collider) {
        if (bodies.collider[slot] == collider) {
            if (next[collider] == NONE) {
                detach(slot);
            } else {
                bodies.collider[slot] = next[collider];
            }
            return;
        }
        int before = bodies.collider[slot];
        while (next[before] != collider) {
            before = next[before];
        }
        next[before] = next[collider];
    }

    /**
     * A body has no colliders any more.
     *
     * @param slot of the body
     */
    public void detach(int slot) {
        if (bodies.collider[slot] != slot) {
            int at = 0;
            while (at < compoundCount && compound[at] != slot) {
                at++;
            }
            if (at < compoundCount) {
                System.arraycopy(compound, at + 1, compound, at, --compoundCount - at);
            }
        }
        bodies.collider[slot] = NONE;
    }

    /**
     * Finds the balls about a body, and whether a surface of it runs along. A body of several parts
     * may be hollow where its centre is: then the smallest ball in a part says how small it is.
     * Between steps.
     *
     * @param slot of the body, which has colliders
     */
    public void measure(int slot) {
        BodyStore b = bodies;
        int first = b.collider[slot];
        b.hasBelt[slot] = false;
        for (int c = first; belts && c != NONE; c = next[c]) {
            int u = 3 * c;
            b.hasBelt[slot] |= belt[u] != 0 || belt[u + 1] != 0 || belt[u + 2] != 0;
            b.hasBelt[slot] |= palettes.runs(c);
        }
        if (b.hasBelt[slot] && b.belts == 0) {
            b.belts = 1;
            b.driven++;
        }
        if (first == slot) {
            b.innerRadius[slot] = innerRadius[slot];
            b.outerRadius[slot] = outerRadius[slot];
            return;
        }
        double inner = 0;
        double least = Double.POSITIVE_INFINITY;
        double outer = 0;
        for (int c = first; c != NONE; c = next[c]) {
            if (isPart(c)) {
                continue; // inside of its whole
            }
            int l = LOCAL * c;
            double x = local[l];
            double y = local[l + 1];
            double z = local[l + 2];
            double arm = Math.sqrt(x * x + y * y + z * z);
            inner = Math.max(inner, innerRadius[c] - arm);
            least = Math.min(least, innerRadius[c]);
            outer = Math.max(outer, outerRadius[c] + arm);
        }
        b.innerRadius[slot] = Math.max(inner, least);
        b.outerRadius[slot] = outer;
        compose(slot);
    }

    /**
     * Puts the children of a body where they are now. Simulation thread.
     *
     * @param slot of the body
     */
    public void compose(int slot) {
        compose(slot, turned);
    }

    /**
     * Puts the children of a body where they are now: x' = x + q o, q' = q r. What rounding takes
     * of a position far from the origin is kept, as the body's. Any worker, one to a body.
     *
     * @param slot of the body
     * @param v room for three numbers
     */
    public void compose(int slot, double[] v) {
        BodyStore b = bodies;
        double qx = b.orientationX[slot];
        double qy = b.orientationY[slot];
        double qz = b.orientationZ[slot];
        double qw = b.orientationW[slot];
        for (int c = b.collider[slot]; c != NONE && c != slot; c = next[c]) {
            int l = LOCAL * c;
            Rotations.rotate(qx, qy, qz, qw, local[l], local[l + 1], local[l + 2], v);
            b.positionX[c] = b.positionX[slot];
            b.positionY[c] = b.positionY[slot];
            b.positionZ[c] = b.positionZ[slot];
            System.arraycopy(b.positionLow, 3 * slot, b.positionLow, 3 * c, 3);
            b.outerRadius[c] = b.outerRadius[slot];
            b.move(c, v[0], v[1], v[2]);
            double rx = local[l + 3];
            double ry = local[l + 4];
            double rz = local[l + 5];
            double rw = local[l + 6];
            b.orientationX[c] = qw * rx + qx * rw + qy * rz - qz * ry;
            b.orientationY[c] = qw * ry - qx * rz + qy * rw + qz * rx;
            b.orientationZ[c] = qw * rz + qx * ry - qy * rx + qz * rw;
            b.orientationW[c] = qw * rw - qx * rx - qy * ry - qz * rz;
        }
    }
}
