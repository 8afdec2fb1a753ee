package dev.cairn.physics.shape.decomposition;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;

/** Cuts the part with the largest error in two, again and again. */
final class Cutter {
    /** What is larger by less is a tie, and the older part comes first. */
    private static final double TIE = 1 + 1e-9;

    private final Solid solid;
    private final double tolerance;
    private final double allowed;
    private final Jobs jobs;
    private final Cuts cuts;

    Cutter(Solid solid, long seed, double tolerance, double allowed, Jobs jobs) {
        this.solid = solid;
        this.tolerance = tolerance;
        this.allowed = allowed;
        this.jobs = jobs;
        cuts = new Cuts(solid, seed, tolerance, jobs);
    }

    /**
     * Cuts until all parts are within the allowed error, or there are enough of them.
     *
     * @param progress is told a share, ascending
     */
    List<Part> cut(int most, DoubleConsumer progress) {
        Piece whole = Piece.of(solid);
        double[] points = whole.points();
        ConvexHull hull = Piece.hull(points, tolerance);
        if (hull == null) {
            hull = ConvexHull.of(points); // says why there is none
        }
        List<Part> done = new ArrayList<>();
        List<Part> open = new ArrayList<>(List.of(measured(whole, hull)));
        int number = 0;
        while (!open.isEmpty()) {
            progress.accept(Math.min(1, (done.size() + open.size()) / (double) most));
            int worst = 0;
            for (int i = 1; i < open.size(); i++) {
                worst = open.get(i).beyond > open.get(worst).beyond * TIE ? i : worst;
            }
            Part part = open.remove(worst);
            Piece piece = part.piece;
            if (part.bound <= allowed || done.size() + open.size() + 1 >= most || piece == null) {
                done.add(part);
                continue;
            }
            Cuts.Cut cut = cuts.best(piece, part.hull, number++);
            if (cut == null) {
                done.add(part);
                continue;
            }
            Part[] two = new Part[2];
            jobs.run(
                    (side, worker) -> {
                        Cuts.Half half = side == 0 ? cut.above() : cut.below();
                        two[side] = measured(half.piece(), half.hull());
                    },
                    2);
            open.add(two[0]);
            open.add(two[1]);
        }
        return done;
    }

    private Part measured(Piece piece, ConvexHull hull) {
        HullGap gap = new HullGap(solid);
        gap.measure(hull, allowed / 8, 0.25, allowed, Double.POSITIVE_INFINITY);
        return new Part(piece, hull, piece.points(), gap.found, gap.bound);
    }
}
