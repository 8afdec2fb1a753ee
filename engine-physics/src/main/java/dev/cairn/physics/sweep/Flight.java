package dev.cairn.physics.sweep;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.jspecify.annotations.Nullable;

/**
 * The way of a shape: a point that it turns about (the pivot) goes along a parabola, and the shape
 * turns about it at a constant angular velocity, or as a body that nothing turns ({@link
 * #tumbles}).
 *
 * <p>Places are told as moves from where they were at the start, so that they are exact far from
 * the origin. One thread.
 */
public final class Flight {
    /** 1/sqrt(3). */
    private static final double MOST_SWING = 0.5773502691896258;

    /** What moves. */
    public Shape shape = HalfSpace.of();

    /** Velocity of the pivot at the start, m/s, and its acceleration, m/s²; world. */
    public double vx, vy, vz, ax, ay, az;

    /** Angular velocity, rad/s, world. */
    public double wx, wy, wz;

    /** Its length at most; 0 where a turn changes nothing. */
    double spin;

    /** By how much the angular velocity may change in the time looked at, and at which rate. */
    double swing, swingRate;

    /** How far a point of the shape may be from the pivot, m. */
    double radius;

    /** From the pivot to the shape's centre at the start; all 0 for most. */
    private double leverX, leverY, leverZ;

    private double sx, sy, sz, sw = 1;

    /** At a time: how far the shape's centre has moved, and its orientation. */
    public double x, y, z, qx, qy, qz, qw = 1;

    /** At a time: angular velocity, rad/s, world. */
    public double nowX, nowY, nowZ;

    /** At a time: from the pivot to the shape's centre. */
    public double armX, armY, armZ;

    /** At a time: the turn since the start. */
    private double tx, ty, tz, tw = 1;

    /** How far the point of the last {@link #back} has moved. */
    public double movedX, movedY, movedZ;

    private final double[] turned = new double[3];
    private final double[] turn = new double[7];

    /** Spin, rad/s, from which on rounding leaves nothing of how a body lies: it is not turned. */
    private static final double UNKNOWN = 1e14;

    /** How it turns, unless at a constant rate. */
    private @Nullable FreeRotationPath free;

    /** A shape that stays, until it is set. */
    public Flight() {}

    /** Orientation of the shape at the start: unit quaternion, world from shape. */
    public Flight turned(double x, double y, double z, double w) {
        sx = x;
        sy = y;
        sz = z;
        sw = w;
        return this;
    }

    /** From the pivot to the shape's centre at the start, world, m. */
    public Flight lever(double x, double y, double z) {
        leverX = x;
        leverY = y;
        leverZ = z;
        return this;
    }

    /**
     * Ends the setting.
     *
     * @param reach how far points of the shape that count are from its centre, m
     * @param isBall whether turning about the shape's centre changes nothing
     */
    public void begin(double reach, boolean isBall) {
        double lever = Math.sqrt(leverX * leverX + leverY * leverY + leverZ * leverZ);
        double w = Math.sqrt(wx * wx + wy * wy + wz * wz);
        boolean turns = w > 0 && w < UNKNOWN && !(isBall && lever == 0);
        spin = turns ? w : 0;
        radius = turns ? lever + (isBall ? 0 : reach) : 0;
        swing = 0;
        swingRate = 0;
        free = null;
        nowX = wx;
        nowY = wy;
        nowZ = wz;
        move(0);
    }

    /**
     * From now on it turns as a body that nothing turns; after {@link #begin}.
     *
     * <p>Each rate w1 of such a body changes by (I2 - I3)/I1 w2 w3, which is no more than w2 w3
     * since no moment is above the sum of the others: together by |w|²/sqrt(3) at most.
     *
     * @param turning of the body, at its start
     * @param until how long it is looked at, s
     */
    public void tumbles(FreeRotationPath turning, double until) {
        if (spin == 0 || !(turning.most() < UNKNOWN)) {
            spin = radius = 0;
            return;
        }
        spin = turning.most();
        swingRate = spin * spin * MOST_SWING;
        swing = Math.min(2 * spin, until * swingRate);
        free = turning;
    }

    /** Surface speed of turning, at most; m/s. */
    public double rim() {
        return spin * radius;
    }

    /**
     * How fast turning moves a point along n at most: |n x w| R, w being so far from the start's.
     */
    double turning(double nx, double ny, double nz) {
        if (spin == 0) {
            return 0;
        }
        double cx = ny * wz - nz * wy;
        double cy = nz * wx - nx * wz;
        double cz = nx * wy - ny * wx;
        double across = Math.sqrt(cx * cx + cy * cy + cz * cz);
        if (swing > 0) {
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            across = Math.min(across + swing * length, spin * length);
        }
        return radius * across;
    }

    /** Where it is after a time, s. */
    public void move(double t) {
        x = t * (vx + 0.5 * t * ax);
        y = t * (vy + 0.5 * t * ay);
        z = t * (vz + 0.5 * t * az);
        armX = leverX;
        armY = leverY;
        armZ = leverZ;
        if (spin == 0) {
            tx = ty = tz = 0;
            tw = 1;
            qx = sx;
            qy = sy;
            qz = sz;
            qw = sw;
            return;
        }
        FreeRotationPath turning = free;
        if (turning == null) {
            Rotations.turn(wx, wy, wz, spin, t, turn);
        } else {
            turning.move(t);
            turning.turned(turn);
            nowX = turn[4];
            nowY = turn[5];
            nowZ = turn[6];
        }
        tx = turn[0];
        ty = turn[1];
        tz = turn[2];
        tw = turn[3];
        qx = tw * sx + tx * sw + ty * sz - tz * sy;
        qy = tw * sy - tx * sz + ty * sw + tz * sx;
        qz = tw * sz + tx * sy - ty * sx + tz * sw;
        qw = tw * sw - tx * sx - ty * sy - tz * sz;
        if (leverX != 0 || leverY != 0 || leverZ != 0) {
            Rotations.rotate(tx, ty, tz, tw, leverX, leverY, leverZ, turned);
            armX = turned[0];
            armY = turned[1];
            armZ = turned[2];
            x += armX - leverX;
            y += armY - leverY;
            z += armZ - leverZ;
        }
    }

    /** A direction that has turned since the start as the shape has. */
    public void turned(double x, double y, double z, double[] out) {
        Rotations.rotate(tx, ty, tz, tw, x, y, z, out);
    }

    /** Where a point of now, from the shape's centre, was at the start, from the pivot. */
    public void back(double px, double py, double pz, double[] out) {
        // from the pivot now
        Rotations.rotate(tx, ty, tz, tw, leverX, leverY, leverZ, turned);
        double rx = px + turned[0];
        double ry = py + turned[1];
        double rz = pz + turned[2];
        Rotations.rotate(-tx, -ty, -tz, tw, rx, ry, rz, out);
        movedX = x - (turned[0] - leverX) + rx - out[0];
        movedY = y - (turned[1] - leverY) + ry - out[1];
        movedZ = z - (turned[2] - leverZ) + rz - out[2];
    }
}
