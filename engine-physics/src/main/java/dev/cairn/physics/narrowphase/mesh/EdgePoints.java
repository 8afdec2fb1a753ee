package dev.cairn.physics.narrowphase.mesh;

import java.util.Arrays;

/**
 * Points on edges and corners that stand out, each in a group: of a plane, or of a normal of their
 * own. Axes of the mesh, from the shape's centre, m.
 */
final class EdgePoints {
    /** Groups of their own that a point is compared with, the latest ones. */
    private static final int COMPARED = 32;

    /** Points. */
    int count;

    /** Groups with a normal of their own. */
    int groups;

    /** Of each point: on the shape's surface, and separation. */
    double[] number = new double[4 * 32];

    int[] name = new int[32], triangle = new int[32];

    /** Of a plane, or {@code -1 - g} for a group of their own. */
    int[] group = new int[32];

    double[] normal = new double[3 * 16];

    void clear() {
        count = 0;
        groups = 0;
    }

    /** The group of a normal. */
    int group(double mx, double my, double mz) {
        for (int g = groups - 1; g >= 0 && g >= groups - COMPARED; g--) {
            if (mx * normal[3 * g] + my * normal[3 * g + 1] + mz * normal[3 * g + 2]
                    >= FaceRegions.ONE_PLANE) {
                return -1 - g;
            }
        }
        if (3 * groups == normal.length) {
            normal = Arrays.copyOf(normal, 2 * normal.length);
        }
        normal[3 * groups] = mx;
        normal[3 * groups + 1] = my;
        normal[3 * groups + 2] = mz;
        return -1 - groups++;
    }

    /** Adds a point, unless its group has one of that name. */
    void add(int toGroup, int of, int named, double x, double y, double z, double separation) {
        for (int i = count - 1; i >= 0 && i >= count - 4 * COMPARED; i--) {
            if (group[i] == toGroup && name[i] == named) {
                return;
            }
        }
        if (count == name.length) {
            name = Arrays.copyOf(name, 2 * count);
            triangle = Arrays.copyOf(triangle, 2 * count);
            group = Arrays.copyOf(group, 2 * count);
            number = Arrays.copyOf(number, 8 * count);
        }
        number[4 * count] = x;
        number[4 * count + 1] = y;
        number[4 * count + 2] = z;
        number[4 * count + 3] = separation;
        name[count] = named;
        triangle[count] = of;
        group[count++] = toGroup;
    }
}
