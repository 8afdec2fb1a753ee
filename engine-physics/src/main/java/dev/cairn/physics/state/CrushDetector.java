package dev.cairn.physics.state;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

/**
 * A body that is crushed: one with contacts that press from opposite sides, by bodies that nothing
 * moves and that come nearer to each other.
 */
public final class CrushDetector {
    /** Cosine between two normals that are opposite enough. */
    private static final double OPPOSITE = -0.7;

    private final BodyStore bodies;
    private final ContactStore rows;

    /** Looks at the contacts of the last step. */
    public CrushDetector(BodyStore bodies, ContactStore rows) {
        this.bodies = bodies;
        this.rows = rows;
    }

    /**
     * The body of a row, if a kinematic one presses it against another.
     *
     * @return its slot, or -1
     */
    public int crushed(int row) {
        int held = held(row, true);
        return held >= 0 && isBetween(row, held) ? held : -1;
    }

    /** The body that is pressed in a row by one that nothing moves, or -1. */
    private int held(int row, boolean byKinematic) {
        if (!rows.isSolved(row) || !presses(row)) {
            return -1;
        }
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        byte other = bodies.kind[bodies.kind[a] == BodyStore.DYNAMIC ? b : a];
        boolean stands =
                other == BodyStore.KINEMATIC || (!byKinematic && other == BodyStore.STATIC);
        return !stands ? -1 : bodies.kind[a] == BodyStore.DYNAMIC ? a : b;
    }

    private boolean presses(int row) {
        for (int p = 0; p < rows.pointCount[row]; p++) {
            if (rows.totalNormalImpulse[ContactStore.POINTS * row + p] > 0) {
                return true;
            }
        }
        return false;
    }

    private boolean isBetween(int row, int held) {
        for (int other = 0; other < rows.count; other++) {
            if (other != row && held(other, false) == held) {
                // normals from the body outwards
                double s = side(row, held) * side(other, held);
                double cosine =
                        s
                                * (rows.normalX(row) * rows.normalX(other)
                                        + rows.normalY(row) * rows.normalY(other)
                                        + rows.normalZ(row) * rows.normalZ(other));
                if (cosine < OPPOSITE && speed(row, held) + speed(other, held) < 0) {
                    return true;
                }
            }
        }
        return false;
    }

    private double side(int row, int held) {
        return rows.bodyA[row] == held ? 1 : -1;
    }

    /** At which the surface of the other body moves away from the body's centre, m/s. */
    private double speed(int row, int held) {
        BodyStore b = bodies;
        int o = rows.bodyA[row] == held ? rows.bodyB[row] : rows.bodyA[row];
        int p = ContactStore.POINTS * row;
        boolean isA = rows.bodyA[row] == o;
        double rx = isA ? rows.anchorAX(p) : rows.anchorBX(p);
        double ry = isA ? rows.anchorAY(p) : rows.anchorBY(p);
        double rz = isA ? rows.anchorAZ(p) : rows.anchorBZ(p);
        double vx = b.pointVelocityX(o, ry, rz);
        double vy = b.pointVelocityY(o, rx, rz);
        double vz = b.pointVelocityZ(o, rx, ry);
        return side(row, held)
                * (vx * rows.normalX(row) + vy * rows.normalY(row) + vz * rows.normalZ(row));
    }
}
