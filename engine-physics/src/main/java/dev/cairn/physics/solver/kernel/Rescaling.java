package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.row.ConstraintRows;

/** What contacts know, when the length of the sub-step changes. */
public final class Rescaling {
    /**
     * Share of what friction holds now that goes into the mean. A disturbance is enlarged by {@code
     * 1 + gain (ratio - 1)} when a tick is longer, and what sweeps leave of it between is about a
     * third: small enough for ratios up to 33.
     */
    private static final double FRICTION_GAIN = 0.05;

    private Rescaling() {}

    /**
     * Prepares the impulses that contacts kept for a sub-step of another length, by which filling a
     * row will scale them. Of a longer one, only the load that a contact has learnt goes with the
     * time, {@code l' = ratio p + (l - p)}; the rest is taken over as it is: momentum that was
     * passed on, and noise. Enlarged, a stack's noise grew from tick to tick, and it fell.
     *
     * @param ratio of the lengths, new to old
     * @param before length of the old one, s
     */
    public static void keepLoads(
            ConstraintRows rows,
            ContactStore contacts,
            double ratio,
            double before,
            int from,
            int to) {
        for (int j = from; j < to; j++) {
            if (rows.points(j) == 0) {
                continue; // fills a group of lanes up, and belongs to no contact
            }
            int source = rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE];
            int first = ContactStore.POINTS * source;
            for (int p = first; p < first + rows.points(j) && ratio > 1; p++) {
                double load = Math.min(contacts.preload[p], contacts.normalImpulse[p]);
                contacts.normalImpulse[p] = load + (contacts.normalImpulse[p] - load) / ratio;
            }
            keepFriction(contacts, source, ratio, before);
        }
    }

    /** The same for friction, whose load is a slow mean over the changes of length. */
    private static void keepFriction(ContactStore c, int source, double ratio, double before) {
        double x = c.frictionImpulseX(source);
        double y = c.frictionImpulseY(source);
        double z = c.frictionImpulseZ(source);
        double twist = c.twistImpulse(source);
        double[] load = c.frictionLoad;
        int k = 4 * source;
        boolean isNew = load[k] == 0 && load[k + 1] == 0 && load[k + 2] == 0 && load[k + 3] == 0;
        double gain = isNew ? 1 : FRICTION_GAIN;
        load[k] += gain * (x / before - load[k]);
        load[k + 1] += gain * (y / before - load[k + 1]);
        load[k + 2] += gain * (z / before - load[k + 2]);
        load[k + 3] += gain * (twist / before - load[k + 3]);
        if (!(ratio > 1)) {
            return;
        }
        double square = load[k] * load[k] + load[k + 1] * load[k + 1] + load[k + 2] * load[k + 2];
        double known = before * Math.sqrt(square);
        double held = Math.sqrt(x * x + y * y + z * z);
        // no more than friction holds now
        double more = before * (1 - 1 / ratio);
        double share = known > held ? more * (held / known) : more;
        double knownTwist = before * Math.abs(load[k + 3]);
        double heldTwist = Math.abs(twist);
        double twistShare = knownTwist > heldTwist ? more * (heldTwist / knownTwist) : more;
        c.setFrictionImpulse(
                source,
                x / ratio + share * load[k],
                y / ratio + share * load[k + 1],
                z / ratio + share * load[k + 2],
                twist / ratio + twistShare * load[k + 3]);
    }

    /**
     * Lets contacts hold what they held when the sub-step has changed that softness goes by. The
     * stiffness, as a force, goes with {@code 1 / h²}; so gap less offset goes with {@code h²}, and
     * the offset takes what is left over of the gap. Without it a stack that has just come to rest
     * drops or is thrown by the difference of its sags.
     *
     * @param ratio of the lengths, new to old
     */
    public static void carryOver(
            ConstraintRows rows, ContactStore contacts, double ratio, int from, int to) {
        int lanes = rows.lanes;
        double more = ratio * ratio - 1;
        for (int j = from; j < to; j++) {
            if (rows.settleMark[j] != 0) {
                continue;
            }
            int o = rows.base(j);
            int first =
                    ContactStore.POINTS
                            * rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE];
            for (int i = 0; i < rows.points(j); i++) {
                if (contacts.normalImpulse[first + i] > 0) {
                    double separation = contacts.separation[first + i];
                    int q = o + (ConstraintRows.GAP + i) * lanes;
                    double gap = Math.min(separation, rows.get(q) + more * separation);
                    rows.put(q, gap);
                    int point = ConstraintRows.POINT + i * ConstraintRows.POINT_FIELDS;
                    rows.put(o + (point + ConstraintRows.SEPARATION) * lanes, gap);
                }
            }
        }
    }
}
