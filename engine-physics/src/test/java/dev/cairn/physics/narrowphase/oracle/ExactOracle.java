package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Quaterniond;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The signed distance of two polyhedra with sixty digits, from the very numbers that the engine is
 * given: all face normals and edge pairs, and all features where apart.
 */
public final class ExactOracle {
    private static final MathContext DIGITS = new MathContext(60);

    private ExactOracle() {}

    /** A vector. */
    private record Vec(BigDecimal x, BigDecimal y, BigDecimal z) {
        Vec minus(Vec o) {
            return new Vec(
                    x.subtract(o.x, DIGITS), y.subtract(o.y, DIGITS), z.subtract(o.z, DIGITS));
        }

        Vec plus(Vec o) {
            return new Vec(x.add(o.x, DIGITS), y.add(o.y, DIGITS), z.add(o.z, DIGITS));
        }

        Vec times(BigDecimal f) {
            return new Vec(x.multiply(f, DIGITS), y.multiply(f, DIGITS), z.multiply(f, DIGITS));
        }

        BigDecimal dot(Vec o) {
            return x.multiply(o.x, DIGITS)
                    .add(y.multiply(o.y, DIGITS), DIGITS)
                    .add(z.multiply(o.z, DIGITS), DIGITS);
        }

        Vec cross(Vec o) {
            return new Vec(
                    y.multiply(o.z, DIGITS).subtract(z.multiply(o.y, DIGITS), DIGITS),
                    z.multiply(o.x, DIGITS).subtract(x.multiply(o.z, DIGITS), DIGITS),
                    x.multiply(o.y, DIGITS).subtract(y.multiply(o.x, DIGITS), DIGITS));
        }

        BigDecimal length() {
            return dot(this).sqrt(DIGITS);
        }
    }

    private record Solid(Vec[] vertices, int[][] loops) {
        BigDecimal most(Vec n) {
            BigDecimal best = vertices[0].dot(n);
            for (Vec v : vertices) {
                best = best.max(v.dot(n));
            }
            return best;
        }

        BigDecimal least(Vec n) {
            return most(n.times(BigDecimal.valueOf(-1))).negate();
        }

        Vec normal(int face) {
            Vec o = vertices[loops[face][0]];
            return vertices[loops[face][1]].minus(o).cross(vertices[loops[face][2]].minus(o));
        }
    }

    private static BigDecimal num(double v) {
        return new BigDecimal(v);
    }

    private static Solid solid(Shape shape, Quaterniond q, double x, double y, double z) {
        Polyhedron h = ConvexOracle.polyhedron(shape);
        Vec im = new Vec(num(q.x), num(q.y), num(q.z));
        BigDecimal w = num(q.w);
        BigDecimal two = BigDecimal.valueOf(2).divide(im.dot(im).add(w.multiply(w)), DIGITS);
        Vec at = new Vec(num(x), num(y), num(z));
        Vec[] vertices = new Vec[h.vertexCount()];
        for (int v = 0; v < vertices.length; v++) {
            Vec p = new Vec(num(h.vertexX(v)), num(h.vertexY(v)), num(h.vertexZ(v)));
            // p + 2 u x (u x p + w p) / |q|².
            Vec t = im.cross(p).plus(p.times(w));
            vertices[v] = p.plus(im.cross(t).times(two)).plus(at);
        }
        return new Solid(vertices, h.faceLoops());
    }

    public static double distance(Scene s) {
        Solid a = solid(s.a, s.qa, 0, 0, 0);
        Solid b = solid(s.b, s.qb, s.d.x, s.d.y, s.d.z);
        BigDecimal best = null;
        for (int f = 0; f < a.loops.length; f++) {
            best = max(best, gap(a, b, a.normal(f)));
        }
        for (int f = 0; f < b.loops.length; f++) {
            best = max(best, gap(a, b, b.normal(f).times(BigDecimal.valueOf(-1))));
        }
        for (Vec[] ea : edges(a)) {
            for (Vec[] eb : edges(b)) {
                Vec n = ea[1].minus(ea[0]).cross(eb[1].minus(eb[0]));
                if (n.dot(n).compareTo(new BigDecimal("1e-40")) > 0) {
                    best = max(best, gap(a, b, n));
                    best = max(best, gap(a, b, n.times(BigDecimal.valueOf(-1))));
                }
            }
        }
        return best.signum() <= 0 ? best.doubleValue() : apart(a, b);
    }

    private static BigDecimal max(BigDecimal a, BigDecimal b) {
        return a == null ? b : a.max(b);
    }

    private static BigDecimal gap(Solid a, Solid b, Vec n) {
        return b.least(n).subtract(a.most(n)).divide(n.length(), DIGITS);
    }

    private static Vec[][] edges(Solid s) {
        java.util.List<Vec[]> all = new java.util.ArrayList<>();
        for (int[] loop : s.loops) {
            for (int i = 0; i < loop.length; i++) {
                int j = loop[(i + 1) % loop.length];
                if (loop[i] < j) {
                    all.add(new Vec[] {s.vertices[loop[i]], s.vertices[j]});
                }
            }
        }
        return all.toArray(new Vec[0][]);
    }

    private static double apart(Solid a, Solid b) {
        BigDecimal best = overFaces(a, b).min(overFaces(b, a));
        for (Vec[] ea : edges(a)) {
            for (Vec[] eb : edges(b)) {
                best = best.min(segments(ea, eb));
            }
        }
        return best.doubleValue();
    }

    private static BigDecimal overFaces(Solid a, Solid b) {
        BigDecimal best = num(Double.MAX_VALUE);
        for (int f = 0; f < b.loops.length; f++) {
            Vec n = b.normal(f);
            BigDecimal level = b.most(n);
            for (Vec v : a.vertices) {
                BigDecimal height = v.dot(n).subtract(level);
                if (height.signum() >= 0 && inside(b, f, n, v)) {
                    best = best.min(height.divide(n.length(), DIGITS));
                }
            }
        }
        return best;
    }

    private static boolean inside(Solid b, int f, Vec n, Vec v) {
        int[] loop = b.loops[f];
        for (int i = 0; i < loop.length; i++) {
            Vec o = b.vertices[loop[i]];
            Vec e = b.vertices[loop[(i + 1) % loop.length]].minus(o);
            if (e.cross(n).dot(v.minus(o)).signum() > 0) {
                return false;
            }
        }
        return true;
    }

    private static BigDecimal segments(Vec[] a, Vec[] b) {
        Vec u = a[1].minus(a[0]);
        Vec v = b[1].minus(b[0]);
        Vec r = b[0].minus(a[0]);
        BigDecimal uu = u.dot(u);
        BigDecimal vv = v.dot(v);
        BigDecimal uv = u.dot(v);
        BigDecimal det = uu.multiply(vv, DIGITS).subtract(uv.multiply(uv, DIGITS));
        BigDecimal best =
                point(a[0], b[0], v)
                        .min(point(a[1], b[0], v))
                        .min(point(b[0], a[0], u))
                        .min(point(b[1], a[0], u));
        if (det.compareTo(new BigDecimal("1e-40")) > 0) {
            BigDecimal ur = u.dot(r);
            BigDecimal vr = v.dot(r);
            BigDecimal s = ur.multiply(vv).subtract(vr.multiply(uv)).divide(det, DIGITS);
            BigDecimal t = ur.multiply(uv).subtract(vr.multiply(uu)).divide(det, DIGITS);
            if (unit(s) && unit(t)) {
                best = best.min(r.plus(v.times(t)).minus(u.times(s)).length());
            }
        }
        return best;
    }

    private static boolean unit(BigDecimal t) {
        return t.signum() >= 0 && t.compareTo(BigDecimal.ONE) <= 0;
    }

    private static BigDecimal point(Vec p, Vec q, Vec v) {
        Vec r = p.minus(q);
        BigDecimal t = r.dot(v).divide(v.dot(v), DIGITS);
        t = t.max(BigDecimal.ZERO).min(BigDecimal.ONE);
        return r.minus(v.times(t)).length();
    }
}
