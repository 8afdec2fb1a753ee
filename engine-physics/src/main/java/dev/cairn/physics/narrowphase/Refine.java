package dev.cairn.physics.narrowphase;

import dev.cairn.physics.shape.Polyhedron;

/**
 * From a rough axis of a pair with a round core to the exact one.
 *
 * <p>The signed distance of two cores is the largest separation over all unit axes n,
 *
 * <pre>
 *   s(n) = n . d - hA(n) - hB(-n),
 * </pre>
 *
 * <p>and s is smooth but where a support point is not unique: on the normal of a face or cap, on
 * the great circle at right angles to an edge, on the circle of the normals of a cylinder's or a
 * cone's side. Between those each core counts as a vertex, or as the rim of a disc, whose reach is
 * n . c + R |n - (n . axis) axis|. So the best axis is the normal of a flat, or a crossing of two
 * circles (closed form), or the best point of a circle or of a free region (Newton), and all of
 * these near the rough axis are tried. Each is judged by its true separation, which bounds the
 * signed distance from below whatever led to it, so the largest is the answer.
 */
final class Refine {
    private static final int EDGES = 3;
    private static final int MOST = 8;

    /** A flat: its normal is the axis. */
    static final int FLAT = 0;

    /** A circle of normals, those of a line of the surface. */
    static final int LINE = 1;

    /** A vertex or a rim. */
    static final int POINT = 2;

    /** Not refined: anything as good replaces it. */
    static final int ROUGH = 3;

    /** The best axis, its separation of the cores, and what it belongs to on either side. */
    double axisX, axisY, axisZ, separation;

    int kindA, kindB;
    private final Side sideA = new Side(), sideB = new Side();
    private Pair pair = new Pair();
    private double nx, ny, nz;
    private double startX, startY, startZ;

    /** What one shape may touch with; everything in A's frame and turned towards n. */
    private static final class Side {
        int flats, lines, points;
        final double[] flatX = new double[MOST], flatY = new double[MOST], flatZ = new double[MOST];

        /** Circles: n . c = level. */
        final double[] lineX = new double[MOST],
                lineY = new double[MOST],
                lineZ = new double[MOST],
                level = new double[MOST];

        /** A point of each line or a disc, from A's centre; with the radius of the disc. */
        final double[] px = new double[2 * MOST],
                py = new double[2 * MOST],
                pz = new double[2 * MOST],
                radius = new double[2 * MOST];

        /** The axis of the discs. */
        double ax, ay, az;

        final double[] cosine = new double[EDGES];
        final int[] edge = new int[EDGES];
    }

    /** Starts from a unit axis, which is the answer if nothing is better. */
    void run(Pair p, double x, double y, double z) {
        pair = p;
        startX = x;
        startY = y;
        startZ = z;
        axisX = x;
        axisY = y;
        axisZ = z;
        kindA = ROUGH;
        kindB = ROUGH;
        separation = along(x, y, z);
        gather(sideA, p.roundA, p.spindleA, p.a, false);
        gather(sideB, p.roundB, p.spindleB, p.b, true);
        for (int i = 0; i < sideA.flats; i++) {
            tryAxis(sideA.flatX[i], sideA.flatY[i], sideA.flatZ[i], FLAT, POINT);
        }
        for (int i = 0; i < sideB.flats; i++) {
            tryAxis(sideB.flatX[i], sideB.flatY[i], sideB.flatZ[i], POINT, FLAT);
        }
        for (int i = 0; i < sideA.lines; i++) {
            for (int j = 0; j < sideB.lines; j++) {
                crossing(i, j);
            }
            for (int j = 0; j < sideB.points; j++) {
                circle(sideA, i, MOST + j, sideB, LINE, POINT);
            }
        }
        for (int j = 0; j < sideB.lines; j++) {
            for (int i = 0; i < sideA.points; i++) {
                circle(sideB, j, MOST + i, sideA, POINT, LINE);
            }
        }
        for (int i = 0; i < sideA.points; i++) {
            for (int j = 0; j < sideB.points; j++) {
                free(MOST + i, MOST + j);
            }
        }
    }

    private double along(double x, double y, double z) {
        return x * pair.dx
                + y * pair.dy
                + z * pair.dz
                - pair.reachA(x, y, z)
                - pair.reachB(-x, -y, -z);
    }

    private void tryAxis(double x, double y, double z, int ofA, int ofB) {
        double s = along(x, y, z);
        double tie = 0x1p-46 * pair.scale;
        // Among equals the flatter features tell more.
        if (s > separation + tie || (s > separation - tie && ofA + ofB < kindA + kindB)) {
            separation = s;
            axisX = x;
            axisY = y;
            axisZ = z;
            kindA = ofA;
            kindB = ofB;
        }
    }

    /** Scales to unit length first. */
    private void tryLength(int ofA, int ofB) {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double dot = nx * startX + ny * startY + nz * startZ;
        if (length > 0 && dot > 0.5 * length) {
            tryAxis(nx / length, ny / length, nz / length, ofA, ofB);
        }
    }

    private void gather(Side s, boolean isRound, Spindle spindle, Polyhedron h, boolean flip) {
        s.flats = 0;
        s.lines = 0;
        s.points = 0;
        double x = flip ? -startX : startX;
        double y = flip ? -startY : startY;
        double z = flip ? -startZ : startZ;
        if (flip) {
            double bx = pair.r00 * x + pair.r10 * y + pair.r20 * z;
            double by = pair.r01 * x + pair.r11 * y + pair.r21 * z;
            z = pair.r02 * x + pair.r12 * y + pair.r22 * z;
            x = bx;
            y = by;
        }
        if (isRound) {
            spindle(s, spindle, y, flip);
        } else {
            polyhedron(s, h, x, y, z, flip);
        }
    }

    private void spindle(Side s, Spindle c, double along, boolean flip) {
        s.ax = flip ? pair.r01 : 0;
        s.ay = flip ? pair.r11 : 1;
        s.az = flip ? pair.r21 : 0;
        double sign = flip ? -1 : 1;
        if (along > 0.5 && c.highRadius > 0) {
            flat(s, sign * s.ax, sign * s.ay, sign * s.az);
        }
        if (along < -0.5 && c.lowRadius > 0) {
            flat(s, -sign * s.ax, -sign * s.ay, -sign * s.az);
        }
        if (c.isPoint()) {
            point(s, c.high, 0, flip);
            return;
        }
        if (Math.abs(along - c.sideAlong) < 0.5) {
            line(s, s.ax, s.ay, s.az, sign * c.sideAlong);
            disc(s, s.lines - 1, c.high, c.highRadius, flip);
        }
        boolean nearSide = Math.abs(along - c.sideAlong) < 0.1;
        if (nearSide || along >= c.sideAlong) {
            point(s, c.high, c.highRadius, flip);
        }
        if (nearSide || along < c.sideAlong) {
            point(s, c.low, c.lowRadius, flip);
        }
    }

    private static void flat(Side s, double x, double y, double z) {
        s.flatX[s.flats] = x;
        s.flatY[s.flats] = y;
        s.flatZ[s.flats++] = z;
    }

    private static void line(Side s, double x, double y, double z, double level) {
        s.lineX[s.lines] = x;
        s.lineY[s.lines] = y;
        s.lineZ[s.lines] = z;
        s.level[s.lines++] = level;
    }

    private void point(Side s, double height, double radius, boolean flip) {
        disc(s, MOST + s.points++, height, radius, flip);
    }

    private void disc(Side s, int at, double height, double radius, boolean flip) {
        s.px[at] = s.ax * height + (flip ? pair.dx : 0);
        s.py[at] = s.ay * height + (flip ? pair.dy : 0);
        s.pz[at] = s.az * height + (flip ? pair.dz : 0);
        s.radius[at] = radius;
    }

    private void polyhedron(Side s, Polyhedron h, double x, double y, double z, boolean flip) {
        s.ax = 0;
        s.ay = 1;
        s.az = 0;
        int v = h.support(x, y, z);
        int face = Axes.faceToward(h, v, x, y, z);
        double fx = h.normalX(face);
        double fy = h.normalY(face);
        double fz = h.normalZ(face);
        if (flip) {
            flat(s, -turnX(fx, fy, fz), -turnY(fx, fy, fz), -turnZ(fx, fy, fz));
        } else {
            flat(s, fx, fy, fz);
        }
        vertex(s, MOST + s.points++, h, v, flip);
        int edges = nearestEdges(s, h, v, x, y, z);
        for (int i = 0; i < edges; i++) {
            int from = h.edgeFrom(s.edge[i]);
            int to = h.edgeTo(s.edge[i]);
            double ex = h.vertexX(to) - h.vertexX(from);
            double ey = h.vertexY(to) - h.vertexY(from);
            double ez = h.vertexZ(to) - h.vertexZ(from);
            double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
            ex /= length;
            ey /= length;
            ez /= length;
            if (flip) {
                line(s, turnX(ex, ey, ez), turnY(ex, ey, ez), turnZ(ex, ey, ez), 0);
            } else {
                line(s, ex, ey, ez, 0);
            }
            vertex(s, s.lines - 1, h, v, flip);
        }
    }

    private void vertex(Side s, int at, Polyhedron h, int v, boolean flip) {
        s.radius[at] = 0;
        if (flip) {
            pair.vertexB(v);
            s.px[at] = pair.px;
            s.py[at] = pair.py;
            s.pz[at] = pair.pz;
        } else {
            s.px[at] = h.vertexX(v);
            s.py[at] = h.vertexY(v);
            s.pz[at] = h.vertexZ(v);
        }
    }

    private double turnX(double x, double y, double z) {
        return pair.r00 * x + pair.r01 * y + pair.r02 * z;
    }

    private double turnY(double x, double y, double z) {
        return pair.r10 * x + pair.r11 * y + pair.r12 * z;
    }

    private double turnZ(double x, double y, double z) {
        return pair.r20 * x + pair.r21 * y + pair.r22 * z;
    }

    private static int nearestEdges(Side s, Polyhedron h, int v, double x, double y, double z) {
        int count = 0;
        for (int k = h.spokeBegin(v); k < h.spokeBegin(v + 1); k++) {
            int to = h.spokeVertex(k);
            double ex = h.vertexX(to) - h.vertexX(v);
            double ey = h.vertexY(to) - h.vertexY(v);
            double ez = h.vertexZ(to) - h.vertexZ(v);
            double c = Math.abs(ex * x + ey * y + ez * z) / Math.sqrt(ex * ex + ey * ey + ez * ez);
            int at = count;
            while (at > 0 && s.cosine[at - 1] > c) {
                at--;
            }
            if (at < EDGES) {
                count = Math.min(count + 1, EDGES);
                for (int m = count - 1; m > at; m--) {
                    s.cosine[m] = s.cosine[m - 1];
                    s.edge[m] = s.edge[m - 1];
                }
                s.cosine[at] = c;
                s.edge[at] = h.spokeEdge(k);
            }
        }
        return count;
    }

    /** Where two circles of normals cross: n . a = s and n . b = t. */
    private void crossing(int i, int j) {
        double ax = sideA.lineX[i];
        double ay = sideA.lineY[i];
        double az = sideA.lineZ[i];
        double bx = sideB.lineX[j];
        double by = sideB.lineY[j];
        double bz = sideB.lineZ[j];
        double s = sideA.level[i];
        double t = sideB.level[j];
        double cx = ay * bz - az * by;
        double cy = az * bx - ax * bz;
        double cz = ax * by - ay * bx;
        double det = cx * cx + cy * cy + cz * cz;
        if (det <= 0x1p-60) {
            return;
        }
        double g = ax * bx + ay * by + az * bz;
        double alpha = (s - t * g) / det;
        double beta = (t - s * g) / det;
        double rest = 1 - alpha * s - beta * t;
        if (rest < 0) {
            return;
        }
        double gamma = Math.sqrt(rest / det);
        if (cx * startX + cy * startY + cz * startZ < 0) {
            gamma = -gamma;
        }
        nx = alpha * ax + beta * bx + gamma * cx;
        ny = alpha * ay + beta * by + gamma * cy;
        nz = alpha * az + beta * bz + gamma * cz;
        tryLength(LINE, LINE);
    }

    /**
     * The best axis on the circle of a line of one side against a vertex or rim of the other:
     * Newton along the circle.
     */
    private void circle(Side own, int line, int point, Side other, int ofA, int ofB) {
        double ax = own.lineX[line];
        double ay = own.lineY[line];
        double az = own.lineZ[line];
        double s = own.level[line];
        double q = Math.sqrt(Math.max(0, 1 - s * s));
        double sign = own == sideA ? 1 : -1;
        double cx = sign * (other.px[point] - own.px[line]);
        double cy = sign * (other.py[point] - own.py[line]);
        double cz = sign * (other.pz[point] - own.pz[line]);
        double dot = startX * ax + startY * ay + startZ * az;
        double mx = startX - dot * ax;
        double my = startY - dot * ay;
        double mz = startZ - dot * az;
        for (int step = 0; step < 16; step++) {
            double length = Math.sqrt(mx * mx + my * my + mz * mz);
            if (!(length > 0)) {
                return;
            }
            mx /= length;
            my /= length;
            mz /= length;
            double tx = ay * mz - az * my;
            double ty = az * mx - ax * mz;
            double tz = ax * my - ay * mx;
            nx = s * ax + q * mx;
            ny = s * ay + q * my;
            nz = s * az + q * mz;
            // n' = q t, n'' = -q m.
            double slope = q * (tx * cx + ty * cy + tz * cz);
            double bend = -q * (mx * cx + my * cy + mz * cz);
            if (other.radius[point] > 0) {
                double na = nx * other.ax + ny * other.ay + nz * other.az;
                double ta = q * (tx * other.ax + ty * other.ay + tz * other.az);
                double ma = -q * (mx * other.ax + my * other.ay + mz * other.az);
                double ux = nx - na * other.ax;
                double uy = ny - na * other.ay;
                double uz = nz - na * other.az;
                double rho = Math.sqrt(ux * ux + uy * uy + uz * uz);
                if (rho <= 0x1p-40) {
                    return;
                }
                double rhoSlope = -na * ta / rho;
                slope -= other.radius[point] * rhoSlope;
                bend += other.radius[point] * (ta * ta + na * ma + rhoSlope * rhoSlope) / rho;
            }
            double delta =
                    bend < 0 ? Math.max(-0.5, Math.min(0.5, -slope / bend)) : slope > 0 ? .2 : -.2;
            mx += delta * tx;
            my += delta * ty;
            mz += delta * tz;
            if (Math.abs(delta) <= 0x1p-50) {
                break;
            }
        }
        tryLength(ofA, ofB);
    }

    /** The best axis between two vertices or rims: Newton on the sphere. */
    private void free(int i, int j) {
        double cx = sideB.px[j] - sideA.px[i];
        double cy = sideB.py[j] - sideA.py[i];
        double cz = sideB.pz[j] - sideA.pz[i];
        nx = startX;
        ny = startY;
        nz = startZ;
        if (sideA.radius[i] == 0 && sideB.radius[j] == 0) {
            nx = cx;
            ny = cy;
            nz = cz;
            tryLength(POINT, POINT);
            return;
        }
        for (int step = 0; step < 16; step++) {
            // A basis of the tangent plane from the coordinate axis that is least along n.
            boolean small = Math.abs(nx) < 0.6;
            double ux = small ? 0 : -nz;
            double uy = small ? nz : 0;
            double uz = small ? -ny : nx;
            double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
            ux /= length;
            uy /= length;
            uz /= length;
            double vx = ny * uz - nz * uy;
            double vy = nz * ux - nx * uz;
            double vz = nx * uy - ny * ux;
            double gu = cx * ux + cy * uy + cz * uz;
            double gv = cx * vx + cy * vy + cz * vz;
            double value = cx * nx + cy * ny + cz * nz;
            double huu = 0;
            double huv = 0;
            double hvv = 0;
            for (int k = 0; k < 2; k++) {
                Side side = k == 0 ? sideA : sideB;
                double radius = k == 0 ? side.radius[i] : side.radius[j];
                if (radius == 0) {
                    continue;
                }
                double na = nx * side.ax + ny * side.ay + nz * side.az;
                double mx = nx - na * side.ax;
                double my = ny - na * side.ay;
                double mz = nz - na * side.az;
                double rho = Math.sqrt(mx * mx + my * my + mz * mz);
                if (rho <= 0x1p-40) {
                    return;
                }
                value -= radius * rho;
                gu -= radius * (mx * ux + my * uy + mz * uz) / rho;
                gv -= radius * (mx * vx + my * vy + mz * vz) / rho;
                // The direction along the rim, axis x n / rho, in the tangent plane.
                double wx = (side.ay * nz - side.az * ny) / rho;
                double wy = (side.az * nx - side.ax * nz) / rho;
                double wz = (side.ax * ny - side.ay * nx) / rho;
                double wu = wx * ux + wy * uy + wz * uz;
                double wv = wx * vx + wy * vy + wz * vz;
                huu -= radius / rho * wu * wu;
                huv -= radius / rho * wu * wv;
                hvv -= radius / rho * wv * wv;
            }
            huu -= value;
            hvv -= value;
            double det = huu * hvv - huv * huv;
            if (!(det > 0 && huu < 0)) {
                return;
            }
            double du = -(hvv * gu - huv * gv) / det;
            double dv = -(huu * gv - huv * gu) / det;
            double move = Math.sqrt(du * du + dv * dv);
            double limit = move > 0.3 ? 0.3 / move : 1;
            nx += limit * (du * ux + dv * vx);
            ny += limit * (du * uy + dv * vy);
            nz += limit * (du * uz + dv * vz);
            length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            nx /= length;
            ny /= length;
            nz /= length;
            if (!(move > 0x1p-50)) {
                break;
            }
        }
        tryLength(POINT, POINT);
    }
}
