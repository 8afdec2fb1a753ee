package dev.cairn.physics.decomposition;

import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.TriangleMesh;

import java.util.ArrayList;
import java.util.List;

/** Concave solids whose every place has a known distance, as meshes. */
final class Concaves {
    private Concaves() {}

    /** Cells of a letter, drawn in rows from above; each # is a cube of an edge of 1 m. */
    static TriangleMesh letter(double scale, String... rows) {
        List<Double> xyz = new ArrayList<>();
        for (int row = 0; row < rows.length; row++) {
            for (int column = 0; column < rows[row].length(); column++) {
                for (int side = 0; side < 6 && isCell(rows, row, column); side++) {
                    if (side < 4 && isCell(rows, row + DOWN[side], column + RIGHT[side])) {
                        continue; // a wall within
                    }
                    face(xyz, side, column, rows.length - 1 - row);
                }
            }
        }
        double[] vertices = xyz.stream().mapToDouble(v -> scale * v).toArray();
        int[] indices = new int[vertices.length / 3];
        for (int i = 0; i < indices.length; i++) {
            indices[i] = i;
        }
        return TriangleMesh.of(vertices, indices);
    }

    private static final int[] DOWN = {0, 0, -1, 1}, RIGHT = {1, -1, 0, 0};

    static boolean isCell(String[] rows, int row, int column) {
        return row >= 0
                && row < rows.length
                && column >= 0
                && column < rows[row].length()
                && rows[row].charAt(column) == '#';
    }

    /** Sides: +x, -x, +y, -y, +z, -z. */
    private static void face(List<Double> xyz, int side, int x, int y) {
        double[][] corner = {
            {1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1},
            {0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0},
            {0, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0},
            {0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1},
            {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1},
            {0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0}
        };
        for (int k : new int[] {0, 1, 2, 0, 2, 3}) {
            xyz.add(x + corner[side][3 * k]);
            xyz.add(y + corner[side][3 * k + 1]);
            xyz.add(corner[side][3 * k + 2]);
        }
    }

    /** The distance of a place from the cells, m. */
    static double fromLetter(String[] rows, double x, double y, double z) {
        double least = Double.POSITIVE_INFINITY;
        for (int row = 0; row < rows.length; row++) {
            for (int column = 0; column < rows[row].length(); column++) {
                if (isCell(rows, row, column)) {
                    double low = rows.length - 1 - row;
                    double dx = Math.max(0, Math.max(column - x, x - column - 1));
                    double dy = Math.max(0, Math.max(low - y, y - low - 1));
                    double dz = Math.max(0, Math.max(-z, z - 1));
                    least = Math.min(least, Math.sqrt(dx * dx + dy * dy + dz * dz));
                }
            }
        }
        return least;
    }

    /** About the y axis; the surface's corners are on the smooth one. */
    static TriangleMesh torus(int around, int across, double ring, double tube) {
        double[] xyz = new double[3 * around * across];
        int[] indices = new int[6 * around * across];
        for (int i = 0; i < around; i++) {
            for (int j = 0; j < across; j++) {
                double a = 2 * Math.PI * i / around;
                double b = 2 * Math.PI * j / across;
                int k = i * across + j;
                double out = ring + tube * StrictMath.cos(b);
                xyz[3 * k] = out * StrictMath.cos(a);
                xyz[3 * k + 1] = tube * StrictMath.sin(b);
                xyz[3 * k + 2] = out * StrictMath.sin(a);
                int beside = i * across + (j + 1) % across;
                int next = (i + 1) % around * across + j;
                int both = (i + 1) % around * across + (j + 1) % across;
                int[] two = {k, beside, both, k, both, next};
                System.arraycopy(two, 0, indices, 6 * k, 6);
            }
        }
        return TriangleMesh.of(xyz, indices);
    }

    /** How far a place is above the highest of a hull's planes, m: at most 0 inside. */
    static double above(ConvexHull hull, double x, double y, double z) {
        double[] v = hull.vertices();
        double most = Double.NEGATIVE_INFINITY;
        for (int[] loop : hull.faceLoops()) {
            double nx = 0;
            double ny = 0;
            double nz = 0;
            for (int i = 0; i < loop.length; i++) {
                int a = 3 * loop[i];
                int b = 3 * loop[(i + 1) % loop.length];
                nx += (v[a + 1] - v[b + 1]) * (v[a + 2] + v[b + 2]);
                ny += (v[a + 2] - v[b + 2]) * (v[a] + v[b]);
                nz += (v[a] - v[b]) * (v[a + 1] + v[b + 1]);
            }
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            int a = 3 * loop[0];
            double h = nx * (x - v[a]) + ny * (y - v[a + 1]) + nz * (z - v[a + 2]);
            most = Math.max(most, h / length);
        }
        return most;
    }
}
