package dev.cairn.physics.narrowphase.gjk;

import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.SolidOfRevolution;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The points with which two shapes touch along the axis of their signed distance.
 *
 * <p>With n that axis, s the separation of the cores along it, and D their Minkowski difference B -
 * A, the point s n is on the surface of D, so B moved by -s n touches A without overlapping, and a
 * point that they then have in common is the answer. A vertex or a point of a rim of the one will
 * do when it is on the other. When edges cross or faces lie on each other it need not be: then B is
 * left a little short of there, by
 *
 * <pre>
 *   e = 2^-28 of the pair's scale,
 * </pre>
 *
 * <p>and {@link Gjk} finds the nearest points p and q. Both lie in the cores, and all of q - p but
 * e n is error: of a search that ends with |q - p| &lt;= e (1 + t) it is at most e sqrt(2 t (2 +
 * t)), since n . (q - p) is e at least; if the signed distance is wrong by g, that and sqrt(2 e g).
 * So a search that is far from exact will do.
 */
public final class Witness {
    /** Of the pair's scale: how far apart the cores are put; more when rounding hides that. */
    private static final double APART = 0x1p-28;

    private static final double MORE = 0x1p4;
    private static final int TRIES = 3;

    /** Of the pair's scale: a point this far beside a shape is on it. */
    private static final double ON = 0x1p-46;

    private final Gjk gjk = new Gjk();
    private Pair pair = Pair.NONE;
    private double nx, ny, nz, cores;

    /** Midway between the two points, in A's frame. */
    public double x, y, z;

    /** The point of A's core that does best, and how far it or its partner is beside a core. */
    private double ax, ay, az, least;

    public Witness() {
        gjk.tolerance = 0x1p-26;
    }

    /**
     * Finds the points.
     *
     * @param dirX unit axis from A to B in A's frame
     * @param distance of the shapes along it, m
     */
    public void find(Pair p, double dirX, double dirY, double dirZ, double distance) {
        pair = p;
        nx = dirX;
        ny = dirY;
        nz = dirZ;
        cores = distance + p.radiusA + p.radiusB;
        least = Double.POSITIVE_INFINITY;
        double enough = ON * p.scale;
        int v = p.supportA(nx, ny, nz, 0);
        weighPoint(p.vertexAX(v), p.vertexAY(v), p.vertexAZ(v));
        if (least > enough) {
            p.vertexB(p.supportB(-nx, -ny, -nz, 0));
            weighPoint(p.px - cores * nx, p.py - cores * ny, p.pz - cores * nz);
        }
        if (least > enough) {
            search();
        }
        double to = 0.5 * (cores + p.radiusA - p.radiusB);
        x = ax + to * nx;
        y = ay + to * ny;
        z = az + to * nz;
    }

    /** Keeps a point of A's core if it is better than the last. */
    private void weighPoint(double px, double py, double pz) {
        Pair p = pair;
        double ofA = p.roundA ? beyond(p.solidA, px, py, pz) : beyond(p.a, px, py, pz);
        double bx = px + cores * nx - p.dx;
        double by = py + cores * ny - p.dy;
        double bz = pz + cores * nz - p.dz;
        double lx = p.r00 * bx + p.r10 * by + p.r20 * bz;
        double ly = p.r01 * bx + p.r11 * by + p.r21 * bz;
        double lz = p.r02 * bx + p.r12 * by + p.r22 * bz;
        double ofB = p.roundB ? beyond(p.solidB, lx, ly, lz) : beyond(p.b, lx, ly, lz);
        double worse = Math.max(ofA, ofB);
        if (worse < least) {
            least = worse;
            ax = px;
            ay = py;
            az = pz;
        }
    }

    /** How far a point is beyond the plane or side that it is farthest beyond. */
    private static double beyond(Polyhedron h, double x, double y, double z) {
        double most = Double.NEGATIVE_INFINITY;
        for (int f = 0; f < h.faceCount(); f++) {
            double s = h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z - h.offset(f);
            most = Math.max(most, s);
        }
        return most;
    }

    private static double beyond(SolidOfRevolution s, double x, double y, double z) {
        double across = Math.sqrt(x * x + z * z) - s.lowRadius;
        double side = across * s.sideAcross + (y - s.low) * s.sideAlong;
        return Math.max(side, Math.max(y - s.high, s.low - y));
    }

    /** The nearest points when B has been put a little short of touching. */
    private void search() {
        Pair p = pair;
        double dx = p.dx;
        double dy = p.dy;
        double dz = p.dz;
        double e = APART * p.scale;
        boolean found = false;
        for (int i = 0; i < TRIES && !found; i++) {
            double back = cores - e;
            p.dx = dx - back * nx;
            p.dy = dy - back * ny;
            p.dz = dz - back * nz;
            p.solidA.restart();
            p.solidB.restart();
            gjk.run(p, nx, ny, nz, Double.MAX_VALUE);
            found = !gjk.overlap;
            e *= MORE;
        }
        p.dx = dx;
        p.dy = dy;
        p.dz = dz;
        if (gjk.count == 3) {
            correctWeights();
            correctWeights();
        }
        nearest();
    }

    /**
     * Corrects the weights of a triangle. A rim gives slivers, whose weights rounding spoils; of
     * what they miss v = q - p by, r, the same formula gives the weights to add: with the edges e
     * and f and m = e x f, (r x f) . m / m² and (e x r) . m / m².
     */
    private void correctWeights() {
        double[] wx = gjk.wx;
        double[] wy = gjk.wy;
        double[] wz = gjk.wz;
        double[] w = gjk.weight;
        double ex = wx[1] - wx[0];
        double ey = wy[1] - wy[0];
        double ez = wz[1] - wz[0];
        double fx = wx[2] - wx[0];
        double fy = wy[2] - wy[0];
        double fz = wz[2] - wz[0];
        double rx = gjk.vx - (w[0] * wx[0] + w[1] * wx[1] + w[2] * wx[2]);
        double ry = gjk.vy - (w[0] * wy[0] + w[1] * wy[1] + w[2] * wy[2]);
        double rz = gjk.vz - (w[0] * wz[0] + w[1] * wz[1] + w[2] * wz[2]);
        double mx = ey * fz - ez * fy;
        double my = ez * fx - ex * fz;
        double mz = ex * fy - ey * fx;
        double square = mx * mx + my * my + mz * mz;
        double f = (mx * (ry * fz - rz * fy) + my * (rz * fx - rx * fz) + mz * (rx * fy - ry * fx));
        double g = (mx * (ey * rz - ez * ry) + my * (ez * rx - ex * rz) + mz * (ex * ry - ey * rx));
        w[1] += f / square;
        w[2] += g / square;
        w[0] -= f / square + g / square;
    }

    /**
     * What the search found, with the error shared by both; both are put into the planes at right
     * angles to n that touch the cores, for between points of a rim it found those of a chord.
     */
    private void nearest() {
        Pair p = pair;
        double px = 0;
        double py = 0;
        double pz = 0;
        for (int i = 0; i < gjk.count; i++) {
            px += gjk.weight[i] * p.vertexAX(gjk.ia[i]);
            py += gjk.weight[i] * p.vertexAY(gjk.ia[i]);
            pz += gjk.weight[i] * p.vertexAZ(gjk.ia[i]);
        }
        double along = gjk.vx * nx + gjk.vy * ny + gjk.vz * nz;
        double below = p.reachA(nx, ny, nz) - (px * nx + py * ny + pz * nz);
        weighPoint(
                px + 0.5 * (gjk.vx - along * nx) + below * nx,
                py + 0.5 * (gjk.vy - along * ny) + below * ny,
                pz + 0.5 * (gjk.vz - along * nz) + below * nz);
    }
}
