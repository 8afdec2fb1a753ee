package dev.cairn.render.ui.nuklear;

import org.lwjgl.system.MemoryUtil;

import java.nio.charset.StandardCharsets;

/**
 * The text of a field, in UTF-8 as Nuklear edits it; made anew only when it changes. Of a text that
 * is longer than there is room only the beginning is edited, and the rest stays behind it.
 */
final class FieldText {
    private String content = "";
    private byte[] bytes = {};

    /** How many of the bytes are edited: whole letters. */
    private int head;

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
            head = Math.min(bytes.length, most);
            while (head < bytes.length && head > 0 && (bytes[head] & 0xC0) == 0x80) {
                head--; // the second and later bytes of a letter are 10xxxxxx
            }
        }
        content = text;
        for (int i = 0; i < head; i++) {
            MemoryUtil.memPutByte(to + i, bytes[i]);
        }
        return head;
    }

    /**
     * What the user made of it.
     *
     * @param from address of the edited text
     * @param length its bytes
     * @return the same object where nothing changed
     */
    String read(long from, int length) {
        boolean same = length == head;
        for (int i = 0; i < length && same; i++) {
            same = MemoryUtil.memGetByte(from + i) == bytes[i];
        }
        if (same) {
            return content;
        }
        byte[] now = new byte[length + bytes.length - head];
        for (int i = 0; i < length; i++) {
            now[i] = MemoryUtil.memGetByte(from + i);
        }
        System.arraycopy(bytes, head, now, length, bytes.length - head);
        return new String(now, StandardCharsets.UTF_8);
    }
}
