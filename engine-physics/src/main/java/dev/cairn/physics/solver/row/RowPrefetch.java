package dev.cairn.physics.solver.row;

import dev.cairn.physics.internal.ContactStore;

/**
 * Looks ahead in the contact store. The contacts of a colour lie apart there, and the copying of
 * one is so much code that the processor does not see the next one's loads while it waits for
 * memory: it would wait for one contact after the other. Reading a number of each cache line of
 * some contacts brings all of these on their way at once.
 */
public final class RowPrefetch {
    private static final int LINE = 8;

    private RowPrefetch() {}

    /**
     * Touches the contacts of a range of places.
     *
     * @return a number that depends on all that was read; to be written somewhere, else nothing is
     *     read
     */
    public static double contacts(ConstraintRows rows, ContactStore c, int from, int to) {
        double sum = 0;
        for (int j = from; j < to; j++) {
            int source = rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE];
            int p = ContactStore.POINTS * source;
            int o = ContactStore.anchor(p);
            sum += c.anchors[o] + c.anchors[o + LINE] + c.anchors[o + 2 * LINE];
            sum += c.head[ContactStore.head(source)];
            sum += c.separation[p] + c.normalImpulse[p] + c.preload[p];
        }
        return sum;
    }

    /** The same for a range of rows, which lie in one piece. */
    public static double rows(ConstraintRows rows, int from, int to) {
        double sum = 0;
        if (rows.isSingle) {
            return floats(rows, from, to);
        }
        double[] d = rows.doubles;
        int end = ConstraintRows.START + to * ConstraintRows.FIELDS;
        for (int i = ConstraintRows.START + from * ConstraintRows.FIELDS; i < end; i += LINE) {
            sum += d[i];
        }
        return sum;
    }

    private static double floats(ConstraintRows rows, int from, int to) {
        float sum = 0;
        float[] d = rows.floats;
        int end = ConstraintRows.START + to * ConstraintRows.FIELDS;
        for (int i = ConstraintRows.START + from * ConstraintRows.FIELDS; i < end; i += 2 * LINE) {
            sum += d[i];
        }
        return sum;
    }

    /** The same for what the solver leaves in a contact. */
    public static double results(ConstraintRows rows, ContactStore c, int from, int to) {
        double sum = 0;
        for (int j = from; j < to; j++) {
            int source = rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE];
            int p = ContactStore.POINTS * source;
            sum += c.head[ContactStore.head(source)] + c.totalNormalImpulse[p];
            sum += c.separation[p] + c.normalImpulse[p] + c.preload[p];
        }
        return sum;
    }
}
