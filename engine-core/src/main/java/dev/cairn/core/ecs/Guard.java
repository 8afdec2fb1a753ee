package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.ecs.storage.Hash;
import dev.cairn.core.ecs.storage.Slab;

/**
 * Checked mode: notices a system that writes what it may only read, or that writes NaN. Columns are
 * hashed before and after the system; the systems of a level then run one after the other, so the
 * one that is named did it.
 */
final class Guard {
    private final String system;
    private long[][] published = new long[0][];
    private long[][] next = new long[0][];

    Guard(String system) {
        this.system = system;
    }

    void before(Chunk chunk) {
        published = new long[][] {hashPublished(chunk)};
        next = new long[][] {hashNext(chunk)};
    }

    void after(Chunk chunk) {
        compare(chunk, 0);
    }

    void before(ChunkList chunks) {
        published = new long[chunks.count()][];
        next = new long[chunks.count()][];
        for (int i = 0; i < chunks.count(); i++) {
            published[i] = hashPublished(chunks.get(i));
            next[i] = hashNext(chunks.get(i));
        }
    }

    void after(ChunkList chunks) {
        for (int i = 0; i < chunks.count(); i++) {
            compare(chunks.get(i), i);
        }
    }

    private static long[] hashPublished(Chunk chunk) {
        Slab slab = chunk.slab;
        long[] hashes = new long[slab.published.length];
        for (int slot = 0; slot < hashes.length; slot++) {
            hashes[slot] = Hash.of(slab.published[slot], slab.size);
        }
        return hashes;
    }

    /** Zero for columns that the system may write. */
    private static long[] hashNext(Chunk chunk) {
        Slab slab = chunk.slab;
        long[] hashes = new long[slab.next.length];
        for (int slot = 0; slot < hashes.length; slot++) {
            if ((chunk.rights()[slot] & Access.WRITE) == 0) {
                hashes[slot] = Hash.of(slab.next[slot], slab.size);
            }
        }
        return hashes;
    }

    private void compare(Chunk chunk, int index) {
        Slab slab = chunk.slab;
        long[] nowPublished = hashPublished(chunk);
        long[] nowNext = hashNext(chunk);
        for (int slot = 0; slot < nowPublished.length; slot++) {
            Field field = slab.archetype.fields[slot];
            boolean inPlace = (chunk.rights()[slot] & Access.IN_PLACE) != 0;
            if (!inPlace && nowPublished[slot] != published[index][slot]) {
                throw new AccessException(
                        "system '"
                                + system
                                + "' wrote the published column "
                                + field
                                + ", which everyone reads during a tick; declare out("
                                + field.component()
                                + ") and write the array from chunk.out");
            }
            if (nowNext[slot] != next[index][slot]) {
                throw new AccessException(
                        "system '"
                                + system
                                + "' wrote column "
                                + field
                                + " through next, which is for reading what another system wrote;"
                                + " a column has one writer per tick");
            }
            boolean written = inPlace || slab.isWritten(slot);
            if (written && (chunk.rights()[slot] & Access.WRITE) != 0) {
                scan(slab, slot, field);
            }
        }
    }

    private void scan(Slab slab, int slot, Field field) {
        for (int row = 0; row < slab.size; row++) {
            boolean bad =
                    switch (slab.next[slot]) {
                        case double[] doubles -> Double.isNaN(doubles[row]);
                        case float[] floats -> Float.isNaN(floats[row]);
                        default -> false;
                    };
            if (bad) {
                throw new AccessException(
                        "system '"
                                + system
                                + "' left NaN in column "
                                + field
                                + " of entity "
                                + Entities.toString(slab.entities[row])
                                + "; find where it arises, or, if the system declared writesAll,"
                                + " write every row");
            }
        }
    }
}
