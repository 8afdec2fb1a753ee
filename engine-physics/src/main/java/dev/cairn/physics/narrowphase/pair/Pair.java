package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedral;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * Two shapes in the frame of the first: its centre of mass is the origin, its axes are the axes. A
 * shape is a core (a polyhedron or a {@link SolidOfRevolution}) and a radius around it. {@code r}
 * turns B's axes into A's, {@code d} is B's centre in A's frame, {@code w} turns A's axes into the
 * world's.
 */
public final class Pair {
    private static final Polyhedron NO_CORE = Polyhedron.of(Box.cubeOfHalfExtent(1));

    /** Of no shapes, and never set: what a search has before its first pair. */
    public static final Pair NONE = new Pair();

    public Polyhedron a = NO_CORE, b = NO_CORE;

    /** The core is no polyhedron; {@link #a} or {@link #b} is then meaningless. */
    public boolean roundA, roundB;

    /** The cores of round shapes. */
    public final SolidOfRevolution solidA = new SolidOfRevolution(),
            solidB = new SolidOfRevolution();

    public double radiusA, radiusB;
    public double r00, r01, r02, r10, r11, r12, r20, r21, r22;

    /** The quaternion of {@code r}, unit up to rounding. */
    public double qx, qy, qz, qw;

    public double w00, w01, w02, w10, w11, w12, w20, w21, w22;
    public double dx, dy, dz;

    /**
     * Sum of the outer radii and of the distance of the centres: what rounding errors are
     * proportional to.
     */
    public double scale;

    /** The smaller outer diameter: what an answer of any use is much finer than. */
    public double small;

    /** The smaller inner radius: what a tolerance of a contact may be proportional to. */
    public double inner;

    /** A support point of B in A's frame, see {@link #vertexB}. */
    public double px, py, pz;

    /** The vertex that the last {@link #faceSeparationA} or {@link #faceSeparationB} met. */
    public int end;

    public void set(
            Shape shapeA,
            Shape shapeB,
            double ax,
            double ay,
            double az,
            double aw,
            double bx,
            double by,
            double bz,
            double bw,
            double wx,
            double wy,
            double wz) {
        a = polyhedron(shapeA);
        b = polyhedron(shapeB);
        roundA = a == NO_CORE && solidA.set(shapeA);
        roundB = b == NO_CORE && solidB.set(shapeB);
        radiusA = roundA ? solidA.round : 0;
        radiusB = roundB ? solidB.round : 0;
        inner = Math.min(shapeA.innerRadius(), shapeB.innerRadius());
        small = 2 * Math.min(shapeA.outerRadius(), shapeB.outerRadius());
        world(ax, ay, az, aw);
        dx = w00 * wx + w10 * wy + w20 * wz;
        dy = w01 * wx + w11 * wy + w21 * wz;
        dz = w02 * wx + w12 * wy + w22 * wz;
        qx = aw * bx - ax * bw - ay * bz + az * by;
        qy = aw * by + ax * bz - ay * bw - az * bx;
        qz = aw * bz - ax * by + ay * bx - az * bw;
        qw = aw * bw + ax * bx + ay * by + az * bz;
        relative(qx, qy, qz, qw);
        scale =
                shapeA.outerRadius()
                        + shapeB.outerRadius()
                        + Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
    }

    private static Polyhedron polyhedron(Shape shape) {
        return shape instanceof Polyhedral p ? Polyhedron.of(p) : NO_CORE;
    }

    /**
     * Rotation matrix of a quaternion that is unit up to rounding; the division removes what
     * rounding left.
     */
    private void world(double x, double y, double z, double w) {
        double s = 2 / (x * x + y * y + z * z + w * w);
        w00 = 1 - s * (y * y + z * z);
        w01 = s * (x * y - z * w);
        w02 = s * (x * z + y * w);
        w10 = s * (x * y + z * w);
        w11 = 1 - s * (x * x + z * z);
        w12 = s * (y * z - x * w);
        w20 = s * (x * z - y * w);
        w21 = s * (y * z + x * w);
        w22 = 1 - s * (x * x + y * y);
    }

    private void relative(double x, double y, double z, double w) {
        double s = 2 / (x * x + y * y + z * z + w * w);
        r00 = 1 - s * (y * y + z * z);
        r01 = s * (x * y - z * w);
        r02 = s * (x * z + y * w);
        r10 = s * (x * y + z * w);
        r11 = 1 - s * (x * x + z * z);
        r12 = s * (y * z - x * w);
        r20 = s * (x * z - y * w);
        r21 = s * (y * z + x * w);
        r22 = 1 - s * (x * x + y * y);
    }

    /**
     * The vertex of A's core farthest in a direction; {@code hint} is any vertex, better a near
     * one.
     */
    public int supportA(double x, double y, double z, int hint) {
        return roundA ? solidA.support(x, y, z) : a.support(x, y, z, hint);
    }

    /** The vertex of B's core farthest in a direction of A's frame. */
    public int supportB(double x, double y, double z, int hint) {
        double bx = r00 * x + r10 * y + r20 * z;
        double by = r01 * x + r11 * y + r21 * z;
        double bz = r02 * x + r12 * y + r22 * z;
        return roundB ? solidB.support(bx, by, bz) : b.support(bx, by, bz, hint);
    }

    public double vertexAX(int vertex) {
        return roundA ? solidA.x(vertex) : a.vertexX(vertex);
    }

    public double vertexAY(int vertex) {
        return roundA ? solidA.y(vertex) : a.vertexY(vertex);
    }

    public double vertexAZ(int vertex) {
        return roundA ? solidA.z(vertex) : a.vertexZ(vertex);
    }

    /** Puts a vertex of B's core, in A's frame, into {@link #px}, {@link #py}, {@link #pz}. */
    public void vertexB(int vertex) {
        double x = roundB ? solidB.x(vertex) : b.vertexX(vertex);
        double y = roundB ? solidB.y(vertex) : b.vertexY(vertex);
        double z = roundB ? solidB.z(vertex) : b.vertexZ(vertex);
        px = r00 * x + r01 * y + r02 * z + dx;
        py = r10 * x + r11 * y + r12 * z + dy;
        pz = r20 * x + r21 * y + r22 * z + dz;
    }

    /** How far the ends of B's core are from its centre at most. */
    public double reach() {
        double end = Math.max(Math.abs(solidB.low), Math.abs(solidB.high));
        return end + Math.max(solidB.lowRadius, solidB.highRadius);
    }

    /** How far B's core reaches along a direction of A's frame, from B's centre. */
    public double reachB(double x, double y, double z) {
        double bx = r00 * x + r10 * y + r20 * z;
        double by = r01 * x + r11 * y + r21 * z;
        double bz = r02 * x + r12 * y + r22 * z;
        if (roundB) {
            return solidB.reach(bx, by, bz);
        }
        int v = b.support(bx, by, bz);
        return b.vertexX(v) * bx + b.vertexY(v) * by + b.vertexZ(v) * bz;
    }

    /** How far A's core reaches along a direction. */
    public double reachA(double x, double y, double z) {
        if (roundA) {
            return solidA.reach(x, y, z);
        }
        int v = a.support(x, y, z);
        return a.vertexX(v) * x + a.vertexY(v) * y + a.vertexZ(v) * z;
    }

    /**
     * A support vertex that does not depend on what came before: where the direction has a zero, a
     * block takes the side towards the other centre, in a mirror image as well.
     */
    public int endA(double x, double y, double z) {
        return roundA ? solidA.support(x, y, z) : a.support(x, y, z, dx, dy, dz);
    }

    /** The same for B, along a direction of A's frame. */
    public int endB(double x, double y, double z) {
        double bx = r00 * x + r10 * y + r20 * z;
        double by = r01 * x + r11 * y + r21 * z;
        double bz = r02 * x + r12 * y + r22 * z;
        if (roundB) {
            return solidB.support(bx, by, bz);
        }
        if (bx != 0 && by != 0 && bz != 0) {
            return b.support(bx, by, bz);
        }
        double ox = -(r00 * dx + r10 * dy + r20 * dz);
        double oy = -(r01 * dx + r11 * dy + r21 * dz);
        double oz = -(r02 * dx + r12 * dy + r22 * dz);
        return b.support(bx, by, bz, ox, oy, oz);
    }

    /**
     * Signed distance of the cores along a unit axis of A's frame that points from A to B; a lower
     * bound of their distance.
     */
    public double separation(double x, double y, double z) {
        int va = endA(x, y, z);
        vertexB(endB(-x, -y, -z));
        return (px - vertexAX(va)) * x + (py - vertexAY(va)) * y + (pz - vertexAZ(va)) * z;
    }

    /** Signed distance along the outward normal of a face of A. */
    public double faceSeparationA(int face) {
        double x = a.normalX(face);
        double y = a.normalY(face);
        double z = a.normalZ(face);
        end = endB(-x, -y, -z);
        vertexB(end);
        return px * x + py * y + pz * z - a.offset(face);
    }

    /** Signed distance along the outward normal of a face of B. */
    public double faceSeparationB(int face) {
        double x = b.normalX(face);
        double y = b.normalY(face);
        double z = b.normalZ(face);
        double ax = r00 * x + r01 * y + r02 * z;
        double ay = r10 * x + r11 * y + r12 * z;
        double az = r20 * x + r21 * y + r22 * z;
        int v = endA(-ax, -ay, -az);
        end = v;
        double ux = vertexAX(v) - dx;
        double uy = vertexAY(v) - dy;
        double uz = vertexAZ(v) - dz;
        return ux * ax + uy * ay + uz * az - b.offset(face);
    }

    /** The same for polyhedra, from a vertex of B that is near. */
    public double faceSeparationA(int face, int near) {
        double x = a.normalX(face);
        double y = a.normalY(face);
        double z = a.normalZ(face);
        end =
                b.climb(
                        -(r00 * x + r10 * y + r20 * z),
                        -(r01 * x + r11 * y + r21 * z),
                        -(r02 * x + r12 * y + r22 * z),
                        near);
        vertexB(end);
        return px * x + py * y + pz * z - a.offset(face);
    }

    /** The same for polyhedra, from a vertex of A that is near. */
    public double faceSeparationB(int face, int near) {
        double x = b.normalX(face);
        double y = b.normalY(face);
        double z = b.normalZ(face);
        double ax = r00 * x + r01 * y + r02 * z;
        double ay = r10 * x + r11 * y + r12 * z;
        double az = r20 * x + r21 * y + r22 * z;
        int v = a.climb(-ax, -ay, -az, near);
        end = v;
        return (a.vertexX(v) - dx) * ax
                + (a.vertexY(v) - dy) * ay
                + (a.vertexZ(v) - dz) * az
                - b.offset(face);
    }
}
