package dev.cairn.render.ui.nuklear;

import org.lwjgl.system.MemoryUtil;

/**
 * One text at a time in UTF-8 outside the heap, for libraries that copy what they are given.
 * LWJGL's own way makes garbage with each text. Window thread.
 */
public final class NativeText implements AutoCloseable {
    private static final int BYTES = 4096;

    private final long address = MemoryUtil.nmemAllocChecked(BYTES);
    private int length;

    /** Room for some thousand letters. */
    public NativeText() {}

    /**
     * Writes a text, cut off after some thousand letters.
     *
     * @param text what
     * @return its address, valid until the next call
     */
    public long of(CharSequence text) {
        int at = 0;
        for (int i = 0; i < text.length() && at < BYTES - 5; i++) {
            char letter = text.charAt(i);
            if (letter < 0x80) {
                at = put(at, letter);
            } else if (letter < 0x800) {
                at = put(put(at, 0xC0 | (letter >> 6)), 0x80 | (letter & 0x3F));
            } else if (Character.isHighSurrogate(letter)
                    && i + 1 < text.length()
                    && Character.isLowSurrogate(text.charAt(i + 1))) {
                int point = Character.toCodePoint(letter, text.charAt(++i));
                at = put(put(at, 0xF0 | (point >> 18)), 0x80 | ((point >> 12) & 0x3F));
                at = put(put(at, 0x80 | ((point >> 6) & 0x3F)), 0x80 | (point & 0x3F));
            } else {
                // Half a pair is no letter.
                int shown = Character.isSurrogate(letter) ? '?' : letter;
                at =
                        shown == '?'
                                ? put(at, shown)
                                : put(
                                        put(
                                                put(at, 0xE0 | (shown >> 12)),
                                                0x80 | ((shown >> 6) & 0x3F)),
                                        0x80 | (shown & 0x3F));
            }
        }
        put(at, 0);
        length = at;
        return address;
    }

    /** Bytes of the last text. */
    int length() {
        return length;
    }

    private int put(int at, int value) {
        MemoryUtil.memPutByte(address + at, (byte) value);
        return at + 1;
    }

    @Override
    public void close() {
        MemoryUtil.nmemFree(address);
    }
}
