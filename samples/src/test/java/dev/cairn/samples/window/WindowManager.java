package dev.cairn.samples.window;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * What a window manager tells a window on X11: that it is minimised, that it is there again, that
 * its close button was pressed. Three requests of the X protocol (X.Org, "X Window System
 * Protocol", appendix B; states and messages by the ICCCM, 4.1.3.1 and 4.2.8.1).
 */
public final class WindowManager implements AutoCloseable {
    private static final int CREATE_WINDOW = 1;
    private static final int SET_OWNER = 22;
    private static final int SELECTION_REQUEST = 30;
    private static final int SELECTION_NOTIFY = 31;
    private static final int SEND_EVENT = 25;
    private static final int CHANGE_PROPERTY = 18;
    private static final int INTERN_ATOM = 16;
    private static final int CLIENT_MESSAGE = 33;
    private static final int NORMAL = 1;
    private static final int ICONIC = 3;

    private final SocketChannel server;
    private final int window;
    private final int own;
    private final int root;

    WindowManager(String display, int window) throws IOException {
        this.window = window;
        server = SocketChannel.open(StandardProtocolFamily.UNIX);
        server.connect(UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + display.substring(1)));
        send(bytes(12).put((byte) 'l').put((byte) 0).putShort((short) 11).position(12));
        ByteBuffer head = read(8);
        if (head.get(0) != 1) {
            throw new IOException("the X server refuses: " + head.get(0));
        }
        ByteBuffer setup = read(4 * (head.getShort(6) & 0xFFFF));
        own = setup.getInt(4) | 1; // the first of the names that are ours to give
        int vendor = (setup.getShort(16) + 3) / 4 * 4;
        root = setup.getInt(32 + vendor + 8 * setup.get(21));
    }

    public void minimise() throws IOException {
        state(ICONIC);
    }

    public void restore() throws IOException {
        state(NORMAL);
    }

    private void state(int value) throws IOException {
        int property = atom("WM_STATE");
        send(
                bytes(32)
                        .putInt(CHANGE_PROPERTY | 8 << 16)
                        .putInt(window)
                        .putInt(property)
                        .putInt(property) // its type has the same name
                        .putInt(32)
                        .putInt(2)
                        .putInt(value)
                        .putInt(0));
        atom("WM_STATE"); // an answer: the server has done it
    }

    /** The close button. */
    public void askToClose() throws IOException {
        int protocols = atom("WM_PROTOCOLS");
        int close = atom("WM_DELETE_WINDOW");
        send(
                bytes(44)
                        .putInt(SEND_EVENT | 11 << 16)
                        .putInt(window)
                        .putInt(0)
                        .putInt(CLIENT_MESSAGE | 32 << 8)
                        .putInt(window)
                        .putInt(protocols)
                        .putInt(close)
                        .position(44));
        atom("WM_PROTOCOLS");
    }

    /**
     * What a file manager does where a file is let go over the window ("Drag-and-Drop Protocol for
     * the X Window System", version 5): it owns the selection, tells of the way and of the drop,
     * and hands out the files' names when it is asked.
     */
    public void drop(List<String> uris, int x, int y) throws IOException {
        int selection = atom("XdndSelection");
        int list = atom("text/uri-list");
        int enter = atom("XdndEnter");
        int position = atom("XdndPosition");
        int drop = atom("XdndDrop");
        int finished = atom("XdndFinished");
        int copy = atom("XdndActionCopy");
        send(
                bytes(32)
                        .putInt(CREATE_WINDOW | 8 << 16)
                        .putInt(own)
                        .putInt(root)
                        .putInt(0)
                        .putInt(1 | 1 << 16)
                        .putInt(1 << 16)
                        .putInt(0)
                        .putInt(0));
        send(bytes(16).putInt(SET_OWNER | 4 << 16).putInt(own).putInt(selection).putInt(0));
        message(enter, own, 5 << 24, list, 0, 0);
        message(position, own, 0, x << 16 | y, 0, copy);
        message(drop, own, 0, 0, 0, 0);
        ByteBuffer asked = read(32);
        while (asked.get(0) != SELECTION_REQUEST) {
            asked = read(32);
        }
        int requestor = asked.getInt(12);
        int target = asked.getInt(20);
        int property = asked.getInt(24);
        StringBuilder names = new StringBuilder();
        uris.forEach(uri -> names.append(uri).append("\r\n"));
        byte[] letters = names.toString().getBytes(StandardCharsets.US_ASCII);
        int words = 6 + (letters.length + 3) / 4;
        send(
                bytes(4 * words)
                        .putInt(CHANGE_PROPERTY | words << 16)
                        .putInt(requestor)
                        .putInt(property)
                        .putInt(target)
                        .putInt(8)
                        .putInt(letters.length)
                        .put(letters)
                        .position(4 * words));
        send(
                bytes(44)
                        .putInt(SEND_EVENT | 11 << 16)
                        .putInt(requestor)
                        .putInt(0)
                        .putInt(SELECTION_NOTIFY)
                        .putInt(0)
                        .putInt(requestor)
                        .putInt(selection)
                        .putInt(target)
                        .putInt(property)
                        .position(44));
        ByteBuffer told = read(32);
        while ((told.get(0) & 0x7F) != CLIENT_MESSAGE || told.getInt(8) != finished) {
            told = read(32);
        }
    }

    private void message(int type, int... data) throws IOException {
        ByteBuffer event =
                bytes(44)
                        .putInt(SEND_EVENT | 11 << 16)
                        .putInt(window)
                        .putInt(0)
                        .putInt(CLIENT_MESSAGE | 32 << 8)
                        .putInt(window)
                        .putInt(type);
        for (int each : data) {
            event.putInt(each);
        }
        send(event);
    }

    private int atom(String name) throws IOException {
        byte[] letters = name.getBytes(StandardCharsets.US_ASCII);
        int words = 2 + (letters.length + 3) / 4;
        send(
                bytes(4 * words)
                        .putInt(INTERN_ATOM | words << 16)
                        .putInt(letters.length)
                        .put(letters)
                        .position(4 * words));
        while (true) {
            ByteBuffer answer = read(32);
            if (answer.get(0) == 0) {
                throw new IOException("the X server says: error " + answer.get(1));
            }
            if (answer.get(0) == 1) {
                return answer.getInt(8);
            }
        }
    }

    private static ByteBuffer bytes(int count) {
        return ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
    }

    private void send(ByteBuffer request) throws IOException {
        request.flip();
        while (request.hasRemaining()) {
            server.write(request);
        }
    }

    private ByteBuffer read(int count) throws IOException {
        ByteBuffer answer = bytes(count);
        while (answer.hasRemaining()) {
            if (server.read(answer) < 0) {
                throw new IOException("the X server has gone");
            }
        }
        return answer.flip();
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
