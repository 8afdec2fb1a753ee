package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.job.Jobs;

import java.util.Objects;

/**
 * The tick that is being computed: the only context of a system. Valid during the call that
 * received it, on the thread that received it; there is one object per worker. Nothing here
 * allocates in steady state.
 */
public final class Tick {
    private final World world;
    private final SystemRunner none;
    private final int worker;
    private final RandomStream random = new RandomStream();
    private SystemRunner system;
    private int block;
    private long number;
    private double stepSeconds;

    Tick(World world, SystemRunner none, int worker) {
        this.world = world;
        this.none = none;
        this.system = none;
        this.worker = worker;
    }

    void begin(long newNumber, double newStepSeconds) {
        number = newNumber;
        stepSeconds = newStepSeconds;
    }

    Tick bind(SystemRunner newSystem, int newBlock) {
        system = newSystem;
        block = newBlock;
        return this;
    }

    void unbind() {
        system = none;
    }

    /** Chunks run in parallel from now on, or no longer. Simulation thread. */
    void fork(boolean value) {
        world.parallel = value;
    }

    /**
     * The number of this tick.
     *
     * @return 1 for the first tick of a world
     */
    public long number() {
        return number;
    }

    /**
     * The length of this tick.
     *
     * @return seconds, finite and positive
     */
    public double stepSeconds() {
        return stepSeconds;
    }

    /**
     * The workers, for a {@link WorldSystem} to fork on. A chunk system runs inside a fork already.
     *
     * @return the world's job system
     */
    public Jobs jobs() {
        return world.jobs();
    }

    /**
     * The worker that runs this call, for scratch memory per worker; results must not depend on it.
     *
     * @return index in {@code [0, jobs().workers())}
     */
    public int worker() {
        return worker;
    }

    /**
     * The commands of this system and chunk. A {@link WorldSystem} records on the simulation
     * thread.
     *
     * @return the recorder, valid during this call
     * @throws AccessException if the system has not declared {@link Access#commands}
     */
    public Commands commands() {
        return system.commands(block, number);
    }

    /**
     * A shared object of the world.
     *
     * @param type the class that it was put under
     * @param <T> its type
     * @return the resource
     * @throws ComponentException if there is none
     */
    public <T> T resource(Class<T> type) {
        return world.resource(type);
    }

    /**
     * Whether an entity was alive when this tick began.
     *
     * @param entity an entity
     * @return whether it is alive in the published state
     */
    public boolean isAlive(long entity) {
        return world.isAlive(entity);
    }

    /**
     * Random numbers of this tick. The returned cursor is this worker's own and is reused by the
     * next call; blocks that a world system forks make their own {@link RandomStream}.
     *
     * @param entity the entity, or any other number that tells draws apart
     * @param stream number of the use, so that two systems draw different numbers
     * @return a cursor at the beginning of the stream
     */
    public RandomStream random(long entity, int stream) {
        return random.reset(world.seed(), number, entity, stream);
    }

    /**
     * Number of chunks that match the running system.
     *
     * @return the number of chunks
     */
    public int chunkCount() {
        return system.chunks.count();
    }

    /**
     * A chunk that matches the running system.
     *
     * @param index the chunk, in {@code [0, chunkCount())}
     * @return the chunk
     * @throws IndexOutOfBoundsException if there is no such chunk
     */
    public Chunk chunk(int index) {
        return system.chunks.get(Objects.checkIndex(index, system.chunks.count()));
    }
}
