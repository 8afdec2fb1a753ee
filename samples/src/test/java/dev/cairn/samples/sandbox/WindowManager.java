package dev.cairn.samples.sandbox;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;

/**
 * What a window manager tells a window on X11: that it is minimised, that it is there again, that
 * its close button was pressed. Three requests of the X protocol (X.Org, "X Window System
 * Protocol", appendix B; states and messages by the ICCCM, 4.1.3.1 and 4.2.8.1).
 */
final class WindowManager implements AutoCloseable {
    private static final int SEND_EVENT = 25;
    private static final int CHANGE_PROPERTY = 18;
    private static final int INTERN_ATOM = 16;
    private static final int CLIENT_MESSAGE = 33;
    private static final int NORMAL = 1;
    private static final int ICONIC = 3;

    private final SocketChannel server;
    private final int window;

    WindowManager(String display, int window) throws IOException {
        this.window = window;
        server = SocketChannel.open(StandardProtocolFamily.UNIX);
        server.connect(UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + display.substring(1)));
        send(bytes(12).put((byte) 'l').put((byte) 0).putShort((short) 11).position(12));
        ByteBuffer head = read(8);
        if (head.get(0) != 1) {
            throw new IOException("the X server refuses: " + head.get(0));
        }
        read(4 * (head.getShort(6) & 0xFFFF));
    }

    void minimise() throws IOException {
        state(ICONIC);
    }

    void restore() throws IOException {
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
    void askToClose() throws IOException {
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
