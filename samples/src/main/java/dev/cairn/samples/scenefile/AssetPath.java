package dev.cairn.samples.scenefile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * Which files a scene may name: meshes, pictures and moments by their ending, in the scene's folder
 * or in the one that the program was started in, or below. A scene comes from anywhere; what it
 * names is read, and told of when it is wrong.
 */
final class AssetPath {
    static final List<String> MESHES = List.of(".obj");
    static final List<String> PICTURES = List.of(".png", ".jpg", ".jpeg", ".bmp", ".tga");

    static final List<String> MOMENTS = List.of(".cairn");

    private AssetPath() {}

    /**
     * Where a file is.
     *
     * @param folder of the scene
     * @param name as the scene has it, relative to the folder
     * @param endings one of which it must have
     * @return its path, which need not exist
     * @throws IllegalArgumentException if it is no such file by its name, or outside
     */
    static Path of(Path folder, String name, List<String> endings) {
        Path file = folder.resolve(name);
        String last = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (endings.stream().noneMatch(last::endsWith)) {
            throw new IllegalArgumentException(
                    "expected a file that ends in %s, found \"%s\""
                            .formatted(String.join(", ", endings), SceneFileException.shown(name)));
        }
        Path real = real(file);
        if (!real.startsWith(real(folder)) && !real.startsWith(real(Path.of("")))) {
            throw new IllegalArgumentException(
                    ("expected a file in the scene's folder or below the current one, found \"%s\","
                         + " which is outside of both; copy it beside the scene, or start in a"
                         + " folder above both")
                            .formatted(SceneFileException.shown(name)));
        }
        return file;
    }

    /** With links followed as far as the path exists. */
    private static Path real(Path path) {
        Path whole = path.toAbsolutePath().normalize();
        try {
            return whole.toRealPath();
        } catch (IOException missing) {
            Path parent = whole.getParent();
            return parent == null ? whole : real(parent).resolve(whole.getFileName());
        }
    }
}
