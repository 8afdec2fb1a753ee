package dev.cairn.physics.internal;

import java.util.Arrays;

/**
 * All contacts of this tick as a structure of arrays; a contact is a row in {@code [0, count)}, one
 * row per pair of bodies whose fat bounds overlap. Rows without points ({@code pointCount == 0})
 * take no part in the solve.
 *
 * <p>Points are stored four to a row: point {@code p} of row {@code c} is at {@code 4 * c + p}. The
 * normal is a unit vector in world axes from body A to body B. Anchors are the contact point,
 * midway between the surfaces, relative to each body's centre of mass, in world axes at the start
 * of the tick, in metres. Impulses are what warm-starts the next tick.
 */
public final class ContactStore {
    /** Makes an empty store. */
    public ContactStore() {}

    /** Points per row. */
    public static final int POINTS = 4;

    /** Numbers per row in {@link #kept}. */
    public static final int KEPT = 24;

    /** Rows in use. */
    public int count;

    /** Rows that take part in this tick: entries of {@link #active} in use. */
    public int activeCount;

    /**
     * The rows that take part in this tick, ascending. Rows of bodies that sleep are not among
     * them: their points and impulses stay as they are.
     */
    public int[] active = {};

    /** Slots of the two bodies; at least one of them is dynamic. */
    public int[] bodyA = {}, bodyB = {};

    /** 0 to 4. */
    public int[] pointCount = {};

    /**
     * Mean distance of the patch's area from its middle over that of its points; 0 when the points
     * are all of the patch.
     */
    public double[] patch = {};

    /** Unit normal from A to B, world. */
    public double[] normalX = {}, normalY = {}, normalZ = {};

    /** Mixed Coulomb coefficient. */
    public double[] friction = {};

    /** Mixed coefficient of restitution, 0..1. */
    public double[] restitution = {};

    /** 1 while the bodies touch: since they came within reach they have overlapped or pushed. */
    public byte[] touching = {};

    /** The narrow phase's warm-start word; 0 if there is none. */
    public long[] cache = {};

    /** Whether {@link #kept} holds something of a row. */
    public boolean[] keeps = {};

    /**
     * Relative pose and points when a pair of boxes was last collided; the manifold stage's own.
     */
    public double[] kept = {};

    /**
     * Friction impulse at the patch centre in world axes, N s over the last sub-step; warm start.
     */
    public double[] frictionImpulseX = {}, frictionImpulseY = {}, frictionImpulseZ = {};

    /** Twist impulse about the normal, N m s over the last sub-step; warm start. */
    public double[] twistImpulse = {};

    /** Per point: contact point relative to A's and B's centres of mass, world axes, m. */
    public double[] anchorAX = {},
            anchorAY = {},
            anchorAZ = {},
            anchorBX = {},
            anchorBY = {},
            anchorBZ = {};

    /**
     * Per point: signed distance of the surfaces along the normal, m; negative when they overlap.
     */
    public double[] separation = {};

    /**
     * Per point: id of the features that touch; equal ids in successive ticks are the same point.
     */
    public int[] feature = {};

    /** Per point: normal impulse of the last sub-step, N s, never negative; warm start. */
    public double[] normalImpulse = {};

    /**
     * Per point: the resting load that the solver has learnt, N s over a sub-step, never negative;
     * carried with the point like {@link #normalImpulse}, 0 for a new one.
     */
    public double[] preload = {};

    /**
     * Per point: sum of the normal impulses over the tick, N s; what users read as the contact's
     * impulse.
     */
    public double[] totalNormalImpulse = {};

    /** Makes every row take part. */
    public void activateAll() {
        for (int row = 0; row < count; row++) {
            active[row] = row;
        }
        activeCount = count;
    }

    /**
     * Grows every column to at least {@code capacity} rows; between phases only.
     *
     * @param capacity rows that must fit
     */
    public void ensureCapacity(int capacity) {
        if (capacity <= bodyA.length) {
            return;
        }
        int n = Math.max(capacity, Math.max(64, bodyA.length + (bodyA.length >> 1)));
        int m = n * POINTS;
        active = Arrays.copyOf(active, n);
        bodyA = Arrays.copyOf(bodyA, n);
        bodyB = Arrays.copyOf(bodyB, n);
        pointCount = Arrays.copyOf(pointCount, n);
        patch = Arrays.copyOf(patch, n);
        normalX = Arrays.copyOf(normalX, n);
        normalY = Arrays.copyOf(normalY, n);
        normalZ = Arrays.copyOf(normalZ, n);
        friction = Arrays.copyOf(friction, n);
        restitution = Arrays.copyOf(restitution, n);
        touching = Arrays.copyOf(touching, n);
        cache = Arrays.copyOf(cache, n);
        keeps = Arrays.copyOf(keeps, n);
        kept = Arrays.copyOf(kept, n * KEPT);
        frictionImpulseX = Arrays.copyOf(frictionImpulseX, n);
        frictionImpulseY = Arrays.copyOf(frictionImpulseY, n);
        frictionImpulseZ = Arrays.copyOf(frictionImpulseZ, n);
        twistImpulse = Arrays.copyOf(twistImpulse, n);
        anchorAX = Arrays.copyOf(anchorAX, m);
        anchorAY = Arrays.copyOf(anchorAY, m);
        anchorAZ = Arrays.copyOf(anchorAZ, m);
        anchorBX = Arrays.copyOf(anchorBX, m);
        anchorBY = Arrays.copyOf(anchorBY, m);
        anchorBZ = Arrays.copyOf(anchorBZ, m);
        separation = Arrays.copyOf(separation, m);
        feature = Arrays.copyOf(feature, m);
        normalImpulse = Arrays.copyOf(normalImpulse, m);
        preload = Arrays.copyOf(preload, m);
        totalNormalImpulse = Arrays.copyOf(totalNormalImpulse, m);
    }
}
