package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.ecs.storage.Store;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.Objects;

/**
 * Structural changes that a system asks for during a tick. They are recorded per (system, chunk),
 * in the order of the calls, and made at commit in the order of (system, chunk, sequence), so the
 * result does not depend on which worker came first. A system declares that it gives commands
 * ({@link Access#commands}), and two that do have an order.
 *
 * <p>What concerns a dead entity is refused when it is recorded. What has become pointless by the
 * time of the commit, because an earlier command of the same tick deleted the entity or removed the
 * component, is skipped and counted in {@link World#skippedCommands()}; an {@code add} of a
 * component that an earlier command added replaces it.
 *
 * <p>An object belongs to one (system, chunk); get it anew from {@link Tick#commands()} in each
 * call. Recording allocates only while the buffers grow.
 */
public final class Commands {
    private static final byte SPAWN = 0;
    private static final byte PART = 1;
    private static final byte DELETE = 2;
    private static final byte ADD = 3;
    private static final byte REMOVE = 4;
    private static final byte CLEAR = 5;
    private static final byte SET = 6;

    /** How long observers may go on asking for changes that are told to observers. */
    private static final int MOST_ROUNDS = 1000;

    private final Store store;
    private final Handles handles;
    private final int system;
    private final int chunk;
    private final @Nullable Thread owner;
    private byte[] operations = new byte[8];
    private long[] targets = new long[8];
    private @Nullable Object[] payloads = new Object[8];
    private long[] spawned = new long[4];
    private int count;
    private int spawns;
    private int resolved;
    private long tick;

    /** Whoever can turn a handle into an entity. */
    interface Handles {
        /** The entity of a handle of this tick, or {@link Entities#NONE} where it has none yet. */
        long entityOf(long handle);
    }

    Commands(Store store, Handles handles, int system, int chunk, @Nullable Thread owner) {
        this.store = store;
        this.handles = handles;
        this.system = system;
        this.chunk = chunk;
        this.owner = owner;
    }

    /** Forgets the last tick's commands when a new tick begins to record. */
    Commands begin(long current) {
        if (tick != current) {
            tick = current;
            count = 0;
            spawns = 0;
            resolved = 0;
        }
        return this;
    }

    /**
     * Makes an entity at commit.
     *
     * @param components its components, each at most once
     * @return a handle that the other commands of this tick accept in place of the entity, and that
     *     {@link World#resolve} turns into the entity after the step
     * @throws NullPointerException if a component is null
     * @throws ComponentException if a component is given twice
     */
    public long spawn(Record... components) {
        WorldContents.requireParts(components);
        Store.components(components);
        long handle = Handle.of(system, chunk, tick, spawns);
        record(SPAWN, components.length, null);
        spawns++;
        for (Record part : components) {
            record(PART, Entities.NONE, part);
        }
        return handle;
    }

    /**
     * Deletes an entity at commit.
     *
     * @param entity an entity, or a handle of this tick
     * @throws DeadEntityException if it is not alive
     */
    public void delete(long entity) {
        check(entity, "delete");
        record(DELETE, entity, null);
    }

    /**
     * Gives an entity one more component at commit.
     *
     * @param entity an entity, or a handle of this tick
     * @param component the component
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     */
    public void add(long entity, Record component) {
        WorldContents.requirePart(component);
        check(entity, "add");
        Component.of(component.getClass());
        record(ADD, entity, component);
    }

    /**
     * Takes a component from an entity at commit.
     *
     * @param entity an entity, or a handle of this tick
     * @param component the component
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     */
    public void remove(long entity, Component<?> component) {
        WorldContents.requireKey(component);
        check(entity, "remove");
        record(REMOVE, entity, component);
    }

    /**
     * Takes all components from an entity at commit; it stays alive.
     *
     * @param entity an entity, or a handle of this tick
     * @throws DeadEntityException if the entity is not alive
     */
    public void clear(long entity) {
        check(entity, "clear");
        record(CLEAR, entity, null);
    }

    /**
     * Replaces a component of an entity at commit, after the columns of this tick are published.
     *
     * @param entity an entity, or a handle of this tick
     * @param component the new value
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     */
    public void set(long entity, Record component) {
        WorldContents.requirePart(component);
        check(entity, "set");
        Component.of(component.getClass());
        record(SET, entity, component);
    }

    /** Forgets what was recorded and spawned: the world has another state. */
    void forget() {
        tick = -1;
        drop();
        spawns = 0;
        resolved = 0;
    }

    private void check(long entity, String call) {
        if (!Handle.isHandle(entity)) {
            store.require(entity, call);
        } else if (!Handle.isOf(entity, tick)) {
            throw new DeadEntityException(
                    "the handle for "
                            + call
                            + " is from another tick; turn it into an entity with World.resolve"
                            + " after the step that made it");
        }
    }

    private void record(byte operation, long target, @Nullable Object payload) {
        if (owner != null && !owner.equals(Thread.currentThread())) {
            throw new IllegalStateException(
                    "the commands of a WorldSystem are recorded on the simulation thread only;"
                            + " collect per block, and record after jobs().run has returned");
        }
        if (count == operations.length) {
            operations = Arrays.copyOf(operations, count * 2);
            targets = Arrays.copyOf(targets, count * 2);
            payloads = Arrays.copyOf(payloads, count * 2);
        }
        operations[count] = operation;
        targets[count] = target;
        payloads[count] = payload;
        count++;
    }

    /** Makes the changes. At commit, simulation thread. Returns how many were skipped. */
    int apply(long current) {
        if (tick != current) {
            return 0;
        }
        int skipped = 0;
        int round = 0;
        int roundEnd = count;
        for (int i = 0; i < count; i++) {
            if (i == roundEnd) { // observers have asked for more meanwhile
                roundEnd = count;
                requireEnd(++round, payloads[i]);
            }
            if (operations[i] == SPAWN) {
                i += applySpawn(i);
            } else if (!apply(operations[i], targets[i], payloads[i])) {
                skipped++;
            }
        }
        drop();
        return skipped;
    }

    /** Without what was recorded. */
    void drop() {
        Arrays.fill(payloads, 0, count, null);
        count = 0;
    }

    private static void requireEnd(int round, @Nullable Object payload) {
        if (round > MOST_ROUNDS) {
            throw new IllegalStateException(
                    "observers have answered each other's commands for "
                            + MOST_ROUNDS
                            + " rounds, the last one with "
                            + payload
                            + "; one of them asks for what it is told of itself, so let it ask"
                            + " for an end first");
        }
    }

    private int applySpawn(int at) {
        Record[] parts = new Record[(int) targets[at]];
        for (int part = 0; part < parts.length; part++) {
            parts[part] = (Record) Objects.requireNonNull(payloads[at + 1 + part], "payload");
        }
        if (resolved == spawned.length) {
            spawned = Arrays.copyOf(spawned, resolved * 2);
        }
        spawned[resolved++] = store.spawn(parts);
        return parts.length;
    }

    private boolean apply(byte operation, long target, @Nullable Object payload) {
        long entity = Handle.isHandle(target) ? handles.entityOf(target) : target;
        if (!store.entities.isAlive(entity)) {
            return false;
        }
        switch (operation) {
            case DELETE -> store.delete(entity);
            case CLEAR -> store.clear(entity);
            case REMOVE -> {
                Component<?> component = (Component<?>) Objects.requireNonNull(payload, "payload");
                if (!store.has(entity, component)) {
                    return false;
                }
                store.remove(entity, component);
            }
            default -> {
                Record value = (Record) Objects.requireNonNull(payload, "payload");
                boolean present = store.has(entity, Component.of(value.getClass()));
                if (present) {
                    store.set(entity, value);
                } else if (operation == ADD) {
                    store.add(entity, value);
                } else {
                    return false;
                }
            }
        }
        return true;
    }

    /** The entity that the n-th spawn of a tick became, or none. */
    long entityOf(long handle) {
        int ordinal = Handle.ordinal(handle);
        return Handle.isOf(handle, tick) && ordinal < resolved ? spawned[ordinal] : Entities.NONE;
    }
}
