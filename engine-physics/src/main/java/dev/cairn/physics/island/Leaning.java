package dev.cairn.physics.island;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Sag;

/**
 * Contacts between a body that moves and one asleep: whether the sleeper goes on sleeping, by the
 * rule in the package's essay.
 *
 * <p>Simulation thread; allocates only when rows are added.
 */
public final class Leaning {
    /**
     * Change of a moment that wakes, over the sleeper's inner radius times its weight or the load
     * that it carried, whichever is more.
     */
    private static final double CHANGE = 0.5;

    private final SleepingBodies sleepers;
    private final AwakeNeighbours neighbours;
    private final BodyStore bodies;
    private final ContactStore contacts;

    private double gravityX;
    private double gravityY;
    private double gravityZ;
    private double seconds = 1;

    /** A rule. */
    public Leaning(SleepingBodies sleepers, BodyStore bodies, ContactStore contacts) {
        this.sleepers = sleepers;
        this.neighbours = sleepers.awakeNeighbours();
        this.bodies = bodies;
        this.contacts = contacts;
    }

    /**
     * Remembers the loads of sleepers that fell asleep in this tick beside bodies that move; after
     * the solve.
     *
     * @param perSecond ticks per second, of this tick's length
     * @param substeps sub-steps of a tick
     */
    public void begin(double perSecond, int substeps) {
        byte[] kind = bodies.kind;
        addUp(perSecond, substeps);
        for (int i = 0; i < contacts.activeCount; i++) {
            int row = contacts.active[i];
            int mover = mover(row);
            int sleeper = contacts.bodyA[row] + contacts.bodyB[row] - mover;
            if (kind[mover] != BodyStore.DYNAMIC
                    || kind[sleeper] != BodyStore.ASLEEP
                    || sleepers.settled(sleeper)) {
                continue;
            }
            if (contacts.isSolved(row)) {
                contacts.beginLeaning();
                contacts.lean[row] =
                        Math.max(Double.MIN_NORMAL, contacts.normalImpulse(row) * perSecond);
                neighbours.leanOn(mover);
                neighbours.remember(mover);
            } else if (contacts.leans) {
                contacts.lean[row] = 0;
            }
        }
    }

    /**
     * Before any row of a tick is asked for.
     *
     * @param gx gravity, world, m/s²
     * @param gy gravity, world, m/s²
     * @param gz gravity, world, m/s²
     * @param stepSeconds length of the tick, s
     * @param perSecond ticks per second, of the last tick's length
     * @param substeps sub-steps of a tick
     */
    public void look(
            double gx, double gy, double gz, double stepSeconds, double perSecond, int substeps) {
        gravityX = gx;
        gravityY = gy;
        gravityZ = gz;
        seconds = stepSeconds;
        if (contacts.leans) {
            addUp(perSecond, substeps);
        }
    }

    /** Whether a row is of a body that leans on a sleeper. */
    public boolean leans(int row) {
        return contacts.leans && contacts.lean[row] > 0;
    }

    /** The sleeper of a row wakes. */
    public void forget(int row) {
        if (leans(row)) {
            contacts.lean[row] = 0;
            neighbours.forget(mover(row));
        }
    }

    /**
     * Whether the sleeper of a row carries about what it did when the other began to lean on it.
     *
     * @param perSecond ticks per second, of the last tick's length
     */
    public boolean staysAsleep(int row, double perSecond) {
        int mover = mover(row);
        if (bodies.kind[mover] != BodyStore.DYNAMIC) {
            return false;
        }
        int sleeper = contacts.bodyA[row] + contacts.bodyB[row] - mover;
        double radius = bodies.innerRadius[sleeper];
        double bears = bears(row, sleeper);
        // L: lever of the contact over the sleeper's inner radius, at least 1
        double lever = Math.max(1, lever(row, sleeper) / radius);
        if (!leans(row) || !neighbours.leans(mover)) {
            // m v L <= share B h
            double speed = CHANGE * bears * seconds * bodies.inverseMass[mover] / lever;
            return mayBegin(row, mover, speed, radius);
        }
        double before = contacts.lean[row];
        double change = lever * before;
        if (contacts.isSolved(row)) {
            double force = contacts.normalImpulse(row) * perSecond;
            // G = min(max(0, F - F0), |R - R0|); M/r = L G + (F0 + G) d/r
            double growth = Math.min(Math.max(0, force - before), neighbours.change(mover));
            change = lever * growth + (before + growth) * neighbours.moved(mover) / radius;
        }
        return change <= CHANGE * Math.max(bears, before);
    }

    /**
     * What a sleeper bears along a contact's normal before it moves, N: its weight from above or
     * below, and what friction makes of that from the side, {@code B = min(m |g|, m (|g.n| + mu
     * |g|))}.
     */
    private double bears(int row, int sleeper) {
        double gx = gravityX;
        double gy = gravityY;
        double gz = gravityZ;
        double g = Math.sqrt(gx * gx + gy * gy + gz * gz);
        double along =
                gx * contacts.normalX(row)
                        + gy * contacts.normalY(row)
                        + gz * contacts.normalZ(row);
        double most = Math.abs(along) + contacts.friction(row) * g;
        return Math.min(g, most) / bodies.inverseMass[sleeper];
    }

    /**
     * A body comes to touch one asleep, slowly: what it presses with shows in the next tick.
     *
     * @param speed the largest at which it may, m/s
     * @param radius inner radius of the sleeper, m
     */
    private boolean mayBegin(int row, int mover, double speed, double radius) {
        if (closing(row, mover) > speed || overlaps(row, radius)) {
            return false;
        }
        contacts.beginLeaning();
        contacts.lean[row] = Double.MIN_NORMAL;
        if (!neighbours.leans(mover)) {
            neighbours.leanOn(mover);
            neighbours.remember(mover);
        }
        return true;
    }

    private int mover(int row) {
        int a = contacts.bodyA[row];
        return bodies.kind[a] == BodyStore.DYNAMIC ? a : contacts.bodyB[row];
    }

    /** How fast the points of a row on a body come nearer to the other one, at most; m/s. */
    private double closing(int row, int s) {
        double sign = contacts.bodyA[row] == s ? 1 : -1;
        double nx = sign * contacts.normalX(row);
        double ny = sign * contacts.normalY(row);
        double nz = sign * contacts.normalZ(row);
        double[] r = contacts.anchors;
        double most = 0;
        for (int i = 0; i < contacts.pointCount[row]; i++) {
            int o = anchor(row, i, s);
            // v + w x r, along the normal towards the other
            double x = bodies.velocityX[s];
            double y = bodies.velocityY[s];
            double z = bodies.velocityZ[s];
            x += bodies.angularVelocityY[s] * r[o + 2] - bodies.angularVelocityZ[s] * r[o + 1];
            y += bodies.angularVelocityZ[s] * r[o] - bodies.angularVelocityX[s] * r[o + 2];
            z += bodies.angularVelocityX[s] * r[o + 1] - bodies.angularVelocityY[s] * r[o];
            most = Math.max(most, nx * x + ny * y + nz * z);
        }
        return most;
    }

    /** Whether the bodies of a row are in each other by more than what does not show. */
    private boolean overlaps(int row, double radius) {
        for (int i = 0; i < contacts.pointCount[row]; i++) {
            if (contacts.separation[ContactStore.POINTS * row + i] < -Sag.SHOWS * radius) {
                return true;
            }
        }
        return false;
    }

    /** How far the first point of a row is from a body's centre, m. */
    private double lever(int row, int s) {
        double[] r = contacts.anchors;
        int o = anchor(row, 0, s);
        return Math.sqrt(r[o] * r[o] + r[o + 1] * r[o + 1] + r[o + 2] * r[o + 2]);
    }

    private int anchor(int row, int point, int s) {
        int o = ContactStore.anchor(ContactStore.POINTS * row + point);
        return contacts.bodyA[row] == s ? o : o + 3;
    }

    /** What sleepers and what never moves do to each body that moves, friction included. */
    private void addUp(double perSecond, int substeps) {
        for (int i = 0; i < contacts.activeCount; i++) {
            int row = contacts.active[i];
            neighbours.clear(contacts.bodyA[row]);
            neighbours.clear(contacts.bodyB[row]);
        }
        byte[] kind = bodies.kind;
        for (int i = 0; i < contacts.activeCount; i++) {
            int row = contacts.active[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            boolean movesA = kind[a] == BodyStore.DYNAMIC;
            boolean movesB = kind[b] == BodyStore.DYNAMIC;
            if (movesA != movesB && contacts.isSolved(row) && !bodies.isMoved(movesA ? b : a)) {
                bear(row, movesA ? a : b, movesA ? -perSecond : perSecond, substeps);
            }
        }
    }

    private void bear(int row, int mover, double perSecond, int substeps) {
        double normal = contacts.normalImpulse(row) * perSecond;
        // of the last sub-step
        double friction = substeps * perSecond;
        neighbours.bear(
                mover,
                normal * contacts.normalX(row) + friction * contacts.frictionImpulseX(row),
                normal * contacts.normalY(row) + friction * contacts.frictionImpulseY(row),
                normal * contacts.normalZ(row) + friction * contacts.frictionImpulseZ(row));
    }
}
