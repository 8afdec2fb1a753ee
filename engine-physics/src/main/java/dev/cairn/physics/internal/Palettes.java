package dev.cairn.physics.internal;

import java.util.Arrays;

/**
 * Of colliders whose triangles have numbers of materials: what each number from 1 on is, beside the
 * collider's own material, which is 0. Simulation thread; allocates when it grows.
 */
public final class Palettes {
    /**
     * Numbers of a material: friction, restitution, arm of rolling friction, rules of mixing, and
     * from {@link #BELT} the velocity of the surface.
     */
    public static final int MATERIAL = 7;

    /** Where in a material its surface's velocity is, body axes, m/s. */
    public static final int BELT = 4;

    private static final double[] NOTHING = {};

    private double[][] materials = {};

    Palettes() {}

    /** Whether any collider has, or had, several materials. */
    public boolean any() {
        return materials.length > 0;
    }

    /** Whether a collider has materials beside its own. */
    boolean has(int collider) {
        return of(collider).length > 0;
    }

    /**
     * The materials of a collider.
     *
     * @return {@link #MATERIAL} numbers of each; not to be changed
     */
    public double[] of(int collider) {
        return collider < materials.length ? materials[collider] : NOTHING;
    }

    /**
     * Where among those of a collider a material begins.
     *
     * @param number of the material
     * @return -1 for the collider's own
     */
    int at(int collider, int number) {
        int at = MATERIAL * (number - 1);
        return at < of(collider).length ? at : -1;
    }

    /** Whether the surface of one of a collider's materials runs along. */
    boolean runs(int collider) {
        double[] all = of(collider);
        boolean runs = false;
        for (int at = BELT; at < all.length; at += MATERIAL) {
            runs |= all[at] != 0 || all[at + 1] != 0 || all[at + 2] != 0;
        }
        return runs;
    }

    /** Gives a collider other ones. */
    public void set(int collider, double[] all) {
        if (materials.length <= collider) {
            if (all.length == 0) {
                return;
            }
            int old = materials.length;
            materials = Arrays.copyOf(materials, Math.max(2 * old, collider + 1));
            Arrays.fill(materials, old, materials.length, NOTHING);
        }
        materials[collider] = all;
    }
}
