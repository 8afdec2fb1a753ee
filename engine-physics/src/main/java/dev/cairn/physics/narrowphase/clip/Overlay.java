package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The corners of the region where two {@link Patch}es face each other, seen along the reference's
 * normal, with the separation at each: into a {@link Clipper}, in the order of their angle.
 *
 * <p>A rim has no corners, so it gets four, along the world's axes: they stay where they are when
 * the body spins about its own axis. The deepest point of the rim is a fifth, unless the disc lies
 * {@link #FLUSH}; {@link Reduction} keeps the four of the last tick until it is really deeper.
 */
public final class Overlay {
    /**
     * Sine of the tilt up to which a disc lies flat: then its deepest point, which is deeper than
     * the four by less than 0.3 of that and the radius, is no corner. It runs around the rim as the
     * disc sways, so that its contact forgets its load: a coin that lies swayed for ever by what
     * its soft contacts sag, 0.07 mm, and sank into the floor by that.
     */
    private static final double FLUSH = 1.7e-3;

    public final Clipper out = new Clipper();

    private Pair pair = Pair.NONE;
    private Patch ref = new Patch(), inc = new Patch();
    private double nx, ny, nz;
    private double slack, slackBefore;
    private int last;
    private double ux, uy, uz, vx, vy, vz;
    private final CornerOrder order = new CornerOrder();
    private final LevelCorner level = new LevelCorner();

    /** Sets the reference, whose flat's normal the separations are along. */
    public void begin(Pair p, Patch reference, Patch incident, int lastNames) {
        begin(p, reference, incident, reference.nx, reference.ny, reference.nz, lastNames);
    }

    public void begin(
            Pair p,
            Patch reference,
            Patch incident,
            double normalX,
            double normalY,
            double normalZ,
            int lastNames) {
        pair = p;
        ref = reference;
        inc = incident;
        nx = normalX;
        ny = normalY;
        nz = normalZ;
        last = lastNames;
        slack = ContactTolerances.ON_PLANE * p.inner;
        slackBefore = ContactTolerances.STILL_ON_PLANE * p.inner;
        out.count = 0;
    }

    /** Both patches have flats, not both faces; or one has a flat and the other's line is used. */
    public void run() {
        if (!inc.flatter) {
            if (ref.flat == Patch.FACE) {
                lineOnFace();
            } else {
                lineOnDisc();
            }
        } else if (ref.flat == Patch.DISC && inc.flat == Patch.DISC) {
            discOnDisc();
        } else {
            discAndFace(ref.flat == Patch.DISC ? ref : inc, ref.flat == Patch.DISC ? inc : ref);
        }
    }

    private double slack(int name) {
        return last != 0 && FeatureIds.contains(last, name) ? slackBefore : slack;
    }

    /** A corner by its point on the incident shape. */
    private void put(double x, double y, double z, double separation, int name) {
        out.ensure(out.count + 1);
        int at = out.count++;
        out.x[at] = x;
        out.y[at] = y;
        out.z[at] = z;
        out.separation[at] = separation;
        out.feature[at] = name;
    }

    private double above(double x, double y, double z) {
        return nx * (x - ref.ox) + ny * (y - ref.oy) + nz * (z - ref.oz);
    }

    /** A corner by a point on the reference; its other end is on the incident's flat. */
    private void putFromReference(double x, double y, double z, int name) {
        double t = inc.height(x, y, z, nx, ny, nz);
        put(x + t * nx, y + t * ny, z + t * nz, t, name);
    }

    private void putFromIncident(double x, double y, double z, int name) {
        put(x, y, z, above(x, y, z), name);
    }

    private int crossingName(int ofRef, int ofInc) {
        return ref.second
                ? FeatureIds.CROSSING | ofInc << 15 | ofRef
                : FeatureIds.CROSSING | ofRef << 15 | ofInc;
    }

    // Lines -------------------------------------------------------------------------------------

    private double from, to;
    private int fromName, toName;

    private void lineOnFace() {
        from = 0;
        to = 1;
        fromName = inc.nameP;
        toName = inc.nameQ;
        double lx = inc.qx - inc.px;
        double ly = inc.qy - inc.py;
        double lz = inc.qz - inc.pz;
        for (int i = 0; i < ref.count; i++) {
            int j = i + 1 == ref.count ? 0 : i + 1;
            double ex = ref.x[j] - ref.x[i];
            double ey = ref.y[j] - ref.y[i];
            double ez = ref.z[j] - ref.z[i];
            double sx = ey * nz - ez * ny;
            double sy = ez * nx - ex * nz;
            double sz = ex * ny - ey * nx;
            double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
            double p =
                    (sx * (inc.px - ref.x[i]) + sy * (inc.py - ref.y[i]) + sz * (inc.pz - ref.z[i]))
                            / length;
            double slope = (sx * lx + sy * ly + sz * lz) / length;
            cut(p, slope, ref.edge[i]);
        }
        putLine(lx, ly, lz);
    }

    /** Keeps the part of the line where p + t slope is not positive. */
    private void cut(double p, double slope, int edge) {
        double atFrom = p + from * slope;
        double atTo = p + to * slope;
        double t = slope == 0 ? 0 : -p / slope;
        if (atTo > slack(toName)) {
            toName = crossingName(edge, Patch.END + 2);
            to = atFrom > slack(fromName) ? -1 : Math.max(from, t);
        } else if (atFrom > slack(fromName)) {
            fromName = crossingName(edge, Patch.END + 3);
            from = Math.min(to, t);
        }
    }

    private void putLine(double lx, double ly, double lz) {
        if (to < from) {
            return;
        }
        putFromIncident(inc.px + from * lx, inc.py + from * ly, inc.pz + from * lz, fromName);
        if (to - from > 0x1p-20) {
            putFromIncident(inc.px + to * lx, inc.py + to * ly, inc.pz + to * lz, toName);
        }
    }

    private void lineOnDisc() {
        from = 0;
        to = 1;
        fromName = inc.nameP;
        toName = inc.nameQ;
        double lx = inc.qx - inc.px;
        double ly = inc.qy - inc.py;
        double lz = inc.qz - inc.pz;
        double reach = ref.radius + slack;
        double ax = inc.px - ref.ox;
        double ay = inc.py - ref.oy;
        double az = inc.pz - ref.oz;
        double h = ax * nx + ay * ny + az * nz;
        ax -= h * nx;
        ay -= h * ny;
        az -= h * nz;
        double k = lx * nx + ly * ny + lz * nz;
        double fx = lx - k * nx;
        double fy = ly - k * ny;
        double fz = lz - k * nz;
        double a = fx * fx + fy * fy + fz * fz;
        double b = ax * fx + ay * fy + az * fz;
        double c = ax * ax + ay * ay + az * az - reach * reach;
        double d = b * b - a * c;
        if (d <= 0 || a == 0) {
            return;
        }
        double root = Math.sqrt(d);
        if ((-b - root) / a > 0) {
            from = (-b - root) / a;
            fromName = crossingName(ref.rim, Patch.END + 2);
        }
        if ((-b + root) / a < 1) {
            to = (-b + root) / a;
            toName = crossingName(ref.rim, Patch.END + 3);
        }
        putLine(lx, ly, lz);
    }

    // Discs -------------------------------------------------------------------------------------

    /** Two directions in the plane of a disc, from the world's axes. */
    private void axes(Patch disc) {
        double wx = pair.w00;
        double wy = pair.w01;
        double wz = pair.w02;
        double dot = wx * disc.nx + wy * disc.ny + wz * disc.nz;
        if (Math.abs(dot) > 0.8) {
            wx = pair.w20;
            wy = pair.w21;
            wz = pair.w22;
            dot = wx * disc.nx + wy * disc.ny + wz * disc.nz;
        }
        ux = wx - dot * disc.nx;
        uy = wy - dot * disc.ny;
        uz = wz - dot * disc.nz;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= length;
        uy /= length;
        uz /= length;
        vx = disc.ny * uz - disc.nz * uy;
        vy = disc.nz * ux - disc.nx * uz;
        vz = disc.nx * uy - disc.ny * ux;
    }

    private double rimX, rimY, rimZ;

    /**
     * The rim's corner k: four along the axes, and the deepest, against a flat's normal.
     *
     * @return whether there is one
     */
    private boolean rim(Patch disc, int k, double mx, double my, double mz) {
        double a = k == 0 ? 1 : k == 2 ? -1 : 0;
        double b = k == 1 ? 1 : k == 3 ? -1 : 0;
        double x = a * ux + b * vx;
        double y = a * uy + b * vy;
        double z = a * uz + b * vz;
        if (k == 4) {
            double dot = mx * disc.nx + my * disc.ny + mz * disc.nz;
            x = dot * disc.nx - mx;
            y = dot * disc.ny - my;
            z = dot * disc.nz - mz;
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length <= FLUSH) {
                return false;
            }
            x /= length;
            y /= length;
            z /= length;
        }
        rimX = disc.ox + disc.radius * x;
        rimY = disc.oy + disc.radius * y;
        rimZ = disc.oz + disc.radius * z;
        return true;
    }

    /** The five corners of a disc on a plane without end. */
    public void discOnPlane() {
        axes(inc);
        for (int k = 0; k < 5; k++) {
            if (rim(inc, k, nx, ny, nz)) {
                putFromIncident(rimX, rimY, rimZ, inc.kind | (inc.rim + k));
            }
        }
    }

    /**
     * Both ends of a line, or all corners that a polyhedron stands on, which is the first shape, on
     * a plane without end.
     */
    public void restOnPlane() {
        if (inc.flatter) {
            for (int i = 0; i < inc.count; i++) {
                putFromIncident(inc.x[i], inc.y[i], inc.z[i], inc.kind | inc.vertex[i]);
            }
            putLevel();
        } else {
            putFromIncident(inc.px, inc.py, inc.pz, inc.nameP);
            putFromIncident(inc.qx, inc.qy, inc.qz, inc.nameQ);
        }
    }

    /** The corner, too, with which a polyhedron stands beside those of its face. */
    private void putLevel() {
        Polyhedron h = inc.hull;
        double offset = nx * ref.ox + ny * ref.oy + nz * ref.oz;
        if (level.find(h, inc.face, nx, ny, nz, offset, pair.inner, inc.kind, last)) {
            int v = level.vertex;
            putFromIncident(h.vertexX(v), h.vertexY(v), h.vertexZ(v), inc.kind | v);
        }
    }

    private void discAndFace(Patch disc, Patch face) {
        boolean discIsRef = disc == ref;
        axes(disc);
        for (int k = 0; k < 5; k++) {
            if (rim(disc, k, face.nx, face.ny, face.nz)) {
                int name = disc.kind | (disc.rim + k);
                if (insideFace(face, discIsRef, slack(name))) {
                    putEither(discIsRef, name);
                }
            }
        }
        double before = 0;
        for (int i = 0; i <= face.count; i++) {
            int at = i == face.count ? 0 : i;
            double t = disc.height(face.x[at], face.y[at], face.z[at], nx, ny, nz);
            double qx = face.x[at] + t * nx - disc.ox;
            double qy = face.y[at] + t * ny - disc.oy;
            double qz = face.z[at] + t * nz - disc.oz;
            double square = qx * qx + qy * qy + qz * qz;
            int name = face.kind | face.vertex[at];
            double reach = disc.radius + slack(name);
            boolean inside = square <= reach * reach;
            if (i < face.count && inside) {
                if (discIsRef) {
                    putFromIncident(face.x[at], face.y[at], face.z[at], name);
                } else {
                    putFromReference(face.x[at], face.y[at], face.z[at], name);
                }
            }
            if (i > 0 && !(inside && before <= 0)) {
                edgeAndRim(disc, face.edge[i - 1], lastX, lastY, lastZ, qx, qy, qz);
            }
            before = inside ? -1 : 1;
            lastX = qx;
            lastY = qy;
            lastZ = qz;
        }
    }

    private double lastX, lastY, lastZ;

    /** A corner at the rim point, which is on the disc. */
    private void putEither(boolean discIsRef, int name) {
        if (discIsRef) {
            putFromReference(rimX, rimY, rimZ, name);
        } else {
            putFromIncident(rimX, rimY, rimZ, name);
        }
    }

    private boolean insideFace(Patch face, boolean faceIsIncident, double room) {
        double sign = faceIsIncident ? -1 : 1;
        for (int i = 0; i < face.count; i++) {
            int j = i + 1 == face.count ? 0 : i + 1;
            double ex = face.x[j] - face.x[i];
            double ey = face.y[j] - face.y[i];
            double ez = face.z[j] - face.z[i];
            double sx = sign * (ey * nz - ez * ny);
            double sy = sign * (ez * nx - ex * nz);
            double sz = sign * (ex * ny - ey * nx);
            double over =
                    sx * (rimX - face.x[i]) + sy * (rimY - face.y[i]) + sz * (rimZ - face.z[i]);
            if (over > room * Math.sqrt(sx * sx + sy * sy + sz * sz)) {
                return false;
            }
        }
        return true;
    }

    /** Where a side of a face, seen from the disc's centre, crosses the rim. */
    private void edgeAndRim(
            Patch disc,
            int edge,
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz) {
        double ex = bx - ax;
        double ey = by - ay;
        double ez = bz - az;
        double a = ex * ex + ey * ey + ez * ez;
        double b = ax * ex + ay * ey + az * ez;
        double c = ax * ax + ay * ay + az * az - disc.radius * disc.radius;
        double d = b * b - a * c;
        if (d <= 0) {
            return;
        }
        double root = Math.sqrt(d);
        for (int k = 0; k < 2; k++) {
            double t = (k == 0 ? -b - root : -b + root) / a;
            if (t > 0 && t < 1) {
                rimX = disc.ox + ax + t * ex;
                rimY = disc.oy + ay + t * ey;
                rimZ = disc.oz + az + t * ez;
                int own = disc.rim + k;
                putEither(
                        disc == ref,
                        disc == ref ? crossingName(own, edge) : crossingName(edge, own));
            }
        }
    }

    private void discOnDisc() {
        axes(inc);
        double mx = nx;
        double my = ny;
        double mz = nz;
        for (int k = 0; k < 5; k++) {
            if (rim(inc, k, mx, my, mz)) {
                int name = inc.kind | (inc.rim + k);
                double t = above(rimX, rimY, rimZ);
                double x = rimX - t * mx - ref.ox;
                double y = rimY - t * my - ref.oy;
                double z = rimZ - t * mz - ref.oz;
                double reach = ref.radius + slack(name);
                if (x * x + y * y + z * z <= reach * reach) {
                    putFromIncident(rimX, rimY, rimZ, name);
                }
            }
        }
        axes(ref);
        for (int k = 0; k < 5; k++) {
            if (rim(ref, k, inc.nx, inc.ny, inc.nz)) {
                onIncidentDisc(ref.kind | (ref.rim + k));
            }
        }
        lens();
    }

    /** The rim point of the reference, if it is over the incident disc. */
    private void onIncidentDisc(int name) {
        double t = inc.height(rimX, rimY, rimZ, nx, ny, nz);
        double x = rimX + t * nx - inc.ox;
        double y = rimY + t * ny - inc.oy;
        double z = rimZ + t * nz - inc.oz;
        double reach = inc.radius + slack(name);
        if (x * x + y * y + z * z <= reach * reach) {
            putFromReference(rimX, rimY, rimZ, name);
        }
    }

    /** Two discs side by side: where the rims cross, and the rim of each within the other. */
    private void lens() {
        double h = above(inc.ox, inc.oy, inc.oz);
        double dx = inc.ox - h * nx - ref.ox;
        double dy = inc.oy - h * ny - ref.oy;
        double dz = inc.oz - h * nz - ref.oz;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        boolean apart = length >= ref.radius + inc.radius;
        if (apart || length <= Math.max(slackBefore, Math.abs(ref.radius - inc.radius))) {
            return;
        }
        dx /= length;
        dy /= length;
        dz /= length;
        double a =
                (length * length + ref.radius * ref.radius - inc.radius * inc.radius)
                        / (2 * length);
        double b = Math.sqrt(Math.max(0, ref.radius * ref.radius - a * a));
        double tx = ny * dz - nz * dy;
        double ty = nz * dx - nx * dz;
        double tz = nx * dy - ny * dx;
        for (int sign = -1; sign <= 1; sign += 2) {
            int own = sign < 0 ? 0 : 1;
            putFromReference(
                    ref.ox + a * dx + sign * b * tx,
                    ref.oy + a * dy + sign * b * ty,
                    ref.oz + a * dz + sign * b * tz,
                    crossingName(ref.rim + own, inc.rim + own));
        }
        putFromReference(
                ref.ox + ref.radius * dx,
                ref.oy + ref.radius * dy,
                ref.oz + ref.radius * dz,
                ref.kind | (ref.rim + 5));
        double back = length - inc.radius;
        putFromReference(
                ref.ox + back * dx,
                ref.oy + back * dy,
                ref.oz + back * dz,
                inc.kind | (inc.rim + 5));
    }

    /** Drops what is farther apart than the margin and sorts the rest around their middle. */
    public void finish(double margin) {
        order.sort(out, nx, ny, nz, margin);
    }
}
