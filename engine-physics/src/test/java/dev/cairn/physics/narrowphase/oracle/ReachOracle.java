package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The signed distance of any two convex shapes from nothing but how far each reaches along a
 * direction: the largest separation over all directions, by many starts and a search without
 * derivatives. Never above the truth; below it by what the search leaves.
 */
public final class ReachOracle {
    private static final int SPREAD = 600;
    private static final int STARTS = 5;

    private final Vector3d local = new Vector3d();

    /** How far a shape reaches along a unit direction, from its centre of mass. */
    public double reach(Shape shape, Quaterniond q, Vector3d direction) {
        if (shape instanceof Moved m) {
            // The centre of mass moves along, so only the turn is left.
            Quaterniond turn = new Quaterniond(q).mul(m.rotation(new Quaterniond()));
            return reach(m.inner(), turn, direction);
        }
        Vector3d d = q.transformInverse(direction, local);
        double across = Math.sqrt(d.x * d.x + d.z * d.z);
        if (shape instanceof Sphere s) {
            return s.radius();
        }
        if (shape instanceof Capsule c) {
            return Math.abs(d.y) * c.halfLength() + c.radius();
        }
        if (shape instanceof Cylinder c) {
            return Math.abs(d.y) * c.halfHeight() + across * c.radius();
        }
        if (shape instanceof Cone c) {
            double height = 2 * c.halfHeight();
            return Math.max(.75 * height * d.y, across * c.radius() - .25 * height * d.y);
        }
        Polyhedron h = ConvexOracle.polyhedron(shape);
        double best = -Double.MAX_VALUE;
        for (int v = 0; v < h.vertexCount(); v++) {
            best = Math.max(best, d.x * h.vertexX(v) + d.y * h.vertexY(v) + d.z * h.vertexZ(v));
        }
        return best;
    }

    /** The separation along a unit direction from A to B: a lower bound of the signed distance. */
    public double separation(Scene s, Vector3d n) {
        if (s.a instanceof HalfSpace) {
            Vector3d up = s.qa.transform(new Vector3d(0, 1, 0));
            return up.dot(s.d) - reach(s.b, s.qb, up.negate());
        }
        if (s.b instanceof HalfSpace) {
            Vector3d up = s.qb.transform(new Vector3d(0, 1, 0));
            return -up.dot(s.d) - reach(s.a, s.qa, up.negate());
        }
        Vector3d back = new Vector3d(n).negate();
        return n.dot(s.d) - reach(s.a, s.qa, n) - reach(s.b, s.qb, back);
    }

    public double distance(Scene s) {
        Vector3d[] best = new Vector3d[STARTS];
        double[] value = new double[STARTS];
        java.util.Arrays.fill(value, -Double.MAX_VALUE);
        double golden = StrictMath.PI * (3 - Math.sqrt(5));
        for (int i = 0; i < SPREAD; i++) {
            double y = 1 - (2 * i + 1.0) / SPREAD;
            double across = Math.sqrt(1 - y * y);
            keep(
                    s,
                    best,
                    value,
                    new Vector3d(
                            across * StrictMath.cos(golden * i),
                            y,
                            across * StrictMath.sin(golden * i)));
        }
        flats(s, best, value, s.a, s.qa);
        flats(s, best, value, s.b, s.qb);
        double most = -Double.MAX_VALUE;
        for (int k = 0; k < STARTS; k++) {
            most = Math.max(most, climb(s, best[k], value[k]));
        }
        return most;
    }

    private void flats(Scene s, Vector3d[] best, double[] value, Shape shape, Quaterniond q) {
        if (shape instanceof Moved m) {
            Quaterniond turn = new Quaterniond(q).mul(m.rotation(new Quaterniond()));
            flats(s, best, value, m.inner(), turn);
            return;
        }
        if (shape instanceof Cylinder || shape instanceof Cone) {
            keep(s, best, value, q.transform(new Vector3d(0, 1, 0)));
            keep(s, best, value, q.transform(new Vector3d(0, -1, 0)));
        } else if (shape instanceof Box || shape instanceof ConvexHull) {
            Polyhedron h = ConvexOracle.polyhedron(shape);
            for (int f = 0; f < h.faceCount(); f++) {
                Vector3d n = new Vector3d(h.normalX(f), h.normalY(f), h.normalZ(f));
                q.transform(n);
                keep(s, best, value, n);
                keep(s, best, value, n.negate(new Vector3d()));
            }
        }
    }

    private void keep(Scene s, Vector3d[] best, double[] value, Vector3d n) {
        double v = separation(s, n);
        int at = STARTS;
        while (at > 0 && v > value[at - 1]) {
            at--;
        }
        if (at < STARTS) {
            for (int k = STARTS - 1; k > at; k--) {
                best[k] = best[k - 1];
                value[k] = value[k - 1];
            }
            best[at] = n;
            value[at] = v;
        }
    }

    private double climb(Scene s, Vector3d start, double first) {
        Vector3d n = new Vector3d(start);
        double value = first;
        double twist = 0;
        Vector3d u = new Vector3d();
        Vector3d v = new Vector3d();
        Vector3d m = new Vector3d();
        for (double step = .1; step > 1e-11; ) {
            u.set(Math.abs(n.x) < .6 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0));
            u.cross(n).normalize();
            n.cross(u, v);
            boolean up = false;
            for (int k = 0; k < 16 && !up; k++) {
                double angle = twist + StrictMath.PI * k / 8;
                m.set(n).fma(step * StrictMath.cos(angle), u).fma(step * StrictMath.sin(angle), v);
                m.normalize();
                double here = separation(s, m);
                if (here > value) {
                    value = here;
                    n.set(m);
                    up = true;
                }
            }
            twist += .37;
            step = up ? step * 1.3 : step / 2;
        }
        return value;
    }
}
