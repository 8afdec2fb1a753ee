package dev.cairn.benchmarks;

import dev.cairn.core.job.BlockJob;
import dev.cairn.physics.PhysicsWorld;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Times the stages of a world's contact solver, which has no clock of its own: each of its block
 * jobs is replaced by one that reads the time before and after. What lies between two jobs is the
 * solver's serial code; it counts for the job that follows.
 *
 * <p>For a world of one worker. A block costs two readings of the clock, some 50 ns, more than
 * without.
 */
final class SolverClock {
    private final List<String> names = new ArrayList<>();
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
            List<Object> owners = new ArrayList<>(List.of(solver));
            // one for rows of floats, one for rows of doubles: their jobs have the same names
            owners.addAll(Arrays.asList((Object[]) field(solver, "lockstep")));
            for (Object owner : owners) {
                for (Field field : jobs(owner)) {
                    if (!names.contains(field.getName())) {
                        names.add(field.getName());
                    }
                }
            }
            jobNanos = new long[names.size()];
            gapNanos = new long[jobNanos.length];
            for (Object owner : owners) {
                for (Field field : jobs(owner)) {
                    field.setAccessible(true);
                    int job = names.indexOf(field.getName());
                    field.set(owner, clocked(job, (BlockJob) field.get(owner)));
                }
            }
        } catch (ReflectiveOperationException changed) {
            throw new IllegalStateException(
                    "The contact solver is built another way now; SolverClock looks for"
                        + " PhysicsWorld.physics, its solver, and the block jobs of that one and of"
                        + " its two locksteps",
                    changed);
        }
    }

    private static List<Field> jobs(Object owner) {
        return Arrays.stream(owner.getClass().getDeclaredFields())
                .filter(field -> field.getType() == BlockJob.class)
                .toList();
    }

    private static Object field(Object owner, String name) throws ReflectiveOperationException {
        for (Class<?> type = owner.getClass(); type != null; type = type.getSuperclass()) {
            for (Field field : type.getDeclaredFields()) {
                if (field.getName().equals(name)) {
                    field.setAccessible(true);
                    return field.get(owner);
                }
            }
        }
        throw new NoSuchFieldException(owner.getClass() + " has no field " + name);
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
        int index = names.indexOf(job);
        if (index < 0) {
            throw new IllegalStateException(
                    "the contact solver has no job \"%s\"; it has %s"
                            .formatted(job, String.join(", ", names)));
        }
        return index;
    }
}
