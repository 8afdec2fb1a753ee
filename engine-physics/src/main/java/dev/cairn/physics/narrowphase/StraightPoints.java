package dev.cairn.physics.narrowphase;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.CAPACITY;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CORNER;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CUT_SEPARATION;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.NORMAL;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.OFFSET;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STRAIGHT;

/**
 * Reads the four points of a pair in a batch that was cut straight. Without loops, so that indices
 * are checked once.
 */
final class StraightPoints {
    private StraightPoints() {}

    /** Whether the four names are those of the last tick, from {@code first} on. */
    static boolean named(double[] t, int i, int[] names, int first) {
        int entry = (int) t[STRAIGHT + i];
        return names[first] == StraightNames.name(entry, 0)
                && names[first + 1] == StraightNames.name(entry, 1)
                && names[first + 2] == StraightNames.name(entry, 2)
                && names[first + 3] == StraightNames.name(entry, 3);
    }

    /** Writes names, points and separations; returns the word. */
    static long copy(double[] t, int i, Manifold out) {
        int entry = (int) t[STRAIGHT + i];
        int order = StraightNames.order(entry);
        out.pointCount = 4;
        copy(t, i, entry, 0, order & 3, out);
        copy(t, i, entry, 1, order >> 2 & 3, out);
        copy(t, i, entry, 2, order >> 4 & 3, out);
        copy(t, i, entry, 3, order >> 6 & 3, out);
        return StraightNames.word(entry);
    }

    private static void copy(double[] t, int i, int entry, int p, int place, Manifold out) {
        int at = CORNER + 3 * CAPACITY * place + i;
        out.pointX[p] = t[at];
        out.pointY[p] = t[at + CAPACITY];
        out.pointZ[p] = t[at + 2 * CAPACITY];
        out.separation[p] = t[CUT_SEPARATION + place * CAPACITY + i];
        out.feature[p] = StraightNames.name(entry, p);
    }

    /** Writes the contact but the names, see {@link BoxContacts#write}; returns the word. */
    static long write(
            double[] t,
            int i,
            double[] normal,
            int n,
            double[] anchors,
            int at,
            double[] separation,
            int first) {
        normal[n] = t[NORMAL + i];
        normal[n + 1] = t[NORMAL + CAPACITY + i];
        normal[n + 2] = t[NORMAL + 2 * CAPACITY + i];
        int entry = (int) t[STRAIGHT + i];
        int order = StraightNames.order(entry);
        separation[first] = write(t, i, order & 3, anchors, at);
        separation[first + 1] = write(t, i, order >> 2 & 3, anchors, at + 6);
        separation[first + 2] = write(t, i, order >> 4 & 3, anchors, at + 12);
        separation[first + 3] = write(t, i, order >> 6 & 3, anchors, at + 18);
        return StraightNames.word(entry);
    }

    private static double write(double[] t, int i, int place, double[] anchors, int at) {
        int from = CORNER + 3 * CAPACITY * place + i;
        double x = t[from];
        double y = t[from + CAPACITY];
        double z = t[from + 2 * CAPACITY];
        anchors[at] = x;
        anchors[at + 1] = y;
        anchors[at + 2] = z;
        anchors[at + 3] = x - t[OFFSET + i];
        anchors[at + 4] = y - t[OFFSET + CAPACITY + i];
        anchors[at + 5] = z - t[OFFSET + 2 * CAPACITY + i];
        return t[CUT_SEPARATION + place * CAPACITY + i];
    }
}
