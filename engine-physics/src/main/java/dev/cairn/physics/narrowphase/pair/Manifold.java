package dev.cairn.physics.narrowphase.pair;

/**
 * The contact of one pair: a normal and up to four points. A plain record of numbers that the
 * narrow phase fills; reuse one per worker.
 *
 * <p>Feature ids are exact: equal ids in successive ticks are the same pair of features. Bits
 * 31..30 are the kind, and the rest names it: 0 vertex of A (30 bits); 1 vertex of B (30 bits); 2
 * edge of A (bits 29..15) crossing edge of B (bits 14..0); 3 a single point without a better name.
 * They do not depend on which shape's face was the reference.
 */
public final class Manifold {
    /** Most points. */
    public static final int POINTS = 4;

    /** Points in use, 0..4; 0 when the shapes are farther apart than the margin. */
    public int pointCount;

    /** Unit normal from A to B, world axes. */
    public double normalX, normalY, normalZ;

    /** Points midway between the surfaces, relative to A's centre of mass, world axes, m. */
    public final double[] pointX = new double[POINTS],
            pointY = new double[POINTS],
            pointZ = new double[POINTS];

    /**
     * Signed distance of the surfaces along the normal at each point, m; negative when they
     * overlap.
     */
    public final double[] separation = new double[POINTS];

    /** Feature id of each point, ascending as unsigned numbers when the narrow phase returns. */
    public final int[] feature = new int[POINTS];

    /**
     * True when an iteration cap was met: the answer is valid along its own axis, a better axis may
     * exist.
     */
    public boolean capped;

    /**
     * By how much the deepest separation along this normal may differ from the true signed distance
     * of the shapes, m. Rounding alone, unless a face was preferred to a slightly better edge pair
     * to keep the contact calm.
     */
    public double bound;

    /**
     * Of a patch that has more corners than points: the mean distance of its area from its middle
     * over that of the points from theirs; 0 when the points are all of the patch.
     */
    public double patch;

    /** The least separation of the points, m; {@code Double.MAX_VALUE} without points. */
    public double deepest() {
        double least = Double.MAX_VALUE;
        for (int i = 0; i < pointCount; i++) {
            least = Math.min(least, separation[i]);
        }
        return least;
    }

    /** Inserts a point, given in world axes, in order of its name. */
    public void insert(int name, double gap, double x, double y, double z) {
        int at = pointCount++;
        while (at > 0 && Integer.compareUnsigned(feature[at - 1], name) > 0) {
            feature[at] = feature[at - 1];
            separation[at] = separation[at - 1];
            pointX[at] = pointX[at - 1];
            pointY[at] = pointY[at - 1];
            pointZ[at] = pointZ[at - 1];
            at--;
        }
        feature[at] = name;
        separation[at] = gap;
        pointX[at] = x;
        pointY[at] = y;
        pointZ[at] = z;
    }
}
