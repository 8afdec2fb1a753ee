package dev.cairn.physics.narrowphase;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.CAPACITY;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CENTRE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FACE_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FACE_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.OFFSET;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.RELATIVE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_EDGE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.TURN_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.TURN_B;

import dev.cairn.physics.narrowphase.wide.BoxAxes;
import dev.cairn.physics.narrowphase.wide.BoxBatch;
import dev.cairn.physics.shape.Box;

/**
 * Contacts of pairs of boxes in batches: the fifteen axes of all pairs by {@link BoxAxes}, then
 * pair by pair what {@link NarrowPhase} does, by the same rules and with the same results, for face
 * contacts and pairs that are apart. The rest (an edge, a corner) goes to {@link NarrowPhase}.
 *
 * <p>One instance per worker; not thread-safe; allocates nothing.
 */
public final class BoxContacts {
    /**
     * Thinner boxes (inner by outer radius) take the other way: rounding would hide their thickness
     * from a support point.
     */
    private static final double THINNEST = 1e-9;

    private final BoxBatch batch = new BoxBatch();
    private final double[] t = batch.data;
    private final BoxFaces faces = new BoxFaces();
    private final NarrowPhase single;

    /** Of the pair at hand. */
    private int faceA, faceB;

    private double separationA, separationB;

    /**
     * An empty batch.
     *
     * @param single collides what is no face contact; by the fast paths
     */
    public BoxContacts(NarrowPhase single) {
        this.single = single;
    }

    /**
     * Whether a box may be put into a batch.
     *
     * @param box any
     * @return false for extremely thin ones
     */
    public static boolean fits(Box box) {
        return box.innerRadius() >= THINNEST * box.outerRadius();
    }

    /**
     * Puts a pair into the batch. The arguments are those of {@link NarrowPhase#collide}.
     *
     * @param i its place, 0 to {@link BoxBatch#CAPACITY} - 1
     * @param a first shape
     * @param b second shape
     * @param qAx orientation of A
     * @param qAy orientation of A
     * @param qAz orientation of A
     * @param qAw orientation of A
     * @param qBx orientation of B
     * @param qBy orientation of B
     * @param qBz orientation of B
     * @param qBw orientation of B
     * @param dx centre of B minus centre of A, world axes, m
     * @param dy see {@code dx}
     * @param dz see {@code dx}
     */
    public void put(
            int i,
            Box a,
            Box b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz) {
        t[TURN_A + i] = qAx;
        t[TURN_A + CAPACITY + i] = qAy;
        t[TURN_A + 2 * CAPACITY + i] = qAz;
        t[TURN_A + 3 * CAPACITY + i] = qAw;
        t[TURN_B + i] = qBx;
        t[TURN_B + CAPACITY + i] = qBy;
        t[TURN_B + 2 * CAPACITY + i] = qBz;
        t[TURN_B + 3 * CAPACITY + i] = qBw;
        t[OFFSET + i] = dx;
        t[OFFSET + CAPACITY + i] = dy;
        t[OFFSET + 2 * CAPACITY + i] = dz;
        t[HALF_A + i] = a.halfX();
        t[HALF_A + CAPACITY + i] = a.halfY();
        t[HALF_A + 2 * CAPACITY + i] = a.halfZ();
        t[HALF_B + i] = b.halfX();
        t[HALF_B + CAPACITY + i] = b.halfY();
        t[HALF_B + 2 * CAPACITY + i] = b.halfZ();
    }

    /**
     * Finds the axes of all pairs that were put.
     *
     * @param count how many
     */
    public void findAxes(int count) {
        BoxAxes.run(batch, count);
    }

    /**
     * The contact of one pair, after {@link #findAxes}. The arguments are those of {@link
     * NarrowPhase#collide}, and so is the result; of {@link Manifold#bound} only the rounding
     * differs.
     *
     * @param i its place
     * @param a first shape
     * @param b second shape
     * @param inner the smaller of the inner radii, m
     * @param margin points up to this far apart are reported, m, not negative
     * @param cache the word that the last call for this pair returned; 0 if there is none
     * @param out receives the contact
     * @return the word to pass next time
     */
    public long collide(
            int i, Box a, Box b, double inner, double margin, long cache, Manifold out) {
        out.pointCount = 0;
        out.bound = 0;
        out.capped = false;
        if (stillApart(i, cache, margin)) {
            return cache;
        }
        separationA = t[SEPARATION_A + i];
        faceA = (int) t[FACE_A + i];
        if (separationA > margin) {
            return NarrowPhase.word(NarrowPhase.FACE_A, faceA, 0);
        }
        separationB = t[SEPARATION_B + i];
        faceB = (int) t[FACE_B + i];
        if (separationB > margin) {
            return NarrowPhase.word(NarrowPhase.FACE_B, faceB, 0);
        }
        double best = Math.max(Math.max(separationA, separationB), t[SEPARATION_EDGE + i]);
        if (best > margin) {
            boolean onB = separationB > separationA;
            return onB
                    ? NarrowPhase.word(NarrowPhase.FACE_B, faceB, 0)
                    : NarrowPhase.word(NarrowPhase.FACE_A, faceA, 0);
        }
        double calm = NarrowPhase.CALM * inner;
        boolean flip = chooseFace(i, a, b, cache, calm);
        int face = flip ? faceB : faceA;
        double deepest = faces.face(t, i, flip, face, inner, margin, (int) cache, out);
        double better =
                cache >>> 62 == NarrowPhase.EDGES
                        ? 0.5 * calm + 0.05 * Math.abs(best)
                        : 1.5 * calm + 0.15 * Math.abs(best);
        boolean strays =
                Math.abs(deepest - best) > better
                        || best - (flip ? separationB : separationA) > better;
        if (out.pointCount == 0 || strays) {
            return single(i, a, b, margin, cache, out);
        }
        out.bound = Math.abs(best - deepest) + 0x1p-48 * scale(i);
        return NarrowPhase.word(
                flip ? NarrowPhase.FACE_B : NarrowPhase.FACE_A, face, Names.of(out));
    }

    private long single(int i, Box a, Box b, double margin, long cache, Manifold out) {
        return single.collide(
                a,
                b,
                t[TURN_A + i],
                t[TURN_A + CAPACITY + i],
                t[TURN_A + 2 * CAPACITY + i],
                t[TURN_A + 3 * CAPACITY + i],
                t[TURN_B + i],
                t[TURN_B + CAPACITY + i],
                t[TURN_B + 2 * CAPACITY + i],
                t[TURN_B + 3 * CAPACITY + i],
                t[OFFSET + i],
                t[OFFSET + CAPACITY + i],
                t[OFFSET + 2 * CAPACITY + i],
                margin,
                cache,
                out);
    }

    /** At least what rounding errors are proportional to. */
    private double scale(int i) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum +=
                    t[HALF_A + k * CAPACITY + i]
                            + t[HALF_B + k * CAPACITY + i]
                            + Math.abs(t[CENTRE + k * CAPACITY + i]);
        }
        return sum;
    }

    /** The face that separated or carried the pair last time separates it now. */
    private boolean stillApart(int i, long cache, double margin) {
        long kind = cache >>> 62;
        int face = (int) (cache >>> 47) & 0x7FFF;
        if (kind == NarrowPhase.FACE_A && face < 6) {
            return alongA(i, face) > margin;
        }
        return kind == NarrowPhase.FACE_B && face < 6 && alongB(i, face) > margin;
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
    private boolean chooseFace(int i, Box a, Box b, long cache, double calm) {
        long before = cache >>> 62;
        int last = (int) (cache >>> 47) & 0x7FFF;
        double enough = Math.max(separationA, separationB) - calm;
        if (before == NarrowPhase.FACE_A && last != faceA && last < 6) {
            double s = alongA(i, last);
            if (s >= enough) {
                faceA = last;
                separationA = s;
            }
        }
        if (before == NarrowPhase.FACE_B && last != faceB && last < 6) {
            double s = alongB(i, last);
            if (s >= enough) {
                faceB = last;
                separationB = s;
            }
        }
        double bias = before == NarrowPhase.FACE_A ? calm : -calm;
        if (before != NarrowPhase.FACE_A && before != NarrowPhase.FACE_B) {
            double far = Math.max(Math.abs(t[CENTRE + i]), Math.abs(t[CENTRE + CAPACITY + i]));
            far = Math.max(far, Math.abs(t[CENTRE + 2 * CAPACITY + i]));
            bias = 0x1p-40 * (a.outerRadius() + b.outerRadius() + far);
        }
        return separationB > separationA + bias;
    }
}
