package dev.cairn.physics.internal;

import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateVisitor;

import java.util.Arrays;

/**
 * The points of contacts in a state, told by what cannot be foreseen, so that the difference of two
 * states is small. With a and b the anchors of point p, d its separation and n the normal: both
 * anchors are one point, so b - a is the same vector for all points of a row; and that point is
 * midway between the surfaces, of which one is a plane:
 *
 * <pre>
 *   b[p] ~ b[0] + (a[p] - a[0])
 *   d[p] ~ d[0] + 2 n . (a[p] - a[0])
 * </pre>
 *
 * but for rounding. What is kept is the difference of the bits of both sides; a guess that fails
 * costs room and nothing else. The first point goes by 0. Points that a row does not have are 0.
 */
final class PackedPoints {
    private static final int POINTS = ContactColumns.POINTS;
    private static final int ANCHORS = ContactColumns.ANCHORS;
    private static final int ROW = POINTS * ANCHORS;

    private long[] anchors = {};
    private long[] separation = {};

    /** Hands the points of all rows over. */
    void state(StateVisitor s, ContactStore c) {
        int rows = c.count;
        if (separation.length < POINTS * rows) {
            anchors = new long[ROW * c.bodyA.length];
            separation = new long[POINTS * c.bodyA.length];
        }
        for (int row = 0; row < rows && !s.isRestoring(); row++) {
            pack(c, row);
        }
        anchors = s.array("anchors", anchors, ROW * rows);
        separation = s.array("separation", separation, POINTS * rows);
        for (int row = 0; row < rows && s.isRestoring(); row++) {
            unpack(c, row);
        }
    }

    private void pack(ContactStore c, int row) {
        double[] at = c.anchors;
        double[] head = c.head;
        int points = c.pointCount[row];
        int i = ContactColumns.anchor(POINTS * row);
        int o = ROW * row;
        int p = POINTS * row;
        int n = ContactColumns.head(row);
        double nx = 2 * head[n];
        double ny = 2 * head[n + 1];
        double nz = 2 * head[n + 2];
        double ax = at[i];
        double ay = at[i + 1];
        double az = at[i + 2];
        double bx = 0;
        double by = 0;
        double bz = 0;
        double d = 0;
        for (int end = p + points; p < end; p++, i += ANCHORS, o += ANCHORS) {
            double x = at[i] - ax;
            double y = at[i + 1] - ay;
            double z = at[i + 2] - az;
            anchors[o] = Double.doubleToRawLongBits(at[i]);
            anchors[o + 1] = Double.doubleToRawLongBits(at[i + 1]);
            anchors[o + 2] = Double.doubleToRawLongBits(at[i + 2]);
            anchors[o + 3] = less(at[i + 3], bx + x);
            anchors[o + 4] = less(at[i + 4], by + y);
            anchors[o + 5] = less(at[i + 5], bz + z);
            separation[p] = less(c.separation[p], d + (nx * x + ny * y + nz * z));
            if (p == POINTS * row) {
                bx = at[i + 3];
                by = at[i + 4];
                bz = at[i + 5];
                d = c.separation[p];
            }
        }
        if (points < POINTS) {
            Arrays.fill(anchors, o, ROW * row + ROW, 0);
            Arrays.fill(separation, p, POINTS * row + POINTS, 0);
        }
    }

    private void unpack(ContactStore c, int row) {
        double[] at = c.anchors;
        double[] head = c.head;
        int points = c.pointCount[row];
        if (points < 0 || points > POINTS) {
            throw new StateException(
                    "the state is damaged: contact " + row + " has " + points + " points, of 4");
        }
        int first = ContactColumns.anchor(POINTS * row);
        int i = first;
        int o = ROW * row;
        int p = POINTS * row;
        int n = ContactColumns.head(row);
        double nx = 2 * head[n];
        double ny = 2 * head[n + 1];
        double nz = 2 * head[n + 2];
        double ax = Double.longBitsToDouble(anchors[o]);
        double ay = Double.longBitsToDouble(anchors[o + 1]);
        double az = Double.longBitsToDouble(anchors[o + 2]);
        double bx = 0;
        double by = 0;
        double bz = 0;
        double d = 0;
        for (int end = p + points; p < end; p++, i += ANCHORS, o += ANCHORS) {
            at[i] = Double.longBitsToDouble(anchors[o]);
            at[i + 1] = Double.longBitsToDouble(anchors[o + 1]);
            at[i + 2] = Double.longBitsToDouble(anchors[o + 2]);
            double x = at[i] - ax;
            double y = at[i + 1] - ay;
            double z = at[i + 2] - az;
            at[i + 3] = more(anchors[o + 3], bx + x);
            at[i + 4] = more(anchors[o + 4], by + y);
            at[i + 5] = more(anchors[o + 5], bz + z);
            c.separation[p] = more(separation[p], d + (nx * x + ny * y + nz * z));
            if (p == POINTS * row) {
                bx = at[i + 3];
                by = at[i + 4];
                bz = at[i + 5];
                d = c.separation[p];
            }
        }
        if (points < POINTS) {
            Arrays.fill(at, i, first + ROW, 0);
            Arrays.fill(c.separation, p, POINTS * row + POINTS, 0);
        }
    }

    /** Small numbers for bits that are near, of either sign. */
    private static long less(double x, double foreseen) {
        long d = Double.doubleToRawLongBits(x) - Double.doubleToRawLongBits(foreseen);
        return (d << 1) ^ (d >> 63);
    }

    private static double more(long packed, double foreseen) {
        long d = (packed >>> 1) ^ -(packed & 1);
        return Double.longBitsToDouble(Double.doubleToRawLongBits(foreseen) + d);
    }
}
