package dev.cairn.samples.editor.files;

import static org.lwjgl.util.nfd.NativeFileDialog.NFD_ERROR;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_FreePath;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_GetError;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_Init;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_OKAY;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_OpenDialog;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_Quit;
import static org.lwjgl.util.nfd.NativeFileDialog.NFD_SaveDialog;

import org.jspecify.annotations.Nullable;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.Configuration;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.Platform;
import org.lwjgl.util.nfd.NFDFilterItem;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The desktop's dialog by nativefiledialog-extended. On Linux it is the desktop portal's, which
 * draws it in a process of its own: GTK inside ours would install its own handler of X errors,
 * which ends the process.
 */
final class NativeDialog implements DesktopDialog {
    /** Name of the property: {@code desktop}, or {@code window} for the window's own list. */
    static final String PROPERTY = "cairn.dialog";

    private static final long QUICK_NANOS = 200_000_000;

    /**
     * The dialog, as far as can be told without a call into it.
     *
     * @return null if it is not wanted, or Linux has no session bus, over which portals talk
     */
    static @Nullable DesktopDialog find() {
        if ("window".equals(System.getProperty(PROPERTY))) {
            return null;
        }
        return Platform.get() == Platform.LINUX && !SessionBus.isNamed()
                ? null
                : new NativeDialog();
    }

    @Override
    public boolean needsWindowThread() {
        return Platform.get() == Platform.MACOSX;
    }

    @Override
    public @Nullable Path ask(FileQuestion question) throws IOException {
        try {
            if (Platform.get() == Platform.LINUX) {
                SessionBus.open();
                Configuration.NFD_LINUX_PORTAL.set(true);
            }
            if (NFD_Init() != NFD_OKAY) {
                throw new IOException(String.valueOf(NFD_GetError()));
            }
        } catch (LinkageError missing) {
            throw new IOException("a library is missing: " + missing.getMessage(), missing);
        }
        try (MemoryStack stack = MemoryStack.stackPush()) {
            String kind = question.ending().substring(1);
            NFDFilterItem.Buffer filters = NFDFilterItem.malloc(1, stack);
            filters.get(0).name(stack.UTF8(kind)).spec(stack.UTF8(kind));
            PointerBuffer taken = stack.callocPointer(1);
            String folder =
                    Files.isDirectory(question.folder()) && isText(question.folder().toString())
                            ? question.folder().toString()
                            : null;
            String name = isText(question.name()) ? question.name() : null;
            long begun = System.nanoTime();
            int answer =
                    question.saves()
                            ? NFD_SaveDialog(taken, filters, folder, name)
                            : NFD_OpenDialog(taken, filters, folder);
            if (answer == NFD_ERROR && !wasClosed(begun)) {
                throw new IOException(String.valueOf(NFD_GetError()));
            }
            if (answer != NFD_OKAY) {
                return null;
            }
            Path path = Path.of(MemoryUtil.memUTF8(taken.get(0)));
            NFD_FreePath(taken.get(0));
            return path;
        } finally {
            NFD_Quit();
        }
    }

    /**
     * Whether an error is no more than Escape or the close button of the dialog: portals answer
     * that by "2, ended in some other way". No user is as fast as a portal that cannot.
     */
    private static boolean wasClosed(long begunNanos) {
        return System.nanoTime() - begunNanos > QUICK_NANOS
                && String.valueOf(NFD_GetError()).contains("response code 2");
    }

    /** D-Bus ends the process for a text that is no UTF-8, such as half a pair of surrogates. */
    private static boolean isText(String text) {
        return !text.isEmpty()
                && text.indexOf('\0') < 0
                && StandardCharsets.UTF_8.newEncoder().canEncode(text);
    }
}
