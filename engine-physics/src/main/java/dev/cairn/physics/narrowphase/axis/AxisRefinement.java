package dev.cairn.physics.narrowphase.axis;

import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;

import java.util.Arrays;

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
public final class AxisRefinement {
    private static final int STEPS = 32;

    /** Cosine of 0.02 rad: a rim this much across the axis may bend the separation sharply. */
    private static final double NEARLY = 0.9998;

    /** A flat: its normal is the axis. */
    public static final int FLAT = 0;

    /** A circle of normals, those of a line of the surface. */
    public static final int LINE = 1;

    /** A vertex or a rim. */
    public static final int POINT = 2;

    /** Not refined: anything as good replaces it. */
    static final int ROUGH = 3;

    /** The best axis, its separation of the cores, and what it belongs to on either side. */
    public double axisX, axisY, axisZ, separation;

    public int kindA, kindB;

    /**
     * The places of these among the features of either side; of flats and lines the other's is
     * unknown.
     */
    private int placeA, placeB;

    /** The best axis of each sum of two kinds. */
    private final double[] best = new double[2 * ROUGH + 1],
            bestX = new double[2 * ROUGH + 1],
            bestY = new double[2 * ROUGH + 1],
            bestZ = new double[2 * ROUGH + 1];

    private final int[] bestA = new int[2 * ROUGH + 1], bestB = new int[2 * ROUGH + 1];
    private final int[] atA = new int[2 * ROUGH + 1], atB = new int[2 * ROUGH + 1];
    private int nowA, nowB;
    private final CandidateFeatures sideA = new CandidateFeatures(false),
            sideB = new CandidateFeatures(true);
    private final RimStart start = new RimStart();

    /** See {@link #isOptimal}. */
    final OptimalityTest optimality = new OptimalityTest(sideA, sideB);

    private Pair pair = Pair.NONE;
    private double nx, ny, nz;
    private double startX, startY, startZ;

    /** Starts from a unit axis, which is the answer if nothing is better. */
    public void run(Pair p, double x, double y, double z) {
        run(p, x, y, z, false);
    }

    /** The same; wide, all features of polyhedra that are near compete, not those of one corner. */
    public void run(Pair p, double x, double y, double z, boolean wide) {
        pair = p;
        startX = x;
        startY = y;
        startZ = z;
        Arrays.fill(best, Axes.NEVER);
        tryAxis(x, y, z, ROUGH, ROUGH);
        sideA.gather(p, x, y, z, wide);
        sideB.gather(p, -x, -y, -z, wide);
        for (int i = 0; i < sideA.flats; i++) {
            nowA = i;
            tryAxis(sideA.flatX[i], sideA.flatY[i], sideA.flatZ[i], FLAT, POINT);
        }
        for (int i = 0; i < sideB.flats; i++) {
            nowB = i;
            tryAxis(sideB.flatX[i], sideB.flatY[i], sideB.flatZ[i], POINT, FLAT);
        }
        for (int i = 0; i < sideA.lines; i++) {
            for (int j = 0; j < sideB.lines; j++) {
                nowA = i;
                nowB = j;
                crossing(i, j);
            }
            nowA = i;
            for (int j = 0; j < sideB.points; j++) {
                circle(sideA, i, CandidateFeatures.MOST + j, sideB, LINE, POINT);
            }
        }
        for (int j = 0; j < sideB.lines; j++) {
            nowB = j;
            for (int i = 0; i < sideA.points; i++) {
                circle(sideB, j, CandidateFeatures.MOST + i, sideA, POINT, LINE);
            }
        }
        for (int i = 0; i < sideA.points; i++) {
            for (int j = 0; j < sideB.points; j++) {
                free(CandidateFeatures.MOST + i, CandidateFeatures.MOST + j);
            }
        }
        choose();
    }

    private double along(double x, double y, double z) {
        return x * pair.dx
                + y * pair.dy
                + z * pair.dz
                - pair.reachA(x, y, z)
                - pair.reachB(-x, -y, -z);
    }

    /** Keeps the best axis of its flatness; the order of trying does not matter. */
    private void tryAxis(double x, double y, double z, int ofA, int ofB) {
        double s = along(x, y, z);
        int at = ofA + ofB;
        if (s > best[at]) {
            best[at] = s;
            bestX[at] = x;
            bestY[at] = y;
            bestZ[at] = z;
            bestA[at] = ofA;
            bestB[at] = ofB;
            atA[at] = nowA;
            atB[at] = nowB;
        }
    }

    /** Among axes that are equal up to rounding the flattest features tell most. */
    private void choose() {
        double most = Axes.NEVER;
        for (double s : best) {
            most = Math.max(most, s);
        }
        double tie = 0x1p-52 * pair.scale;
        int at = 0;
        while (!(best[at] > most - tie) && best[at] < most) {
            at++;
        }
        separation = best[at];
        axisX = bestX[at];
        axisY = bestY[at];
        axisZ = bestZ[at];
        kindA = bestA[at];
        kindB = bestB[at];
        placeA = atA[at];
        placeB = atB[at];
    }

    /**
     * Whether the axis found is the best of all near ones, see {@link OptimalityTest}, which then
     * tells the way to a better one.
     */
    boolean isOptimal() {
        return optimality.holds(this, pair, placeA, placeB);
    }

    /** Scales to unit length first. */
    private void tryLength(int ofA, int ofB) {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double dot = nx * startX + ny * startY + nz * startZ;
        if (length > 0 && dot > 0.5 * length) {
            tryAxis(nx / length, ny / length, nz / length, ofA, ofB);
        }
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
     * The best axis on the circle of a line of one side against a vertex or rim of the other. When
     * the rim's own axis nearly lies on the circle the reach bends sharply there, so that is a
     * second place to start from.
     */
    private void circle(
            CandidateFeatures own, int line, int point, CandidateFeatures other, int ofA, int ofB) {
        climb(own, line, point, other, startX, startY, startZ, ofA, ofB);
        if (other.radius[point] > 0) {
            double dot = startX * other.ax + startY * other.ay + startZ * other.az;
            if (Math.abs(dot) > NEARLY
                    && start.onCircle(
                            own, line, other, point, dot < 0 ? -1 : 1, own == sideA ? 1 : -1)) {
                climb(own, line, point, other, start.x, start.y, start.z, ofA, ofB);
            }
        }
    }

    /** Newton along a circle from the place of it that is nearest to a direction. */
    private void climb(
            CandidateFeatures own,
            int line,
            int point,
            CandidateFeatures other,
            double fromX,
            double fromY,
            double fromZ,
            int ofA,
            int ofB) {
        double ax = own.lineX[line];
        double ay = own.lineY[line];
        double az = own.lineZ[line];
        double s = own.level[line];
        double q = Math.sqrt(Math.max(0, 1 - s * s));
        double sign = own == sideA ? 1 : -1;
        double cx = sign * (other.px[point] - own.px[line]);
        double cy = sign * (other.py[point] - own.py[line]);
        double cz = sign * (other.pz[point] - own.pz[line]);
        double radius = other.radius[point];
        double noise = 0x1p-50 * (Math.abs(cx) + Math.abs(cy) + Math.abs(cz) + radius);
        double dot = fromX * ax + fromY * ay + fromZ * az;
        double mx = fromX - dot * ax;
        double my = fromY - dot * ay;
        double mz = fromZ - dot * az;
        double keptX = mx;
        double keptY = my;
        double keptZ = mz;
        double tx = 0;
        double ty = 0;
        double tz = 0;
        double delta = 0;
        double last = Axes.NEVER;
        for (int step = 0; step < STEPS; step++) {
            double length = Math.sqrt(mx * mx + my * my + mz * mz);
            if (!(length > 0)) {
                return;
            }
            mx /= length;
            my /= length;
            mz /= length;
            nx = s * ax + q * mx;
            ny = s * ay + q * my;
            nz = s * az + q * mz;
            double na = nx * other.ax + ny * other.ay + nz * other.az;
            double ux = nx - na * other.ax;
            double uy = ny - na * other.ay;
            double uz = nz - na * other.az;
            double rho = Math.sqrt(ux * ux + uy * uy + uz * uz);
            double value = nx * cx + ny * cy + nz * cz - radius * rho;
            if (value < last - noise) {
                // Too far: the reach bends more than it did where the step began.
                delta *= 0.25;
                mx = keptX + delta * tx;
                my = keptY + delta * ty;
                mz = keptZ + delta * tz;
                continue;
            }
            last = value;
            keptX = mx;
            keptY = my;
            keptZ = mz;
            tx = ay * mz - az * my;
            ty = az * mx - ax * mz;
            tz = ax * my - ay * mx;
            // n' = q t, n'' = -q m.
            double slope = q * (tx * cx + ty * cy + tz * cz);
            double bend = -q * (mx * cx + my * cy + mz * cz);
            if (radius > 0) {
                if (rho <= 0x1p-46) {
                    return;
                }
                double ta = q * (tx * other.ax + ty * other.ay + tz * other.az);
                double ma = -q * (mx * other.ax + my * other.ay + mz * other.az);
                double rhoSlope = -na * ta / rho;
                slope -= radius * rhoSlope;
                bend += radius * (ta * ta + na * ma + rhoSlope * rhoSlope) / rho;
            }
            delta = bend < 0 ? Math.max(-0.5, Math.min(0.5, -slope / bend)) : slope > 0 ? .2 : -.2;
            mx += delta * tx;
            my += delta * ty;
            mz += delta * tz;
            if (Math.abs(delta) <= 0x1p-50) {
                break;
            }
        }
        double turn = other == sideA ? 1 : -1;
        if (other.reachesWith(point, turn * nx, turn * ny, turn * nz)) {
            tryLength(ofA, ofB);
        }
    }

    /**
     * The best axis between two vertices or rims. Where rims are nearly parallel the separation
     * bends sharply between their two axes, so there is a second place to start from.
     */
    private void free(int i, int j) {
        double cx = sideB.px[j] - sideA.px[i];
        double cy = sideB.py[j] - sideA.py[i];
        double cz = sideB.pz[j] - sideA.pz[i];
        if (sideA.radius[i] == 0 && sideB.radius[j] == 0) {
            double length = Math.sqrt(cx * cx + cy * cy + cz * cz);
            nx = cx / length;
            ny = cy / length;
            nz = cz / length;
            if (sideA.reachesWith(i, nx, ny, nz) && sideB.reachesWith(j, -nx, -ny, -nz)) {
                tryLength(POINT, POINT);
            }
            return;
        }
        nx = startX;
        ny = startY;
        nz = startZ;
        climb(i, j, cx, cy, cz);
        double a = startX * sideA.ax + startY * sideA.ay + startZ * sideA.az;
        double b = startX * sideB.ax + startY * sideB.ay + startZ * sideB.az;
        boolean rims = sideA.radius[i] > 0 && sideB.radius[j] > 0;
        if (rims
                && Math.abs(a) > NEARLY
                && Math.abs(b) > NEARLY
                && start.ofRims(sideA, i, a < 0 ? -1 : 1, sideB, j, b < 0 ? -1 : 1, cx, cy, cz)) {
            nx = start.x;
            ny = start.y;
            nz = start.z;
            climb(i, j, cx, cy, cz);
        }
    }

    private double gu, gv, huu, huv, hvv, value;
    private double ux, uy, uz, vx, vy, vz;

    /** Newton on the sphere from n. */
    private void climb(int i, int j, double cx, double cy, double cz) {
        double radii = sideA.radius[i] + sideB.radius[j];
        double noise = 0x1p-50 * (Math.abs(cx) + Math.abs(cy) + Math.abs(cz) + radii);
        double keptX = nx;
        double keptY = ny;
        double keptZ = nz;
        double moveX = 0;
        double moveY = 0;
        double moveZ = 0;
        double last = Axes.NEVER;
        for (int step = 0; step < STEPS; step++) {
            if (!local(i, j, cx, cy, cz)) {
                return;
            }
            boolean back = value < last - noise;
            double size;
            if (back) {
                moveX *= 0.25;
                moveY *= 0.25;
                moveZ *= 0.25;
                size = 1;
            } else {
                last = value;
                keptX = nx;
                keptY = ny;
                keptZ = nz;
                double det = huu * hvv - huv * huv;
                if (!(det > 0 && huu < 0)) {
                    return;
                }
                double du = -(hvv * gu - huv * gv) / det;
                double dv = -(huu * gv - huv * gu) / det;
                size = Math.sqrt(du * du + dv * dv);
                double limit = size > 0.3 ? 0.3 / size : 1;
                moveX = limit * (du * ux + dv * vx);
                moveY = limit * (du * uy + dv * vy);
                moveZ = limit * (du * uz + dv * vz);
            }
            nx = keptX + moveX;
            ny = keptY + moveY;
            nz = keptZ + moveZ;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            nx /= length;
            ny /= length;
            nz /= length;
            if (!(size > 0x1p-50)) {
                break;
            }
        }
        if (sideA.reachesWith(i, nx, ny, nz) && sideB.reachesWith(j, -nx, -ny, -nz)) {
            tryLength(POINT, POINT);
        }
    }

    /** The separation along n, its slope and its bend; false on the axis of a rim. */
    private boolean local(int i, int j, double cx, double cy, double cz) {
        // A basis of the tangent plane from the coordinate axis that is least along n.
        boolean small = Math.abs(nx) < 0.6;
        ux = small ? 0 : -nz;
        uy = small ? nz : 0;
        uz = small ? -ny : nx;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= length;
        uy /= length;
        uz /= length;
        vx = ny * uz - nz * uy;
        vy = nz * ux - nx * uz;
        vz = nx * uy - ny * ux;
        gu = cx * ux + cy * uy + cz * uz;
        gv = cx * vx + cy * vy + cz * vz;
        value = cx * nx + cy * ny + cz * nz;
        huu = 0;
        huv = 0;
        hvv = 0;
        for (int k = 0; k < 2; k++) {
            CandidateFeatures side = k == 0 ? sideA : sideB;
            double radius = k == 0 ? side.radius[i] : side.radius[j];
            if (radius == 0) {
                continue;
            }
            double na = nx * side.ax + ny * side.ay + nz * side.az;
            double mx = nx - na * side.ax;
            double my = ny - na * side.ay;
            double mz = nz - na * side.az;
            double rho = Math.sqrt(mx * mx + my * my + mz * mz);
            if (rho <= 0x1p-46) {
                return false;
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
        return true;
    }
}
