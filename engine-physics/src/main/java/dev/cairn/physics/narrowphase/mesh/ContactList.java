package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;

import java.util.Arrays;

/**
 * The contacts of some pairs, one after the other: from the surface to the convex shape, in world
 * axes, points from the convex shape's centre. Grows when there are more than ever.
 */
public final class ContactList {
    /** Numbers of a contact: normal, patch, then of each point place and separation. */
    private static final int NUMBERS = 4 + 4 * Manifold.POINTS;

    /** Contacts. */
    public int count;

    /** Contacts that have room from the beginning. */
    private static final int FIRST = 32;

    private double[] number = new double[FIRST * NUMBERS];
    private int[] points = new int[FIRST];
    private int[] feature = new int[FIRST * Manifold.POINTS];
    private int[] triangle = new int[FIRST];

    /** Without contacts. */
    public ContactList() {}

    /** Adds what a manifold holds: normal from surface to shape, points from the shape's centre. */
    void add(Manifold m, int ofTriangle) {
        if (count == points.length) {
            ensureCapacity(2 * count);
        }
        triangle[count] = ofTriangle;
        int at = NUMBERS * count;
        number[at] = m.normalX;
        number[at + 1] = m.normalY;
        number[at + 2] = m.normalZ;
        number[at + 3] = m.patch;
        for (int p = 0; p < m.pointCount; p++) {
            int to = at + 4 + 4 * p;
            number[to] = m.pointX[p];
            number[to + 1] = m.pointY[p];
            number[to + 2] = m.pointZ[p];
            number[to + 3] = m.separation[p];
            feature[Manifold.POINTS * count + p] = m.feature[p];
        }
        points[count++] = m.pointCount;
    }

    /** How many contacts there is room for. */
    public int capacity() {
        return points.length;
    }

    /** Makes room for so many contacts. */
    public void ensureCapacity(int contacts) {
        if (contacts > points.length) {
            points = Arrays.copyOf(points, contacts);
            triangle = Arrays.copyOf(triangle, contacts);
            number = Arrays.copyOf(number, NUMBERS * contacts);
            feature = Arrays.copyOf(feature, Manifold.POINTS * contacts);
        }
    }

    /** How many points a contact has. */
    public int pointCount(int contact) {
        return points[contact];
    }

    /** The triangle under the deepest point, by the number of the user. */
    public int triangle(int contact) {
        return triangle[contact];
    }

    /** The id of a point, the surface's features as those of A. */
    public int feature(int contact, int point) {
        return feature[Manifold.POINTS * contact + point];
    }

    /** How far a point is apart, m. */
    public double separation(int contact, int point) {
        return number[NUMBERS * contact + 4 + 4 * point + 3];
    }

    /** A component of the normal, from the surface to the shape, world axes. */
    public double normal(int contact, int axis) {
        return number[NUMBERS * contact + axis];
    }

    /**
     * Hands a contact over as that of two shapes A and B.
     *
     * @param isFirst whether the surface is A
     * @param dx the shape's centre minus the surface's, world axes, m
     */
    public void get(int contact, boolean isFirst, double dx, double dy, double dz, Manifold out) {
        int at = NUMBERS * contact;
        double sign = isFirst ? 1 : -1;
        out.normalX = sign * number[at];
        out.normalY = sign * number[at + 1];
        out.normalZ = sign * number[at + 2];
        out.patch = number[at + 3];
        out.pointCount = 0;
        for (int p = 0; p < points[contact]; p++) {
            int from = at + 4 + 4 * p;
            int name = feature(contact, p);
            out.insert(
                    isFirst ? name : swapped(name),
                    number[from + 3],
                    number[from] + (isFirst ? dx : 0),
                    number[from + 1] + (isFirst ? dy : 0),
                    number[from + 2] + (isFirst ? dz : 0));
        }
    }

    /** The id with A for B and B for A; crossings have names of their own, the same both ways. */
    public static int swapped(int name) {
        int kind = name & FeatureIds.CLOSEST;
        boolean isVertex = kind == FeatureIds.VERTEX_A || kind == FeatureIds.VERTEX_B;
        return isVertex ? name ^ FeatureIds.VERTEX_B : name;
    }
}
