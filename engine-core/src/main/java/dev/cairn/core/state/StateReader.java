package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.foreign.MemorySegment;
import java.lang.reflect.Array;
import java.util.Arrays;

/** Restores. */
final class StateReader implements StateVisitor {
    private final WorldState state;
    private int entry;

    StateReader(WorldState state) {
        this.state = state;
    }

    /** From the first entry on. */
    void begin() {
        entry = 0;
    }

    @Override
    public boolean isRestoring() {
        return true;
    }

    @Override
    public void section(String name, Object owner) {
        next(name, WorldState.SECTION);
    }

    @Override
    public int value(String name, int now) {
        return (int) StateWriter.INT.get(state.bytes, next(name, WorldState.INT));
    }

    /** The arrays up to the next object; without any, each row has at least an id of its own. */
    @Override
    public int count(String name, int now) {
        int value = value(name, now);
        WorldState s = state;
        int most = -1;
        for (int e = entry; e < s.entries && s.kinds[e] != WorldState.SECTION; e++) {
            if (s.kinds[e] >= WorldState.INTS) {
                most = Math.max(most, s.counts[e]);
            }
        }
        if (value < 0 || value > (most < 0 ? s.size / Long.BYTES : most)) {
            throw new StateException(
                    s.path(entry - 1)
                            + " is "
                            + value
                            + ", and there are no arrays of so many elements; the state is damaged,"
                            + " or of another version");
        }
        return value;
    }

    @Override
    public long value(String name, long now) {
        return (long) StateWriter.LONG.get(state.bytes, next(name, WorldState.LONG));
    }

    @Override
    public double value(String name, double now) {
        return Double.longBitsToDouble(
                (long) StateWriter.LONG.get(state.bytes, next(name, WorldState.DOUBLE)));
    }

    @Override
    public boolean value(String name, boolean now) {
        return state.bytes[next(name, WorldState.BOOLEAN)] != 0;
    }

    @Override
    @SuppressWarnings({"unchecked", "NullAway"}) // what was saved here was of this type
    public <T extends @Nullable Object> T reference(String name, T now) {
        return (T) state.objects[next(name, WorldState.REFERENCE)];
    }

    @Override
    @SuppressWarnings("unchecked") // an array of the same type
    public <A> A array(String name, A now, int from, int count, int room, boolean clears) {
        if (entry < state.entries && state.counts[entry] != count) {
            next(name, state.kinds[entry], count); // refused before room is made
        }
        A to = now;
        int length = Math.max(room, from + count);
        if (Array.getLength(now) < length) {
            to = (A) Array.newInstance(now.getClass().getComponentType(), length);
        }
        int end = from + count;
        if (to instanceof double[] a) {
            int at = next(name, WorldState.DOUBLES, count);
            MemorySegment.copy(state.memory, StateWriter.DOUBLES, at, a, from, count);
            if (clears) {
                Arrays.fill(a, end, a.length, 0);
            }
        } else if (to instanceof int[] a) {
            int at = next(name, WorldState.INTS, count);
            MemorySegment.copy(state.memory, StateWriter.INTS, at, a, from, count);
            if (clears) {
                Arrays.fill(a, end, a.length, 0);
            }
        } else if (to instanceof long[] a) {
            int at = next(name, WorldState.LONGS, count);
            MemorySegment.copy(state.memory, StateWriter.LONGS, at, a, from, count);
            if (clears) {
                Arrays.fill(a, end, a.length, 0);
            }
        } else if (to instanceof byte[] a) {
            int at = next(name, WorldState.BYTES, count);
            System.arraycopy(state.bytes, at, a, from, count);
            if (clears) {
                Arrays.fill(a, end, a.length, (byte) 0);
            }
        } else if (to instanceof boolean[] a) {
            int at = next(name, WorldState.BOOLEANS, count);
            byte[] saved = state.bytes;
            for (int i = 0; i < count; i++) {
                a[from + i] = saved[at + i] != 0;
            }
            if (clears) {
                Arrays.fill(a, end, a.length, false);
            }
        } else if (to instanceof float[] a) {
            int at = next(name, WorldState.FLOATS, count);
            MemorySegment.copy(state.memory, StateWriter.FLOATS, at, a, from, count);
            if (clears) {
                Arrays.fill(a, end, a.length, 0);
            }
        } else if (to instanceof Object[] a) {
            objects(name, a, from, count);
        } else {
            throw new IllegalArgumentException(name + " is no array");
        }
        return to;
    }

    private void objects(String name, @Nullable Object[] to, int from, int count) {
        int at = next(name, WorldState.REFERENCES, count);
        try {
            System.arraycopy(state.objects, at, to, from, count);
        } catch (ArrayStoreException other) {
            throw new StateException(
                    state.path(entry - 1)
                            + " holds an object that is no "
                            + to.getClass().getComponentType().getName()
                            + "; the state is not one of this world",
                    other);
        }
        Arrays.fill(to, from + count, to.length, null);
    }

    private int next(String name, byte kind, int count) {
        int at = next(name, kind);
        if (state.counts[entry - 1] != count) {
            throw new StateException(
                    state.path(entry - 1)
                            + " has "
                            + state.counts[entry - 1]
                            + " elements where "
                            + count
                            + " are expected; the state is damaged, or of another version");
        }
        return at;
    }

    private int next(String name, byte kind) {
        WorldState s = state;
        if (entry == s.entries) {
            throw new StateException(
                    "the state ends where "
                            + name
                            + " is expected; it is of another kind of world, or of another"
                            + " version");
        }
        if (!name.equals(s.names[entry]) || kind != s.kinds[entry]) {
            throw new StateException(
                    "the state has "
                            + s.path(entry)
                            + " ("
                            + WorldState.KIND_NAMES[s.kinds[entry]]
                            + ") where "
                            + name
                            + " ("
                            + WorldState.KIND_NAMES[kind]
                            + ") is expected; it is of another kind of world, or of another"
                            + " version");
        }
        return s.at[entry++];
    }

    /** All must have been asked for. */
    void end() {
        if (entry != state.entries) {
            throw new StateException(
                    "the state goes on with "
                            + state.path(entry)
                            + " where nothing is expected; it is of another kind of world, or of"
                            + " another version");
        }
    }
}
