package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * A certificate of separation or penetration: bounds of the signed distance d of a pair that were
 * proven at an earlier relative pose, together with the separations of the faces that might have
 * been the reference, and what of both holds at the present pose. Seen from the larger shape, no
 * point of the smaller one has moved since by more than
 *
 * <pre>m = sqrt(2 (|de|^2 + 4 |dq|^2 R^2))</pre>
 *
 * where e is its centre, q the relative orientation (a unit quaternion) and R its outer radius. The
 * separation along an axis that is fixed in the larger shape changes by at most as much, and the
 * signed distance is the largest of these, so it does too. The separation along a face, of either
 * shape, has changed by at most what the other one's points have moved as seen from it, for which R
 * is the larger radius and the distance of the centres. While a decision is the same for all values
 * that this leaves, it needs no other certificate. Moves count from the pose of the certificate;
 * they do not add up.
 */
public final class DistanceCertificate {
    /** Numbers in which a certificate is kept. Zeros are a pose that no pair is near. */
    static final int SIZE = 11;

    private static final int CENTRE = 4, LOW = 7, HIGH = 8, RIVAL = 9, FACE = 10;

    /** Of the pair's scale: what rounding adds to a move. */
    private static final double ROUNDING = 0x1p-48;

    /** Bounds of the signed distance at the present pose, m. */
    double low, high;

    /** The best face of those that were weighed separates by at most this, m. */
    double rival;

    /** The pose is that of the certificate to the last bit. */
    boolean same;

    /** The face of which {@link #rival} tells, on B or not. */
    int face;

    boolean onB;

    /** Nothing is proven. */
    void none() {
        low = Double.NEGATIVE_INFINITY;
        high = Double.POSITIVE_INFINITY;
        rival = Double.POSITIVE_INFINITY;
        same = false;
    }

    /**
     * Takes what a place tells about the present pose; nothing when the move alone is more than any
     * depth may be wrong by.
     */
    void recall(Pair p, long[] memory, int at, double hysteresis) {
        boolean second = movesB(p);
        double ex = centreX(p, second) - Double.longBitsToDouble(memory[at + CENTRE]);
        double ey = centreY(p, second) - Double.longBitsToDouble(memory[at + CENTRE + 1]);
        double ez = centreZ(p, second) - Double.longBitsToDouble(memory[at + CENTRE + 2]);
        double slide = ex * ex + ey * ey + ez * ez;
        low = Double.longBitsToDouble(memory[at + LOW]);
        high = Double.longBitsToDouble(memory[at + HIGH]);
        double most = 1.5 * hysteresis + 0.15 * Math.max(Math.abs(low), Math.abs(high));
        if (2 * slide > most * most) {
            none();
            return;
        }
        double x = p.qx - Double.longBitsToDouble(memory[at]);
        double y = p.qy - Double.longBitsToDouble(memory[at + 1]);
        double z = p.qz - Double.longBitsToDouble(memory[at + 2]);
        double w = p.qw - Double.longBitsToDouble(memory[at + 3]);
        double turn = 4 * (x * x + y * y + (z * z + w * w));
        rival = Double.longBitsToDouble(memory[at + RIVAL]);
        same = turn + slide == 0;
        if (!same) {
            double radius = second ? p.b.outerRadius() : p.a.outerRadius();
            double rounding = ROUNDING * p.scale;
            double moved = Math.sqrt(2 * (slide + radius * radius * turn)) + rounding;
            low -= moved;
            high += moved;
            rival += Math.sqrt(2 * (slide + 4 * p.scale * p.scale * turn)) + rounding;
        }
        rival = Math.min(high, rival);
        face = (int) memory[at + FACE] >>> 1;
        onB = (memory[at + FACE] & 1) != 0;
    }

    /**
     * Keeps what is proven at the present pose.
     *
     * @param best along the best of the faces that were weighed; infinite when that did not decide
     */
    static void keep(
            Pair p,
            long[] memory,
            int at,
            double low,
            double high,
            double best,
            int face,
            boolean onB) {
        boolean second = movesB(p);
        memory[at] = Double.doubleToRawLongBits(p.qx);
        memory[at + 1] = Double.doubleToRawLongBits(p.qy);
        memory[at + 2] = Double.doubleToRawLongBits(p.qz);
        memory[at + 3] = Double.doubleToRawLongBits(p.qw);
        memory[at + CENTRE] = Double.doubleToRawLongBits(centreX(p, second));
        memory[at + CENTRE + 1] = Double.doubleToRawLongBits(centreY(p, second));
        memory[at + CENTRE + 2] = Double.doubleToRawLongBits(centreZ(p, second));
        memory[at + LOW] = Double.doubleToRawLongBits(low);
        memory[at + HIGH] = Double.doubleToRawLongBits(high);
        memory[at + RIVAL] = Double.doubleToRawLongBits(best);
        memory[at + FACE] = (long) face << 1 | (onB ? 1 : 0);
    }

    /** Empties a place. */
    public static void forget(long[] memory, int at) {
        java.util.Arrays.fill(memory, at, at + SIZE, 0);
    }

    /**
     * Whether a face contact is the answer for any signed distance between two bounds: the face is
     * the reference, no other direction separates by much more, and the points tell the depth.
     *
     * @param best along the best face at most
     */
    static boolean confirmsFace(
            double s, double least, double low, double high, double best, double hysteresis) {
        double allowance = allowance(low, high, hysteresis);
        return s >= best - hysteresis
                && high - s <= allowance
                && depthError(low, least, high) <= allowance;
    }

    /** The same but for other directions and the points. */
    boolean keepsReference(double s, double hysteresis) {
        return same || s >= rival - hysteresis;
    }

    /** The same but for the reference and the points. */
    boolean keepsDirection(double s, double hysteresis) {
        return same || high - s <= allowance(Math.max(s, low), high, hysteresis);
    }

    /** Whether a depth is near enough to all that the signed distance may be. */
    boolean confirmsDepth(double low, double least, double hysteresis) {
        return depthError(low, least, high) <= allowance(low, high, hysteresis);
    }

    /** What the depth at the points of a face may be wrong by. */
    private static double allowance(double low, double high, double hysteresis) {
        double smallest = low > 0 ? low : Math.max(0, -high);
        return 1.5 * hysteresis + 0.15 * smallest;
    }

    /** What a depth may be wrong by. */
    static double depthError(double low, double least, double high) {
        return Math.max(Math.abs(least - low), Math.abs(high - least));
    }

    /** Whether the bounds are near enough to each other to tell anything. */
    boolean isTight(double hysteresis) {
        return high - low <= 2 * allowance(low, high, hysteresis);
    }

    private static boolean movesB(Pair p) {
        return p.b.outerRadius() <= p.a.outerRadius();
    }

    /** The centre of the smaller shape as seen from the other. */
    private static double centreX(Pair p, boolean ofB) {
        return ofB ? p.dx : -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz);
    }

    private static double centreY(Pair p, boolean ofB) {
        return ofB ? p.dy : -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz);
    }

    private static double centreZ(Pair p, boolean ofB) {
        return ofB ? p.dz : -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz);
    }
}
