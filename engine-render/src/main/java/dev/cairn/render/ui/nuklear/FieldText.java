package dev.cairn.render.ui.nuklear;

import org.lwjgl.system.MemoryUtil;

import java.nio.charset.StandardCharsets;

/** The text of a field, in UTF-8 as Nuklear edits it; made anew only when it changes. */
final class FieldText {
    private String content = "";
    private byte[] bytes = {};

    /**
     * Writes a text.
     *
     * @param text what the application has
     * @param to address
     * @param most bytes that have room
     * @return how many were written
     */
    int write(String text, long to, int most) {
        if (!text.equals(content)) {
            bytes = text.getBytes(StandardCharsets.UTF_8);
        }
        content = text;
        int length = Math.min(bytes.length, most);
        for (int i = 0; i < length; i++) {
            MemoryUtil.memPutByte(to + i, bytes[i]);
        }
        return length;
    }

    /**
     * What the user made of it.
     *
     * @param from address of the edited text
     * @param length its bytes
     * @param most what {@link #write} had room for
     * @return the same object where nothing changed
     */
    String read(long from, int length, int most) {
        boolean same = length <= bytes.length;
        for (int i = 0; i < length && same; i++) {
            same = MemoryUtil.memGetByte(from + i) == bytes[i];
        }
        // A text that was too long is not edited as long as its beginning stays.
        if (same && (length == bytes.length || length == most)) {
            return content;
        }
        byte[] now = new byte[length];
        for (int i = 0; i < length; i++) {
            now[i] = MemoryUtil.memGetByte(from + i);
        }
        return new String(now, StandardCharsets.UTF_8);
    }
}
