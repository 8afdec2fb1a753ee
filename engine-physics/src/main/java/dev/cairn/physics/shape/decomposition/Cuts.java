package dev.cairn.physics.shape.decomposition;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The planes along which a piece may be cut, and the choice among them: the one whose two hulls
 * have the least volume together.
 *
 * <p>Candidates are the planes of faces that lie deep below the hull, planes through their hollow
 * edges, planes across the axes at regular places, and some that are drawn from the seed. All are
 * tried on a thinned piece, the best few on all of it.
 */
final class Cuts {
    private static final int DEEP = 14;
    private static final int SLICES = 8;
    private static final int DRAWN = 4;

    /** Polygons on which all planes are tried. */
    private static final int THIN = 256;

    /** How many planes are tried on all polygons. */
    private static final int BEST = 4;

    /** A sum of volumes is less only if it is so by this share: ties go to the first plane. */
    private static final double TIE = 1e-9;

    /**
     * Share of the difference of the volumes that counts as volume. The first cuts of a ring gain
     * nothing, and only even ones lead to some that do.
     */
    private static final double UNEVEN = 0.02;

    private final Solid solid;
    private final long seed;
    private final double tolerance;
    private final Jobs jobs;
    private final Solid.Probe[] probe;

    /**
     * For a solid.
     *
     * @param tolerance of hulls, m
     */
    Cuts(Solid solid, long seed, double tolerance, Jobs jobs) {
        this.solid = solid;
        this.seed = seed;
        this.tolerance = tolerance;
        this.jobs = jobs;
        probe = new Solid.Probe[jobs.workers()];
        Arrays.setAll(probe, worker -> solid.new Probe());
    }

    /** A piece and its hull. */
    record Half(Piece piece, ConvexHull hull) {}

    /** What a plane leaves on its two sides. */
    record Cut(Half above, Half below) {
        double score() {
            return Cuts.score(above.hull.volume(), below.hull.volume());
        }
    }

    /**
     * Chooses.
     *
     * @param number of the piece, for the planes that are drawn
     */
    @Nullable Cut best(Piece piece, ConvexHull hull, int number) {
        List<double[]> planes = planes(piece, hull, number);
        Piece thin = piece.thinned(THIN);
        double[] score = new double[planes.size()];
        double[] extremes = thin == piece ? new double[0] : hull.vertices();
        jobs.run(
                (i, worker) -> score[i] = score(thin, extremes, planes.get(i), probe[worker]),
                score.length);
        int[] first = new int[Math.min(BEST, score.length)];
        for (int k = 0; k < first.length; k++) {
            for (int i = 1; i < score.length; i++) {
                first[k] = score[i] < score[first[k]] * (1 - TIE) ? i : first[k];
            }
            if (score[first[k]] == Double.POSITIVE_INFINITY) {
                first = Arrays.copyOf(first, k);
                break;
            }
            score[first[k]] = Double.POSITIVE_INFINITY;
        }
        int[] tried = first;
        @Nullable Cut[] cuts = new Cut[tried.length];
        jobs.run(
                (k, worker) -> cuts[k] = cut(piece, planes.get(tried[k]), probe[worker]),
                cuts.length);
        Cut best = null;
        for (Cut cut : cuts) {
            if (cut != null && (best == null || cut.score() < best.score() * (1 - TIE))) {
                best = cut;
            }
        }
        return best;
    }

    private static double score(double above, double below) {
        return above + below + UNEVEN * Math.abs(above - below);
    }

    private @Nullable Cut cut(Piece piece, double[] plane, Solid.Probe probe) {
        Piece[] both = piece.cut(solid, probe, plane);
        if (both == null) {
            return null;
        }
        ConvexHull above = Piece.hull(both[0].points(), tolerance);
        ConvexHull below = Piece.hull(both[1].points(), tolerance);
        return above == null || below == null
                ? null
                : new Cut(new Half(both[0], above), new Half(both[1], below));
    }

    private double score(Piece thin, double[] extremes, double[] plane, Solid.Probe probe) {
        Piece[] both = thin.cut(solid, probe, plane);
        if (both == null) {
            return Double.POSITIVE_INFINITY;
        }
        double[] volume = new double[2];
        for (int side = 0; side < 2; side++) {
            double[] points = both[side].points();
            int count = points.length;
            points = Arrays.copyOf(points, count + extremes.length);
            for (int k = 0; k < extremes.length; k += 3) {
                double h = Planes.height(plane, extremes[k], extremes[k + 1], extremes[k + 2]);
                if (side == 0 ? h >= 0 : h <= 0) {
                    System.arraycopy(extremes, k, points, count, 3);
                    count += 3;
                }
            }
            ConvexHull hull = Piece.hull(Arrays.copyOf(points, count), tolerance);
            if (hull == null) {
                return Double.POSITIVE_INFINITY;
            }
            volume[side] = hull.volume();
        }
        return score(volume[0], volume[1]);
    }

    private List<double[]> planes(Piece piece, ConvexHull hull, int number) {
        List<double[]> planes = new ArrayList<>();
        Vector3d com = hull.centreOfMass(new Vector3d());
        double[] box = new double[6];
        hull.bounds(0, 0, 0, 1, box, 0);
        double[] middle = {com.x, com.y, com.z};
        for (int k = 0; k < 6; k++) {
            box[k] += middle[k % 3];
        }
        double size = Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
        deep(piece, hull, com, size, planes);
        for (int axis = 0; axis < 3; axis++) {
            for (int slice = 1; slice < SLICES; slice++) {
                double[] plane = new double[4];
                plane[axis] = 1;
                plane[3] = box[axis] + slice * (box[axis + 3] - box[axis]) / SLICES;
                planes.add(plane);
            }
        }
        for (int k = 0; k < DRAWN; k++) {
            planes.add(drawn(number, k, box));
        }
        return planes;
    }

    /** A plane of any direction through a place in the middle half of a box. */
    private double[] drawn(int number, int k, double[] box) {
        long stream = CounterRandom.mix(seed, 64L * number + k);
        double[] plane = new double[4];
        double square = 0;
        for (int i = 0; square < 0.01 || square > 1; i += 3) {
            square = 0;
            for (int axis = 0; axis < 3; axis++) {
                plane[axis] = 2 * CounterRandom.share(stream, i + axis) - 1;
                square += plane[axis] * plane[axis];
            }
        }
        double length = Math.sqrt(square);
        for (int axis = 0; axis < 3; axis++) {
            plane[axis] /= length;
            double at = 0.25 + 0.5 * CounterRandom.share(stream, -1 - axis);
            plane[3] += plane[axis] * (box[axis] + at * (box[axis + 3] - box[axis]));
        }
        return plane;
    }

    /** Planes at the polygons that are deepest below the hull, no two nearly the same. */
    private void deep(
            Piece piece, ConvexHull hull, Vector3d com, double size, List<double[]> planes) {
        Piece some = piece.thinned(8 * THIN);
        double[] depth = new double[some.polygon.length];
        Polyhedron faces = Polyhedron.of(hull);
        for (int i = 0; i < depth.length; i++) {
            depth[i] = depth(some.polygon[i], faces, com);
        }
        Integer[] order = new Integer[depth.length];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, (a, b) -> Double.compare(depth[b], depth[a]));
        int taken = 0;
        for (int k = 0; k < order.length && taken < DEEP; k++) {
            int i = order[k];
            if (depth[i] <= 1e-9 * size) {
                break;
            }
            int t = some.source[i];
            double[] plane = Arrays.copyOfRange(solid.normal, 3 * t, 3 * t + 4);
            plane[3] = along(plane, 9 * t);
            boolean isNew = add(plane, com, size, planes);
            for (int e = 0; e < 3; e++) {
                if (((solid.hollow[t] >> e) & 1) != 0) {
                    isNew |= add(across(t, e), com, size, planes);
                }
            }
            taken += isNew ? 1 : 0;
        }
    }

    private static double depth(double[] polygon, Polyhedron faces, Vector3d com) {
        double x = 0;
        double y = 0;
        double z = 0;
        int n = polygon.length / 3;
        for (int k = 0; k < polygon.length; k += 3) {
            x += polygon[k] / n;
            y += polygon[k + 1] / n;
            z += polygon[k + 2] / n;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int f = 0; f < faces.faceCount(); f++) {
            double h =
                    faces.normalX(f) * (x - com.x)
                            + faces.normalY(f) * (y - com.y)
                            + faces.normalZ(f) * (z - com.z);
            least = Math.min(least, faces.offset(f) - h);
        }
        return least;
    }

    private double along(double[] plane, int corner) {
        return plane[0] * solid.corner[corner]
                + plane[1] * solid.corner[corner + 1]
                + plane[2] * solid.corner[corner + 2];
    }

    /** The plane through an edge of a triangle at right angles to it. */
    private double[] across(int t, int e) {
        int a = 9 * t + 3 * e;
        int b = 9 * t + 3 * ((e + 1) % 3);
        double ux = solid.corner[b] - solid.corner[a];
        double uy = solid.corner[b + 1] - solid.corner[a + 1];
        double uz = solid.corner[b + 2] - solid.corner[a + 2];
        double length = Planes.length(ux, uy, uz);
        double nx = solid.normal[3 * t];
        double ny = solid.normal[3 * t + 1];
        double nz = solid.normal[3 * t + 2];
        double[] plane = {
            (uy * nz - uz * ny) / length,
            (uz * nx - ux * nz) / length,
            (ux * ny - uy * nx) / length,
            0
        };
        plane[3] = along(plane, a);
        return plane;
    }

    /** Adds a plane unless one like it is there: within 1/8 rad, and 1/32 of the size. */
    private static boolean add(double[] plane, Vector3d com, double size, List<double[]> planes) {
        double own = Planes.height(plane, com.x, com.y, com.z);
        for (double[] other : planes) {
            double cosine = plane[0] * other[0] + plane[1] * other[1] + plane[2] * other[2];
            double height = Planes.height(other, com.x, com.y, com.z);
            double apart = Math.abs(cosine < 0 ? own + height : own - height);
            if (Math.abs(cosine) > 0.992 && apart < size / 32) {
                return false;
            }
        }
        planes.add(plane);
        return true;
    }
}
