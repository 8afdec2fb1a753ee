package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.storage.Archetype;
import dev.cairn.core.ecs.storage.ComponentSet;
import dev.cairn.core.ecs.storage.Slab;
import dev.cairn.core.ecs.storage.Store;

import java.util.Arrays;

/**
 * The chunks of one query or system, kept up to date. The list is rebuilt only when the number of
 * used slabs changes, and views are made once per slab, so a steady tick makes nothing.
 */
final class ChunkList {
    /** All rights between ticks, when writes go to the published column. */
    private static final byte DIRECT =
            (byte) (Access.READ | Access.WRITE | Access.NEXT | Chunk.DIRECT);

    private final Store store;
    private final Access access;
    private final boolean direct;
    private final boolean checked;
    private final ComponentSet required;
    private final ComponentSet excluded;

    private int scanned;
    private int dropped;
    private Archetype[] archetypes = new Archetype[0];
    private byte[][] rights = new byte[0][];
    private int[][] writable = new int[0][];
    private Chunk[][] views = new Chunk[0][];
    private Chunk[] flat = new Chunk[0];
    private int count;
    private long seen;

    ChunkList(Store store, Access access, boolean direct, boolean checked) {
        this.store = store;
        this.access = access;
        this.direct = direct;
        this.checked = checked;
        this.required = ComponentSet.of(access.required());
        this.excluded = ComponentSet.of(access.excluded());
    }

    /** Brings the list up to date. Between stages, simulation thread. */
    int refresh() {
        if (seen != store.structureVersion) {
            rebuild();
            seen = store.structureVersion;
        }
        return count;
    }

    int count() {
        return count;
    }

    Chunk get(int index) {
        return flat[index];
    }

    private void rebuild() {
        if (dropped != store.dropped) {
            dropped = store.dropped;
            scanned = 0;
            archetypes = new Archetype[0];
            rights = new byte[0][];
            writable = new int[0][];
            views = new Chunk[0][];
        }
        for (; scanned < store.archetypes.size(); scanned++) {
            Archetype archetype = store.archetypes.get(scanned);
            if (archetype.set.containsAll(required) && !archetype.set.intersects(excluded)) {
                match(archetype);
            }
        }
        int total = 0;
        for (Archetype archetype : archetypes) {
            total += archetype.chunkCount();
        }
        if (total > flat.length) {
            flat = Arrays.copyOf(flat, Math.max(total, flat.length * 2));
        }
        count = 0;
        for (int i = 0; i < archetypes.length; i++) {
            int chunks = archetypes[i].chunkCount();
            if (views[i].length < chunks) {
                enlarge(i);
            }
            System.arraycopy(views[i], 0, flat, count, chunks);
            count += chunks;
        }
    }

    private void match(Archetype archetype) {
        int index = archetypes.length;
        archetypes = Arrays.copyOf(archetypes, index + 1);
        rights = Arrays.copyOf(rights, index + 1);
        writable = Arrays.copyOf(writable, index + 1);
        views = Arrays.copyOf(views, index + 1);
        byte[] granted = rights(archetype);
        int[] slots = new int[granted.length];
        int written = 0;
        for (int slot = 0; slot < granted.length; slot++) {
            if (!direct && (granted[slot] & Access.WRITE) != 0) {
                slots[written++] = slot;
            }
        }
        archetypes[index] = archetype;
        rights[index] = granted;
        writable[index] = Arrays.copyOf(slots, written);
        views[index] = new Chunk[0];
    }

    /** By column. */
    private byte[] rights(Archetype archetype) {
        byte[] granted = new byte[archetype.fields.length];
        for (int slot = 0; slot < granted.length; slot++) {
            granted[slot] = direct ? DIRECT : access.rights(archetype.fields[slot].component());
        }
        return granted;
    }

    /** Slabs are only ever added, so views stay valid. */
    private void enlarge(int i) {
        Slab[] slabs = archetypes[i].slabs;
        int old = views[i].length;
        views[i] = Arrays.copyOf(views[i], slabs.length);
        for (int chunk = old; chunk < slabs.length; chunk++) {
            views[i][chunk] =
                    new Chunk(
                            slabs[chunk], access.system(), rights[i], writable[i], store, checked);
        }
    }
}
