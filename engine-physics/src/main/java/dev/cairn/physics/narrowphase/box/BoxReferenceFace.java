package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;

/**
 * Chooses, pair by pair of a batch, whether two boxes are apart, and else which face is the
 * reference, by the rules of {@code NarrowPhase}. The same in lanes, for the usual pairs: {@link
 * dev.cairn.physics.narrowphase.wide.BoxAxes#choose}.
 */
final class BoxReferenceFace {
    /** Columns of the batch. */
    private final double[] t;

    /** Of each pair: whether it is on a face, or else apart. */
    final boolean[] onFace = new boolean[CAPACITY];

    /** The key of the last tick; of a pair that is apart then that for the next one. */
    final long[] key = new long[CAPACITY];

    /** The largest separation along an axis, and that along the reference face, m. */
    final double[] best = new double[CAPACITY], separation = new double[CAPACITY];

    /**
     * Of each pair on a face: whether two edges are tried before the face is clipped; after {@link
     * #choose} whether they separate by so much more that {@link #crosses} has to tell.
     */
    final boolean[] crosses = new boolean[CAPACITY];

    /** See {@link BoxContacts#leftOut}. */
    final double[] leftOut = new double[CAPACITY];

    /** Of the pair at hand. */
    private int faceA, faceB;

    private double separationA, separationB;

    final BoxEdgeContact crossing;

    BoxReferenceFace(double[] columns) {
        t = columns;
        crossing = new BoxEdgeContact(columns);
    }

    private void load(int i) {
        separationA = t[SEPARATION_A + i];
        faceA = (int) t[FACE_A + i];
        separationB = t[SEPARATION_B + i];
        faceB = (int) t[FACE_B + i];
    }

    /** Whether a pair is apart by an axis of a face; needs no axes of edges. */
    boolean apartByFaces(int i) {
        load(i);
        double distance = t[MARGIN + i];
        onFace[i] = false;
        if (stillApart(i, key[i], distance)) {
            return true;
        }
        leftOut[i] = separationA;
        if (separationA > distance) {
            key[i] = WarmStartKey.of(WarmStartKey.FACE_A, faceA, 0);
            return true;
        }
        leftOut[i] = separationB;
        if (separationB > distance) {
            key[i] = WarmStartKey.of(WarmStartKey.FACE_B, faceB, 0);
            return true;
        }
        return false;
    }

    /** Decides whether a pair that is not apart by faces is so by edges, and else on its face. */
    void choose(int i) {
        load(i);
        best[i] = Math.max(Math.max(separationA, separationB), t[SEPARATION_EDGE + i]);
        leftOut[i] = best[i];
        if (best[i] > t[MARGIN + i]) {
            onFace[i] = false;
            boolean onB = separationB > separationA;
            key[i] =
                    onB
                            ? WarmStartKey.of(WarmStartKey.FACE_B, faceB, 0)
                            : WarmStartKey.of(WarmStartKey.FACE_A, faceA, 0);
            return;
        }
        onFace[i] = true;
        boolean flip = chooseFace(i, key[i], ContactTolerances.HYSTERESIS * t[INNER + i]);
        int face = flip ? faceB : faceA;
        separation[i] = flip ? separationB : separationA;
        t[FLIP + i] = flip ? 1 : 0;
        t[AXIS + i] = face >> 1;
        t[SIGN + i] = (face & 1) == 0 ? -1 : 1;
        crosses[i] = best[i] - separation[i] > better(i);
    }

    /** Decides between edges and face by their directions, as {@code HullPairs} does. */
    void crosses(int i, boolean wide) {
        if (wide) {
            crosses[i] =
                    t[EDGE + i] >= 0 && t[CROSSING_COSINE + i] <= ContactTolerances.NEARLY_PARALLEL;
            return;
        }
        int face = 2 * (int) t[AXIS + i] + (t[SIGN + i] > 0 ? 1 : 0);
        crosses[i] =
                crossing.place(i)
                        && crossing.cosine(i, t[FLIP + i] != 0, face)
                                <= ContactTolerances.NEARLY_PARALLEL;
    }

    /** Whether the face contact tells another depth than the best axis, see {@code NarrowPhase}. */
    boolean strays(int i, double least) {
        return Math.abs(least - best[i]) > better(i);
    }

    /** How much truer a point contact must be, as in {@code HullPairs}. */
    private double better(int i) {
        return ContactTolerances.depthError(
                key[i] >>> 62 == WarmStartKey.EDGES,
                ContactTolerances.HYSTERESIS * t[INNER + i],
                best[i]);
    }

    /** The face that separated or carried the pair last time separates it now. */
    private boolean stillApart(int i, long cache, double distance) {
        long before = cache >>> 62;
        int face = (int) (cache >>> 47) & 0x7FFF;
        if (before == WarmStartKey.FACE_A && face < 6) {
            leftOut[i] = face == faceA ? separationA : alongA(i, face);
            return leftOut[i] > distance;
        }
        if (before == WarmStartKey.FACE_B && face < 6) {
            leftOut[i] = face == faceB ? separationB : alongB(i, face);
            return leftOut[i] > distance;
        }
        return false;
    }

    /** Separation along the normal of a face of A. */
    private double alongA(int i, int face) {
        int k = face >> 1;
        int row = RELATIVE + 3 * k * CAPACITY + i;
        double extent =
                Math.abs(t[row]) * t[HALF_B + i]
                        + Math.abs(t[row + CAPACITY]) * t[HALF_B + CAPACITY + i]
                        + Math.abs(t[row + 2 * CAPACITY]) * t[HALF_B + 2 * CAPACITY + i];
        double along = t[CENTRE + k * CAPACITY + i];
        return ((face & 1) == 0 ? -along : along) - (t[HALF_A + k * CAPACITY + i] + extent);
    }

    /** Separation along the normal of a face of B. */
    private double alongB(int i, int face) {
        int k = face >> 1;
        double x = t[RELATIVE + k * CAPACITY + i];
        double y = t[RELATIVE + (3 + k) * CAPACITY + i];
        double z = t[RELATIVE + (6 + k) * CAPACITY + i];
        double extent =
                Math.abs(x) * t[HALF_A + i]
                        + Math.abs(y) * t[HALF_A + CAPACITY + i]
                        + Math.abs(z) * t[HALF_A + 2 * CAPACITY + i];
        double along =
                t[CENTRE + i] * x + t[CENTRE + CAPACITY + i] * y + t[CENTRE + 2 * CAPACITY + i] * z;
        return ((face & 1) == 0 ? along : -along) - (t[HALF_B + k * CAPACITY + i] + extent);
    }

    /**
     * The reference face: the face of the last tick while it is nearly as good as the best; true
     * when it is B's.
     */
    private boolean chooseFace(int i, long cache, double hysteresis) {
        long before = cache >>> 62;
        int last = (int) (cache >>> 47) & 0x7FFF;
        if (before == WarmStartKey.FACE_A && last != faceA && last < 6) {
            double s = alongA(i, last);
            if (s >= Math.max(separationA, separationB) - hysteresis) {
                faceA = last;
                separationA = s;
            }
        }
        if (before == WarmStartKey.FACE_B && last != faceB && last < 6) {
            double s = alongB(i, last);
            if (s >= Math.max(separationA, separationB) - hysteresis) {
                faceB = last;
                separationB = s;
            }
        }
        double bias = before == WarmStartKey.FACE_A ? hysteresis : -hysteresis;
        if (before != WarmStartKey.FACE_A && before != WarmStartKey.FACE_B) {
            double far = Math.max(Math.abs(t[CENTRE + i]), Math.abs(t[CENTRE + CAPACITY + i]));
            far = Math.max(far, Math.abs(t[CENTRE + 2 * CAPACITY + i]));
            bias = 0x1p-40 * (outerRadius(HALF_A + i) + outerRadius(HALF_B + i) + far);
        }
        return separationB > separationA + bias;
    }

    private double outerRadius(int half) {
        double x = t[half];
        double y = t[half + CAPACITY];
        double z = t[half + 2 * CAPACITY];
        return Math.sqrt(x * x + y * y + z * z);
    }
}
