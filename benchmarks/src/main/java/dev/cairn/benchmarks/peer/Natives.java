package dev.cairn.benchmarks.peer;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Locale;

/**
 * Loads an engine's native library from its artifact on the class path, or from the file that the
 * system property {@code cairn.natives.<engine>} names. The library is bound to the loader of this
 * class, which has to be that of the engine's classes.
 */
final class Natives {
    private Natives() {}

    /** Loads the first of some resources that exists. */
    @SuppressWarnings(
            "restricted") // the point of this class; the JVMs are started with the permission
    static void load(Engine engine, List<String> resources) {
        String named = System.getProperty("cairn.natives." + engine.id());
        try {
            if (named != null) {
                System.load(Path.of(named).toAbsolutePath().toString());
                return;
            }
            for (String resource : resources) {
                try (InputStream in = Natives.class.getResourceAsStream("/" + resource)) {
                    if (in != null) {
                        System.load(extract(in, resource).toString());
                        return;
                    }
                }
            }
        } catch (IOException | UnsatisfiedLinkError failure) {
            throw new MissingEngineException(
                    engine.title() + ": its native library does not load: " + failure.getMessage(),
                    failure);
        }
        throw new MissingEngineException(
                "%s: no native library for %s %s on the class path; looked for %s"
                        .formatted(
                                engine.title(),
                                System.getProperty("os.name"),
                                System.getProperty("os.arch"),
                                String.join(", ", resources)));
    }

    private static Path extract(InputStream in, String resource) throws IOException {
        String name = resource.substring(resource.lastIndexOf('/') + 1);
        Path folder = Files.createTempDirectory("cairn-natives");
        Path file = folder.resolve(name);
        Files.copy(in, file, StandardCopyOption.REPLACE_EXISTING);
        folder.toFile().deleteOnExit();
        file.toFile().deleteOnExit();
        return file;
    }

    /** Returns {@code linux}, {@code windows} or {@code osx}. */
    static String system() {
        String name = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        return name.startsWith("windows") ? "windows" : name.startsWith("mac") ? "osx" : "linux";
    }
}
