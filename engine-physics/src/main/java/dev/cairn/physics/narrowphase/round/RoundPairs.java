package dev.cairn.physics.narrowphase.round;

import static dev.cairn.physics.narrowphase.wide.RoundBatch.*;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.wide.RoundBatch;

/**
 * Contacts of balls and capsules in batches, a pair to a lane: the same bits as {@link
 * RoundContacts}. Only where {@link dev.cairn.physics.narrowphase.wide.BoxAxes#wide}.
 *
 * <p>One instance per worker; not thread-safe; allocates nothing.
 */
public final class RoundPairs {
    private final RoundBatch batch = new RoundBatch();
    private final double[] t = batch.data;
    private final RoundContacts single = new RoundContacts();

    /** The key of a pair of balls or capsules that has a single point, and of no other. */
    public static final long SINGLE = RoundContacts.SINGLE;

    /**
     * Puts a pair into the batch.
     *
     * @param i its place, 0 to {@link RoundBatch#CAPACITY} - 1
     * @param halfA half length of A, m; 0 for a ball
     * @param halfB half length of B, m; 0 for a ball
     */
    public void put(
            int i,
            double dx,
            double dy,
            double dz,
            double radiusA,
            double halfA,
            double radiusB,
            double halfB) {
        t[OFFSET + i] = dx;
        t[OFFSET + CAPACITY + i] = dy;
        t[OFFSET + 2 * CAPACITY + i] = dz;
        t[RADIUS_A + i] = radiusA;
        t[HALF_A + i] = halfA;
        t[RADIUS_B + i] = radiusB;
        t[HALF_B + i] = halfB;
    }

    /**
     * Puts what the margin of a pair is made of: points up to that far apart are reported.
     *
     * @param arcA what turning of A adds, m, not negative
     * @param arcB what turning of B adds, m, not negative
     */
    public void ahead(int i, double vx, double vy, double vz, double arcA, double arcB) {
        t[AHEAD + i] = vx;
        t[AHEAD + CAPACITY + i] = vy;
        t[AHEAD + 2 * CAPACITY + i] = vz;
        t[ARC_A + i] = arcA;
        t[ARC_B + i] = arcB;
    }

    /** Puts the orientation of a capsule; that of a ball is not minded. */
    public void turn(int i, boolean second, double qx, double qy, double qz, double qw) {
        int turn = (second ? TURN_B : TURN_A) + i;
        t[turn] = qx;
        t[turn + CAPACITY] = qy;
        t[turn + 2 * CAPACITY] = qz;
        t[turn + 3 * CAPACITY] = qw;
    }

    /**
     * Collides all pairs that were put.
     *
     * @param reach share of the relative speed in the margin, s
     * @param fraction share of the smaller radius in the margin
     */
    public void run(
            int count, boolean capsulesA, boolean capsulesB, double reach, double fraction) {
        batch.run(count, capsulesA, capsulesB, reach, fraction);
    }

    /**
     * The contact of one pair, after {@link #run}; false when {@link #sideBySide} or {@code
     * NarrowPhase} must find it; nothing is written then.
     */
    public boolean take(int i, Manifold out) {
        double kind = t[KIND + i];
        if (kind >= RoundBatch.LINES) {
            return false;
        }
        out.bound = 0x1p-46 * t[SCALE + i];
        out.capped = false;
        out.patch = 0;
        out.pointCount = 0;
        if (kind == RoundBatch.ONE_POINT) {
            out.pointCount = 1;
            out.normalX = t[NORMAL + i];
            out.normalY = t[NORMAL + CAPACITY + i];
            out.normalZ = t[NORMAL + 2 * CAPACITY + i];
            out.pointX[0] = t[POINT + i];
            out.pointY[0] = t[POINT + CAPACITY + i];
            out.pointZ[0] = t[POINT + 2 * CAPACITY + i];
            out.separation[0] = t[SEPARATION + i];
            out.feature[0] = FeatureIds.CLOSEST;
        }
        return true;
    }

    /**
     * Whether a pair has one point, after {@link #run}; false when it is apart, or {@code
     * NarrowPhase} must find it.
     */
    public boolean touches(int i) {
        return t[KIND + i] == RoundBatch.ONE_POINT;
    }

    /**
     * The contact of two capsules that may lie side by side, after {@link #take} left it; false
     * when {@code NarrowPhase} must find it; nothing is written then.
     */
    public boolean sideBySide(int i, long cache, Manifold out) {
        if (t[KIND + i] != RoundBatch.LINES) {
            return false;
        }
        single.sideBySide(t, i, cache, out);
        return true;
    }

    /**
     * The key to pass for a pair next time, after {@link #sideBySide}; 0 when the pair is apart.
     */
    public long key() {
        return single.key();
    }

    /**
     * Writes the contact of a pair that {@link #touches}, without more.
     *
     * @param normal receives the unit normal from A to B
     * @param anchors receives the point from A's centre, then from B's, world, m
     * @return the separation, m
     */
    public double write(int i, double[] normal, int n, double[] anchors, int p) {
        normal[n] = t[NORMAL + i];
        normal[n + 1] = t[NORMAL + CAPACITY + i];
        normal[n + 2] = t[NORMAL + 2 * CAPACITY + i];
        double x = t[POINT + i];
        double y = t[POINT + CAPACITY + i];
        double z = t[POINT + 2 * CAPACITY + i];
        anchors[p] = x;
        anchors[p + 1] = y;
        anchors[p + 2] = z;
        anchors[p + 3] = x - t[OFFSET + i];
        anchors[p + 4] = y - t[OFFSET + CAPACITY + i];
        anchors[p + 5] = z - t[OFFSET + 2 * CAPACITY + i];
        return t[SEPARATION + i];
    }

    /**
     * The key to pass for a pair next time, after {@link #take}.
     *
     * @param out what {@link #take} filled
     * @return 0 when the pair is apart
     */
    public static long key(Manifold out) {
        return out.pointCount == 0 ? 0 : RoundContacts.SINGLE;
    }
}
