package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Saves. */
final class StateWriter implements StateVisitor {
    static final ValueLayout.OfDouble DOUBLES =
            ValueLayout.JAVA_DOUBLE_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    static final ValueLayout.OfLong LONGS =
            ValueLayout.JAVA_LONG_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    static final ValueLayout.OfInt INTS =
            ValueLayout.JAVA_INT_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    static final ValueLayout.OfFloat FLOATS =
            ValueLayout.JAVA_FLOAT_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);

    static final VarHandle INT =
            MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    static final VarHandle LONG =
            MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    private final WorldState state;

    StateWriter(WorldState state) {
        this.state = state;
    }

    @Override
    public boolean isRestoring() {
        return false;
    }

    @Override
    public void section(String name, Object owner) {
        state.add(name, WorldState.SECTION, state.size, 0);
    }

    @Override
    public void rows(int count) {
        int last = state.entries - 1;
        if (last < 0 || state.kinds[last] != WorldState.SECTION) {
            throw new IllegalStateException(
                    "rows are told of directly behind section(..), before any field");
        }
        state.counts[last] = count;
    }

    @Override
    public int value(String name, int now) {
        int at = room(name, WorldState.INT, 1);
        INT.set(state.bytes, at, now);
        return now;
    }

    @Override
    public long value(String name, long now) {
        int at = room(name, WorldState.LONG, 1);
        LONG.set(state.bytes, at, now);
        return now;
    }

    @Override
    public double value(String name, double now) {
        int at = room(name, WorldState.DOUBLE, 1);
        LONG.set(state.bytes, at, Double.doubleToRawLongBits(now));
        return now;
    }

    @Override
    public boolean value(String name, boolean now) {
        int at = room(name, WorldState.BOOLEAN, 1);
        state.bytes[at] = (byte) (now ? 1 : 0);
        return now;
    }

    @Override
    public <T extends @Nullable Object> T reference(String name, T now) {
        state.ensureObjects(state.objectCount + 1);
        state.add(name, WorldState.REFERENCE, state.objectCount, 1);
        state.objects[state.objectCount++] = now;
        return now;
    }

    @Override
    public <A> A array(String name, A now, int begin, int count, int room, boolean clears) {
        int from = count == 0 ? 0 : begin; // an empty array may be shorter than where rows begin
        if (now instanceof double[] a) {
            int at = room(name, WorldState.DOUBLES, count);
            MemorySegment.copy(a, from, state.memory, DOUBLES, at, count);
        } else if (now instanceof int[] a) {
            int at = room(name, WorldState.INTS, count);
            MemorySegment.copy(a, from, state.memory, INTS, at, count);
        } else if (now instanceof long[] a) {
            int at = room(name, WorldState.LONGS, count);
            MemorySegment.copy(a, from, state.memory, LONGS, at, count);
        } else if (now instanceof byte[] a) {
            int at = room(name, WorldState.BYTES, count);
            System.arraycopy(a, from, state.bytes, at, count);
        } else if (now instanceof boolean[] a) {
            int at = room(name, WorldState.BOOLEANS, count);
            byte[] to = state.bytes;
            for (int i = 0; i < count; i++) {
                to[at + i] = (byte) (a[from + i] ? 1 : 0);
            }
        } else if (now instanceof float[] a) {
            int at = room(name, WorldState.FLOATS, count);
            MemorySegment.copy(a, from, state.memory, FLOATS, at, count);
        } else if (now instanceof Object[] a) {
            state.ensureObjects(state.objectCount + count);
            state.add(name, WorldState.REFERENCES, state.objectCount, count);
            System.arraycopy(a, from, state.objects, state.objectCount, count);
            state.objectCount += count;
        } else {
            throw new IllegalArgumentException(
                    name
                            + " is a "
                            + now.getClass().getSimpleName()
                            + ", which no state"
                            + " holds; use double, float, long, int, byte or boolean");
        }
        return now;
    }

    /** A new entry of numbers; the bytes up to the next multiple of eight are 0. */
    private int room(String name, byte kind, int count) {
        WorldState s = state;
        int at = s.size;
        long length = (long) WorldState.WIDTH[kind] * count;
        long end = at + (length + 7 & -8L);
        s.ensureBytes(end);
        for (long i = at + length; i < end; i++) {
            s.bytes[(int) i] = 0;
        }
        s.add(name, kind, at, count);
        s.size = (int) end;
        return at;
    }
}
