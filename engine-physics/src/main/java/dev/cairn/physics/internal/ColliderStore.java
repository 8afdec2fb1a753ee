package dev.cairn.physics.internal;

import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import java.util.Arrays;

/**
 * All colliders as a structure of arrays: a collider is a shape on a body, with a surface. Broad
 * phase, pairs, narrow phase and queries speak of colliders; solver, islands, sleep and forces
 * speak of bodies. A body has one or more, in a list from {@link BodyStore#collider} on.
 *
 * <p>A collider is a slot in {@code [0, slotCount)}; free slots are used again last freed first.
 * Simulation thread, and blocks of its stages, only.
 */
public final class ColliderStore {
    /** In place of a collider where there is none. */
    public static final int NONE = -1;

    /** The bodies that have them. */
    public final BodyStore bodies;

    /**
     * Where the colliders are. A body's only collider is about the body's centre of mass and has
     * its slot, so these are the bodies' own columns and nothing is copied.
     */
    public final Poses poses;

    /** One past the highest slot in use. */
    public int slotCount;

    /** Slot of the body that has it; stays until the slot is used again. */
    public int[] body = {};

    /** The body's next collider, or {@link #NONE}. */
    public int[] next = {};

    /** Its geometry is about the collider's centre. */
    public Shape[] shape = {};

    /** What the shape's surface is made of, see {@link Surface}. */
    public byte[] surface = {};

    /** Radii of the shape's inner and outer ball about its centre, m. */
    public double[] innerRadius = {}, outerRadius = {};

    /** Coulomb coefficient. */
    public double[] friction = {};

    /** Newton's coefficient of restitution, 0..1. */
    public double[] restitution = {};

    /** Arm of rolling friction, m. */
    public double[] rollingArm = {};

    private int[] free = new int[16];
    private int freeCount;

    /**
     * Without colliders.
     *
     * @param bodies who will have them
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
        surface = c.column("surface", surface);
        innerRadius = c.column("innerRadius", innerRadius);
        outerRadius = c.column("outerRadius", outerRadius);
        friction = c.column("friction", friction);
        restitution = c.column("restitution", restitution);
        rollingArm = c.column("rollingArm", rollingArm);
    }

    /**
     * Makes the only collider of a body, about its centre of mass.
     *
     * @param slot of the body
     * @param geometry about that centre; where it is in the body's frame does not matter
     * @return the collider's slot
     */
    public int attach(int slot, Shape geometry) {
        int collider = freeCount > 0 ? free[--freeCount] : slotCount++;
        ensureCapacity(slotCount);
        assert collider == slot : "the poses of a body are those of its collider";
        bodies.collider[slot] = collider;
        body[collider] = slot;
        next[collider] = NONE;
        Shape solid = Surface.aboutCentre(geometry);
        shape[collider] = solid;
        surface[collider] = Surface.of(solid);
        bodies.isBall[slot] = solid instanceof Sphere;
        innerRadius[collider] = geometry.innerRadius();
        outerRadius[collider] = geometry.outerRadius();
        return collider;
    }

    /**
     * Gives a collider, the only one of its body, another shape.
     *
     * @param collider whose
     * @param geometry about the body's centre of mass
     */
    public void replace(int collider, Shape geometry) {
        Shape solid = Surface.aboutCentre(geometry);
        shape[collider] = solid;
        surface[collider] = Surface.of(solid);
        bodies.isBall[body[collider]] = solid instanceof Sphere;
        innerRadius[collider] = geometry.innerRadius();
        outerRadius[collider] = geometry.outerRadius();
    }

    /**
     * Frees the slots of a body's colliders, which have no rows any more.
     *
     * @param slot of the body
     */
    public void detach(int slot) {
        for (int c = bodies.collider[slot]; c != NONE; c = next[c]) {
            if (freeCount == free.length) {
                free = Arrays.copyOf(free, 2 * freeCount);
            }
            free[freeCount++] = c;
        }
    }
}
