package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * Reads the four points of a pair in a batch whose face was clipped to a quadrilateral in lanes.
 * Without loops, so that indices are checked once.
 */
final class AlignedPoints {
    private AlignedPoints() {}

    /** Whether the four names are those of the last tick, from {@code first} on in an order. */
    static boolean named(double[] t, int i, int[] names, int first, int order) {
        int entry = (int) t[ALIGNED + i];
        return names[first] == AlignedFeatureIds.name(entry, order & 3)
                && names[first + 1] == AlignedFeatureIds.name(entry, order >> 2 & 3)
                && names[first + 2] == AlignedFeatureIds.name(entry, order >> 4 & 3)
                && names[first + 3] == AlignedFeatureIds.name(entry, order >> 6 & 3);
    }

    /** Writes names, points and separations; returns the key. */
    static long copy(double[] t, int i, Manifold out) {
        int entry = (int) t[ALIGNED + i];
        int order = AlignedFeatureIds.order(entry);
        int a = at(order, i);
        int b = at(order >> 2, i);
        int c = at(order >> 4, i);
        int d = at(order >> 6, i);
        double ax = t[a];
        double ay = t[a + CAPACITY];
        double az = t[a + 2 * CAPACITY];
        double as = t[a + 3 * CAPACITY];
        double bx = t[b];
        double by = t[b + CAPACITY];
        double bz = t[b + 2 * CAPACITY];
        double bs = t[b + 3 * CAPACITY];
        double cx = t[c];
        double cy = t[c + CAPACITY];
        double cz = t[c + 2 * CAPACITY];
        double cs = t[c + 3 * CAPACITY];
        double dx = t[d];
        double dy = t[d + CAPACITY];
        double dz = t[d + 2 * CAPACITY];
        double ds = t[d + 3 * CAPACITY];
        out.pointCount = 4;
        four(out.pointX, ax, bx, cx, dx);
        four(out.pointY, ay, by, cy, dy);
        four(out.pointZ, az, bz, cz, dz);
        four(out.separation, as, bs, cs, ds);
        int[] name = out.feature;
        name[3] = AlignedFeatureIds.name(entry, 3);
        name[0] = AlignedFeatureIds.name(entry, 0);
        name[1] = AlignedFeatureIds.name(entry, 1);
        name[2] = AlignedFeatureIds.name(entry, 2);
        return AlignedFeatureIds.key(entry);
    }

    private static int at(int place, int i) {
        return CORNER + POINT * (place & 3) + i;
    }

    private static void four(double[] to, double a, double b, double c, double d) {
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to[3] = d;
    }

    /** Writes the contact but the names, see {@link BoxContacts#write}; returns the key. */
    static long write(
            double[] t,
            int i,
            int places,
            double[] normal,
            int n,
            double[] anchors,
            int at,
            double[] separation,
            int first) {
        normal[n] = t[NORMAL + i];
        normal[n + 1] = t[NORMAL + CAPACITY + i];
        normal[n + 2] = t[NORMAL + 2 * CAPACITY + i];
        int entry = (int) t[ALIGNED + i];
        int order = AlignedFeatureIds.order(entry);
        separation[first] = write(t, i, at(order >> (places << 1 & 6), i), anchors, at);
        separation[first + 1] = write(t, i, at(order >> (places >> 1 & 6), i), anchors, at + 6);
        separation[first + 2] = write(t, i, at(order >> (places >> 3 & 6), i), anchors, at + 12);
        separation[first + 3] = write(t, i, at(order >> (places >> 5 & 6), i), anchors, at + 18);
        return AlignedFeatureIds.key(entry);
    }

    private static double write(double[] t, int i, int from, double[] anchors, int at) {
        double x = t[from];
        double y = t[from + CAPACITY];
        double z = t[from + 2 * CAPACITY];
        double s = t[from + 3 * CAPACITY];
        anchors[at] = x;
        anchors[at + 1] = y;
        anchors[at + 2] = z;
        anchors[at + 3] = x - t[OFFSET + i];
        anchors[at + 4] = y - t[OFFSET + CAPACITY + i];
        anchors[at + 5] = z - t[OFFSET + 2 * CAPACITY + i];
        return s;
    }
}
