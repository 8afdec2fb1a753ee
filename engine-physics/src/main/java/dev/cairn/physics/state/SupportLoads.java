package dev.cairn.physics.state;

import static dev.cairn.physics.internal.ContactStore.POINTS;

import dev.cairn.physics.internal.ContactStore;

/**
 * What contacts know of loads that have become less: of a body that is lighter now, or of all in a
 * weaker gravity. They keep impulses, and offsets as the impulses that these stand for. Of a body
 * that weighs a thousandth of what it did, an offset is a thousand times as long, and the body
 * hopped by it; a stack whose gravity is turned off rose by the impulses that had carried it.
 *
 * <p>In a weaker gravity all loads go with it. Of one body, the impulses on a body add up to {@code
 * J}, which at rest carries its weight: those along {@code J} hold it up, {@code U} in all, the
 * others press on it, {@code D = U - |J|}. With the share {@code r} of its mass it needs {@code D +
 * r |J|} of them.
 */
public final class SupportLoads {
    private SupportLoads() {}

    /**
     * Scales what all contacts know; between steps.
     *
     * @param share new gravity along the old one, over the old one, 0..1
     */
    public static void weaken(ContactStore c, double share) {
        for (int row = 0; row < c.count; row++) {
            if (c.isSolved(row)) {
                scale(c, row, share);
            }
        }
    }

    /**
     * Scales what holds a body up; between steps. Looks at all rows.
     *
     * @param body slot
     * @param share new weight over old weight, 0..1
     */
    public static void lighten(ContactStore c, int body, double share) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int row = 0; row < c.count; row++) {
            double sign = sign(c, row, body);
            double sum = sign == 0 ? 0 : sum(c, row);
            x += sign * (c.normalX(row) * sum + c.frictionImpulseX(row));
            y += sign * (c.normalY(row) * sum + c.frictionImpulseY(row));
            z += sign * (c.normalZ(row) * sum + c.frictionImpulseZ(row));
        }
        double up = 0;
        for (int row = 0; row < c.count; row++) {
            up += Math.max(0, along(c, row, body, x, y, z));
        }
        double carried = x * x + y * y + z * z;
        if (!(up > 0) || !(carried > 0)) {
            return;
        }
        // (D + r |J|) / U = 1 - (1 - r) |J| / U
        double factor = 1 - (1 - share) * Math.min(1, carried / up);
        for (int row = 0; row < c.count; row++) {
            if (along(c, row, body, x, y, z) > 0) {
                scale(c, row, factor);
            }
        }
    }

    /**
     * 1 if a row's impulse acts on the body as it is, -1 if the other way round, 0 if not at all.
     */
    private static double sign(ContactStore c, int row, int body) {
        if (!c.isSolved(row)) {
            return 0;
        }
        return c.bodyB[row] == body ? 1 : c.bodyA[row] == body ? -1 : 0;
    }

    private static double sum(ContactStore c, int row) {
        double sum = 0;
        for (int p = POINTS * row; p < POINTS * row + c.pointCount[row]; p++) {
            sum += c.normalImpulse[p];
        }
        return sum;
    }

    /** Scalar product of what a row does to the body and a vector. */
    private static double along(ContactStore c, int row, int body, double x, double y, double z) {
        double sign = sign(c, row, body);
        if (sign == 0) {
            return 0;
        }
        double sum = sum(c, row);
        return sign
                * (x * (c.normalX(row) * sum + c.frictionImpulseX(row))
                        + y * (c.normalY(row) * sum + c.frictionImpulseY(row))
                        + z * (c.normalZ(row) * sum + c.frictionImpulseZ(row)));
    }

    private static void scale(ContactStore c, int row, double factor) {
        for (int p = POINTS * row; p < POINTS * row + c.pointCount[row]; p++) {
            c.normalImpulse[p] *= factor;
            c.preload[p] *= factor;
        }
        c.setFrictionImpulse(
                row,
                factor * c.frictionImpulseX(row),
                factor * c.frictionImpulseY(row),
                factor * c.frictionImpulseZ(row),
                factor * c.twistImpulse(row));
    }
}
