package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * Writes the points of a contact, once its axis is known: the clipped face, the crossing of two
 * edges, or the nearest points. Works in A's frame and turns what it writes into world axes.
 */
public final class ContactPoints {
    /**
     * Shares of a patch are multiples of one over this. The sums over its corners are rounded by
     * where they begin and which way they go round, which a mirror turns.
     */
    private static final double GRAINS = 0x1p24;

    private final Pair pair;
    private final Axes axes;
    private final Gjk gjk;
    public final Clipper clipper = new Clipper();
    private final Reduction reduction = new Reduction();
    private final CornerOrder order = new CornerOrder();
    private final LevelCorner level = new LevelCorner();

    /** Unit axis from A to B, in A's frame. */
    public double axisX, axisY, axisZ;

    /** The vertex of the last face contact whose face was clipped. */
    public int incidentVertex, incidentFace;

    private double tx, ty, tz;

    public ContactPoints(Pair pair, Axes axes, Gjk gjk) {
        this.pair = pair;
        this.axes = axes;
        this.gjk = gjk;
    }

    public double worldX() {
        return pair.w00 * axisX + pair.w01 * axisY + pair.w02 * axisZ;
    }

    public double worldY() {
        return pair.w10 * axisX + pair.w11 * axisY + pair.w12 * axisZ;
    }

    public double worldZ() {
        return pair.w20 * axisX + pair.w21 * axisY + pair.w22 * axisZ;
    }

    public void setAxis(double x, double y, double z) {
        axisX = x;
        axisY = y;
        axisZ = z;
    }

    /** Sets the axis to the one with the largest separation. */
    public void bestAxis() {
        double best = axes.best();
        if (best == axes.separationA) {
            faceAxis(false);
        } else if (best == axes.separationB) {
            faceAxis(true);
        } else if (best == axes.separationEdge) {
            setAxis(axes.edgeX, axes.edgeY, axes.edgeZ);
        } else {
            setAxis(axes.rawX, axes.rawY, axes.rawZ);
        }
    }

    /** Sets the axis to the normal of the chosen face of A, or of B when flipped. */
    public void faceAxis(boolean flip) {
        if (flip) {
            double x = -pair.b.normalX(axes.faceB);
            double y = -pair.b.normalY(axes.faceB);
            double z = -pair.b.normalZ(axes.faceB);
            axisX = pair.r00 * x + pair.r01 * y + pair.r02 * z;
            axisY = pair.r10 * x + pair.r11 * y + pair.r12 * z;
            axisZ = pair.r20 * x + pair.r21 * y + pair.r22 * z;
        } else {
            setAxis(
                    pair.a.normalX(axes.faceA),
                    pair.a.normalY(axes.faceA),
                    pair.a.normalZ(axes.faceA));
        }
    }

    /** The face contact of the chosen face of A, or of B when flipped. */
    public void face(boolean flip, double margin, double hysteresis, int last, Manifold out) {
        Polyhedron reference = flip ? pair.b : pair.a;
        int face = flip ? axes.faceB : axes.faceA;
        toOther(flip, reference.normalX(face), reference.normalY(face), reference.normalZ(face));
        face(flip, (flip ? pair.a : pair.b).support(tx, ty, tz), margin, hysteresis, last, out);
    }

    /** The same, where the other shape's deepest vertex is known. */
    public void face(
            boolean flip, int vertex, double margin, double hysteresis, int last, Manifold out) {
        faceAxis(flip);
        Polyhedron reference = flip ? pair.b : pair.a;
        int face = flip ? axes.faceB : axes.faceA;
        double nx = reference.normalX(face);
        double ny = reference.normalY(face);
        double nz = reference.normalZ(face);
        toOther(flip, nx, ny, nz);
        incidentVertex = vertex;
        incidentFace = Axes.faceToward(flip ? pair.a : pair.b, vertex, tx, ty, tz);
        clipper.clip(pair, flip, face, incidentFace, margin, last);
        clipLevel(flip, reference, face, margin, last);
        boolean many = clipper.count > Manifold.POINTS;
        double mean = many ? Reduction.meanDistance(clipper) : 0;
        reduction.reduce(clipper, nx, ny, nz, 0.01 * hysteresis, hysteresis, last);
        out.patch = many ? Math.rint(GRAINS * mean / Reduction.meanOfCorners(clipper)) / GRAINS : 0;
        for (int i = 0; i < clipper.count; i++) {
            double half = clipper.separation[i] / 2;
            double x = clipper.x[i] - half * nx;
            double y = clipper.y[i] - half * ny;
            double z = clipper.z[i] - half * nz;
            if (flip) {
                double ux = pair.r00 * x + pair.r01 * y + pair.r02 * z + pair.dx;
                double uy = pair.r10 * x + pair.r11 * y + pair.r12 * z + pair.dy;
                z = pair.r20 * x + pair.r21 * y + pair.r22 * z + pair.dz;
                x = ux;
                y = uy;
            }
            point(x, y, z, clipper.separation[i], clipper.feature[i], out);
        }
        writeNormal(out);
    }

    /**
     * Clips the face of a {@link LevelCorner}, too, up to that corner, where the reference face is
     * flat ground. One of several level faces is left alone: two ridges that cross are what bears
     * then, and four points can't hold that and what lies around it.
     */
    private void clipLevel(boolean flip, Polyhedron reference, int face, double margin, int last) {
        if (reference.level.exist(face) || !level.find(pair, !flip, incidentFace, face, last)) {
            return;
        }
        int own = clipper.count;
        clipper.clipMore(face, level.face, level.separation, margin);
        if (clipper.count > own) {
            double nx = reference.normalX(face);
            order.sort(clipper, nx, reference.normalY(face), reference.normalZ(face), margin);
        }
    }

    /** A normal of the reference, reversed, in the other shape's frame. */
    private void toOther(boolean flip, double nx, double ny, double nz) {
        if (flip) {
            tx = -(pair.r00 * nx + pair.r01 * ny + pair.r02 * nz);
            ty = -(pair.r10 * nx + pair.r11 * ny + pair.r12 * nz);
            tz = -(pair.r20 * nx + pair.r21 * ny + pair.r22 * nz);
        } else {
            tx = -(pair.r00 * nx + pair.r10 * ny + pair.r20 * nz);
            ty = -(pair.r01 * nx + pair.r11 * ny + pair.r21 * nz);
            tz = -(pair.r02 * nx + pair.r12 * ny + pair.r22 * nz);
        }
    }

    /**
     * Midway between the nearest points of the lines of two edges; false when they pass beyond an
     * end while apart. Places on an edge count from its middle, so nothing depends on which end is
     * which, and a mirror image gives the mirrored bits.
     */
    public boolean crossing(double margin, Manifold out) {
        Polyhedron a = pair.a;
        int from = a.edgeFrom(axes.edgeA);
        int to = a.edgeTo(axes.edgeA);
        double ax = (a.vertexX(from) + a.vertexX(to)) / 2;
        double ay = (a.vertexY(from) + a.vertexY(to)) / 2;
        double az = (a.vertexZ(from) + a.vertexZ(to)) / 2;
        double ux = (a.vertexX(to) - a.vertexX(from)) / 2;
        double uy = (a.vertexY(to) - a.vertexY(from)) / 2;
        double uz = (a.vertexZ(to) - a.vertexZ(from)) / 2;
        Polyhedron b = pair.b;
        from = b.edgeFrom(axes.edgeB);
        to = b.edgeTo(axes.edgeB);
        double x = (b.vertexX(from) + b.vertexX(to)) / 2;
        double y = (b.vertexY(from) + b.vertexY(to)) / 2;
        double z = (b.vertexZ(from) + b.vertexZ(to)) / 2;
        double px = pair.r00 * x + pair.r01 * y + pair.r02 * z + pair.dx;
        double py = pair.r10 * x + pair.r11 * y + pair.r12 * z + pair.dy;
        double pz = pair.r20 * x + pair.r21 * y + pair.r22 * z + pair.dz;
        x = (b.vertexX(to) - b.vertexX(from)) / 2;
        y = (b.vertexY(to) - b.vertexY(from)) / 2;
        z = (b.vertexZ(to) - b.vertexZ(from)) / 2;
        double vx = pair.r00 * x + pair.r01 * y + pair.r02 * z;
        double vy = pair.r10 * x + pair.r11 * y + pair.r12 * z;
        double vz = pair.r20 * x + pair.r21 * y + pair.r22 * z;
        double rx = px - ax;
        double ry = py - ay;
        double rz = pz - az;
        double uu = ux * ux + uy * uy + uz * uz;
        double vv = vx * vx + vy * vy + vz * vz;
        double uv = ux * vx + uy * vy + uz * vz;
        double ur = ux * rx + uy * ry + uz * rz;
        double vr = vx * rx + vy * ry + vz * rz;
        double det = uu * vv - uv * uv;
        double s = (ur * vv - vr * uv) / det;
        double t = (ur * uv - vr * uu) / det;
        boolean beside =
                !(Math.abs(s) <= ContactTolerances.CROSSING_END
                        && Math.abs(t) <= ContactTolerances.CROSSING_END);
        if (beside || axes.separationEdge > margin) {
            return false;
        }
        setAxis(axes.edgeX, axes.edgeY, axes.edgeZ);
        single(
                (ax + s * ux + (px + t * vx)) / 2,
                (ay + s * uy + (py + t * vy)) / 2,
                (az + s * uz + (pz + t * vz)) / 2,
                axes.separationEdge,
                FeatureIds.CROSSING | axes.edgeA << 15 | axes.edgeB,
                out);
        return true;
    }

    /** The nearest points that GJK ended with. */
    public void nearest(Manifold out) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < gjk.count; i++) {
            x += gjk.weight[i] * pair.vertexAX(gjk.ia[i]);
            y += gjk.weight[i] * pair.vertexAY(gjk.ia[i]);
            z += gjk.weight[i] * pair.vertexAZ(gjk.ia[i]);
        }
        setAxis(gjk.vx / gjk.distance, gjk.vy / gjk.distance, gjk.vz / gjk.distance);
        single(
                x + gjk.vx / 2,
                y + gjk.vy / 2,
                z + gjk.vz / 2,
                gjk.distance,
                FeatureIds.CLOSEST,
                out);
    }

    /**
     * Takes over corners that are given by their point on the incident shape, in A's frame; the
     * normal is the reference's.
     */
    public void take(Clipper c, double nx, double ny, double nz, Manifold out) {
        out.pointCount = 0;
        for (int i = 0; i < c.count; i++) {
            double half = c.separation[i] / 2;
            point(
                    c.x[i] - half * nx,
                    c.y[i] - half * ny,
                    c.z[i] - half * nz,
                    c.separation[i],
                    c.feature[i],
                    out);
        }
        writeNormal(out);
    }

    /** One point more, along the axis that is set. */
    public void add(double x, double y, double z, double separation, int name, Manifold out) {
        point(x, y, z, separation, name, out);
        writeNormal(out);
    }

    public void single(double x, double y, double z, double separation, int name, Manifold out) {
        out.pointCount = 0;
        point(x, y, z, separation, name, out);
        writeNormal(out);
    }

    /** Inserts a point, given in A's frame, in order of its name. */
    private void point(double x, double y, double z, double separation, int name, Manifold out) {
        out.insert(
                name,
                separation,
                pair.w00 * x + pair.w01 * y + pair.w02 * z,
                pair.w10 * x + pair.w11 * y + pair.w12 * z,
                pair.w20 * x + pair.w21 * y + pair.w22 * z);
    }

    /** Writes the axis that is set. */
    public void writeNormal(Manifold out) {
        out.normalX = worldX();
        out.normalY = worldY();
        out.normalZ = worldZ();
    }
}
