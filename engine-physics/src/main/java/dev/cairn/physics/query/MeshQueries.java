package dev.cairn.physics.query;

import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.MeshBuilder;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.jspecify.annotations.Nullable;

/**
 * The questions of {@link ShapeQueries} about a surface of triangles and a convex shape: those of
 * the single triangles that its tree finds. Of equals the triangle that comes first in the tree
 * wins. Allocates only when there are more triangles than ever.
 */
final class MeshQueries {
    private final NarrowPhase narrowPhase;
    private final ConvexHull view = ConvexHull.triangle();
    private final Polyhedron flat = Polyhedron.of(view);
    final Placement triangle = new Placement();
    private final Placement start = new Placement();
    private final TriangleSet.Found found = new TriangleSet.Found();
    private final double[] box = new double[6], wide = new double[6];
    final double[] corner = new double[9];
    private final double[] ray = new double[6], pad = new double[3];
    private final Hit hit = new Hit();

    private TriangleSet set = MeshBuilder.nothing();

    /** Where the surface is: origin and orientation, with the turn of a moved shape. */
    double ox, oy, oz, qx, qy, qz, qw;

    private double tx, ty, tz;
    double nx, ny, nz;

    MeshQueries(NarrowPhase narrowPhase) {
        this.narrowPhase = narrowPhase;
    }

    /** The triangles of a shape, or null. */
    static @Nullable TriangleSet triangles(Shape shape) {
        Shape inner = Surface.unmoved(shape);
        return inner instanceof Meshed m ? TriangleSet.of(m) : null;
    }

    void use(Placement mesh, TriangleSet triangles) {
        set = triangles;
        ox = mesh.x;
        oy = mesh.y;
        oz = mesh.z;
        qx = mesh.qx;
        qy = mesh.qy;
        qz = mesh.qz;
        qw = mesh.qw;
        if (mesh.shape instanceof Moved m) {
            double rx = MovedTurn.x(m, qx, qy, qz, qw);
            double ry = MovedTurn.y(m, qx, qy, qz, qw);
            double rz = MovedTurn.z(m, qx, qy, qz, qw);
            qw = MovedTurn.w(m, qx, qy, qz, qw);
            qx = rx;
            qy = ry;
            qz = rz;
        }
    }

    /** Into t, from the mesh's axes to the world's. */
    private void toWorld(double x, double y, double z) {
        double ux = 2 * (qy * z - qz * y);
        double uy = 2 * (qz * x - qx * z);
        double uz = 2 * (qx * y - qy * x);
        tx = x + qw * ux + (qy * uz - qz * uy);
        ty = y + qw * uy + (qz * ux - qx * uz);
        tz = z + qw * uz + (qx * uy - qy * ux);
    }

    /** Into t, from the world's axes to the mesh's. */
    private void toMesh(double x, double y, double z) {
        double ux = 2 * (qz * y - qy * z);
        double uy = 2 * (qx * z - qz * x);
        double uz = 2 * (qy * x - qx * y);
        tx = x + qw * ux + (qz * uy - qy * uz);
        ty = y + qw * uy + (qx * uz - qz * ux);
        tz = z + qw * uz + (qy * ux - qx * uy);
    }

    /** Makes a triangle the shape at hand, placed in the world about its middle. */
    void place(int t) {
        set.corners(t, corner);
        double gx = (corner[0] + corner[3] + corner[6]) / 3;
        double gy = (corner[1] + corner[4] + corner[7]) / 3;
        double gz = (corner[2] + corner[5] + corner[8]) / 3;
        flat.setTriangle(corner, gx, gy, gz);
        toWorld(gx, gy, gz);
        triangle.setCentre(view, ox + tx, oy + ty, oz + tz, qx, qy, qz, qw);
    }

    private double distance(int t, Placement c) {
        place(t);
        return narrowPhase.distance(
                view,
                c.shape,
                qx,
                qy,
                qz,
                qw,
                c.qx,
                c.qy,
                c.qz,
                c.qw,
                c.x - triangle.x,
                c.y - triangle.y,
                c.z - triangle.z);
    }

    /** The least signed distance of the triangles, m; infinite of two surfaces. */
    double distance(Placement mesh, TriangleSet triangles, Placement c) {
        use(mesh, triangles);
        int best = nearest(c);
        return best < 0 ? Double.POSITIVE_INFINITY : distance(best, c);
    }

    /**
     * The triangle with the least signed distance: looked for in the shape's box, wider and wider.
     * What is nearer than the box is wide is in it.
     */
    private int nearest(Placement c) {
        if (triangles(c.shape) != null) {
            return -1;
        }
        double size = bounds(c);
        double far = 0;
        for (int axis = 0; axis < 3; axis++) {
            far = Math.max(far, set.end(axis, true) - box[axis]);
            far = Math.max(far, box[axis + 3] - set.end(axis, false));
        }
        double width = 0;
        while (true) {
            for (int i = 0; i < 3; i++) {
                wide[i] = box[i] - width;
                wide[i + 3] = box[i + 3] + width;
            }
            set.find(wide, found);
            int best = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < found.count; i++) {
                double d = distance(found.triangle[i], c);
                if (d < least) {
                    least = d;
                    best = found.triangle[i];
                }
            }
            if (least <= width || width > far) {
                return best;
            }
            // a distance is known: no farther need we look
            boolean known = least < Double.POSITIVE_INFINITY;
            width = known ? least : Math.max(2 * width, Math.max(size / 4, far * 0x1p-20));
        }
    }

    /** The shape's box in the mesh's frame; returns its longest side. */
    private double bounds(Placement c) {
        double px = qw * c.qx - qx * c.qw - qy * c.qz + qz * c.qy;
        double py = qw * c.qy + qx * c.qz - qy * c.qw - qz * c.qx;
        double pz = qw * c.qz - qx * c.qy + qy * c.qx - qz * c.qw;
        double pw = qw * c.qw + qx * c.qx + qy * c.qy + qz * c.qz;
        c.shape.bounds(px, py, pz, pw, box, 0);
        toMesh(c.x - ox, c.y - oy, c.z - oz);
        double most = 0;
        for (int axis = 0; axis < 3; axis++) {
            double at = axis == 0 ? tx : axis == 1 ? ty : tz;
            // with room for rounding, as for the tree's boxes
            double room = 0x1p-44 * (Math.abs(at) + box[axis + 3] - box[axis]);
            most = Math.max(most, box[axis + 3] - box[axis]);
            box[axis] += at - room;
            box[axis + 3] += at + room;
        }
        return most;
    }

    /** The nearest points of a surface, which is the first shape, and a convex shape. */
    double closest(Placement mesh, TriangleSet triangles, Placement c, Manifold m, Closest out) {
        use(mesh, triangles);
        int best = nearest(c);
        if (best < 0) {
            throw new IllegalArgumentException(
                    "both shapes are surfaces of triangles, which have no distance here; ask with a"
                            + " convex one");
        }
        place(best);
        double d =
                narrowPhase.closest(
                        view,
                        c.shape,
                        qx,
                        qy,
                        qz,
                        qw,
                        c.qx,
                        c.qy,
                        c.qz,
                        c.qw,
                        c.x - triangle.x,
                        c.y - triangle.y,
                        c.z - triangle.z,
                        m);
        double half = d / 2;
        out.distance = d;
        out.normalX = m.normalX;
        out.normalY = m.normalY;
        out.normalZ = m.normalZ;
        out.ax = triangle.x + (m.pointX[0] - half * m.normalX);
        out.ay = triangle.y + (m.pointY[0] - half * m.normalY);
        out.az = triangle.z + (m.pointZ[0] - half * m.normalZ);
        out.bx = triangle.x + (m.pointX[0] + half * m.normalX);
        out.by = triangle.y + (m.pointY[0] + half * m.normalY);
        out.bz = triangle.z + (m.pointZ[0] + half * m.normalZ);
        out.triangle = set.source(best);
        toMesh(out.ax - ox, out.ay - oy, out.az - oz);
        weigh(tx, ty, tz);
        out.weight1 = weight1;
        out.weight2 = weight2;
        return d;
    }

    double weight1, weight2;

    /** Barycentric coordinates of a place in the plane of the corners at hand. */
    void weigh(double x, double y, double z) {
        normal();
        double length = nx * nx + ny * ny + nz * nz;
        weight1 = area(6, 0, x, y, z) / length;
        weight2 = area(0, 3, x, y, z) / length;
    }

    void normal() {
        double ux = corner[3] - corner[0];
        double uy = corner[4] - corner[1];
        double uz = corner[5] - corner[2];
        double vx = corner[6] - corner[0];
        double vy = corner[7] - corner[1];
        double vz = corner[8] - corner[2];
        nx = uy * vz - uz * vy;
        ny = uz * vx - ux * vz;
        nz = ux * vy - uy * vx;
    }

    /** Of the triangle of two corners and a place, twice its area times that of the whole. */
    private double area(int a, int b, double x, double y, double z) {
        double ux = corner[b] - corner[a];
        double uy = corner[b + 1] - corner[a + 1];
        double uz = corner[b + 2] - corner[a + 2];
        double vx = x - corner[a];
        double vy = y - corner[a + 1];
        double vz = z - corner[a + 2];
        return nx * (uy * vz - uz * vy) + ny * (uz * vx - ux * vz) + nz * (ux * vy - uy * vx);
    }

    // Rays and moving shapes ---------------------------------------------------------------------

    private void aim(double x, double y, double z, double dx, double dy, double dz) {
        toMesh(x - ox, y - oy, z - oz);
        ray[0] = tx;
        ray[1] = ty;
        ray[2] = tz;
        toMesh(dx, dy, dz);
        ray[3] = tx;
        ray[4] = ty;
        ray[5] = tz;
    }

    /**
     * The first triangle on a ray whose front it meets, or whose back where both sides count.
     *
     * @param from where the ray starts; its shape does not matter
     * @param dx unit direction, world
     */
    boolean rayCast(
            Placement mesh,
            TriangleSet triangles,
            Placement from,
            double dx,
            double dy,
            double dz,
            double maxDistance,
            Hit out) {
        use(mesh, triangles);
        aim(from.x, from.y, from.z, dx, dy, dz);
        pad[0] = pad[1] = pad[2] = 0;
        set.along(ray, maxDistance, pad, found);
        double limit = maxDistance;
        int best = -1;
        for (int i = 0; i < found.count; i++) {
            double t = meet(found.triangle[i]);
            if (t <= limit && (best < 0 || t < limit)) {
                limit = t;
                best = found.triangle[i];
            }
        }
        if (best < 0) {
            return false;
        }
        set.corners(best, corner);
        normal();
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double sign = nx * ray[3] + ny * ray[4] + nz * ray[5] > 0 ? -1 : 1;
        toWorld(sign * nx / length, sign * ny / length, sign * nz / length);
        out.normalX = tx;
        out.normalY = ty;
        out.normalZ = tz;
        out.distance = limit;
        out.inside = false;
        out.capped = false;
        out.pointX = from.x + limit * dx;
        out.pointY = from.y + limit * dy;
        out.pointZ = from.z + limit * dz;
        out.triangle = set.source(best);
        weigh(ray[0] + limit * ray[3], ray[1] + limit * ray[4], ray[2] + limit * ray[5]);
        out.weight1 = weight1;
        out.weight2 = weight2;
        return true;
    }

    /**
     * Where a ray meets a triangle, in lengths of its direction; infinite if it does not. The sides
     * are told by volumes with the ray, whose sign two neighbours compute alike, so no ray slips
     * through between them.
     */
    private double meet(int t) {
        set.corners(t, corner);
        normal();
        double across = nx * ray[3] + ny * ray[4] + nz * ray[5];
        if (across == 0 || (across > 0 && !set.isTwoSided)) {
            return Double.POSITIVE_INFINITY;
        }
        for (int c = 0; c < 9; c += 3) {
            corner[c] -= ray[0];
            corner[c + 1] -= ray[1];
            corner[c + 2] -= ray[2];
        }
        double s0 = side(0, 3);
        double s1 = side(3, 6);
        double s2 = side(6, 0);
        boolean isIn = (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
        double height = nx * corner[0] + ny * corner[1] + nz * corner[2];
        double at = height / across;
        return isIn && at >= 0 ? at : Double.POSITIVE_INFINITY;
    }

    /** (a x b) . d of two corners seen from the origin of the ray; minus itself for (b, a). */
    private double side(int a, int b) {
        double x = corner[a + 1] * corner[b + 2] - corner[a + 2] * corner[b + 1];
        double y = corner[a + 2] * corner[b] - corner[a] * corner[b + 2];
        double z = corner[a] * corner[b + 1] - corner[a + 1] * corner[b];
        return x * ray[3] + y * ray[4] + z * ray[5];
    }

    /**
     * The first triangle that a moving shape meets from the front.
     *
     * @param owner moves the shape towards single triangles
     * @param mover where it starts
     * @param dx unit direction, world
     */
    boolean shapeCast(
            ShapeQueries owner,
            Placement mover,
            double dx,
            double dy,
            double dz,
            double maxDistance,
            Placement mesh,
            TriangleSet triangles,
            Hit out) {
        use(mesh, triangles);
        start.setCentre(
                mover.shape, mover.x, mover.y, mover.z, mover.qx, mover.qy, mover.qz, mover.qw);
        aim(start.x, start.y, start.z, dx, dy, dz);
        bounds(start);
        for (int axis = 0; axis < 3; axis++) {
            // the box is about another point than the centre
            pad[axis] = Math.max(box[axis + 3] - ray[axis], ray[axis] - box[axis]);
        }
        set.along(ray, maxDistance, pad, found);
        double limit = maxDistance;
        int best = -1;
        for (int i = 0; i < found.count; i++) {
            int t = found.triangle[i];
            place(t);
            normal();
            boolean isBehind =
                    nx * (ray[0] - corner[0])
                                    + ny * (ray[1] - corner[1])
                                    + nz * (ray[2] - corner[2])
                            < 0;
            boolean leaves = nx * ray[3] + ny * ray[4] + nz * ray[5] >= 0;
            if (!set.isTwoSided && (isBehind || leaves)) {
                continue;
            }
            if (owner.castOne(start, dx, dy, dz, limit, triangle, hit)
                    && (best < 0 || hit.distance < limit)) {
                limit = hit.distance;
                best = t;
                out.set(hit);
            }
        }
        if (best < 0) {
            return false;
        }
        set.corners(best, corner);
        toMesh(out.pointX - ox, out.pointY - oy, out.pointZ - oz);
        weigh(tx, ty, tz);
        out.triangle = set.source(best);
        out.weight1 = weight1;
        out.weight2 = weight2;
        return true;
    }
}
