package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.access.SchedulingException;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentCodec;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.ecs.storage.Hash;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.profile.SystemProfile;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.core.state.WorldState;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Entities, their components, and the systems that run on them.
 *
 * <pre>{@code
 * try (World world = World.builder().systems(new DragSystem()).workers(2).build()) {
 *     long crate = world.spawn(Pose.at(0, 5, 0), new Wind(1, 0, 0));
 *     world.step(1.0 / 60.0);
 *     Pose pose = world.get(crate, Pose.COMPONENT);
 * }
 * }</pre>
 *
 * <p>Between steps the simulation thread may change anything, at once. During a step, systems
 * change the structure through {@link Tick#commands()}; a direct call is refused. Reading ({@link
 * #get}, {@link #has}, {@link #isAlive}, {@link #resource}) is allowed then too, from any worker,
 * and gives the published state (of components written {@code inPlace}: see {@link #get}). All
 * other threads read through {@link dev.cairn.core.snapshot.SnapshotExchange}.
 *
 * <p>A call with bad arguments throws and changes nothing. A steady tick, without structural
 * changes, allocates nothing.
 */
public final class World extends WorldContents implements AutoCloseable, Stateful {
    private final Schedule schedule;
    private final Jobs jobs;
    private final boolean ownsJobs;
    private long seed;
    private final Runner runner;
    private double stepSeconds;
    private int skipped;

    /** The tick in which a system or an observer threw, or 0. */
    private long failedTick;

    /** While a tick runs: its thread; and whether the chunks of systems run in parallel. */
    private volatile @Nullable Thread stepThread;

    volatile boolean parallel;

    private World(Schedule schedule, Jobs jobs, boolean ownsJobs, long seed, boolean checked) {
        this.schedule = schedule;
        this.jobs = jobs;
        this.ownsJobs = ownsJobs;
        this.seed = seed;
        this.runner = new Runner(this, store, observers, schedule, jobs, checked);
    }

    /**
     * Begins a world.
     *
     * @return a builder with no systems, as many workers as fit the machine, and seed 0
     */
    public static Builder builder() {
        return new Builder();
    }

    /**
     * The entity that a {@link Commands#spawn} of the last step made.
     *
     * @param handle what spawn returned
     * @return the entity, which is alive unless something deleted it since
     * @throws DeadEntityException if the handle is not one of the last step
     */
    public long resolve(long handle) {
        long entity = Handle.isHandle(handle) ? runner.entityOf(handle) : Entities.NONE;
        if (entity == Entities.NONE) {
            throw new DeadEntityException(
                    "0x"
                            + Long.toHexString(handle)
                            + " is no handle of a spawn of the last step; resolve it right after"
                            + " the step that recorded it");
        }
        return entity;
    }

    /**
     * Computes one tick: runs the enabled systems, publishes what they wrote, and applies their
     * commands.
     *
     * @param stepSeconds length of the tick, finite and positive
     * @throws IllegalArgumentException if the length is NaN, infinite or not positive
     * @throws WorldFailedException if a system throws, or one threw in an earlier step; the
     *     published state is that of the last good tick
     * @throws WorldClosedException after {@link #close}
     * @throws IllegalStateException if called by a system
     */
    public void step(double stepSeconds) {
        requireChangeable("step");
        if (failedTick != 0) {
            throw new WorldFailedException(
                    "this world failed in tick "
                            + failedTick
                            + " and cannot step again; its last good state can still be read",
                    null);
        }
        if (!(stepSeconds > 0) || stepSeconds == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "stepSeconds is "
                            + stepSeconds
                            + ", but must be finite and above 0, such as 1.0 / 60.0");
        }
        stepping = true;
        stepThread = Thread.currentThread();
        long tick = tickNumber + 1;
        try {
            skipped = runner.run(tick, stepSeconds);
            tickNumber = tick;
            this.stepSeconds = stepSeconds;
            SystemFailure told = observers.takeFailure();
            if (told != null) {
                throw told;
            }
        } catch (Throwable failure) {
            failedTick = tick;
            throw Runner.explain(failure, tick);
        } finally {
            stepping = false;
            stepThread = null;
            parallel = false;
        }
    }

    /**
     * Number of completed ticks.
     *
     * @return 0 before the first step
     */
    public long tickNumber() {
        return tickNumber;
    }

    /**
     * Length of the last completed tick.
     *
     * @return seconds, 0 before the first step
     */
    public double stepSeconds() {
        return stepSeconds;
    }

    /**
     * Commands of the last step that had become pointless when their turn came; see {@link
     * Commands}.
     *
     * @return how many were skipped
     */
    public int skippedCommands() {
        return skipped;
    }

    /**
     * A hash of everything that decides what happens next: tick, seed, ids, free list, tables, and
     * the bits of all published columns. Two worlds that agree in it have, for all practical
     * purposes, the same state. Does not depend on the number of workers, on the order in which
     * systems were registered, or on the JVM. Strings, enum constants and boxed numbers in
     * reference columns count by value, other objects only by being there. Costs one pass over all
     * columns.
     *
     * @return 64 bits
     */
    public long digest() {
        long hash = Hash.mix(Hash.mix(Hash.START, seed), tickNumber);
        return store.digest(hash);
    }

    /**
     * Saves all that decides what happens next: entities with all components, tick and seed.
     * Between steps. Objects in columns are kept by reference, and are not copied; resources are
     * not saved.
     *
     * @return a new state
     * @throws IllegalStateException during a step
     * @throws WorldFailedException if the world has failed
     */
    public WorldState save() {
        WorldState state = new WorldState();
        save(state);
        return state;
    }

    /**
     * The same into a state that may be there already. Allocates only while its buffers grow.
     *
     * @param into what to fill
     */
    public void save(WorldState into) {
        requireChangeable("save");
        into.save(this);
    }

    /**
     * Goes on from a state that was saved here, or in another world with the same systems. Handles
     * of earlier ticks name nothing any more; ids that were given since the state was saved will be
     * given again. A world that has failed can step again.
     *
     * @param state what to restore
     * @throws StateException if it is the state of something else; the world is as before if the
     *     state came from bytes, and else needs another state
     * @throws IllegalStateException during a step
     */
    public void restore(WorldState state) {
        requireChangeable("restore");
        state.restoreOrKeep(this, failedTick == 0);
    }

    /**
     * How a state of such a world becomes bytes: {@code state.writeTo(file, World.codecs(WIND))}.
     * Columns of numbers and texts need no more; nor do those of enums, arrays of primitives, and
     * records of such, as {@link StateCodecs#derived} makes them. Objects of other classes need
     * codecs of their own, by {@code with(..)}.
     *
     * @param components all that entities may have
     * @return codecs
     */
    public static StateCodecs codecs(Component<?>... components) {
        return ComponentCodec.codecs(components);
    }

    /**
     * The declaration of all state, for those who hold a world as a part. Between steps.
     *
     * @param s saves or restores
     */
    @Override
    public void state(StateVisitor s) {
        if (failedTick != 0 && !s.isRestoring()) {
            throw new WorldFailedException(
                    "this world failed in tick "
                            + failedTick
                            + ", so its state is no state to go on from; restore an earlier one",
                    null);
        }
        s.section("world", this);
        tickNumber = s.value("tickNumber", tickNumber);
        stepSeconds = s.value("stepSeconds", stepSeconds);
        seed = s.value("seed", seed);
        skipped = s.value("skipped", skipped);
        store.state(s);
        if (s.isRestoring()) {
            failedTick = 0;
            runner.forgetCommands();
        }
    }

    /**
     * Whether a system or an observer threw in a step, so that this world cannot step again.
     *
     * @return whether it has failed
     */
    public boolean hasFailed() {
        return failedTick != 0;
    }

    /**
     * Whether the calling code may change objects that others share: true between steps and in a
     * {@link WorldSystem} on the simulation thread; false where blocks run in parallel, in a {@link
     * ChunkSystem} or a job, since what they do to a shared object would depend on who comes first.
     * Any thread.
     *
     * @return whether nobody else runs beside the caller within a step
     */
    @SuppressWarnings("ReferenceEquality") // the very thread
    public boolean isSerial() {
        Thread thread = stepThread;
        return thread == null || (!parallel && thread == Thread.currentThread());
    }

    /**
     * The seed of all random streams of this world.
     *
     * @return the seed
     */
    public long seed() {
        return seed;
    }

    /**
     * The systems of this world.
     *
     * @return the schedule
     */
    public Schedule schedule() {
        return schedule;
    }

    /**
     * How long each system works; off until it is enabled.
     *
     * @return the same object each time
     */
    public SystemProfile profile() {
        return runner.clock;
    }

    /**
     * The workers of this world.
     *
     * @return the job system
     */
    public Jobs jobs() {
        return jobs;
    }

    /**
     * Ends the world, and its workers if it made them. What it holds can still be read. A second
     * call does nothing.
     *
     * @throws IllegalStateException if called by a system
     */
    @Override
    public void close() {
        requireBetweenSteps("close");
        if (!closed) {
            closed = true;
            if (ownsJobs) {
                jobs.close();
            }
        }
    }

    /** Settings of a world. */
    public static final class Builder {
        private final List<EcsSystem> systems = new ArrayList<>();
        private @Nullable Schedule schedule;
        private @Nullable Jobs jobs;
        private int workers;
        private long seed;
        private boolean checked;

        private Builder() {}

        /**
         * The systems of the world, with headings.
         *
         * @param schedule the schedule
         * @return this
         */
        public Builder schedule(Schedule schedule) {
            this.schedule =
                    Objects.requireNonNull(schedule, "schedule must not be null: leave it out");
            return this;
        }

        /**
         * Adds systems, as a short way to a schedule with one heading.
         *
         * @param systems the systems
         * @return this
         */
        public Builder systems(EcsSystem... systems) {
            Objects.requireNonNull(systems, "systems must not be null");
            this.systems.addAll(Arrays.asList(systems));
            return this;
        }

        /**
         * The number of workers, the simulation thread included. They end with the world.
         *
         * @param workers the number, in {@code [1, Jobs.MAX_WORKERS]}
         * @return this
         * @throws IllegalArgumentException if the number is out of range
         */
        public Builder workers(int workers) {
            if (workers < 1 || workers > Jobs.MAX_WORKERS) {
                throw new IllegalArgumentException(
                        "workers is "
                                + workers
                                + ", but must be in [1, "
                                + Jobs.MAX_WORKERS
                                + "]; 1 runs everything on the calling thread");
            }
            this.workers = workers;
            return this;
        }

        /**
         * Workers that are shared with others. The world does not close them.
         *
         * @param jobs the job system
         * @return this
         */
        public Builder jobs(Jobs jobs) {
            this.jobs = Objects.requireNonNull(jobs, "jobs must not be null: leave it out");
            return this;
        }

        /**
         * The seed of all random streams, 0 by default.
         *
         * @param seed any number
         * @return this
         */
        public Builder seed(long seed) {
            this.seed = seed;
            return this;
        }

        /**
         * Whether contracts are verified: a write through {@code in} or {@code next}, and NaN left
         * in a written column, end the tick with an {@link AccessException} that names system and
         * column. The systems of a level then run one after the other, and each is a few times
         * slower. (A column that was not declared is refused in any case.)
         *
         * @param checked whether to verify
         * @return this
         */
        public Builder checked(boolean checked) {
            this.checked = checked;
            return this;
        }

        /**
         * Makes the world.
         *
         * @return an empty world
         * @throws SchedulingException if the systems contradict each other
         * @throws IllegalStateException if both ways to give systems, or both to give workers, were
         *     used
         */
        public World build() {
            if (schedule != null && !systems.isEmpty()) {
                throw new IllegalStateException(
                        "both schedule and systems were given; add the systems to the schedule");
            }
            if (jobs != null && workers != 0) {
                throw new IllegalStateException(
                        "both jobs and workers were given; jobs decides the number of workers");
            }
            Schedule built =
                    schedule != null
                            ? schedule
                            : Schedule.builder()
                                    .stage("systems", systems.toArray(EcsSystem[]::new))
                                    .build();
            if (jobs != null) {
                return new World(built, jobs, false, seed, checked);
            }
            Jobs own = Jobs.of(workers == 0 ? Jobs.defaultWorkers() : workers);
            return new World(built, own, true, seed, checked);
        }
    }
}
