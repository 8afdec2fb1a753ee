package dev.cairn.physics.shape.decomposition;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.TriangleMesh;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleConsumer;

/**
 * Makes convex parts of a mesh, so that a body of any form can move: options first, then {@link
 * #run}. One thread; the result is the same, to the bit, for any number of workers.
 *
 * <pre>{@code
 * Decomposition parts = Decomposer.of(mesh).error(0.01).parts(32).run();
 * }</pre>
 *
 * <p>For tools and loading screens: it takes from milliseconds to seconds, and allocates.
 */
public final class Decomposer {
    /** Most parts that may be asked for. */
    public static final int MOST_PARTS = 1024;

    /** Least error that may be asked for, a share of the longest side. */
    public static final double LEAST_ERROR = 1e-4;

    /** Cutting goes on to so many times the parts that are wanted, then the best are merged. */
    private static final int SPARE = 2;

    /** Share of the allowed error by which hulls may be coarser than their points. */
    private static final double COARSE = 1 / 8.0;

    /** What a part may leave out of its points in the end, a share of the allowed error. */
    private static final double MISSING = 1 / 4.0;

    /** How often the tolerance is halved for that. */
    private static final int FINER = 6;

    private final TriangleMesh mesh;
    private int parts = 32;
    private double error = 0.02;
    private long seed;
    private DoubleConsumer progress = share -> {};
    private BooleanSupplier cancelled = () -> false;

    private Decomposer(TriangleMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Begins with up to 32 parts, an error of 0.02 and seed 0.
     *
     * @param mesh best closed; {@link TriangleMesh#report} tells. Of one that is not, a place is
     *     inside if most rays from it cross the surface more often outwards than inwards, and a
     *     sheet is a solid without thickness
     * @return options to set
     */
    public static Decomposer of(TriangleMesh mesh) {
        if (mesh == null) {
            throw new IllegalArgumentException("mesh is null; give the surface of a solid");
        }
        return new Decomposer(mesh);
    }

    /**
     * Bounds the number of parts. It goes before the error.
     *
     * @param most 1 to {@value #MOST_PARTS}
     * @return this
     */
    public Decomposer parts(int most) {
        if (most < 1 || most > MOST_PARTS) {
            throw new IllegalArgumentException(
                    "parts is " + most + "; it must lie in [1, " + MOST_PARTS + "]");
        }
        parts = most;
        return this;
    }

    /**
     * Allows an error: no point of a part may be farther from the mesh's solid. A gap or a hole
     * narrower than twice of it may be closed.
     *
     * @param share of the longest side of the mesh's box, {@value #LEAST_ERROR} to 1
     * @return this
     */
    public Decomposer error(double share) {
        if (!(share >= LEAST_ERROR && share <= 1)) {
            throw new IllegalArgumentException(
                    "error is "
                            + share
                            + " of the longest side; it must lie in ["
                            + LEAST_ERROR
                            + ", 1]");
        }
        error = share;
        return this;
    }

    /**
     * Seeds the planes that are tried beside those that follow from the mesh.
     *
     * @param value any
     * @return this
     */
    public Decomposer seed(long value) {
        seed = value;
        return this;
    }

    /**
     * Has the share that is done told: ascending, 1 at the end, on the thread of {@link #run}.
     *
     * @param told gets it
     * @return this
     */
    public Decomposer progress(DoubleConsumer told) {
        progress = told;
        return this;
    }

    /**
     * Asks now and then, on the thread of {@link #run}, whether to end early.
     *
     * @param asked true to end with a {@link CancellationException}
     * @return this
     */
    public Decomposer cancel(BooleanSupplier asked) {
        cancelled = asked;
        return this;
    }

    /**
     * Computes on this thread alone.
     *
     * @return the parts
     */
    public Decomposition run() {
        try (Jobs alone = Jobs.of(1)) {
            return run(alone);
        }
    }

    /**
     * Computes.
     *
     * @param jobs the workers; not those of a step that is under way
     * @return the parts
     * @throws dev.cairn.physics.shape.DegenerateShapeException if the mesh is flat
     * @throws CancellationException if it was cancelled
     */
    public Decomposition run(Jobs jobs) {
        tell(0);
        Solid solid = new Solid(mesh);
        double allowed = error * solid.size;
        double tolerance = COARSE * allowed;
        Cutter cutter = new Cutter(solid, seed, tolerance, allowed, jobs);
        int wanted = parts == 1 ? 1 : Math.min(MOST_PARTS, SPARE * parts);
        List<Part> all = cutter.cut(wanted, share -> tell(0.6 * share));
        int before = all.size();
        List<Part> left = new ArrayList<>(all);
        new Merger(solid, tolerance, allowed, jobs)
                .merge(left, parts, () -> tell(0.6 + 0.3 * (before - left.size()) / before));
        Decomposition.Measured[] last = new Decomposition.Measured[left.size()];
        tell(0.9);
        jobs.run((i, worker) -> last[i] = finished(left.get(i), solid, allowed), last.length);
        tell(1);
        return new Decomposition(mesh, List.of(last), allowed);
    }

    /** A hull that leaves out little of its points, and all that can be measured of it. */
    private static Decomposition.Measured finished(Part part, Solid solid, double allowed) {
        double tolerance = COARSE * allowed;
        ConvexHull hull = part.hull;
        double missing = Shortfall.of(part.points, hull, solid.snap);
        for (int turn = 0; turn < FINER && missing > MISSING * allowed; turn++) {
            tolerance /= 2;
            hull = Piece.hull(part.points, tolerance);
            if (hull == null) {
                throw new IllegalStateException("a part of a volume has a hull of none");
            }
            missing = Shortfall.of(part.points, hull, solid.snap);
        }
        HullGap gap = new HullGap(solid);
        gap.measure(hull, allowed / 8, 0, allowed / 2, Double.POSITIVE_INFINITY);
        double found = gap.found;
        double bound = gap.bound;
        if (bound > allowed && found <= allowed) {
            // more cubes than were looked at: fewer do to tell whether it is within
            gap.measure(hull, allowed / 8, 0, allowed, Double.POSITIVE_INFINITY);
            found = Math.max(found, gap.found);
            bound = Math.min(bound, gap.bound);
        }
        return new Decomposition.Measured(hull, found, bound, missing);
    }

    private void tell(double share) {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("the decomposition was cancelled at " + share);
        }
        progress.accept(share);
    }
}
