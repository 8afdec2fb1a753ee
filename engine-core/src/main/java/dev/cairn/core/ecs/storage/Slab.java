package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.state.StateVisitor;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The storage of one chunk: its rows, and per column a published array and the array of the tick
 * that is being computed. Both are the same array until a system asks to write. Then the spare
 * array takes the writes, and commit exchanges the two references; nothing is copied back.
 */
public final class Slab {
    public final Archetype archetype;

    /** Readable by everyone during a tick. */
    public final Object[] published;

    /** What this tick writes; the same reference as published where nothing wrote. */
    public final Object[] next;

    /** The array that the next write will take; null until the first write. */
    public final @Nullable Object[] spare;

    /** Tick of the last commit that replaced the column. */
    public final long[] versions;

    public long[] entities;
    public int size;

    /** Tick of the last change of rows or of values from outside the tick. */
    public long structureTick;

    Slab(Archetype archetype, int capacity) {
        Field[] fields = archetype.fields;
        this.archetype = archetype;
        this.published = new Object[fields.length];
        this.spare = new Object[fields.length];
        this.versions = new long[fields.length];
        this.entities = new long[capacity];
        for (int slot = 0; slot < fields.length; slot++) {
            published[slot] = fields[slot].newColumn(capacity);
        }
        this.next = published.clone();
    }

    /** Between ticks only. */
    @SuppressWarnings("SuspiciousSystemArraycopy") // both are arrays of the column's kind
    void grow(int capacity) {
        Field[] fields = archetype.fields;
        for (int slot = 0; slot < fields.length; slot++) {
            Object larger = fields[slot].newColumn(capacity);
            System.arraycopy(published[slot], 0, larger, 0, size);
            published[slot] = larger;
            next[slot] = larger;
            spare[slot] = null;
        }
        entities = Arrays.copyOf(entities, capacity);
    }

    /** Makes the column writable. By the column's first writer of this tick, once. */
    @SuppressWarnings("SuspiciousSystemArraycopy") // both are arrays of the column's kind
    public void open(int slot, boolean prefill, boolean poison) {
        Object target = spare[slot];
        if (target == null) {
            target = archetype.fields[slot].newColumn(entities.length);
            spare[slot] = target;
        }
        if (prefill) {
            System.arraycopy(published[slot], 0, target, 0, size);
        } else if (poison) {
            poison(target);
        }
        next[slot] = target;
    }

    /** Checked mode: a row that a writesAll system forgets shows up as NaN. */
    private static void poison(Object column) {
        if (column instanceof double[] doubles) {
            Arrays.fill(doubles, Double.NaN);
        } else if (column instanceof float[] floats) {
            Arrays.fill(floats, Float.NaN);
        }
    }

    /** Whether this tick writes the column. */
    @SuppressWarnings("ReferenceEquality") // one array on both sides means that nothing wrote
    public boolean isWritten(int slot) {
        return next[slot] != published[slot];
    }

    /** Publishes the column if it was written. */
    public void commit(int slot, long tick) {
        if (isWritten(slot)) {
            spare[slot] = published[slot];
            published[slot] = next[slot];
            versions[slot] = tick;
        }
    }

    /** Forgets what a failed tick wrote. */
    public void rollBack(int slot) {
        next[slot] = published[slot];
    }

    /** Copies a row over another, of this or another slab of the same archetype. */
    void copyRow(Slab from, int fromRow, int row) {
        Field[] fields = archetype.fields;
        for (int slot = 0; slot < fields.length; slot++) {
            fields[slot].copyRow(from.published[slot], fromRow, published[slot], row);
        }
        entities[row] = from.entities[fromRow];
    }

    /** Rows and published columns; between ticks, when nobody writes. */
    void state(StateVisitor s) {
        s.section("chunk", this);
        size = s.value("size", size);
        structureTick = s.value("structureTick", structureTick);
        s.array("versions", versions, versions.length);
        s.array("entities", entities, size);
        for (int slot = 0; slot < published.length; slot++) {
            s.array(archetype.fields[slot].name(), published[slot], size);
        }
    }

    /** Without rows. */
    void empty() {
        for (int row = 0; row < size; row++) {
            forgetRow(row);
            forgetSpare(row);
        }
        size = 0;
    }

    /** Drops the references of a row that is no longer used. */
    void forgetRow(int row) {
        for (int slot : archetype.objectSlots) {
            archetype.fields[slot].forget(published[slot], row);
        }
    }

    /** Drops what the spare arrays still hold of a row. */
    void forgetSpare(int row) {
        for (int slot : archetype.objectSlots) {
            archetype.fields[slot].forget(spare[slot], row);
        }
    }
}
