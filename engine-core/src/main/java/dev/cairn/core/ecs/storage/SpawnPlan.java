package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.RecordCodec;

import java.util.Arrays;

/** How a tuple of record classes, in the order of a call, becomes a row. */
final class SpawnPlan {
    final Class<?>[] types;
    final Archetype archetype;

    private final RecordCodec[] codecs;
    private final int[] bases;

    SpawnPlan(Class<?>[] types, Component<?>[] components, Archetype archetype) {
        this.types = types;
        this.archetype = archetype;
        this.codecs = new RecordCodec[components.length];
        this.bases = new int[components.length];
        for (int i = 0; i < components.length; i++) {
            codecs[i] = components[i].codec();
            bases[i] = archetype.base(components[i]);
        }
    }

    void write(int part, Record value, Slab slab, int local) {
        codecs[part].write(value, slab.published, bases[part], local);
    }

    boolean matches(Record[] records) {
        if (records.length != types.length) {
            return false;
        }
        for (int i = 0; i < types.length; i++) {
            if (records[i].getClass() != types[i]) {
                return false;
            }
        }
        return true;
    }

    @Override
    public String toString() {
        return Arrays.toString(types);
    }
}
