package dev.cairn.physics.narrowphase.clip;

/**
 * Puts the corners of a convex region, which were found in any order, into the order of their angle
 * around their middle.
 *
 * <p>One instance per worker; allocates only when there are more corners than ever before.
 */
public final class CornerOrder {
    /** Of the corners sorted so far, ascending: 0 to 4, growing with the angle. */
    private double[] key = new double[32];

    /** Before any corners. */
    public CornerOrder() {}

    /**
     * Drops what is farther apart than the margin and sorts the rest.
     *
     * @param nx a normal of their plane
     */
    public void sort(Clipper c, double nx, double ny, double nz, double margin) {
        double mx = 0;
        double my = 0;
        double mz = 0;
        int kept = 0;
        for (int i = 0; i < c.count; i++) {
            if (c.separation[i] <= margin) {
                move(c, i, kept++);
                mx += c.x[i];
                my += c.y[i];
                mz += c.z[i];
            }
        }
        c.count = kept;
        if (kept <= 4) {
            return;
        }
        mx /= kept;
        my /= kept;
        mz /= kept;
        if (key.length < kept) {
            key = new double[2 * kept];
        }
        // Any two directions across the normal will do for an order.
        boolean small = Math.abs(nx) < 0.6;
        double ax = small ? 0 : -nz;
        double ay = small ? nz : 0;
        double az = small ? -ny : nx;
        double bx = ny * az - nz * ay;
        double by = nz * ax - nx * az;
        double bz = nx * ay - ny * ax;
        for (int i = 0; i < kept; i++) {
            double x = c.x[i] - mx;
            double y = c.y[i] - my;
            double z = c.z[i] - mz;
            double p = x * ax + y * ay + z * az;
            double q = x * bx + y * by + z * bz;
            double sum = Math.abs(p) + Math.abs(q);
            double turn = sum > 0 ? p / sum : 0;
            insert(c, i, q < 0 ? 3 + turn : 1 - turn);
        }
    }

    private void insert(Clipper c, int i, double turn) {
        double x = c.x[i];
        double y = c.y[i];
        double z = c.z[i];
        double s = c.separation[i];
        int f = c.feature[i];
        int at = i;
        while (at > 0 && key[at - 1] > turn) {
            move(c, at - 1, at);
            key[at] = key[at - 1];
            at--;
        }
        c.x[at] = x;
        c.y[at] = y;
        c.z[at] = z;
        c.separation[at] = s;
        c.feature[at] = f;
        key[at] = turn;
    }

    /** Copies a corner to another place. */
    public static void move(Clipper c, int i, int to) {
        c.x[to] = c.x[i];
        c.y[to] = c.y[i];
        c.z[to] = c.z[i];
        c.separation[to] = c.separation[i];
        c.feature[to] = c.feature[i];
    }
}
