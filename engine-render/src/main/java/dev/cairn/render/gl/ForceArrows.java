package dev.cairn.render.gl;

import dev.cairn.physics.DebugData;

/**
 * How hard bodies push each other: one arrow for each pair that touches, from the middle of its
 * contact points along the force on the second body. Stateless, makes no garbage. GL thread.
 */
public final class ForceArrows {
    private static final int COLOUR = 0xFF8A3D;
    private static final double LONGEST = 1;

    /** Shorter ones say nothing, by the longest. */
    private static final double LEAST = 0.01;

    /** Of the head, by the length of the arrow. */
    private static final double HEAD = 0.25;

    private static final double HEAD_WIDTH = 0.1;

    /** Arrows lie inside of the bodies for the most part. */
    private static final double INSIDE = 0.8;

    private ForceArrows() {}

    /**
     * Draws them.
     *
     * @param data what the engine knows; the points of a pair follow each other
     * @param lines what they are made of
     */
    public static void draw(DebugData data, DebugLines lines) {
        double most = 0;
        for (int from = 0; from < data.pointCount(); ) {
            int to = end(data, from);
            most = Math.max(most, push(data, from, to));
            from = to;
        }
        lines.hidden(INSIDE);
        for (int from = 0; from < data.pointCount(); ) {
            int to = end(data, from);
            double share = push(data, from, to) / Math.max(most, 1e-300);
            if (share > LEAST) {
                arrow(data, from, to, LONGEST * share, lines);
            }
            from = to;
        }
        lines.hidden(DebugLines.HIDDEN);
    }

    /** Behind the last point of the pair that a point belongs to. */
    private static int end(DebugData data, int from) {
        int to = from + 1;
        while (to < data.pointCount()
                && data.firstBodies()[to] == data.firstBodies()[from]
                && data.secondBodies()[to] == data.secondBodies()[from]) {
            to++;
        }
        return to;
    }

    private static double push(DebugData data, int from, int to) {
        return Math.sqrt(
                square(along(data, from, to, 0))
                        + square(along(data, from, to, 1))
                        + square(along(data, from, to, 2)));
    }

    /** The pair's impulse along an axis, N s. */
    private static double along(DebugData data, int from, int to, int axis) {
        double sum = 0;
        for (int i = from; i < to; i++) {
            sum += data.impulses()[i] * data.normals()[3 * i + axis];
        }
        return sum;
    }

    private static double square(double x) {
        return x * x;
    }

    /** From the point at which the sum of the pair's forces acts. */
    private static void arrow(DebugData data, int from, int to, double length, DebugLines lines) {
        double[] p = data.points();
        double x = 0;
        double y = 0;
        double z = 0;
        double sum = 0;
        for (int i = from; i < to; i++) {
            sum += data.impulses()[i];
        }
        for (int i = from; i < to; i++) {
            double share = data.impulses()[i] / sum;
            x += share * p[3 * i];
            y += share * p[3 * i + 1];
            z += share * p[3 * i + 2];
        }
        double push = push(data, from, to);
        double nx = along(data, from, to, 0) / push;
        double ny = along(data, from, to, 1) / push;
        double nz = along(data, from, to, 2) / push;
        double tipX = x + length * nx;
        double tipY = y + length * ny;
        double tipZ = z + length * nz;
        lines.line(x, y, z, tipX, tipY, tipZ, COLOUR, 3);
        // Two directions across: the axis that the normal leans to least, and one across both.
        boolean alongX = Math.abs(nx) < 0.7;
        double ux = alongX ? 0 : -nz;
        double uy = alongX ? nz : 0;
        double uz = alongX ? -ny : nx;
        double norm = HEAD_WIDTH * length / Math.sqrt(ux * ux + uy * uy + uz * uz);
        double vx = ny * uz - nz * uy;
        double vy = nz * ux - nx * uz;
        double vz = nx * uy - ny * ux;
        for (int barb = 0; barb < 4; barb++) {
            double s = barb % 2 == 0 ? norm : -norm;
            boolean first = barb < 2;
            lines.line(
                    tipX,
                    tipY,
                    tipZ,
                    tipX - HEAD * length * nx + s * (first ? ux : vx),
                    tipY - HEAD * length * ny + s * (first ? uy : vy),
                    tipZ - HEAD * length * nz + s * (first ? uz : vz),
                    COLOUR,
                    2.5);
        }
    }
}
