package dev.cairn.physics.narrowphase.round;

import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * Pairs with a ball: the distance of a point core to the other core, the radius subtracted.
 * Outside, the nearest point of the polyhedron; inside, its nearest face, which is exact for a
 * point, so no ball ever meets the expanding polytope.
 */
public final class BallAxis {
    /** Up to this many faces all are tried before GJK: one inner product each. */
    private static final int FEW_FACES = 64;

    /** Unit axis from A to B in A's frame. */
    public double axisX, axisY, axisZ;

    /** Signed distance of the cores. */
    public double distance;

    public boolean capped;

    private final BallBox ballBox = new BallBox();
    private double pointX, pointY, pointZ, normalX, normalY, normalZ;

    /**
     * Finds axis and distance; when the cores are farther apart than {@code limit}, any distance
     * above it.
     */
    public void run(Pair p, Shape a, Shape b, boolean closedForm, Gjk gjk, double limit) {
        capped = false;
        if (p.roundA && p.roundB) {
            centres(p);
            return;
        }
        if (p.roundB) {
            pointX = p.dx;
            pointY = p.dy;
            pointZ = p.dz;
        } else {
            pointX = -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz);
            pointY = -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz);
            pointZ = -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz);
        }
        Shape solid = p.roundB ? a : b;
        Polyhedron h = p.roundB ? p.a : p.b;
        boolean done = (closedForm && solid instanceof Box) ? box(h) : few(p, h, limit);
        if (!done) {
            gjk.run(p, p.dx, p.dy, p.dz, limit);
            if (!gjk.overlap) {
                capped = gjk.capped;
                distance = gjk.beyond ? gjk.lower : gjk.distance;
                axisX = gjk.vx / gjk.distance;
                axisY = gjk.vy / gjk.distance;
                axisZ = gjk.vz / gjk.distance;
                return;
            }
            face(h, Double.MAX_VALUE);
        }
        turn(p);
    }

    private void centres(Pair p) {
        double most = Math.max(Math.abs(p.dx), Math.max(Math.abs(p.dy), Math.abs(p.dz)));
        if (most <= 0x1p-1000) {
            distance = 0;
            axisX = 1;
            axisY = 0;
            axisZ = 0;
            return;
        }
        double x = p.dx / most;
        double y = p.dy / most;
        double z = p.dz / most;
        double length = Math.sqrt(x * x + y * y + z * z);
        distance = length * most;
        axisX = x / length;
        axisY = y / length;
        axisZ = z / length;
    }

    /** Turns the polyhedron's outward normal into the axis from A to B in A's frame. */
    private void turn(Pair p) {
        if (p.roundB) {
            axisX = normalX;
            axisY = normalY;
            axisZ = normalZ;
        } else {
            axisX = -(p.r00 * normalX + p.r01 * normalY + p.r02 * normalZ);
            axisY = -(p.r10 * normalX + p.r11 * normalY + p.r12 * normalZ);
            axisZ = -(p.r20 * normalX + p.r21 * normalY + p.r22 * normalZ);
        }
    }

    /** Closed form for a block, whose vertex 7 is its half extents. */
    private boolean box(Polyhedron h) {
        ballBox.measure(pointX, pointY, pointZ, h.vertexX(7), h.vertexY(7), h.vertexZ(7));
        distance = ballBox.distance;
        normalX = ballBox.x;
        normalY = ballBox.y;
        normalZ = ballBox.z;
        return true;
    }

    /**
     * Tries all faces of a small polyhedron; true when the nearest point lies in one of them or
     * inside.
     */
    private boolean few(Pair p, Polyhedron h, double limit) {
        if (h.faceCount() > FEW_FACES) {
            return false;
        }
        int f = face(h, limit);
        if (distance > limit || distance <= 0x1p-42 * p.scale) {
            return true;
        }
        for (int s = h.faceBegin(f); s < h.faceBegin(f + 1); s++) {
            if (h.sideX(s) * pointX + h.sideY(s) * pointY + h.sideZ(s) * pointZ > h.sideOffset(s)) {
                return false;
            }
        }
        return true;
    }

    /** The face that the point is highest above, or the first one above the limit. */
    private int face(Polyhedron h, double limit) {
        int best = 0;
        distance = -Double.MAX_VALUE;
        for (int f = 0; f < h.faceCount() && distance <= limit; f++) {
            double s =
                    h.normalX(f) * pointX
                            + h.normalY(f) * pointY
                            + h.normalZ(f) * pointZ
                            - h.offset(f);
            if (s > distance) {
                distance = s;
                best = f;
            }
        }
        normalX = h.normalX(best);
        normalY = h.normalY(best);
        normalZ = h.normalZ(best);
        return best;
    }
}
