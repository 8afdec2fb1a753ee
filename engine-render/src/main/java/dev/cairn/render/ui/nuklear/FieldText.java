package dev.cairn.render.ui.nuklear;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** The text of a field, in UTF-8 as Nuklear edits it; made anew only when it changes. */
final class FieldText {
    private String content = "";
    private byte[] bytes = {};

    /**
     * Writes a text.
     *
     * @param text what the application has
     * @param to where to, from its beginning
     * @param most bytes that have room
     * @return how many were written
     */
    int write(String text, ByteBuffer to, int most) {
        if (!text.equals(content)) {
            bytes = text.getBytes(StandardCharsets.UTF_8);
        }
        content = text;
        int length = Math.min(bytes.length, most);
        to.clear();
        to.put(0, bytes, 0, length);
        return length;
    }

    /**
     * What the user made of it.
     *
     * @param from the edited text, from its beginning
     * @param length its bytes
     * @return the same object where nothing changed
     */
    String read(ByteBuffer from, int length) {
        boolean same = length <= bytes.length;
        for (int i = 0; i < length && same; i++) {
            same = from.get(i) == bytes[i];
        }
        // A text that was too long is not edited as long as its beginning stays.
        if (same && (length == bytes.length || length == from.capacity() - 8)) {
            return content;
        }
        byte[] now = new byte[length];
        from.get(0, now);
        return new String(now, StandardCharsets.UTF_8);
    }
}
