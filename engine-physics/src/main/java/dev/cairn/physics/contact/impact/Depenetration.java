package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.KineticEnergy;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.island.Islands;

import java.util.Arrays;

/**
 * Takes back the rest of its way from a body that went into another one, and the speed at which it
 * went in.
 *
 * <p>Both give way as they weigh: with the way b that is taken back, and the normal n at which they
 * close at the speed u along the line through the first one's centre of mass,
 *
 * <pre>
 *   dx = mB/(mA + mB) b  and  -mA/(mA + mB) b,      j = u / (1/mA + 1/mB + (r x n) . J (r x n))
 * </pre>
 *
 * so momentum stays. What lifts a body more than that takes from its motion is paid for by all its
 * velocities, those of an assembly alike. An assembly that floats is put back as a whole, so that
 * no joint opens; a body that joints bind to a fixed one goes where they pull it.
 *
 * <p>Simulation thread; allocates only when something grows.
 */
public final class Depenetration {
    private final ColliderStore colliders;
    private final EdgeSource[] edges;
    private final double[] own = new double[3];
    private final double[] turn = new double[3];

    /** By body slot: it hangs on joints; by root of what hangs together: on a static body. */
    private boolean[] tied = {}, held = {};

    /** By body slot: it was put back in this tick. */
    private boolean[] moved = {};

    private boolean any;
    private int moves;

    /** Bodies that hang together by joints. */
    private final Islands ties = new Islands();

    // the tick in work
    private int[] dynamic = {};
    private int dynamicCount;
    private double gravityX, gravityY, gravityZ;

    /** What bodies were lifted by since a stop began, J. */
    private double lifted;

    /**
     * For the bodies of a world.
     *
     * @param colliders whose bodies these are
     * @param edges all that binds bodies, contacts first
     */
    public Depenetration(ColliderStore colliders, EdgeSource[] edges) {
        this.colliders = colliders;
        this.edges = edges;
    }

    /** Grows the columns with those of the bodies, also in ticks in which no body is fast. */
    public void ensureSlots() {
        if (tied.length < colliders.slotCount) {
            tied = new boolean[colliders.poses.positionX.length];
            held = new boolean[tied.length];
            moved = new boolean[tied.length];
            ties.ensureSlots(tied.length);
        }
    }

    /** Sets the gravity of a tick, m/s². */
    public void weigh(double x, double y, double z) {
        gravityX = x;
        gravityY = y;
        gravityZ = z;
    }

    /**
     * Finds the bodies that have joints.
     *
     * @param bodies slots of the dynamic bodies that were moved
     * @param count how many there are
     */
    public void tie(int[] bodies, int count) {
        dynamic = bodies;
        dynamicCount = count;
        int slots = colliders.bodies.slotCount;
        Arrays.fill(tied, 0, slots, false);
        Arrays.fill(held, 0, slots, false);
        Arrays.fill(moved, 0, slots, false);
        any = false;
        moves = 0;
        ties.begin(dynamic, dynamicCount);
        byte[] kind = colliders.bodies.kind;
        for (int pass = 0; pass < 2; pass++) {
            for (int k = 1; k < edges.length; k++) {
                for (int i = 0; i < edges[k].edges(); i++) {
                    tie(edges[k].edgeA(i), edges[k].edgeB(i), kind, pass == 0);
                }
            }
        }
    }

    private void tie(int a, int b, byte[] kind, boolean isFirst) {
        if (a < 0) {
            return;
        }
        boolean movesA = kind[a] == BodyStore.DYNAMIC;
        boolean movesB = kind[b] == BodyStore.DYNAMIC;
        tied[a] = true;
        tied[b] = true;
        if (isFirst && movesA && movesB) {
            ties.join(a, b);
        } else if (!isFirst && movesA != movesB) {
            held[ties.root(movesA ? a : b)] = true;
        }
    }

    /**
     * Whether a body may be put back: alone, or with those that hang on it.
     *
     * @param body slot
     * @return false if it hangs on a static body
     */
    public boolean isLoose(int body) {
        return !tied[body] || !held[ties.root(body)];
    }

    /** Whether a body was put back in this tick. */
    public boolean hasMoved(int body) {
        return moved[body];
    }

    /** How often an assembly was put back in this tick. */
    public int moves() {
        return moves;
    }

    /** Whether any was. */
    public boolean any() {
        return any;
    }

    /**
     * Stops two that went into each other.
     *
     * @param body slot of a dynamic body
     * @param other slot of the body that it went into, of any kind
     * @param backX way that the first one takes back against the other, world, m
     * @param backY see {@code backX}
     * @param backZ see {@code backX}
     * @param nx from the first one into the other, unit, world
     * @param ny see {@code nx}
     * @param nz see {@code nx}
     */
    public void stop(
            int body,
            int other,
            double backX,
            double backY,
            double backZ,
            double nx,
            double ny,
            double nz) {
        double light = lightness(body);
        double share = light / (light + lightness(other));
        lifted = 0;
        double before = energy(body) + energy(other);
        move(body, share * backX, share * backY, share * backZ);
        if (share < 1) {
            double rest = share - 1;
            move(other, rest * backX, rest * backY, rest * backZ);
        }
        strike(body, other, nx, ny, nz);
        if (colliders.bodies.kind[other] != BodyStore.KINEMATIC) {
            pay(body, lifted + energy(body) + energy(other) - before);
        }
    }

    private double energy(int body) {
        BodyStore s = colliders.bodies;
        return s.kind[body] == BodyStore.DYNAMIC ? KineticEnergy.of(s, body, own) : 0;
    }

    /** A body and what hangs together with it lose an energy, as far as they have it. */
    private void pay(int body, double gain) {
        if (!(gain > 0)) {
            return;
        }
        boolean isAlone = !tied[body] || !isLoose(body);
        double all = isAlone ? energy(body) : 0;
        for (int i = 0; i < dynamicCount && !isAlone; i++) {
            all += isTogether(body, dynamic[i]) ? energy(dynamic[i]) : 0;
        }
        double share = gain < all ? Math.sqrt(1 - gain / all) : 0;
        if (isAlone) {
            slow(body, share);
        }
        for (int i = 0; i < dynamicCount && !isAlone; i++) {
            if (isTogether(body, dynamic[i])) {
                slow(dynamic[i], share);
            }
        }
    }

    private void slow(int body, double share) {
        BodyStore s = colliders.bodies;
        s.velocityX[body] *= share;
        s.velocityY[body] *= share;
        s.velocityZ[body] *= share;
        s.angularVelocityX[body] *= share;
        s.angularVelocityY[body] *= share;
        s.angularVelocityZ[body] *= share;
    }

    /** 1/kg of what moves with a body; 0 if it does not answer. */
    private double lightness(int body) {
        BodyStore s = colliders.bodies;
        if (s.kind[body] != BodyStore.DYNAMIC) {
            return 0;
        }
        if (!tied[body] || !isLoose(body)) {
            return s.inverseMass[body];
        }
        double mass = 0;
        for (int i = 0; i < dynamicCount; i++) {
            if (isTogether(body, dynamic[i])) {
                mass += 1 / s.inverseMass[dynamic[i]];
            }
        }
        return 1 / mass;
    }

    private boolean isTogether(int body, int other) {
        return tied[other] && ties.root(other) == ties.root(body);
    }

    private void move(int body, double x, double y, double z) {
        if (!tied[body] || !isLoose(body)) {
            moveOne(body, x, y, z);
            return;
        }
        moves++;
        for (int i = 0; i < dynamicCount; i++) {
            if (isTogether(body, dynamic[i])) {
                moveOne(dynamic[i], x, y, z);
            }
        }
    }

    private void moveOne(int body, double x, double y, double z) {
        moved[body] = true;
        any = true;
        BodyStore s = colliders.bodies;
        double up = -(gravityX * x + gravityY * y + gravityZ * z);
        lifted += up * s.gravityScale[body] / s.inverseMass[body];
        s.move(body, x, y, z);
        // what was not moved in this tick lies where it lay, and so do its parts
        colliders.compose(body, own);
    }

    private void strike(int body, int other, double nx, double ny, double nz) {
        BodyStore s = colliders.bodies;
        boolean answers = s.kind[other] == BodyStore.DYNAMIC;
        double x = colliders.poses.apartX(other, body);
        double y = colliders.poses.apartY(other, body);
        double z = colliders.poses.apartZ(other, body);
        double lx = y * nz - z * ny;
        double ly = z * nx - x * nz;
        double lz = x * ny - y * nx;
        double in =
                nx * (s.velocityX[body] - s.velocityX[other])
                        + ny * (s.velocityY[body] - s.velocityY[other])
                        + nz * (s.velocityZ[body] - s.velocityZ[other])
                        - (lx * s.angularVelocityX[other]
                                + ly * s.angularVelocityY[other]
                                + lz * s.angularVelocityZ[other]);
        if (!(in > 0)) {
            return;
        }
        double light = answers ? s.inverseMass[other] : 0;
        double all = s.inverseMass[body] + light;
        if (answers) {
            answer(s, other, lx, ly, lz);
            all += lx * turn[0] + ly * turn[1] + lz * turn[2];
        }
        double gone = in * (s.inverseMass[body] / all);
        s.velocityX[body] -= gone * nx;
        s.velocityY[body] -= gone * ny;
        s.velocityZ[body] -= gone * nz;
        if (answers) {
            double j = in / all;
            s.velocityX[other] += j * light * nx;
            s.velocityY[other] += j * light * ny;
            s.velocityZ[other] += j * light * nz;
            s.angularVelocityX[other] += j * turn[0];
            s.angularVelocityY[other] += j * turn[1];
            s.angularVelocityZ[other] += j * turn[2];
        }
    }

    /** J l, world. */
    private void answer(BodyStore s, int body, double lx, double ly, double lz) {
        double qx = s.orientationX[body];
        double qy = s.orientationY[body];
        double qz = s.orientationZ[body];
        double qw = s.orientationW[body];
        Rotations.rotate(-qx, -qy, -qz, qw, lx, ly, lz, turn);
        inverseInertia(s, body, turn[0], turn[1], turn[2], turn);
        Rotations.rotate(qx, qy, qz, qw, turn[0], turn[1], turn[2], turn);
    }

    /** J x, in body axes. */
    static void inverseInertia(BodyStore s, int body, double x, double y, double z, double[] out) {
        double xy = s.inverseInertiaXY[body];
        double xz = s.inverseInertiaXZ[body];
        double yz = s.inverseInertiaYZ[body];
        out[0] = s.inverseInertiaXX[body] * x + xy * y + xz * z;
        out[1] = xy * x + s.inverseInertiaYY[body] * y + yz * z;
        out[2] = xz * x + yz * y + s.inverseInertiaZZ[body] * z;
    }
}
