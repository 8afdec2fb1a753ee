package dev.cairn.core.ecs.storage;

/**
 * The bits of what {@link dev.cairn.core.ecs.Commands#spawn} returns: sign bit set (so it is no
 * entity), then 12 bits of system, 20 of chunk, 7 of tick and 24 of ordinal.
 */
public final class Handle {
    public static final int MAX_SYSTEMS = (1 << 12) - 1;

    /** In place of a system's number: the observers of the world. */
    public static final int OBSERVERS = MAX_SYSTEMS;

    private static final int MAX_CHUNKS = 1 << 20;
    private static final int MAX_SPAWNS = 1 << 24;

    private Handle() {}

    public static long of(int system, int chunk, long tick, int ordinal) {
        if (ordinal >= MAX_SPAWNS || chunk >= MAX_CHUNKS) {
            throw new IllegalStateException(
                    "spawn "
                            + ordinal
                            + " of chunk "
                            + chunk
                            + " is beyond the bounds of a tick, which are "
                            + MAX_SPAWNS
                            + " spawns in each of "
                            + MAX_CHUNKS
                            + " chunks; spread them over several ticks");
        }
        return Long.MIN_VALUE
                | (long) system << 51
                | (long) chunk << 31
                | (tick & 127) << 24
                | ordinal;
    }

    public static boolean isHandle(long id) {
        return id < 0;
    }

    public static int system(long handle) {
        return (int) (handle >>> 51) & OBSERVERS;
    }

    public static int chunk(long handle) {
        return (int) (handle >>> 31) & MAX_CHUNKS - 1;
    }

    public static boolean isOf(long handle, long tick) {
        return (handle >>> 24 & 127) == (tick & 127);
    }

    public static int ordinal(long handle) {
        return (int) handle & MAX_SPAWNS - 1;
    }
}
