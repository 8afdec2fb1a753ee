package dev.cairn.core.job;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * What the blocks of one stage threw, per worker, until the caller rethrows it.
 *
 * <p>A worker records into its own list; the caller reads the lists after the stage, so the order
 * that ends the stage also publishes them. The first record of a worker needs no memory, so that an
 * {@link OutOfMemoryError} in a block is not lost to another one here.
 */
final class Failures {

    private record Failure(int block, Throwable thrown) {}

    private final int[] lowestBlock;
    private final @Nullable Throwable[] lowest;
    private final List<List<Failure>> others;
    private boolean any;

    Failures(int workers) {
        lowestBlock = new int[workers];
        lowest = new Throwable[workers];
        others = new ArrayList<>(workers);
        for (int worker = 0; worker < workers; worker++) {
            others.add(new ArrayList<>(0));
        }
    }

    /** Records a failure. Called by the worker itself, within its block. */
    void record(int worker, int block, Throwable thrown) {
        any = true; // every writer writes the same; the end of the stage publishes it
        Throwable before = lowest[worker];
        int beforeBlock = lowestBlock[worker];
        boolean isLowest = before == null || block < beforeBlock;
        if (isLowest) {
            lowest[worker] = thrown;
            lowestBlock[worker] = block;
        }
        if (before != null) {
            try {
                others.get(worker)
                        .add(
                                isLowest
                                        ? new Failure(beforeBlock, before)
                                        : new Failure(block, thrown));
            } catch (OutOfMemoryError noRoom) {
                // The lowest failure is kept; one that would only be suppressed is let go.
            }
        }
    }

    /** Whether a block has failed; read by the caller after the stage. */
    boolean any() {
        return any;
    }

    /**
     * Empties the lists and returns the failure of the lowest block, with those of the others
     * suppressed in it in block order. Called by the caller after the stage, if {@link #any}.
     */
    @SuppressWarnings("ReferenceEquality") // a throwable cannot suppress itself, the very object
    Throwable take() {
        List<Failure> all = new ArrayList<>();
        for (int worker = 0; worker < lowest.length; worker++) {
            Throwable thrown = lowest[worker];
            if (thrown != null) {
                all.add(new Failure(lowestBlock[worker], thrown));
                all.addAll(others.get(worker));
                others.get(worker).clear();
                lowest[worker] = null;
            }
        }
        any = false;
        all.sort(Comparator.comparingInt(Failure::block));
        Throwable first = all.getFirst().thrown();
        for (Failure failure : all.subList(1, all.size())) {
            if (failure.thrown() != first) {
                first.addSuppressed(failure.thrown());
            }
        }
        return first;
    }
}
