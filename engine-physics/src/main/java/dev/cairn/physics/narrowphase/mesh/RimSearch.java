package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.MeshBuilder;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The points of a convex shape at edges and corners of triangles that stand out of the surface: the
 * general narrow phase of triangle and shape, of whose points those stay whose normal the surface
 * allows. One worker's; all in axes of the mesh, from the centre of the shape, m.
 */
final class RimSearch {
    private final NarrowPhase narrowPhase;
    private final FaceRegions faces;
    private final EdgePoints loose;
    private final Margin margin;
    private final ConvexHull view = ConvexHull.triangle();
    private final Polyhedron flat = Polyhedron.of(view);
    private final NormalCone cone = new NormalCone();
    private final RidgeCulling calm = new RidgeCulling();
    private final TriangleGap gap = new TriangleGap();
    private final RimPoints rims = new RimPoints();
    private final Manifold manifold = new Manifold();
    private final double[] corner = new double[9];
    private TriangleSet set = MeshBuilder.nothing();
    private TriangleSet.Found found = new TriangleSet.Found();
    private Shape shape = view;
    private Pair pair = Pair.NONE;
    private double qx, qy, qz, qw, cx, cy, cz, tolerance;

    /** The triangle at hand: its unit normal towards the shape, and 1, or -1 from the back. */
    private double nx, ny, nz, front;

    private int flags;

    /**
     * For the triangles of some faces.
     *
     * @param narrowPhase collides single triangles
     * @param loose receives the points
     * @param margin up to which points are of interest
     */
    RimSearch(NarrowPhase narrowPhase, FaceRegions faces, EdgePoints loose, Margin margin) {
        this.narrowPhase = narrowPhase;
        this.faces = faces;
        this.loose = loose;
        this.margin = margin;
    }

    /** Chooses the surface, and which triangles are near. */
    void begin(TriangleSet triangles, TriangleSet.Found near) {
        set = triangles;
        found = near;
        calm.clear();
        loose.clear();
    }

    /**
     * Chooses the shape.
     *
     * @param convex with its orientation in the mesh's axes
     * @param own whose A it is
     * @param x its centre in the mesh's frame, m
     * @param tolerated how far from a place one is on it, m
     */
    void place(
            Shape convex,
            Pair own,
            double ox,
            double oy,
            double oz,
            double ow,
            double x,
            double y,
            double z,
            double tolerated) {
        shape = convex;
        pair = own;
        qx = ox;
        qy = oy;
        qz = oz;
        qw = ow;
        cx = x;
        cy = y;
        cz = z;
        tolerance = tolerated;
    }

    /**
     * How far the core of the shape reaches towards a triangle, m.
     *
     * @param normalX unit normal of the triangle that is looked at next
     */
    double reach(double normalX, double normalY, double normalZ) {
        return calm.reach(pair, normalX, normalY, normalZ);
    }

    /**
     * Looks which ridges of a triangle are calm, seen from it; of all before the first search.
     *
     * @param edges bits of its edges
     * @param normalX unit normal towards the shape
     * @param side 1, or -1 from the back
     */
    void look(
            int t,
            int edges,
            double[] corners,
            double normalX,
            double normalY,
            double normalZ,
            double side) {
        flags = edges;
        front = side;
        calm.look(set, t, ridges(), corners, normalX, normalY, normalZ, side, pair, tolerance);
    }

    /**
     * Finds the points of one triangle, unless what stands out of it is calm.
     *
     * @param i its place among the faces
     */
    void run(int i) {
        int t = faces.read(i, corner);
        nx = faces.normalOf(i, 0);
        ny = faces.normalOf(i, 1);
        nz = faces.normalOf(i, 2);
        front = faces.orientation(i);
        flags = faces.edges(i);
        int open = flags / TriangleSet.OPEN & TriangleSet.ALL;
        int ridges = ridges();
        int others = calm.others(set, t, ridges);
        if ((open | others) == 0) {
            return;
        }
        if (gap.isApart(corner, nx, ny, nz, pair, margin)) {
            return;
        }
        boolean oneNormal =
                open == 0
                        && calm.between(
                                        set, t, ridges, corner, nx, ny, nz, front, pair, margin,
                                        tolerance)
                                == 0;
        int own = oneNormal ? calm.own(set, t, ridges, nx, ny, nz) : -1;
        if ((own & (open | others)) == 0) {
            return;
        }
        double gx = (corner[0] + corner[3] + corner[6]) / 3;
        double gy = (corner[1] + corner[4] + corner[7]) / 3;
        double gz = (corner[2] + corner[5] + corner[8]) / 3;
        flat.setTriangle(corner, gx, gy, gz);
        if (own < 0 || !lies(t, faces.groupOf(i), own & others, gx, gy, gz)) {
            standsOut(t, faces.groupOf(i), gx, gy, gz);
        }
    }

    /** Of the triangle at hand, on its side. */
    private int ridges() {
        return flags / (front > 0 ? TriangleSet.CONVEX : TriangleSet.HOLLOW) & TriangleSet.ALL;
    }

    /**
     * Points of some of the triangle's edges on which a flat of the shape lies.
     *
     * @return false if they are not as deep as these are known to be met, or deeper than what lies
     *     on a face is in it
     */
    private boolean lies(int t, int group, int edges, double gx, double gy, double gz) {
        Clipper c =
                rims.cut(
                        view,
                        front,
                        shape,
                        qx,
                        qy,
                        qz,
                        qw,
                        gx,
                        gy,
                        gz,
                        nx,
                        ny,
                        nz,
                        margin.along(nx, ny, nz));
        double least = Double.MAX_VALUE;
        for (int i = 0; i < c.count; i++) {
            least = Math.min(least, c.separation[i]);
        }
        if (least > calm.met + tolerance || least < -RidgeCulling.DEEP * pair.inner) {
            return false;
        }
        for (int i = 0; i < c.count; i++) {
            int name = TriangleFeatures.shared(set, t, c.feature[i]);
            int kind = name & FeatureIds.CLOSEST;
            if (kind == FeatureIds.VERTEX_B || kind == FeatureIds.CLOSEST) {
                continue;
            }
            double s = c.separation[i];
            double x = c.x[i] + gx;
            double y = c.y[i] + gy;
            double z = c.z[i] + gz;
            double px = x - s * nx;
            double py = y - s * ny;
            double pz = z - s * nz;
            if ((on(px, py, pz) & edges) != 0 && allows(px, py, pz, nx, ny, nz)) {
                loose.add(group, t, name, x, y, z, s);
            }
        }
        return true;
    }

    /** Points of the triangle's edges and corners where the surface lets their normal be. */
    private void standsOut(int t, int group, double gx, double gy, double gz) {
        narrowPhase.collide(
                view, shape, 0, 0, 0, 1, qx, qy, qz, qw, -gx, -gy, -gz, margin.most(), 0, manifold);
        Manifold m = manifold;
        double along = m.normalX * nx + m.normalY * ny + m.normalZ * nz;
        boolean any = false;
        for (int i = 0; i < m.pointCount && along > 0; i++) {
            any |= stands(t, group, i, along, gx, gy, gz);
        }
        if (m.pointCount > 0 && along < FaceRegions.ONE_PLANE && !any) {
            nearest(t, gx, gy, gz);
        }
    }

    /** Takes a point of the manifold; returns whether its normal may be there. */
    private boolean stands(int t, int group, int i, double along, double gx, double gy, double gz) {
        Manifold m = manifold;
        if (m.separation[i] > margin.along(m.normalX, m.normalY, m.normalZ)) {
            return false;
        }
        double half = m.separation[i] / 2;
        double x = m.pointX[i] + gx;
        double y = m.pointY[i] + gy;
        double z = m.pointZ[i] + gz;
        double px = x - half * m.normalX;
        double py = y - half * m.normalY;
        double pz = z - half * m.normalZ;
        if (!isOut(t, px, py, pz)) {
            return false;
        }
        x += half * m.normalX;
        y += half * m.normalY;
        z += half * m.normalZ;
        int name = TriangleFeatures.shared(set, t, m.feature[i]);
        int kind = name & FeatureIds.CLOSEST;
        if (along < FaceRegions.ONE_PLANE && allows(px, py, pz, m.normalX, m.normalY, m.normalZ)) {
            int own = loose.group(m.normalX, m.normalY, m.normalZ);
            loose.add(own, t, name, x, y, z, m.separation[i]);
            return true;
        }
        if (along > ContactTolerances.NEARLY_PARALLEL
                && kind != FeatureIds.VERTEX_B
                && kind != FeatureIds.CLOSEST
                && allows(px, py, pz, nx, ny, nz)) {
            loose.add(group, t, name, x, y, z, m.separation[i] * along);
            return true;
        }
        return false;
    }

    /**
     * The points of a face are preferred to a slightly better pair of edges, to keep contacts calm.
     * Where the surface does not let that face's normal be, it is the nearest points after all.
     */
    private void nearest(int t, double gx, double gy, double gz) {
        Manifold m = manifold;
        double d = narrowPhase.closest(view, shape, 0, 0, 0, 1, qx, qy, qz, qw, -gx, -gy, -gz, m);
        if (d > margin.along(m.normalX, m.normalY, m.normalZ)) {
            return;
        }
        double half = d / 2;
        double x = m.pointX[0] + gx;
        double y = m.pointY[0] + gy;
        double z = m.pointZ[0] + gz;
        double px = x - half * m.normalX;
        double py = y - half * m.normalY;
        double pz = z - half * m.normalZ;
        if (isOut(t, px, py, pz)
                && m.normalX * nx + m.normalY * ny + m.normalZ * nz > 0
                && allows(px, py, pz, m.normalX, m.normalY, m.normalZ)) {
            int own = loose.group(m.normalX, m.normalY, m.normalZ);
            loose.add(
                    own,
                    t,
                    FeatureIds.CLOSEST,
                    x + half * m.normalX,
                    y + half * m.normalY,
                    z + half * m.normalZ,
                    d);
        }
    }

    private int on(double px, double py, double pz) {
        return TriangleSides.on(corner, front * nx, front * ny, front * nz, px, py, pz, tolerance);
    }

    private boolean allows(double px, double py, double pz, double x, double y, double z) {
        return cone.allows(set, found, px, py, pz, x, y, z, cx, cy, cz, tolerance);
    }

    /** Whether a place of the triangle is on an edge or at a corner that stands out. */
    private boolean isOut(int t, double px, double py, double pz) {
        int on = on(px, py, pz);
        int edges = ridges() | ((flags / TriangleSet.OPEN) & TriangleSet.ALL);
        if ((on & edges) != 0) {
            return true;
        }
        // corner c is between edge c and the one before
        int at = on & (on << 1 | on >> 2);
        if (at == 0) {
            return false;
        }
        int side = front > 0 ? TriangleSet.CORNER : TriangleSet.CORNER_BACK;
        return (at & set.flags(t) / side & TriangleSet.ALL) != 0;
    }
}
