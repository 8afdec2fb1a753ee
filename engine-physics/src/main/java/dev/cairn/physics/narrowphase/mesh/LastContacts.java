package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;

/** What a pair's contacts were in the last tick, so that the same points are chosen again. */
final class LastContacts {
    /** In world axes, three numbers each. */
    private double[] normals = {};

    private int[] names = {};
    private int count;

    /** Refers to these until the next call. */
    void set(double[] ofNormals, int[] ofNames, int ofCount) {
        normals = ofNormals;
        names = ofNames;
        count = ofCount;
    }

    void clear() {
        count = 0;
    }

    boolean isEmpty() {
        return count == 0;
    }

    /** The names of the one whose normal is nearest to this one, in world axes; 0 if none is. */
    int nearest(double x, double y, double z) {
        double most = ContactTolerances.NEARLY_PARALLEL;
        int found = 0;
        for (int i = 0; i < count; i++) {
            double dot = x * normals[3 * i] + y * normals[3 * i + 1] + z * normals[3 * i + 2];
            if (dot > most) {
                most = dot;
                found = names[i];
            }
        }
        return found;
    }
}
