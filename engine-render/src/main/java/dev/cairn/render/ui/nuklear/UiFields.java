package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkPluginCopy;
import org.lwjgl.nuklear.NkPluginPaste;
import org.lwjgl.system.MemoryUtil;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Fields of text: what is in them, whether one is edited, and the clipboard. Window thread. */
final class UiFields implements AutoCloseable {
    /** Bytes of a text that are edited, and as many that may be typed or pasted in one frame. */
    private static final int MOST_BYTES = 1024;

    private static final int ROOM = 2 * MOST_BYTES;

    private final NkContext context;
    private final NuklearInput input;
    private final long edited = MemoryUtil.nmemAllocChecked(ROOM + 1);
    private final long length = MemoryUtil.nmemAllocChecked(4);
    private final NativeText pasted = new NativeText();
    private final Map<String, FieldText> fields = new HashMap<>();
    private final NkPluginPaste paste = NkPluginPaste.create((handle, edit) -> paste(edit));
    private final NkPluginCopy copy =
            NkPluginCopy.create((handle, text, letters) -> copy(text, letters));
    private Supplier<String> clipboard = () -> "";
    private Consumer<String> toClipboard = text -> {};
    private boolean editing;
    private boolean wasEditing;
    private boolean endsEditing;

    UiFields(NkContext context, NuklearInput input) {
        this.context = context;
        this.input = input;
    }

    void clipboard(Supplier<String> from, Consumer<String> to) {
        clipboard = from;
        toClipboard = to;
        context.clip().paste(paste).copy(copy);
    }

    /** One line, and no more than has room; control characters are no text. */
    private void paste(long edit) {
        String text = clipboard.get();
        String line = text.substring(0, Math.min(text.length(), MOST_BYTES / 3));
        long address = pasted.of(line.strip().replaceAll("\\p{Cntrl}", " "));
        // As if typed: nk_textedit_paste takes bytes for letters.
        nnk_textedit_text(edit, address, pasted.length());
    }

    /** Nuklear tells how many letters, not how many bytes. */
    private void copy(long text, int letters) {
        long end = text;
        for (int i = 0; i < letters; i++) {
            end++;
            while ((MemoryUtil.memGetByte(end) & 0xC0) == 0x80) {
                end++;
            }
        }
        toClipboard.accept(MemoryUtil.memUTF8(text, (int) (end - text)));
    }

    void nextFrame() {
        editing = false;
    }

    void frameDone() {
        wasEditing = editing;
        // What was typed before the key that ends it is text still.
        endsEditing &= input.isWaiting();
    }

    /** Whether keys belong to a field; not those after the one that ends it. */
    boolean isEditing() {
        return wasEditing && !endsEditing;
    }

    void endEditing() {
        endsEditing = true;
    }

    String edit(String label, String content) {
        FieldText field = fields.computeIfAbsent(label, key -> new FieldText());
        MemoryUtil.memPutInt(length, field.write(content, edited, MOST_BYTES));
        MemoryUtil.memPutByte(edited + MemoryUtil.memGetInt(length), (byte) 0);
        int state =
                nnk_edit_string(
                        context.address(), NK_EDIT_FIELD, edited, length, ROOM, MemoryUtil.NULL);
        if (endsEditing && !input.isWaiting() && (state & NK_EDIT_ACTIVE) != 0) {
            nk_edit_unfocus(context);
            endsEditing = false;
        } else {
            editing |= (state & NK_EDIT_ACTIVE) != 0;
        }
        return field.read(edited, MemoryUtil.memGetInt(length));
    }

    @Override
    public void close() {
        MemoryUtil.nmemFree(edited);
        MemoryUtil.nmemFree(length);
        pasted.close();
        paste.free();
        copy.free();
    }
}
