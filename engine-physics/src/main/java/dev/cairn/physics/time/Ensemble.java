package dev.cairn.physics.time;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * Many futures of one state, beside each other: to aim, to plan, to learn. Each worker has one fork
 * and takes branch after branch from the state that the world was in, so a branch costs a restore
 * and its steps, and no branch sees another.
 *
 * <p>A result is a function of the state and of its branch's number, for any number of workers. The
 * systems of the world are shared by all forks: a system that keeps anything outside of components
 * must not be among them.
 */
public final class Ensemble {
    private Ensemble() {}

    /**
     * What happens in a branch.
     *
     * @param <R> what it tells
     */
    @FunctionalInterface
    public interface Branch<R> {
        /**
         * Acts on a fork, steps it and judges it. Called by many threads at once, each with a world
         * of its own; it must touch nothing else that others change.
         *
         * @param world in the state of the world that was forked; {@code bodyOf} finds its bodies
         * @param number of the branch, from 0 on
         * @return what the branch has come to
         */
        R run(PhysicsWorld world, int number);
    }

    /**
     * Runs all branches on the workers of the world, and leaves the world as it is. The caller must
     * not be inside a step.
     *
     * @param world whose state all branches start from
     * @param branches how many, at least 0
     * @param branch what happens in each
     * @param <R> what a branch tells
     * @return results in the order of their numbers
     */
    public static <R> List<R> run(PhysicsWorld world, int branches, Branch<R> branch) {
        if (world == null || branch == null || branches < 0) {
            throw new IllegalArgumentException(
                    "Ensemble.run needs a world, a branch and at least 0 branches, and got "
                            + branches
                            + " of them");
        }
        WorldState start = world.save();
        Jobs jobs = world.ecs().jobs();
        @Nullable Object[] results = new Object[branches];
        Forks<R> forks = new Forks<>(world, start, branch, results);
        try {
            for (int w = 0; w < Math.min(jobs.workers(), branches); w++) {
                forks.add();
            }
            jobs.run(forks, branches);
        } finally {
            forks.close();
        }
        return collect(results);
    }

    @SuppressWarnings({"unchecked", "NullAway"}) // a branch may tell null
    private static <R> List<R> collect(@Nullable Object[] results) {
        List<R> list = new ArrayList<>(results.length);
        for (Object result : results) {
            list.add((R) result);
        }
        return list;
    }

    /** A fork to each worker, which steps alone. */
    private static final class Forks<R> implements BlockJob, AutoCloseable {
        private final PhysicsWorld world;
        private final WorldState start;
        private final Branch<R> branch;
        private final @Nullable Object[] results;
        private final List<PhysicsWorld> worlds = new ArrayList<>();
        private final List<Jobs> alone = new ArrayList<>();

        Forks(PhysicsWorld world, WorldState start, Branch<R> branch, @Nullable Object[] results) {
            this.world = world;
            this.start = start;
            this.branch = branch;
            this.results = results;
        }

        void add() {
            alone.add(Jobs.of(1));
            worlds.add(world.fork(alone.getLast()));
        }

        @Override
        public void run(int block, int worker) {
            PhysicsWorld own = worlds.get(worker);
            own.restore(start);
            results[block] = branch.run(own, block);
        }

        @Override
        public void close() {
            worlds.forEach(PhysicsWorld::close);
            alone.forEach(Jobs::close);
        }
    }
}
