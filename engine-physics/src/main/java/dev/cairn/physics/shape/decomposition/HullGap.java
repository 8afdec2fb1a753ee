package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;

import java.util.Arrays;

/**
 * How far a hull goes beyond a solid: the largest distance from the solid of a point of the hull.
 *
 * <p>The signed distance s of a place x from the solid changes at most as fast as x does. So in a
 * cube of half diagonal r about c it is at most s(c) + r, and what cannot exceed the largest
 * distance known is left out; the rest is cut into eight. What remains at the end says how far the
 * true maximum may be above the largest one found. (S. A. Piyavskii, "An algorithm for finding the
 * absolute extremum of a function", 1972.)
 *
 * <p>One thread's.
 */
final class HullGap {
    /** Cubes that are looked at for one hull. */
    private static final int BUDGET = 1 << 18;

    private final Solid.Probe probe;

    /** The largest distance found, m. */
    double found;

    /** No point is farther than this, m. */
    double bound;

    /** What no more is than this is left out, m; the distance of the cube at hand, m. */
    private double need, away;

    private double[] plane = new double[0];

    HullGap(Solid solid) {
        probe = solid.new Probe();
    }

    /**
     * Measures.
     *
     * @param gap how far {@link #bound} may be above {@link #found}, m
     * @param share the same as a share of {@link #found}
     * @param enough what is below need not be told apart from 0, m
     * @param hopeless when a distance above this is found nothing more is looked for, m
     */
    void measure(ConvexHull hull, double gap, double share, double enough, double hopeless) {
        take(hull);
        found = 0;
        bound = 0;
        double[] box = new double[6];
        hull.bounds(0, 0, 0, 1, box, 0);
        Vector3d com = hull.centreOfMass(new Vector3d());
        double half = 0.5 * Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
        double[] cubes = {
            com.x + 0.5 * (box[0] + box[3]),
            com.y + 0.5 * (box[1] + box[4]),
            com.z + 0.5 * (box[2] + box[5]),
            Double.POSITIVE_INFINITY
        };
        int looked = 0;
        while (cubes.length > 0) {
            double radius = half * Math.sqrt(3);
            double[] kept = new double[cubes.length];
            double[] upper = new double[cubes.length / 4];
            int left = 0;
            for (int i = 0; i < cubes.length; i += 4) {
                need = Math.max(enough, found + Math.max(gap, share * found));
                double most = upper(cubes, i, half, radius);
                if (most > need) {
                    System.arraycopy(cubes, i, kept, 4 * left, 3);
                    kept[4 * left + 3] = away + radius;
                    upper[left++] = most;
                } else {
                    bound = Math.max(bound, most);
                }
            }
            looked += cubes.length / 4;
            if (looked + 8 * left > BUDGET || found > hopeless) {
                for (int i = 0; i < left; i++) {
                    bound = Math.max(bound, upper[i]);
                }
                break;
            }
            half *= 0.5;
            cubes = eighths(kept, upper, left, half);
        }
        bound = Math.max(bound, found);
    }

    /** What is left is cut; a cube knows that the surface is no farther than from its parent. */
    private double[] eighths(double[] kept, double[] upper, int left, double half) {
        double[] cubes = new double[32 * left];
        int next = 0;
        for (int i = 0; i < left; i++) {
            if (upper[i] <= need) {
                bound = Math.max(bound, upper[i]);
                continue;
            }
            for (int k = 0; k < 8; k++) {
                for (int axis = 0; axis < 3; axis++) {
                    cubes[next++] = kept[4 * i + axis] + (((k >> axis) & 1) == 0 ? -half : half);
                }
                cubes[next++] = kept[4 * i + 3];
            }
        }
        return Arrays.copyOf(cubes, next);
    }

    /** Of the distances in a cube an upper bound; 0 if it is outside of the hull, or all solid. */
    private double upper(double[] cubes, int i, double half, double radius) {
        double x = cubes[i];
        double y = cubes[i + 1];
        double z = cubes[i + 2];
        away = probe.distance(x, y, z, need - radius, cubes[i + 3] * (1 + 1e-12));
        if (away + radius <= need) {
            return away + radius;
        }
        boolean isIn = true;
        for (int k = 0; k < plane.length; k += 5) {
            double h = plane[k] * x + plane[k + 1] * y + plane[k + 2] * z - plane[k + 3];
            if (h > half * plane[k + 4]) {
                return 0;
            }
            isIn &= h <= 0;
        }
        if (probe.isInside(x, y, z)) {
            return Math.max(0, radius - away);
        }
        if (isIn) {
            found = Math.max(found, away);
        }
        return away + radius;
    }

    /** The planes of a hull, and how far a cube reaches along each normal by its half side. */
    private void take(ConvexHull hull) {
        Polyhedron p = Polyhedron.of(hull);
        Vector3d com = hull.centreOfMass(new Vector3d());
        plane = new double[5 * p.faceCount()];
        for (int f = 0; f < p.faceCount(); f++) {
            double nx = p.normalX(f);
            double ny = p.normalY(f);
            double nz = p.normalZ(f);
            plane[5 * f] = nx;
            plane[5 * f + 1] = ny;
            plane[5 * f + 2] = nz;
            plane[5 * f + 3] = p.offset(f) + nx * com.x + ny * com.y + nz * com.z;
            plane[5 * f + 4] = Math.abs(nx) + Math.abs(ny) + Math.abs(nz);
        }
    }
}
