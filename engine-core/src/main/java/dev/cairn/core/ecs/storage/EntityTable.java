package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.state.StateVisitor;

import java.util.Arrays;

/**
 * Which ids are alive, and where their rows are. A freed index is taken again by the next spawn
 * (last in, first out) under its next generation; an index whose generations are used up is
 * retired, so an id is never given twice.
 */
public final class EntityTable {
    /**
     * Generations stay positive: negative longs are the handles of {@link
     * dev.cairn.core.ecs.Commands#spawn}.
     */
    public static final int LAST_GENERATION = Integer.MAX_VALUE;

    private static final int FIRST_CAPACITY = 256;

    /** Archetype in the high 32 bits, row in the low; negative where the index is free. */
    private long[] places = new long[FIRST_CAPACITY];

    private int[] generations = new int[FIRST_CAPACITY];
    private int[] free = new int[FIRST_CAPACITY];
    private int freeCount;
    private int used;
    private int alive;

    /** The next id. Its place must be put right after. */
    long create() {
        int index;
        if (freeCount > 0) {
            index = free[--freeCount];
        } else {
            if (used == places.length) {
                grow(used + 1);
            }
            index = used++;
            generations[index] = 1;
        }
        alive++;
        return Entities.of(index, generations[index]);
    }

    /** Makes room for more entities at once. */
    void reserve(int more) {
        int needed = Math.addExact(used, Math.max(0, more - freeCount));
        if (needed > places.length) {
            grow(needed);
        }
    }

    private void grow(int needed) {
        int capacity = Math.max(needed, places.length + (places.length >> 1));
        places = Arrays.copyOf(places, capacity);
        generations = Arrays.copyOf(generations, capacity);
    }

    void put(long entity, int archetype, int row) {
        places[Entities.index(entity)] = (long) archetype << 32 | row;
    }

    /** Archetype and row, or a negative number where the entity is not alive. */
    public long place(long entity) {
        int index = Entities.index(entity);
        return index >= 0 && index < used && generations[index] == Entities.generation(entity)
                ? places[index]
                : -1;
    }

    public boolean isAlive(long entity) {
        return place(entity) >= 0;
    }

    /** Frees the index of an entity that is alive. */
    void free(long entity) {
        int index = Entities.index(entity);
        places[index] = -1;
        alive--;
        if (generations[index] == LAST_GENERATION) {
            return;
        }
        generations[index]++;
        if (freeCount == free.length) {
            free = Arrays.copyOf(free, free.length + (free.length >> 1));
        }
        free[freeCount++] = index;
    }

    public int aliveCount() {
        return alive;
    }

    /** All of it. */
    void state(StateVisitor s) {
        s.section("ids", this);
        used = s.value("used", used);
        alive = s.value("alive", alive);
        freeCount = s.value("freeCount", freeCount);
        places = s.array("places", places, used);
        generations = s.array("generations", generations, used);
        free = s.array("free", free, freeCount);
        if (generations.length != places.length) {
            generations = Arrays.copyOf(generations, places.length);
        }
    }

    /** What decides the ids of coming spawns. */
    long digest(long hash) {
        long result = Hash.mix(hash, used);
        result = Hash.mix(result, Hash.of(generations, used));
        return Hash.mix(result, Hash.of(free, freeCount));
    }

    /** For tests: as if the index had been reused very often. */
    void age(long entity, int generation) {
        generations[Entities.index(entity)] = generation;
    }
}
