package dev.cairn.physics.sweep;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

/**
 * The way of a shape: a point that it turns about (the pivot) goes along a parabola, and the shape
 * turns about it at a constant angular velocity.
 *
 * <p>Places are told as moves from where they were at the start, so that they are exact far from
 * the origin. One thread.
 */
public final class Flight {
    /** What moves. */
    public Shape shape = HalfSpace.of();

    /** Velocity of the pivot at the start, m/s, and its acceleration, m/s²; world. */
    public double vx, vy, vz, ax, ay, az;

    /** Angular velocity, rad/s, world. */
    public double wx, wy, wz;

    /** Its length; 0 where a turn changes nothing. */
    double spin;

    /** How far a point of the shape may be from the pivot, m. */
    double radius;

    /** From the pivot to the shape's centre at the start; all 0 for most. */
    private double leverX, leverY, leverZ;

    private double sx, sy, sz, sw = 1;

    /** At a time: how far the shape's centre has moved, and its orientation. */
    public double x, y, z, qx, qy, qz, qw = 1;

    /** At a time: from the pivot to the shape's centre. */
    public double armX, armY, armZ;

    /** At a time: the turn since the start. */
    private double tx, ty, tz, tw = 1;

    /** How far the point of the last {@link #back} has moved. */
    public double movedX, movedY, movedZ;

    private final double[] turned = new double[3];
    private final double[] turn = new double[4];

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
        boolean turns = w > 0 && !(isBall && lever == 0);
        spin = turns ? w : 0;
        radius = turns ? lever + (isBall ? 0 : reach) : 0;
        move(0);
    }

    /** Surface speed of turning, at most; m/s. */
    public double rim() {
        return spin * radius;
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
        Rotations.turn(wx, wy, wz, spin, t, turn);
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

    /**
     * How the shape would have lain at the start to lie as it does now, had it turned at another
     * rate.
     *
     * @param x angular velocity, rad/s, world
     * @param y see {@code x}
     * @param z see {@code x}
     * @param t the time of now, s
     * @param out receives the unit quaternion, world from shape
     */
    public void turnBack(double x, double y, double z, double t, double[] out) {
        double rate = Math.sqrt(x * x + y * y + z * z);
        if (rate == 0) {
            out[0] = qx;
            out[1] = qy;
            out[2] = qz;
            out[3] = qw;
            return;
        }
        Rotations.turn(-x, -y, -z, rate, t, turn);
        double a = turn[0];
        double b = turn[1];
        double c = turn[2];
        double d = turn[3];
        double ox = d * qx + a * qw + b * qz - c * qy;
        double oy = d * qy - a * qz + b * qw + c * qx;
        double oz = d * qz + a * qy - b * qx + c * qw;
        double ow = d * qw - a * qx - b * qy - c * qz;
        double unit = 1 / Math.sqrt(ox * ox + oy * oy + oz * oz + ow * ow);
        out[0] = ox * unit;
        out[1] = oy * unit;
        out[2] = oz * unit;
        out[3] = ow * unit;
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
