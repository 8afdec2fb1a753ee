package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

/** {@code IncidentPlane} for a pair of a batch of boxes, with the same operations. */
final class BoxIncidentPlane {
    private BoxIncidentPlane() {}

    /**
     * How far above a point of the reference box's frame the plane of the incident face is, m,
     * along that normal.
     */
    static double above(
            double[] t,
            int i,
            boolean flip,
            int incident,
            int axis,
            double normal,
            double px,
            double py,
            double pz) {
        int k = incident >> 1;
        double m = (incident & 1) == 0 ? -1 : 1;
        double h = t[(flip ? HALF_A : HALF_B) + k * CAPACITY + i];
        // A column of the rotation, or a row.
        int at = RELATIVE + (flip ? 3 * k : k) * CAPACITY + i;
        int step = flip ? CAPACITY : 3 * CAPACITY;
        double x = m * t[at];
        double y = m * t[at + step];
        double z = m * t[at + 2 * step];
        double dx = t[CENTRE + i];
        double dy = t[CENTRE + CAPACITY + i];
        double dz = t[CENTRE + 2 * CAPACITY + i];
        double offset =
                flip ? h - m * (k == 0 ? dx : k == 1 ? dy : dz) : h + (x * dx + y * dy + z * dz);
        double cosine = normal * (axis == 0 ? x : axis == 1 ? y : z);
        return (offset - (x * px + y * py + z * pz)) / cosine;
    }
}
