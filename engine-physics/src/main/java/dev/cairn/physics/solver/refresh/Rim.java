package dev.cairn.physics.solver.refresh;

import dev.cairn.physics.solver.body.Rotation;

/**
 * The rim of a disc, cylinder or cone on which a body stands on a plane, as it is in the body.
 *
 * <p>Found of the points of a contact at the tick's start: all are of one rim, and one is where it
 * lies deepest. One thread at a time; allocates when it is made.
 */
public final class Rim {
    /** Distances within a rim that are equal, over its radius. */
    private static final double SAME = 1e-6;

    /** From the centre of mass to the middle of the rim, body, m. */
    public final double[] middle = new double[3];

    /** Axis of the solid, body, unit. */
    public final double[] axis = new double[3];

    /** Radius of the rim, m. */
    public double radius;

    /** Height of the plane over the centre of mass of the tick's start, along the normal, m. */
    public double level;

    /** Normal of the plane, towards the body, world. */
    public final double[] up = new double[3];

    /** The deepest point of the contact. */
    public int point;

    private final double[] low = new double[3];

    /**
     * Finds the rim.
     *
     * @param kept record of the row, see {@link RefreshRow}, from {@code k} on
     * @param points of the row
     * @param rounds what {@link RoundTurn} keeps of the body, from {@code x} on
     * @param start orientation of the body at the tick's start, from {@code q} on
     * @param side 1 if the body is the second of the contact, else -1
     * @return whether there is one
     */
    boolean find(
            double[] kept,
            int k,
            int points,
            double[] rounds,
            int x,
            double[] start,
            int q,
            int side) {
        double along = 0;
        for (int i = 0; i < 3; i++) {
            up[i] = side * kept[k + i];
            along += up[i] * rounds[x + RoundTurn.AXIS + i];
        }
        double square = 0;
        for (int i = 0; i < 3; i++) {
            low[i] = along * rounds[x + RoundTurn.AXIS + i] - up[i];
            square += low[i] * low[i];
        }
        if (!(square > 0) || rounds[x + RoundTurn.RADIUS] != 0) {
            return false;
        }
        point = -1;
        double height = 0;
        for (int p = 0; p < points; p++) {
            int o = k + RefreshRow.POINTS + RefreshRow.NUMBERS * p;
            double gap = kept[o + RefreshRow.GAPS];
            int arm = side > 0 ? o + 3 : o;
            double h = 0;
            double reach = 0;
            double far = 0;
            double rise = 0;
            for (int i = 0; i < 3; i++) {
                double r = kept[arm + i] + 0.5 * side * gap * kept[k + i];
                rise += r * up[i];
                r -= rounds[x + i];
                h += r * rounds[x + RoundTurn.AXIS + i];
                reach += r * low[i];
                far += r * r;
            }
            far -= h * h;
            if (!(far > 0)) {
                return false;
            }
            far = Math.sqrt(far);
            if (p == 0) {
                radius = far;
                height = h;
            } else if (Math.abs(far - radius) > SAME * radius
                    || Math.abs(h - height) > SAME * radius) {
                return false;
            }
            boolean isDeepest = reach > 0 && reach * reach > (1 - 2 * SAME) * square * far * far;
            if (isDeepest && (point < 0 || rise - gap < level)) {
                point = p;
                level = rise - gap;
            }
        }
        if (point < 0) {
            return false;
        }
        for (int n = 0; n < 3; n++) {
            axis[n] = 0;
            middle[n] = 0;
            for (int i = 0; i < 3; i++) {
                double e = Rotation.axis(start[q], start[q + 1], start[q + 2], start[q + 3], n, i);
                axis[n] += e * rounds[x + RoundTurn.AXIS + i];
                middle[n] += e * (rounds[x + i] + height * rounds[x + RoundTurn.AXIS + i]);
            }
        }
        return true;
    }
}
