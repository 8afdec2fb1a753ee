package dev.cairn.render.natives;

import org.jspecify.annotations.Nullable;
import org.lwjgl.system.Platform;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Which of LWJGL's native libraries are missing, found out before the first of them is asked for:
 * LWJGL's own classes fail for good at the first try, and then say nothing but their names.
 * Stateless; any thread.
 */
public final class NativeLibraries {
    /** An artifact, and where its library is in it. */
    private record Library(String artifact, String folder, String name) {}

    private static final List<Library> NEEDED =
            List.of(
                    new Library("lwjgl", "", "lwjgl"),
                    new Library("lwjgl-glfw", "glfw/", "glfw"),
                    new Library("lwjgl-opengl", "opengl/", "lwjgl_opengl"),
                    new Library("lwjgl-stb", "stb/", "lwjgl_stb"));
    private static final Library PANELS = new Library("lwjgl-nuklear", "nuklear/", "lwjgl_nuklear");

    private NativeLibraries() {}

    /**
     * What is missing.
     *
     * @return null if all is there that a picture needs; else one sentence that names all that is
     *     missing and what brings it
     */
    public static @Nullable String missing() {
        return missing(NativeLibraries.class.getClassLoader());
    }

    static @Nullable String missing(ClassLoader loader) {
        List<String> missing = new ArrayList<>();
        for (Library library : NEEDED) {
            if (!isThere(loader, library)) {
                missing.add(library.artifact());
            }
        }
        if (missing.isEmpty()) {
            return null;
        }
        if (!isThere(loader, PANELS)) {
            missing.add(PANELS.artifact());
        }
        String system = system() + (architecture().equals("arm64") ? "-arm64" : "");
        return "the native libraries of %s for %s are not on the class path; add the artifact"
                        .formatted(String.join(", ", missing), system)
                + " dev.cairn:cairn-natives, or each of these with the classifier natives-"
                + system;
    }

    /**
     * Refuses to go on without what a picture needs.
     *
     * @throws IllegalStateException if something is {@link #missing}
     */
    public static void require() {
        String missing = missing();
        if (missing != null) {
            throw new IllegalStateException(missing);
        }
    }

    private static boolean isThere(ClassLoader loader, Library library) {
        String file = fileName(library.name());
        String place =
                "%s/%s/org/lwjgl/%s%s".formatted(system(), architecture(), library.folder(), file);
        return loader.getResource(place) != null
                || isIn(System.getProperty("org.lwjgl.librarypath"), file)
                || isIn(System.getProperty("java.library.path"), file);
    }

    private static boolean isIn(@Nullable String folders, String file) {
        for (String folder : folders == null ? new String[0] : folders.split(File.pathSeparator)) {
            if (!folder.isEmpty() && Files.exists(Path.of(folder, file))) {
                return true;
            }
        }
        return false;
    }

    private static String system() {
        return Platform.get().getName().toLowerCase(Locale.ROOT);
    }

    private static String architecture() {
        return Platform.getArchitecture().name().toLowerCase(Locale.ROOT);
    }

    private static String fileName(String name) {
        return switch (Platform.get()) {
            case WINDOWS -> name + ".dll";
            case MACOSX -> "lib" + name + ".dylib";
            default -> "lib" + name + ".so";
        };
    }
}
