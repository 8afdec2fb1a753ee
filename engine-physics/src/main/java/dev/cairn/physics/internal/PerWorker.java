package dev.cairn.physics.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * What each worker of a stage has of its own: scratch, searches, lists.
 *
 * <p>All are made by the first {@link #ensure} that knows how many workers there are, in a method
 * of its own. Problem: the compiler draws constructors into the methods that call them, however
 * rarely. A stage whose {@code run} held {@code new SeamPlanes(..)} took it a second, in which
 * nothing else of the scene was compiled.
 *
 * @param <T> what a worker has
 */
public final class PerWorker<T> {
    private final Supplier<T> maker;
    private final List<T> all = new ArrayList<>();

    /**
     * Nothing yet.
     *
     * @param maker makes that of one worker
     */
    public PerWorker(Supplier<T> maker) {
        this.maker = maker;
    }

    /** Makes what is missing. Simulation thread, between stages; allocates when it makes. */
    public void ensure(int workers) {
        if (all.size() < workers) {
            make(workers);
        }
    }

    private void make(int workers) {
        while (all.size() < workers) {
            all.add(maker.get());
        }
    }

    /** That of a worker, from 0 on; this worker's thread. */
    public T of(int worker) {
        return all.get(worker);
    }

    /** How many there are; with {@link #of}, on the simulation thread between stages. */
    public int count() {
        return all.size();
    }
}
