package dev.cairn.render.mesh;

import java.nio.file.Path;

/** Stub. */
public final class ObjReader {
    private ObjReader() {}

    /**
     * Reads a {@code .obj} file.
     *
     * @param file where it is
     * @return the mesh
     * @throws ObjFormatException if it is missing, broken or too large
     */
    public static Mesh read(Path file) {
        throw new UnsupportedOperationException();
    }
}
