package dev.cairn.render.app;

import org.lwjgl.stb.STBImageWrite;
import org.lwjgl.system.MemoryUtil;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Pixels that were drawn, in sRGB.
 *
 * @param width pixels, &gt; 0
 * @param height pixels, &gt; 0
 * @param argb {@code width * height} pixels, top row first, 0xAARRGGBB; shared, not copied
 */
@SuppressWarnings(
        "ArrayRecordComponent") // Pixels are data to look at, and nobody compares pictures by
// equals.
public record Picture(int width, int height, int[] argb) {
    /** Checks the sizes. */
    public Picture {
        Objects.requireNonNull(argb, "argb");
        if (width < 1 || height < 1 || argb.length != width * height) {
            throw new IllegalArgumentException(
                    "picture of "
                            + width
                            + " x "
                            + height
                            + " with "
                            + argb.length
                            + " pixels, expected width * height");
        }
    }

    /**
     * One pixel.
     *
     * @param x column from the left
     * @param y row from the top
     * @return 0xAARRGGBB
     */
    public int at(int x, int y) {
        return argb[y * width + x];
    }

    /**
     * Writes the picture.
     *
     * @param file where; parent folders are made
     * @throws java.io.UncheckedIOException if it cannot be written
     */
    public void savePng(Path file) {
        ByteBuffer bytes = MemoryUtil.memAlloc(3 * argb.length);
        try {
            for (int pixel : argb) {
                bytes.put((byte) (pixel >> 16)).put((byte) (pixel >> 8)).put((byte) pixel);
            }
            Path parent = file.toAbsolutePath().getParent();
            if (parent != null) {
                Files.createDirectories(parent);
            }
            STBImageWrite.stbi_flip_vertically_on_write(false);
            if (!STBImageWrite.stbi_write_png(
                    file.toString(), width, height, 3, bytes.flip(), 3 * width)) {
                throw new IOException("the file cannot be written");
            }
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "the picture " + file + " was not saved: " + e.getMessage(), e);
        } finally {
            MemoryUtil.memFree(bytes);
        }
    }
}
