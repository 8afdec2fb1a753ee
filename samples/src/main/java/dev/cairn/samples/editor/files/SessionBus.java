package dev.cairn.samples.editor.files;

import java.io.IOException;
import java.lang.foreign.AddressLayout;
import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.SymbolLookup;
import java.lang.foreign.ValueLayout;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The session bus of a Linux desktop. Its library ends the process when the bus goes away while a
 * connection is open, edits and all, unless it is told not to: that is done here, on the connection
 * that all users of the library share.
 */
final class SessionBus {
    private static final int SESSION = 0;
    private static boolean open;

    private SessionBus() {}

    /** Whether there is an address; without one the library would start a bus of its own. */
    static boolean isNamed() {
        String runtime = System.getenv("XDG_RUNTIME_DIR");
        return System.getenv("DBUS_SESSION_BUS_ADDRESS") != null
                || (runtime != null && Files.exists(Path.of(runtime, "bus")));
    }

    /**
     * Connects, once.
     *
     * @throws IOException if nobody answers
     */
    // The functions and their types are those of dbus/dbus-bus.h and dbus/dbus-connection.h.
    @SuppressWarnings("restricted")
    static synchronized void open() throws IOException {
        if (open) {
            return;
        }
        AddressLayout address = ValueLayout.ADDRESS;
        MemorySegment connection;
        try {
            SymbolLookup library = SymbolLookup.libraryLookup("libdbus-1.so.3", Arena.global());
            Linker linker = Linker.nativeLinker();
            connection =
                    (MemorySegment)
                            linker.downcallHandle(
                                            library.findOrThrow("dbus_bus_get"),
                                            FunctionDescriptor.of(
                                                    address, ValueLayout.JAVA_INT, address))
                                    .invokeExact(SESSION, MemorySegment.NULL);
            if (connection.address() != 0) {
                linker.downcallHandle(
                                library.findOrThrow("dbus_connection_set_exit_on_disconnect"),
                                FunctionDescriptor.ofVoid(address, ValueLayout.JAVA_INT))
                        .invokeExact(connection, 0);
            }
        } catch (Throwable missing) {
            throw new IOException("libdbus-1.so.3 is missing: " + missing.getMessage(), missing);
        }
        if (connection.address() == 0) {
            throw new IOException("nobody answers at the address of the session bus");
        }
        open = true;
    }
}
