package dev.cairn.render.app;

import dev.cairn.physics.DebugData;
import dev.cairn.render.gl.DebugLines;
import dev.cairn.render.gl.ForceArrows;
import dev.cairn.render.gl.Tints;

import org.joml.Vector3d;

/** Turns the debug data of a snapshot into lines. Window thread. */
final class DebugDrawing {
    private static final int CONTACT = 0xFFD23F;
    private static final int OVERLAP = 0xFF4D4D;
    private static final int NORMAL = 0x4FC3F7;
    private static final int BOX = 0x8BC34A;
    private static final int FIXED_BOX = 0x607D8B;
    private static final int VELOCITY = 0xE040FB;
    private static final int CENTRE = 0xFFFFFF;

    /** The graph's lines lie inside of the bodies, and would be too faint. */
    private static final double INSIDE = 0.85;

    private static final double NORMAL_METRES = 0.25;
    private static final double VELOCITY_SECONDS = 0.25;

    /** Below this overlap a contact counts as a touch; the solver's own slop is of this size. */
    private static final double OVERLAP_METRES = 0.001;

    private DebugDrawing() {}

    static void draw(DebugData data, int mask, DebugLines lines) {
        if (has(mask, DebugLayer.BOXES)) {
            boxes(data, lines);
        }
        if (has(mask, DebugLayer.VELOCITIES)) {
            velocities(data, lines);
        }
        if (has(mask, DebugLayer.CENTRES)) {
            double[] c = data.centres();
            for (int i = 0; i < data.bodyCount(); i++) {
                if (data.states()[i] != DebugData.FIXED) {
                    dot(lines, c, 3 * i, CENTRE, 4);
                }
            }
        }
        if (has(mask, DebugLayer.ISLANDS)) {
            graph(data, lines, false);
        }
        if (has(mask, DebugLayer.COLOURS)) {
            graph(data, lines, true);
        }
        if (has(mask, DebugLayer.NORMALS)) {
            normals(data, lines);
        }
        if (has(mask, DebugLayer.IMPULSES)) {
            ForceArrows.draw(data, lines);
        }
        if (has(mask, DebugLayer.JOINTS)) {
            JointDrawing.joints(data.joints(), lines);
        }
        if (has(mask, DebugLayer.JOINT_FORCES)) {
            JointDrawing.loads(data.joints(), lines);
        }
        if (has(mask, DebugLayer.CONTACTS)) {
            for (int i = 0; i < data.pointCount(); i++) {
                boolean deep = data.separations()[i] < -OVERLAP_METRES;
                dot(lines, data.points(), 3 * i, deep ? OVERLAP : CONTACT, 3.5);
            }
        }
    }

    /** What the colours of bodies tell where these layers are shown. */
    static Tints.Kind tint(int mask) {
        return has(mask, DebugLayer.LOAD)
                ? Tints.Kind.LOAD
                : has(mask, DebugLayer.SPEED)
                        ? Tints.Kind.SPEED
                        : has(mask, DebugLayer.SLEEP)
                                ? Tints.Kind.SLEEP
                                : has(mask, DebugLayer.ISLANDS)
                                        ? Tints.Kind.ISLAND
                                        : Tints.Kind.NONE;
    }

    private static boolean has(int mask, DebugLayer layer) {
        return (mask & layer.bit()) != 0;
    }

    static void dot(DebugLines lines, double[] at, int i, int rgb, double pixels) {
        lines.line(at[i], at[i + 1], at[i + 2], at[i], at[i + 1], at[i + 2], rgb, pixels);
    }

    private static void boxes(DebugData data, DebugLines lines) {
        double[] box = data.boxes();
        for (int i = 0; i < data.bodyCount(); i++) {
            byte state = data.states()[i];
            boolean moves = state == DebugData.AWAKE || state == DebugData.ASLEEP;
            lines.box(box, 6 * i, moves ? BOX : FIXED_BOX, 0.75);
        }
    }

    /** From each moving body's centre of mass to its contact points. */
    private static void graph(DebugData data, DebugLines lines, boolean byColour) {
        double[] p = data.points();
        double[] c = data.centres();
        lines.hidden(INSIDE);
        for (int i = 0; i < data.pointCount(); i++) {
            int a = data.firstBodies()[i];
            int b = data.secondBodies()[i];
            if (a == DebugData.NONE || b == DebugData.NONE) {
                continue;
            }
            int island = Math.max(data.islands()[a], data.islands()[b]);
            int which = byColour ? data.colours()[i] : island;
            if (which == DebugData.NONE) {
                continue;
            }
            int rgb = Tints.distinct(which);
            for (int end = 0; end < 2; end++) {
                int body = end == 0 ? a : b;
                if (data.islands()[body] != DebugData.NONE) {
                    int k = 3 * body;
                    lines.line(
                            c[k],
                            c[k + 1],
                            c[k + 2],
                            p[3 * i],
                            p[3 * i + 1],
                            p[3 * i + 2],
                            rgb,
                            byColour ? 2.25 : 1.5);
                }
            }
        }
        lines.hidden(DebugLines.HIDDEN);
    }

    private static void velocities(DebugData data, DebugLines lines) {
        double[] c = data.centres();
        double[] v = data.velocities();
        for (int i = 0; i < data.bodyCount(); i++) {
            int at = 3 * i;
            if (data.states()[i] == DebugData.AWAKE || data.states()[i] == DebugData.KINEMATIC) {
                lines.line(
                        c[at],
                        c[at + 1],
                        c[at + 2],
                        c[at] + VELOCITY_SECONDS * v[at],
                        c[at + 1] + VELOCITY_SECONDS * v[at + 1],
                        c[at + 2] + VELOCITY_SECONDS * v[at + 2],
                        VELOCITY,
                        1.25);
            }
        }
    }

    private static void normals(DebugData data, DebugLines lines) {
        double[] p = data.points();
        double[] n = data.normals();
        for (int i = 0; i < data.pointCount(); i++) {
            int at = 3 * i;
            lines.line(
                    p[at],
                    p[at + 1],
                    p[at + 2],
                    p[at] + NORMAL_METRES * n[at],
                    p[at + 1] + NORMAL_METRES * n[at + 1],
                    p[at + 2] + NORMAL_METRES * n[at + 2],
                    NORMAL,
                    1.25);
        }
    }

    /** Where lines are measured from: a point near the camera, so that floats are fine enough. */
    static Vector3d anchor(Vector3d eye) {
        return eye.set(Math.rint(eye.x), Math.rint(eye.y), Math.rint(eye.z));
    }
}
