package dev.cairn.samples.scenes.level;

import dev.cairn.physics.shape.TriangleMesh;

import java.util.Arrays;
import java.util.function.DoubleBinaryOperator;

/** Puts triangles together: grids over functions, and blocks. One mesh, then thrown away. */
final class Surfaces {
    private double[] xyz = new double[64];
    private int[] index = new int[64];
    private int numbers, corners;

    int vertex(double x, double y, double z) {
        if (numbers + 3 > xyz.length) {
            xyz = Arrays.copyOf(xyz, 2 * xyz.length);
        }
        xyz[numbers++] = x;
        xyz[numbers++] = y;
        xyz[numbers++] = z;
        return numbers / 3 - 1;
    }

    /** Counter-clockwise seen from the front. */
    void triangle(int a, int b, int c) {
        if (corners + 3 > index.length) {
            index = Arrays.copyOf(index, 2 * index.length);
        }
        index[corners++] = a;
        index[corners++] = b;
        index[corners++] = c;
    }

    void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    /** The sides of a block that bodies can get at: all six. */
    Surfaces block(double x0, double y0, double z0, double x1, double y1, double z1) {
        int[] v = new int[8];
        for (int i = 0; i < 8; i++) {
            v[i] = vertex((i & 1) == 0 ? x0 : x1, (i & 2) == 0 ? y0 : y1, (i & 4) == 0 ? z0 : z1);
        }
        quad(v[0], v[4], v[6], v[2]);
        quad(v[1], v[3], v[7], v[5]);
        quad(v[0], v[1], v[5], v[4]);
        quad(v[2], v[6], v[7], v[3]);
        quad(v[0], v[2], v[3], v[1]);
        quad(v[4], v[5], v[7], v[6]);
        return this;
    }

    /** The graph of a function of x and z, n by n squares. */
    Surfaces grid(double half, int n, DoubleBinaryOperator height) {
        int first = numbers / 3;
        for (int j = 0; j <= n; j++) {
            for (int i = 0; i <= n; i++) {
                double x = half * (2.0 * i / n - 1);
                double z = half * (2.0 * j / n - 1);
                vertex(x, height.applyAsDouble(x, z), z);
            }
        }
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                int a = first + j * (n + 1) + i;
                quad(a, a + n + 1, a + n + 2, a + 1);
            }
        }
        return this;
    }

    TriangleMesh mesh() {
        return TriangleMesh.of(Arrays.copyOf(xyz, numbers), Arrays.copyOf(index, corners));
    }
}
