package dev.cairn.physics.contact.impact;

import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.sweep.Flight;

import java.util.Arrays;

/**
 * Strikes the impacts of fast bodies within a tick, each at its time; see the package.
 *
 * <p>Bodies of one convex shape that nothing binds take part; what they meet may be anything convex
 * that nothing but contacts binds. A body that is struck loses the contacts of the tick's start,
 * which were told of a way that it does not go, and is followed through the trees.
 *
 * <p>Simulation thread; allocates only when something grows.
 */
public final class ImpactStage {
    /** Impacts of a body in a tick; what follows is the solver's. */
    private static final int MOST_IMPACTS = 64;

    /** The same of those that bounce. */
    private static final int MOST_BOUNCES = 256;

    /** Share of a tick: what meets a body within it is one impact, and left to the solver. */
    private static final double SOON = 1e-9;

    private static final double[] NO_START = {};

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final ImpactQueue queue = new ImpactQueue();
    private final Impact impact = new Impact();
    private final MovingPair pair;
    private final StruckBodies bodies;
    private final TrackedBodies tracked;
    private final ImpactSearch search;
    private final LeftBodies left;

    /** The material of two colliders that have no row. */
    private final ContactStore mixed = new ContactStore();

    /** Orientation and angular velocity of a body. */
    private final double[] state = new double[7];

    private final ImpactResults results;

    /** Meetings of one time: two colliders and their row. */
    private int[] taken = new int[192];

    private int takenCount;

    // the tick in work
    private double[] start = NO_START;
    private double step, reach, threshold;

    /**
     * A stage.
     *
     * @param colliders whose contacts these are
     * @param contacts the rows
     * @param pair measures meetings
     */
    public ImpactStage(ColliderStore colliders, ContactStore contacts, MovingPair pair) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.pair = pair;
        results = new ImpactResults(colliders, contacts);
        bodies = new StruckBodies(colliders, contacts);
        tracked = new TrackedBodies(colliders, contacts, bodies, pair, queue);
        search = new ImpactSearch(colliders, bodies, pair, queue);
        left = new LeftBodies(colliders, contacts, bodies);
    }

    /**
     * Begins a tick.
     *
     * @param freedom by body, 0 if it is free, 1 if it touches another body, 2 if it is bound
     * @param stepSeconds length of the tick, s
     * @param reachSeconds of the margin, s
     */
    public void begin(byte[] freedom, double stepSeconds, double reachSeconds) {
        step = stepSeconds;
        reach = reachSeconds;
        pair.use(freedom);
        tracked.begin();
        bodies.begin(freedom);
        left.clear();
        results.clear();
        results.reserve(colliders.bodies.kind.length, contacts.bodyA.length);
        queue.clear();
        queue.reserve(contacts.bodyA.length);
        if (mixed.count == 0) {
            mixed.append(1);
        }
    }

    /** No bodies meet in this tick. */
    public void skip() {
        bodies.count = 0;
        results.clear();
    }

    /**
     * Whether two bodies of a row may be struck here.
     *
     * @param row of a contact
     * @return whether both are convex, of one shape, bound by nothing and held by no third body
     */
    public boolean fits(int row) {
        return bodies.fits(row) && !bodies.isHeld(row);
    }

    /**
     * Whether what moves of a row are balls, which touch in one point.
     *
     * @param row of a contact
     * @return whether an impact of them is exact however slow they are
     */
    public boolean isRound(int row) {
        return bodies.isRound(row);
    }

    /**
     * A row whose bodies meet.
     *
     * @param time when, s after the tick's start
     * @param isLost whether they do not, but their motion from there on is unknown
     */
    public void add(int row, double time, boolean isLost) {
        tracked.see(row);
        queue.add(time, contacts.colliderA[row], contacts.colliderB[row], 0, 0, row, isLost);
    }

    /**
     * Strikes all, in the order of their times.
     *
     * @param boxes of the tick
     * @param starts by collider, where its way is looked at from; written for struck bodies
     * @param bounceSpeed closing speed up to which nothing bounces, m/s
     * @param substeps of the solver
     */
    public void run(BroadPhase boxes, double[] starts, double bounceSpeed, int substeps) {
        start = starts;
        threshold = bounceSpeed;
        bodies.link();
        tracked.gather(step);
        search.begin(boxes, starts, step);
        while (queue.poll()) {
            if (!isOpen()) {
                continue;
            }
            if (queue.isLost) {
                lose(queue.a, queue.b, queue.time);
                continue;
            }
            take(queue.a, queue.b, queue.row);
            double first = queue.time;
            while (queue.next() <= first + SOON * step) {
                queue.poll();
                if (isOpen() && queue.isLost) {
                    lose(queue.a, queue.b, queue.time);
                } else if (isOpen()) {
                    take(queue.a, queue.b, queue.row);
                }
            }
            strikeTaken(first);
        }
        left.settle(step / substeps);
        tracked.release();
    }

    /** Whether the meeting that was taken out is still to come. */
    private boolean isOpen() {
        int a = colliders.body[queue.a];
        int b = colliders.body[queue.b];
        return queue.isFresh(bodies.impacts[a], bodies.impacts[b])
                && !bodies.closed[a]
                && !bodies.closed[b];
    }

    private void take(int a, int b, int row) {
        if (3 * takenCount == taken.length) {
            taken = Arrays.copyOf(taken, Math.max(12, 6 * takenCount));
        }
        taken[3 * takenCount] = a;
        taken[3 * takenCount + 1] = b;
        taken[3 * takenCount++ + 2] = row;
    }

    /** Strikes those that meet at one time; a body that meets two is left to the solver. */
    private void strikeTaken(double time) {
        int count = takenCount;
        takenCount = 0;
        for (int i = 0; i < count; i++) {
            int a = taken[3 * i];
            int b = taken[3 * i + 1];
            boolean isHeld = bodies.isBound(colliders.body[a]) || bodies.isBound(colliders.body[b]);
            if (isHeld
                    || isShared(i, count)
                    || !bodies.fits(a, b)
                    || isDead(a, b, taken[3 * i + 2])) {
                leave(a, b, taken[3 * i + 2], time);
            }
        }
        for (int i = 0; i < count; i++) {
            int a = taken[3 * i];
            int b = taken[3 * i + 1];
            if (!bodies.closed[colliders.body[a]] && !bodies.closed[colliders.body[b]]) {
                strike(a, b, taken[3 * i + 2], time);
            }
        }
    }

    /** An impact without a bounce against what is fixed: the contact and the guard do it. */
    private boolean isDead(int a, int b, int row) {
        byte[] kind = colliders.bodies.kind;
        if (kind[colliders.body[a]] != BodyStore.STATIC
                && kind[colliders.body[b]] != BodyStore.STATIC) {
            return false;
        }
        int like = row >= 0 ? row : mix(a, b);
        return (row >= 0 ? contacts : mixed).restitution[like] == 0;
    }

    private boolean isShared(int i, int count) {
        for (int j = 0; j < count; j++) {
            for (int side = 0; side < 4 && j != i; side++) {
                int body = colliders.body[taken[3 * i + (side & 1)]];
                if (body == colliders.body[taken[3 * j + (side >> 1)]]
                        && colliders.bodies.kind[body] == BodyStore.DYNAMIC) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Leaves two to the solver, with the contacts of this moment if they have been struck. */
    private void leave(int first, int second, int row, double time) {
        int a = colliders.body[first];
        int b = colliders.body[second];
        boolean wasClosed = bodies.closed[a] || bodies.closed[b];
        bodies.closed[a] = colliders.bodies.kind[a] == BodyStore.DYNAMIC;
        bodies.closed[b] = colliders.bodies.kind[b] == BodyStore.DYNAMIC;
        boolean isStruck = bodies.impacts[a] > 0 || bodies.impacts[b] > 0;
        if (row >= 0 && (isStruck || !contacts.isSolved(row))) {
            tell(row, time);
        }
        for (int side = 0; side < 2; side++) {
            int body = side == 0 ? a : b;
            if (!bodies.closed[body] || bodies.impacts[body] == 0 || bodies.free[body] != 0) {
                continue;
            }
            if (row >= 0 && !wasClosed) {
                left.add(body, body == contacts.bodyA[row] ? pair.first() : pair.second(), time);
            }
            for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
                int each = link >> 1;
                if (each == row || bodies.isStruckElsewhere(each, body)) {
                    continue;
                }
                if (bodies.isPlain(contacts.colliderA[each])
                        && bodies.isPlain(contacts.colliderB[each])) {
                    tell(each, time);
                }
            }
        }
    }

    /** Tells a row of a moment; that of two balls, which meet along a formula, of the start. */
    private void tell(int row, double time) {
        boolean[] isBall = colliders.bodies.isBall;
        boolean areBalls = isBall[contacts.bodyA[row]] && isBall[contacts.bodyB[row]];
        pair.place(contacts.colliderA[row], contacts.colliderB[row], areBalls ? 0 : time, step);
        pair.tell(row, reach);
    }

    private void strike(int first, int second, int row, double time) {
        pair.place(first, second, time, step);
        // in a row the points get their order, which a mirrored scene has too
        Manifold m = row >= 0 ? pair.tell(row, reach) : pair.there();
        if (m.pointCount == 0) {
            leave(first, second, row, time);
            return;
        }
        int a = colliders.body[first];
        int b = colliders.body[second];
        int like = row >= 0 ? row : mix(first, second);
        ContactStore of = row >= 0 ? contacts : mixed;

        if (row >= 0) {
            // from here on it is the solver's only if they stay in touch
            contacts.disable(row);
        }
        double closing = impact(m, first, second, of.restitution[like], of.friction(like), time);
        if (closing > 0) {
            results.note(row, m, impact.sum);
            shift(a, 0, time);
            shift(b, 6, time);
        }
        boolean again = pair.meetAgain(first, second, time, step);
        boolean isLost = !again && pair.isUndecided();
        boolean isIdle =
                !(closing > 0)
                        && ++bodies.idle[colliders.bodies.kind[a] == BodyStore.DYNAMIC ? a : b]
                                > MOST_IMPACTS;
        if (pair.stays()) {
            leave(first, second, row, time);
            return;
        }
        int most = of.restitution[like] > 0 ? MOST_BOUNCES : MOST_IMPACTS;
        if (isIdle || bodies.impacts[a] >= most || bodies.impacts[b] >= most) {
            pair.place(first, second, time, step);
            stop(first, second, m, time);
            return;
        }
        if (again || isLost) {
            queue.add(
                    pair.time(), first, second, bodies.impacts[a], bodies.impacts[b], row, isLost);
        }
        if (closing > 0) {
            search.follow(a, time);
            search.follow(b, time);
        }
    }

    /** Stops one of two that turn too often in a tick to be tracked. */
    private void lose(int first, int second, double time) {
        if (!bodies.fits(first, second)) {
            return;
        }
        pair.place(first, second, time, step);
        Manifold m = pair.across();
        if (m.pointCount > 0) {
            impact(m, first, second, 0, 0, time);
            System.arraycopy(impact.before, 0, impact.after, 0, impact.after.length);
            stop(first, second, m, time);
        }
    }

    /**
     * Two that strike each other more often than can be followed lose the rest of the tick: they
     * lie as they do, and go on with their common centre of mass. So what is between them stays,
     * and with it the angular momentum {@code r x m u} of their relative motion. Of two of which
     * only one may be stopped, that one stays where it is and goes along with the other.
     */
    private void stop(int first, int second, Manifold m, double time) {
        int a = colliders.body[first];
        int b = colliders.body[second];
        if (bodies.isLoose(a) && bodies.isLoose(b)) {
            stopBoth(a, b, time);
        } else if (bodies.isLoose(a) || bodies.isLoose(b)) {
            int side = bodies.isLoose(a) ? 0 : 1;
            double carried = (step - time) * impact.carrier(1 - side, m);
            int body = side == 0 ? a : b;
            int at = end(side, body, side == 0 ? pair.first() : pair.second());
            results.stops[at] += carried * m.normalX;
            results.stops[at + 1] += carried * m.normalY;
            results.stops[at + 2] += carried * m.normalZ;
        }
    }

    private void stopBoth(int a, int b, double time) {
        double[] light = colliders.bodies.inverseMass;
        // of the mass, the first one's
        double share = light[b] / (light[a] + light[b]);
        double rest = step - time;
        Flight f = pair.first();
        Flight g = pair.second();
        int i = end(0, a, f);
        int j = end(1, b, g);
        double[] v = impact.after;
        double[] stops = results.stops;
        for (int c = 0; c < 3; c++) {
            double ax = c == 0 ? f.ax : c == 1 ? f.ay : f.az;
            double bx = c == 0 ? g.ax : c == 1 ? g.ay : g.az;
            double speed = share * v[c] + (1 - share) * v[6 + c];
            double way = rest * (speed + 0.5 * rest * (share * ax + (1 - share) * bx));
            stops[i + c] += way;
            stops[j + c] += way;
            stops[i + 10 + c] += rest * ax;
            stops[j + 10 + c] += rest * bx;
        }
    }

    /** A body's tick ends as it lies and moves at the impact; returns its place in the results. */
    private int end(int side, int body, Flight f) {
        bodies.closed[body] = true;
        for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
            contacts.disable(link >> 1);
        }
        int at = results.put(body, f);
        System.arraycopy(impact.after, 6 * side, results.stops, at + 10, 6);
        return at;
    }

    private int mix(int first, int second) {
        ContactMaterials.join(mixed, 0, colliders, first, second);
        return 0;
    }

    private double impact(
            Manifold m, int first, int second, double restitution, double friction, double time) {
        Flight f = pair.first();
        Flight g = pair.second();
        side(0, colliders.body[first], f, time);
        side(1, colliders.body[second], g, time);
        // points are from the first collider's centre
        double cx = f.armX;
        double cy = f.armY;
        double cz = f.armZ;
        double bx = cx + pair.apartX() - g.armX;
        double by = cy + pair.apartY() - g.armY;
        double bz = cz + pair.apartZ() - g.armZ;
        return impact.strike(m, cx, cy, cz, bx, by, bz, restitution, friction, threshold);
    }

    private void side(int side, int body, Flight f, double time) {
        impact.side(side, colliders.bodies, body, f, time);
    }

    /** Gives a body the velocities after the impact; dv at t is dv now from a start at -t dv. */
    private void shift(int body, int at, double time) {
        BodyStore s = colliders.bodies;
        if (s.kind[body] != BodyStore.DYNAMIC) {
            return;
        }
        if (bodies.impacts[body]++ == 0) {
            bodies.list[bodies.count++] = body;
            // told of the way before; a body that touches others keeps the contacts that hold it
            for (int link = bodies.head[body];
                    link >= 0 && bodies.free[body] == 0;
                    link = bodies.next[link]) {
                contacts.disable(link >> 1);
            }
        }
        double[] v = impact.before;
        double[] w = impact.after;
        Flight f = at == 0 ? pair.first() : pair.second();
        start[3 * body] = s.positionX[body] + f.x;
        start[3 * body + 1] = s.positionY[body] + f.y;
        start[3 * body + 2] = s.positionZ[body] + f.z;
        bodies.late[body] = time / step;
        double dx = w[at] - v[at];
        double dy = w[at + 1] - v[at + 1];
        double dz = w[at + 2] - v[at + 2];
        s.move(body, -time * dx, -time * dy, -time * dz);
        s.velocityX[body] += dx;
        s.velocityY[body] += dy;
        s.velocityZ[body] += dz;
        bodies.keep(body, f, w, at + 3);
        state[0] = f.qx;
        state[1] = f.qy;
        state[2] = f.qz;
        state[3] = f.qw;
        System.arraycopy(w, at + 3, state, 4, 3);
        pair.back(body, time, state);
        s.orientationX[body] = state[0];
        s.orientationY[body] = state[1];
        s.orientationZ[body] = state[2];
        s.orientationW[body] = state[3];
        s.angularVelocityX[body] = state[4];
        s.angularVelocityY[body] = state[5];
        s.angularVelocityZ[body] = state[6];
    }

    /**
     * The share of the tick after which a body's way was looked at from a new start.
     *
     * @param body slot
     * @return 0 for a body that was not struck
     */
    public double late(int body) {
        return bodies.count > 0 ? bodies.late[body] : 0;
    }

    /**
     * How a body that was struck lay at a share of the tick, not before {@link #late}: into {@code
     * out}, a unit quaternion, world from body. False for a body that was not struck.
     */
    public boolean lay(int body, double share, double[] out) {
        double late = late(body);
        if (late > 0) {
            bodies.lay(body, (share - late) * step, out);
        }
        return late > 0;
    }

    /** Puts bodies where impacts left them, and writes impulses to rows; after the solve. */
    public void report() {
        results.report();
    }
}
