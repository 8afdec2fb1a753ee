package dev.cairn.render.ui.nuklear;

import org.lwjgl.system.MemoryUtil;

/**
 * How rows of several widgets share their width, as arrays of floats. Nuklear keeps a pointer to
 * them until the row ends, so they lie outside the heap.
 */
final class UiShares implements AutoCloseable {
    final long slider = of(0.36f, 0.43f, 0.18f);
    final long choice = of(0.36f, 0.61f);
    final long value = of(0.58f, 0.40f);
    final long button = of(0.52f, 0.45f);
    final long picture = of(0.21f, 0.76f);

    private static long of(float... values) {
        long address = MemoryUtil.nmemAllocChecked(4L * values.length);
        for (int i = 0; i < values.length; i++) {
            MemoryUtil.memPutFloat(address + 4L * i, values[i]);
        }
        return address;
    }

    @Override
    public void close() {
        for (long address : new long[] {slider, choice, value, button, picture}) {
            MemoryUtil.nmemFree(address);
        }
    }
}
