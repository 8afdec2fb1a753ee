package dev.cairn.physics.contact.seam;

import dev.cairn.physics.contact.PointOrder;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;

import java.util.Arrays;

/**
 * The contacts of two bodies along one normal n, as one row.
 *
 * <p>While the bodies are rigid, how fast they close at a point of the contact plane is an affine
 * function of the point. So a point p inside the corners c, {@code p = sum w_i c_i} with {@code w_i
 * >= 0} and {@code sum w_i = 1}, keeps its distance if the corners do and it is not deeper than
 * they say there:
 *
 * <pre>
 *   s(p) >= sum w_i s(c_i)
 * </pre>
 *
 * <p>Such a point needs no row. If at most four corners are left, they are the points of one row,
 * and the patch has one friction, as the face of one box has. Otherwise (an L on a floor has five)
 * the rows are solved as they are.
 *
 * <p>One instance per worker.
 */
final class PatchRows {
    private static final int POINTS = ContactStore.POINTS;

    /** Square of the distance of unit vectors that are the same normal. */
    private static final double SAME = 1e-12;

    /** Of a point: it bears a share of its corner's impulse. */
    private static final int SHARES = 4;

    /** Of the inner radius of a part: lengths in the contact plane that are none. */
    private static final double FLUSH = 0x1p-15;

    private final ColliderStore colliders;
    private final ContactStore contacts;

    /** By point: its place in the store; along the contact plane; separation. */
    private int[] place = {};

    private double[] u = {}, v = {}, depth = {};

    /** Where its anchors on the body begin: 0 or 3. */
    private byte[] side = {};

    /** Whether a point lies in the plane of its corners. */
    private boolean[] isFlush = {};

    /** Points; corners among them, of which the first two are a diagonal. */
    private int number, corners;

    private final int[] chosen = new int[POINTS];
    private final int[] was = new int[POINTS];
    private final PointOrder points = new PointOrder();

    /** The corners on either side of the diagonal, or -1. */
    private int left, right;

    private final int[] sharers = new int[POINTS];
    private final double[] t = new double[6];
    private double slack;

    PatchRows(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /** Makes room for groups of so many rows; between phases only. */
    void ensure(int most) {
        if (place.length < POINTS * most) {
            int n = 2 * POINTS * most;
            place = new int[n];
            u = new double[n];
            v = new double[n];
            depth = new double[n];
            side = new byte[n];
            isFlush = new boolean[n];
        }
    }

    /** Puts the rows that may be one with the first one behind it; returns their end. */
    int gather(int body, int[] member, int from, int last) {
        int to = from + 1;
        for (int i = to; i < last; i++) {
            if (isOnePatch(body, member[from], member[i])) {
                int row = member[i];
                member[i] = member[to];
                member[to++] = row;
            }
        }
        Arrays.sort(member, from, to);
        return to;
    }

    private boolean isOnePatch(int body, int leader, int row) {
        ContactStore c = contacts;
        double sign = isSecond(body, leader) == isSecond(body, row) ? 1 : -1;
        double x = c.normalX(leader) - sign * c.normalX(row);
        double y = c.normalY(leader) - sign * c.normalY(row);
        double z = c.normalZ(leader) - sign * c.normalZ(row);
        return x * x + y * y + z * z <= SAME
                && colliders.bodies.movesWith(other(body, leader), other(body, row))
                && ContactMaterials.isAlike(c, leader, row);
    }

    private boolean isSecond(int body, int row) {
        return contacts.bodyA[row] != body;
    }

    private int other(int body, int row) {
        return isSecond(body, row) ? contacts.bodyA[row] : contacts.bodyB[row];
    }

    /**
     * Makes the row that stands for some, if they have few enough corners.
     *
     * @param row the row to make
     * @param corner receives where its points are, from {@code at} on
     * @param share receives, by member and point, the corner that the point is nearest to, and
     *     {@link #SHARES} if it bears a share of what the corner does
     * @return whether it was made
     */
    boolean join(
            int body, int row, int[] corner, int at, int[] member, int from, int to, byte[] share) {
        collect(body, member, from, to);
        choose();
        hold();
        if (!coversAll()) {
            return false;
        }
        arrange();
        ContactStore c = contacts;
        int leader = member[from];
        ContactMaterials.joinLike(c, row, leader, colliders);
        c.forgetFriction(row);
        c.pointCount[row] = corners;
        for (int k = 0; k < corners; k++) {
            corner[at + k] = place[chosen[k]];
            setPoint(POINTS * row + k, body, leader, place[chosen[k]]);
        }
        int i = 0;
        for (int m = from; m < to; m++) {
            int like = member[m];
            for (int p = 0; p < c.pointCount[like]; p++, i++) {
                int k = nearest(i);
                share[POINTS * m + p] = (byte) (isFlush[i] ? k | SHARES : k);
                c.normalImpulse[POINTS * row + k] += c.normalImpulse[place[i]];
                c.preload[POINTS * row + k] += c.preload[place[i]];
                c.totalNormalImpulse[POINTS * row + k] += c.totalNormalImpulse[place[i]];
            }
            boolean flips = isSecond(body, like) != isSecond(body, leader);
            c.addFriction(row, like, flips ? -1 : 1);
            c.pointCount[like] = -c.pointCount[like];
        }
        return true;
    }

    private void setPoint(int to, int body, int leader, int from) {
        ContactStore c = contacts;
        Poses s = colliders.poses;
        int row = from / POINTS;
        boolean second = isSecond(body, leader);
        int own = ContactStore.anchor(from) + (isSecond(body, row) ? 3 : 0);
        int out = ContactStore.anchor(to) + (second ? 3 : 0);
        int away = ContactStore.anchor(to) + (second ? 0 : 3);
        int other = other(body, leader);
        System.arraycopy(c.anchors, own, c.anchors, out, 3);
        c.anchors[away] = c.anchors[own] - s.apartX(body, other);
        c.anchors[away + 1] = c.anchors[own + 1] - s.apartY(body, other);
        c.anchors[away + 2] = c.anchors[own + 2] - s.apartZ(body, other);
        c.separation[to] = c.separation[from];
        c.feature[to] = c.feature[from];
    }

    /** Gives a row's impulses to the points that it stood for; what they add up to stays. */
    void part(int row, int[] corner, int at, int[] member, int from, int to, byte[] share) {
        ContactStore c = contacts;
        Arrays.fill(sharers, 0);
        for (int m = from; m < to; m++) {
            int like = member[m];
            c.rest(like);
            c.pointCount[like] = -c.pointCount[like];
            for (int i = POINTS * m; i < POINTS * m + c.pointCount[like]; i++) {
                sharers[share[i] & ~SHARES] += share[i] >= SHARES ? 1 : 0;
            }
        }
        for (int m = from; m < to; m++) {
            for (int p = 0; p < c.pointCount[member[m]]; p++) {
                int k = share[POINTS * m + p];
                if (k >= SHARES) {
                    k -= SHARES;
                    c.totalNormalImpulse[POINTS * member[m] + p] =
                            c.totalNormalImpulse[POINTS * row + k] / sharers[k];
                }
            }
        }
        for (int k = 0; k < c.pointCount[row]; k++) {
            c.normalImpulse[corner[at + k]] = c.normalImpulse[POINTS * row + k];
            c.preload[corner[at + k]] = c.preload[POINTS * row + k];
            c.setRank(corner[at + k], k + 1);
        }
        c.addFriction(member[from], row, 1);
    }

    // Corners -------------------------------------------------------------------------------------

    /** Lists all points, in the contact plane of the first row. */
    private void collect(int body, int[] member, int from, int to) {
        ContactStore c = contacts;
        tangents(c.normalX(member[from]), c.normalY(member[from]), c.normalZ(member[from]));
        points.of(colliders.poses, body);
        number = 0;
        slack = Double.MAX_VALUE;
        for (int i = from; i < to; i++) {
            int row = member[i];
            int first = isSecond(body, row) ? 3 : 0;
            double radius =
                    Math.min(
                            colliders.innerRadius[c.colliderA[row]],
                            colliders.innerRadius[c.colliderB[row]]);
            slack = Math.min(slack, FLUSH * radius);
            int end = POINTS * row + Math.abs(c.pointCount[row]);
            for (int p = POINTS * row; p < end; p++) {
                int at = ContactStore.anchor(p) + first;
                double x = c.anchors[at];
                double y = c.anchors[at + 1];
                double z = c.anchors[at + 2];
                place[number] = p;
                side[number] = (byte) first;
                u[number] = t[0] * x + t[1] * y + t[2] * z;
                v[number] = t[3] * x + t[4] * y + t[5] * z;
                depth[number++] = c.separation[p];
            }
        }
    }

    /** Two unit vectors across a unit normal. */
    private void tangents(double x, double y, double z) {
        boolean isFlat = Math.abs(x) < 0.6;
        double ax = isFlat ? 0 : -z;
        double ay = isFlat ? z : 0;
        double az = isFlat ? -y : x;
        double scale = 1 / Math.sqrt(ax * ax + ay * ay + az * az);
        t[0] = scale * ax;
        t[1] = scale * ay;
        t[2] = scale * az;
        t[3] = y * t[2] - z * t[1];
        t[4] = z * t[0] - x * t[2];
        t[5] = x * t[1] - y * t[0];
    }

    /**
     * The corners: the point farthest from the middle, the one farthest from that, and on each side
     * the one farthest from the line of the two.
     */
    private void choose() {
        double middleU = 0;
        double middleV = 0;
        int deepest = 0;
        for (int i = 0; i < number; i++) {
            middleU += u[i] / number;
            middleV += v[i] / number;
            deepest = depth[i] < depth[deepest] ? i : deepest;
        }
        int a = farthest(middleU, middleV);
        int c = farthest(u[a], v[a]);
        double du = u[c] - u[a];
        double dv = v[c] - v[a];
        left = -1;
        right = -1;
        corners = 1;
        chosen[0] = deepest;
        double length = Math.sqrt(du * du + dv * dv);
        if (length <= slack) {
            return;
        }
        double most = slack * length;
        double least = -most;
        for (int i = 0; i < number; i++) {
            double beside = du * (v[i] - v[a]) - dv * (u[i] - u[a]);
            if (beside > most) {
                most = beside;
                left = i;
            } else if (beside < least) {
                least = beside;
                right = i;
            }
        }
        chosen[0] = a;
        chosen[corners++] = c;
        if (left >= 0) {
            chosen[corners++] = left;
        }
        if (right >= 0) {
            chosen[corners++] = right;
        }
    }

    private int farthest(double fromU, double fromV) {
        int best = 0;
        double most = -1;
        for (int i = 0; i < number; i++) {
            double x = u[i] - fromU;
            double y = v[i] - fromV;
            if (x * x + y * y > most) {
                most = x * x + y * y;
                best = i;
            }
        }
        return best;
    }

    /** Whether each point is inside of the corners, and not deeper than they say there. */
    private boolean coversAll() {
        if (corners == 1) {
            for (int i = 0; i < number; i++) {
                isFlush[i] = depth[i] - depth[chosen[0]] <= slack;
            }
            return true;
        }
        int a = chosen[0];
        int c = chosen[1];
        double du = u[c] - u[a];
        double dv = v[c] - v[a];
        double square = du * du + dv * dv;
        double outside = -slack / Math.sqrt(square);
        for (int i = 0; i < number; i++) {
            double beside = du * (v[i] - v[a]) - dv * (u[i] - u[a]);
            double along = (du * (u[i] - u[a]) + dv * (v[i] - v[a])) / square;
            int tip = beside > 0 ? left : right;
            double ofTip = 0;
            double depthOfTip = 0;
            if (tip >= 0) {
                ofTip = beside / (du * (v[tip] - v[a]) - dv * (u[tip] - u[a]));
                along -= ofTip * (du * (u[tip] - u[a]) + dv * (v[tip] - v[a])) / square;
                depthOfTip = depth[tip];
            }
            double ofA = 1 - ofTip - along;
            // s(p) - sum w_i s(c_i)
            double above = depth[i] - (ofA * depth[a] + along * depth[c] + ofTip * depthOfTip);
            if (ofA < outside || along < outside || above < -slack) {
                return false;
            }
            isFlush[i] = above <= slack;
        }
        return true;
    }

    /** Of points in one place the one that was a corner in the last tick stays one. */
    private void hold() {
        for (int k = 0; k < corners; k++) {
            int corner = chosen[k];
            for (int i = 0; i < number && contacts.rank(place[corner]) == 0; i++) {
                if (contacts.rank(place[i]) > 0
                        && Math.abs(u[i] - u[corner]) <= slack
                        && Math.abs(v[i] - v[corner]) <= slack
                        && Math.abs(depth[i] - depth[corner]) <= slack) {
                    left = left == corner ? i : left;
                    right = right == corner ? i : right;
                    chosen[k] = i;
                    corner = i;
                }
            }
        }
    }

    /**
     * The order of the corners: that of the last tick while they are the same, or else the deepest
     * last, see {@link PointOrder}.
     */
    private void arrange() {
        int ranked = 0;
        for (int i = 0; i < number; i++) {
            ranked += contacts.rank(place[i]) > 0 ? 1 : 0;
        }
        int seen = 0;
        for (int k = 0; k < corners; k++) {
            seen |= 1 << contacts.rank(place[chosen[k]]);
        }
        boolean isKnown = ranked == corners && seen == (2 << corners) - 2;
        int order = 0;
        for (int k = 0; k < corners; k++) {
            int corner = chosen[k];
            was[k] = corner;
            order |= k << (2 * ((contacts.rank(place[corner]) - 1) & 3));
        }
        if (!isKnown) {
            for (int k = 0; k < corners; k++) {
                int p = chosen[k];
                int at = ContactStore.anchor(place[p]) + side[p];
                double[] from = contacts.anchors;
                points.put(k, depth[p], from[at], from[at + 1], from[at + 2]);
            }
            order = points.order(corners);
        }
        for (int k = 0; k < corners; k++) {
            chosen[k] = was[order >> (2 * k) & 3];
        }
    }

    private int nearest(int point) {
        int best = 0;
        double least = Double.MAX_VALUE;
        for (int k = 0; k < corners; k++) {
            double x = u[chosen[k]] - u[point];
            double y = v[chosen[k]] - v[point];
            if (x * x + y * y < least) {
                least = x * x + y * y;
                best = k;
            }
        }
        return best;
    }
}
