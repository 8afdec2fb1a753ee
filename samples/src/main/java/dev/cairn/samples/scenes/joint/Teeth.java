package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.render.mesh.Texture;

import java.util.List;

/**
 * How gears and a rack look: outlines with teeth, pulled along the axis. For the physics they are a
 * cylinder and a box; teeth that mesh in the picture are those that the joints count. Stateless.
 */
final class Teeth {
    /** Shares of a tooth's pitch from its middle: where a flank begins at the root, and ends. */
    private static final double[] FLANKS = {-0.3, -0.13, 0.13, 0.3};

    /** Above the pitch circle, and below it, shares of the pitch. */
    private static final double TIP = 0.25;

    private static final double ROOT = 0.3;

    private Teeth() {}

    /**
     * A gear about the y axis.
     *
     * @param teeth how many
     * @param radius of the pitch circle, m
     * @param half of its width, m
     * @param phase by how much of a pitch the first tooth is turned from x towards z
     * @param rgb its colour
     * @return its look
     */
    static ModelGroup gear(int teeth, double radius, double half, double phase, int rgb) {
        int n = FLANKS.length * teeth;
        double pitch = 2 * Math.PI * radius / teeth;
        double[] xyz = new double[3 * (2 * n + 2)];
        int[] index = new int[12 * n];
        int at = 0;
        for (int i = 0; i < n; i++) {
            int tooth = i / FLANKS.length;
            double share = tooth + FLANKS[i % FLANKS.length] + phase;
            double angle = 2 * Math.PI * share / teeth;
            double r = radius + pitch * height(i % FLANKS.length);
            for (int side = 0; side < 2; side++) {
                put(
                        xyz,
                        i + side * n,
                        r * StrictMath.cos(angle),
                        side == 0 ? half : -half,
                        r * StrictMath.sin(angle));
            }
            int next = (i + 1) % n;
            at = triangle(index, at, 2 * n, next, i);
            at = triangle(index, at, 2 * n + 1, n + i, n + next);
            at = triangle(index, at, n + i, i, next);
            at = triangle(index, at, n + i, next, n + next);
        }
        put(xyz, 2 * n, 0, half, 0);
        put(xyz, 2 * n + 1, 0, -half, 0);
        return look(xyz, index, rgb);
    }

    /**
     * A rack along x with its teeth upwards and a gap in its middle.
     *
     * @param pitch from tooth to tooth, m
     * @param length half of it at most, m
     * @param pitchLine height of the line on which the gear rolls, m
     * @param bottom height of its lower side, m
     * @param half of its width, m
     * @param rgb its colour
     * @return its look
     */
    static ModelGroup rack(
            double pitch, double length, double pitchLine, double bottom, double half, int rgb) {
        int teeth = 2 * (int) (length / pitch);
        int n = FLANKS.length * teeth;
        double[] xyz = new double[12 * n];
        int[] index = new int[24 * (n - 1) + 12];
        int at = 0;
        for (int i = 0; i < n; i++) {
            int tooth = i / FLANKS.length;
            double middle = tooth - 0.5 * teeth + 0.5;
            double x = pitch * (middle + FLANKS[i % FLANKS.length]);
            double y = pitchLine + pitch * height(i % FLANKS.length);
            put(xyz, i, x, y, half);
            put(xyz, n + i, x, bottom, half);
            put(xyz, 2 * n + i, x, y, -half);
            put(xyz, 3 * n + i, x, bottom, -half);
            if (i + 1 < n) {
                at = quad(index, at, n + i, n + i + 1, i + 1, i);
                at = quad(index, at, 3 * n + i + 1, 3 * n + i, 2 * n + i, 2 * n + i + 1);
                at = quad(index, at, i, i + 1, 2 * n + i + 1, 2 * n + i);
                at = quad(index, at, 3 * n + i, 3 * n + i + 1, n + i + 1, n + i);
            }
        }
        at = quad(index, at, 3 * n, n, 0, 2 * n);
        quad(index, at, 2 * n - 1, 4 * n - 1, 3 * n - 1, n - 1);
        return look(xyz, index, rgb);
    }

    private static double height(int flank) {
        return flank == 1 || flank == 2 ? TIP : -ROOT;
    }

    private static void put(double[] xyz, int vertex, double x, double y, double z) {
        xyz[3 * vertex] = x;
        xyz[3 * vertex + 1] = y;
        xyz[3 * vertex + 2] = z;
    }

    private static int triangle(int[] index, int at, int a, int b, int c) {
        index[at] = a;
        index[at + 1] = b;
        index[at + 2] = c;
        return at + 3;
    }

    private static int quad(int[] index, int at, int a, int b, int c, int d) {
        return triangle(index, triangle(index, at, a, b, c), a, c, d);
    }

    /** A group of one, since a scene file has the body's own shape for what is no such file. */
    private static ModelGroup look(double[] xyz, int[] index, int rgb) {
        Model model = Model.of(TriangleMesh.of(xyz, index)).texture(Texture.WHITE).color(rgb);
        return new ModelGroup(List.of(model));
    }
}
