package dev.cairn.benchmarks;

import dev.cairn.core.job.BlockJob;
import dev.cairn.physics.PhysicsWorld;

import java.lang.reflect.Field;
import java.util.Arrays;

/**
 * Times the stages of a world's contact solver, which has no clock of its own: each of its block
 * jobs is replaced by one that reads the time before and after. What lies between two jobs is the
 * solver's serial code; it counts for the job that follows.
 *
 * <p>For a world of one worker. A block costs two readings of the clock, some 50 ns, more than
 * without.
 */
final class SolverClock {
    private final String[] names;
    private final long[] jobNanos;
    private final long[] gapNanos;
    private int last = -1;
    private long mark;

    /**
     * Puts clocks around the jobs.
     *
     * @param world with one worker, between steps
     */
    SolverClock(PhysicsWorld world) {
        try {
            Object solver = field(field(world, "physics"), "solver");
            Field[] fields =
                    Arrays.stream(solver.getClass().getDeclaredFields())
                            .filter(field -> field.getType() == BlockJob.class)
                            .toArray(Field[]::new);
            names = Arrays.stream(fields).map(Field::getName).toArray(String[]::new);
            jobNanos = new long[names.length];
            gapNanos = new long[names.length];
            for (int job = 0; job < names.length; job++) {
                Field field = fields[job];
                field.setAccessible(true);
                field.set(solver, clocked(job, (BlockJob) field.get(solver)));
            }
        } catch (ReflectiveOperationException changed) {
            throw new IllegalStateException(
                    "The contact solver is built another way now; SolverClock looks for"
                            + " PhysicsWorld.physics, its solver, and that one's block jobs",
                    changed);
        }
    }

    private static Object field(Object owner, String name) throws ReflectiveOperationException {
        Field field = owner.getClass().getDeclaredField(name);
        field.setAccessible(true);
        return field.get(owner);
    }

    private BlockJob clocked(int job, BlockJob inner) {
        return (block, worker) -> {
            long start = System.nanoTime();
            // Between two blocks of one job, of one colour and the next, say, lies its dispatch.
            (last == job ? jobNanos : gapNanos)[job] += start - mark;
            inner.run(block, worker);
            mark = System.nanoTime();
            jobNanos[job] += mark - start;
            last = job;
        };
    }

    /** Forgets what was measured. */
    void reset() {
        Arrays.fill(jobNanos, 0);
        Arrays.fill(gapNanos, 0);
        last = -1;
    }

    /** Nanoseconds of some jobs since the last reset. */
    long nanos(String... jobs) {
        long sum = 0;
        for (String job : jobs) {
            sum += jobNanos[index(job)];
        }
        return sum;
    }

    /** Nanoseconds between the ends of other jobs and the starts of this one. */
    long nanosBefore(String job) {
        return gapNanos[index(job)];
    }

    private int index(String job) {
        int index = Arrays.asList(names).indexOf(job);
        if (index < 0) {
            throw new IllegalStateException(
                    "the contact solver has no job \"%s\"; it has %s"
                            .formatted(job, String.join(", ", names)));
        }
        return index;
    }
}
