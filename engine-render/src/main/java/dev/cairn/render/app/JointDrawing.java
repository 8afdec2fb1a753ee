package dev.cairn.render.app;

import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointData;
import dev.cairn.render.gl.DebugLines;

/** Turns joints into lines. Window thread. */
final class JointDrawing {
    private static final int LINK = 0xB0BEC5;
    private static final int POINT = 0xFFFFFF;
    private static final int OPEN = 0xFF4D4D;
    private static final int AXIS = 0x4DD0E1;
    private static final int LIMIT = 0xFFD23F;
    private static final int AT_LIMIT = 0xFF8A3D;
    private static final int OFF = 0x607D8B;
    private static final int FORCE = 0xFF8A3D;
    private static final int TORQUE = 0xE040FB;
    private static final double AXIS_METRES = 0.2;
    private static final int ARC = 16;

    /** The points of A and B count as apart from here on, m. */
    private static final double GAP = 0.001;

    /** Within this of a limit it counts as reached, m or rad. */
    private static final double REACHED = 1e-4;

    /** Room for two points, the window thread's. */
    private static final double[] BEFORE = new double[3];

    private static final double[] NEXT = new double[3];

    /** Room for the points of a path. */
    private static final double[] PATH = new double[3 * 97];

    private JointDrawing() {}

    static void joints(JointData data, DebugLines lines) {
        lines.hidden(0.85);
        for (int j = 0; j < data.count(); j++) {
            double[] p = data.points();
            int at = JointData.POINTS * j;
            int rgb = data.enabled()[j] ? LINK : OFF;
            line(lines, p, at, p, at + 3, rgb, 1.5);
            line(lines, p, at + 6, p, at + 9, rgb, 1.5);
            boolean isPath = data.path(j, PATH);
            for (int i = 3; i < PATH.length && isPath; i += 3) {
                line(lines, PATH, i - 3, PATH, i, data.enabled()[j] ? AXIS : OFF, 2);
            }
            boolean isRod = data.limited(j) == JointAxis.DISTANCE;
            boolean isApart = apart(p, at + 3, at + 6) > GAP;
            if (isPath) {
                DebugDrawing.dot(lines, p, at + 6, data.enabled()[j] ? POINT : OFF, 5);
                continue;
            }
            line(lines, p, at + 3, p, at + 6, isApart && !isRod ? OPEN : rgb, 2);
            DebugDrawing.dot(lines, p, at + 3, data.enabled()[j] ? POINT : OFF, 4);
            double[] a = data.axes();
            ray(lines, p, at + 3, a, JointData.AXES * j, AXIS_METRES, 0, AXIS, 1.5);
            JointAxis limited = data.limited(j);
            if (limited != null) {
                limits(data, j, limited, lines);
            }
        }
        lines.hidden(DebugLines.HIDDEN);
    }

    private static void limits(JointData data, int j, JointAxis axis, DebugLines lines) {
        double[] l = data.limits();
        double low = l[JointData.LIMITS * j];
        double high = l[JointData.LIMITS * j + 1];
        double now = l[JointData.LIMITS * j + 2];
        int rgb = now < low + REACHED || now > high - REACHED ? AT_LIMIT : LIMIT;
        int p = JointData.POINTS * j + 3;
        int x = JointData.AXES * j;
        switch (axis) {
            case X -> along(data, p, x, low, high, lines, rgb);
            case Y -> along(data, p, x + 3, low, high, lines, rgb);
            case TWIST -> arc(data, j, low, high, now, lines, rgb);
            case CONE -> cone(data, j, high, lines, rgb);
            case DISTANCE -> line(lines, data.points(), p, data.points(), p + 3, rgb, 1);
            case Z, SWING_Y, SWING_Z, PATH -> DebugDrawing.dot(lines, data.points(), p, rgb, 6);
        }
    }

    private static void along(
            JointData data, int p, int axis, double low, double high, DebugLines lines, int rgb) {
        if (Double.isFinite(low) && Double.isFinite(high)) {
            ray(lines, data.points(), p, data.axes(), axis, high, low, rgb, 2.5);
        }
    }

    /** From the lower to the upper limit about x of A, and a hand where it stands. */
    private static void arc(
            JointData data, int j, double low, double high, double now, DebugLines lines, int rgb) {
        double from = Math.max(low, -Math.PI);
        double to = Math.min(high, Math.PI);
        double[] before = BEFORE;
        double[] next = NEXT;
        for (int k = 0; k <= ARC; k++) {
            turned(data, j, from + k * (to - from) / ARC, next);
            if (k == 0 || k == ARC) {
                line(lines, data.points(), JointData.POINTS * j + 3, next, 0, rgb, 1);
            }
            if (k > 0) {
                line(lines, before, 0, next, 0, rgb, 2);
            }
            System.arraycopy(next, 0, before, 0, 3);
        }
        turned(data, j, now, next);
        line(lines, data.points(), JointData.POINTS * j + 3, next, 0, AXIS, 2.5);
    }

    /** The point of an arc at an angle from y about x. */
    private static void turned(JointData data, int j, double angle, double[] into) {
        double[] a = data.axes();
        int x = JointData.AXES * j;
        double c = AXIS_METRES * Math.cos(angle);
        double s = AXIS_METRES * Math.sin(angle);
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3;
            int w = (k + 2) % 3;
            double z = a[x + u] * a[x + 3 + w] - a[x + w] * a[x + 3 + u];
            into[k] = data.points()[JointData.POINTS * j + 3 + k] + c * a[x + 3 + k] + s * z;
        }
    }

    /** The rim of the cone about x of A, and B's axis. */
    private static void cone(JointData data, int j, double angle, DebugLines lines, int rgb) {
        double[] a = data.axes();
        double[] p = data.points();
        int at = JointData.POINTS * j + 3;
        int x = JointData.AXES * j;
        double[] before = BEFORE;
        double[] next = NEXT;
        double out = Math.sin(Math.min(angle, Math.PI));
        double up = Math.cos(Math.min(angle, Math.PI));
        for (int k = 0; k <= ARC; k++) {
            turned(data, j, 2 * Math.PI * k / ARC, next);
            for (int c = 0; c < 3; c++) {
                next[c] = p[at + c] + out * (next[c] - p[at + c]) + AXIS_METRES * up * a[x + c];
            }
            if (k > 0) {
                line(lines, before, 0, next, 0, rgb, 1.5);
            }
            System.arraycopy(next, 0, before, 0, 3);
        }
        ray(lines, p, at, a, x + 6, AXIS_METRES, 0, AXIS, 2.5);
    }

    static void loads(JointData data, DebugLines lines) {
        double force = 1e-300;
        double torque = 1e-300;
        for (int j = 0; j < data.count(); j++) {
            force = Math.max(force, length(data.loads(), JointData.LOADS * j));
            torque = Math.max(torque, length(data.loads(), JointData.LOADS * j + 3));
        }
        for (int j = 0; j < data.count() && force > 1e-300; j++) {
            double[] p = data.points();
            int at = JointData.POINTS * j + 6;
            int load = JointData.LOADS * j;
            ray(lines, p, at, data.loads(), load, 1 / force, 0, FORCE, 2);
            ray(lines, p, at, data.loads(), load + 3, 1 / torque, 0, TORQUE, 2);
        }
    }

    private static double length(double[] v, int at) {
        return Math.sqrt(v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2]);
    }

    private static double apart(double[] p, int a, int b) {
        double x = p[b] - p[a];
        double y = p[b + 1] - p[a + 1];
        double z = p[b + 2] - p[a + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static void line(
            DebugLines lines, double[] p, int a, double[] q, int b, int rgb, double pixels) {
        lines.line(p[a], p[a + 1], p[a + 2], q[b], q[b + 1], q[b + 2], rgb, pixels);
    }

    /** From one multiple of a direction to another one, beside a point. */
    private static void ray(
            DebugLines lines,
            double[] p,
            int at,
            double[] d,
            int o,
            double to,
            double from,
            int rgb,
            double pixels) {
        lines.line(
                p[at] + from * d[o],
                p[at + 1] + from * d[o + 1],
                p[at + 2] + from * d[o + 2],
                p[at] + to * d[o],
                p[at + 1] + to * d[o + 1],
                p[at + 2] + to * d[o + 2],
                rgb,
                pixels);
    }
}
