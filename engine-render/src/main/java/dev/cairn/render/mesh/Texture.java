package dev.cairn.render.mesh;

import dev.cairn.render.natives.NativeLibraries;

import org.jspecify.annotations.Nullable;
import org.lwjgl.stb.STBImage;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A picture that is drawn on surfaces: sRGB colours, rows from top to bottom. Immutable and free of
 * OpenGL; the renderer uploads it with mipmaps when it first draws it.
 */
public final class Texture {
    /** A quarter of a GiB while it is read. */
    private static final int MAX_PIXELS = 1 << 25;

    private static final double ROUGH = 0.5;

    /** One white pixel: the colour of the model shows as it is. */
    public static final Texture WHITE = of("white", 1, 1, new int[] {0xFFFFFFFF});

    private final String name;
    private final int width;
    private final int height;
    private final int[] argb;
    private final double tileMetres;
    private final double roughness;
    private final double metal;
    private final double opacity;

    private Texture(
            String name,
            int width,
            int height,
            int[] argb,
            double tileMetres,
            double roughness,
            double metal,
            double opacity) {
        this.name = name;
        this.width = width;
        this.height = height;
        this.argb = argb;
        this.tileMetres = tileMetres;
        this.roughness = roughness;
        this.metal = metal;
        this.opacity = opacity;
    }

    /**
     * A texture from pixels.
     *
     * @param name what it is called in messages
     * @param width pixels, 1..16384
     * @param height pixels, 1..16384
     * @param argb {@code width * height} pixels, top row first, 0xAARRGGBB in sRGB; copied; alpha
     *     is ignored
     * @return the texture
     */
    public static Texture of(String name, int width, int height, int[] argb) {
        Objects.requireNonNull(name, "name");
        if (width < 1 || height < 1 || width > 16384 || height > 16384) {
            throw new IllegalArgumentException(
                    "texture '"
                            + name
                            + "' is "
                            + width
                            + " x "
                            + height
                            + " pixels, expected 1..16384 each");
        }
        if (argb.length != width * height) {
            throw new IllegalArgumentException(
                    "texture '"
                            + name
                            + "' has "
                            + argb.length
                            + " pixels, expected "
                            + width
                            + " * "
                            + height);
        }
        return new Texture(name, width, height, argb.clone(), 0, ROUGH, 0, 1);
    }

    private static void bound(Path file, long found, String what) {
        if (found > MAX_PIXELS) {
            throw new IllegalArgumentException(
                    file
                            + ": expected a picture of at most "
                            + MAX_PIXELS
                            + " "
                            + what
                            + ", found "
                            + found
                            + "; make it smaller");
        }
    }

    /**
     * Reads a {@code .png} (also .jpg, .bmp, .tga) file.
     *
     * @param file where it is
     * @return the texture
     * @throws IllegalArgumentException naming the file and the reason, if it cannot be read, or has
     *     more than {@value #MAX_PIXELS} pixels or as many bytes
     */
    public static Texture read(Path file) {
        if (!Files.isRegularFile(file)) {
            throw new IllegalArgumentException(
                    file + ": expected a picture file (.png), found nothing there");
        }
        byte[] bytes;
        try {
            bound(file, Files.size(file), "bytes");
            bytes = Files.readAllBytes(file);
        } catch (IOException e) {
            throw new IllegalArgumentException(
                    file + ": expected a readable picture file (.png), found: " + e, e);
        }
        NativeLibraries.require();
        ByteBuffer encoded = MemoryUtil.memAlloc(Math.max(1, bytes.length));
        try (MemoryStack stack = MemoryStack.stackPush()) {
            encoded.put(bytes).flip();
            IntBuffer width = stack.mallocInt(1);
            IntBuffer height = stack.mallocInt(1);
            IntBuffer channels = stack.mallocInt(1);
            if (STBImage.stbi_info_from_memory(encoded, width, height, channels)) {
                bound(file, (long) width.get(0) * height.get(0), "pixels");
            }
            ByteBuffer pixels = STBImage.stbi_load_from_memory(encoded, width, height, channels, 4);
            if (pixels == null) {
                throw new IllegalArgumentException(
                        file
                                + ": expected a picture (.png), found "
                                + bytes.length
                                + " bytes that are none: "
                                + STBImage.stbi_failure_reason());
            }
            try {
                int[] argb = new int[width.get(0) * height.get(0)];
                for (int i = 0; i < argb.length; i++) {
                    argb[i] =
                            (pixels.get(4 * i + 3) & 255) << 24
                                    | (pixels.get(4 * i) & 255) << 16
                                    | (pixels.get(4 * i + 1) & 255) << 8
                                    | (pixels.get(4 * i + 2) & 255);
                }
                return of(file.toString(), width.get(0), height.get(0), argb);
            } finally {
                STBImage.stbi_image_free(pixels);
            }
        } finally {
            MemoryUtil.memFree(encoded);
        }
    }

    /**
     * A quiet floor: squares of two greys, fine lines between them. Lay it with {@link
     * #tiledEvery}: {@code grid().tiledEvery(2)} makes squares of one metre.
     *
     * @return the texture, 256 x 256, with two by two squares
     */
    public static Texture grid() {
        return Patterns.GRID;
    }

    /**
     * A face of a crate: plain, with a soft darker rim, so that the edges of stacked boxes can be
     * told apart.
     *
     * @return the texture, 128 x 128
     */
    public static Texture panel() {
        return Patterns.PANEL;
    }

    /**
     * The skin of a ball: eight sectors, light and slightly darker, and a band, so that its turning
     * shows.
     *
     * @return the texture, 256 x 128
     */
    public static Texture beachBall() {
        return Patterns.BEACH_BALL;
    }

    /**
     * Brushed metal in the colour of the model: it mirrors sun and sky where {@link
     * dev.cairn.render.camera.Effects#reflections} are drawn, and is plain elsewhere.
     *
     * @return the picture
     */
    public static Texture bareMetal() {
        return Patterns.METAL;
    }

    /**
     * Clear glass with a breath of the model's colour: what is behind it is seen through it.
     *
     * @return the picture
     */
    public static Texture glass() {
        return Patterns.GLASS;
    }

    /**
     * What is shown where a picture cannot be read: a checker of magenta and black, which nobody
     * takes for the real one.
     *
     * @return the texture, 64 x 64, with four by four squares
     */
    public static Texture missing() {
        return Patterns.MISSING;
    }

    /**
     * The same picture laid over the model by its coordinates in metres instead of by the mesh's
     * texture coordinates: each face takes the two axes that it lies in. A floor of any size keeps
     * its pattern's size so.
     *
     * @param metres length of one repetition, &gt; 0; 0 returns to the mesh's own coordinates
     * @return a new texture that shares the pixels
     */
    public Texture tiledEvery(double metres) {
        if (!(metres >= 0) || Double.isInfinite(metres)) {
            throw new IllegalArgumentException(
                    "texture '" + name + "': tile is " + metres + " m, expected >= 0 and finite");
        }
        return new Texture(name, width, height, argb, metres, roughness, metal, opacity);
    }

    /**
     * What it is called in messages.
     *
     * @return the name
     */
    public String name() {
        return name;
    }

    /**
     * Width.
     *
     * @return pixels
     */
    public int width() {
        return width;
    }

    /**
     * Height.
     *
     * @return pixels
     */
    public int height() {
        return height;
    }

    /**
     * The pixels, top row first, 0xAARRGGBB in sRGB.
     *
     * @return a copy
     */
    public int[] argb() {
        return argb.clone();
    }

    /**
     * Length of one repetition if the texture is laid by metres.
     *
     * @return metres; 0 if the mesh's own texture coordinates are used
     */
    public double tileMetres() {
        return tileMetres;
    }

    /**
     * The same picture on a surface of another finish, for what mirrors sun and sky; see {@link
     * dev.cairn.render.camera.Effects}.
     *
     * @param newRoughness 0.05 (a mirror) .. 1 (chalk)
     * @param newMetal 0 (paint, stone, plastic) .. 1 (bare metal, which mirrors in its own colour)
     * @return a copy that shares the pixels
     * @throws IllegalArgumentException if a number is out of range
     */
    public Texture finish(double newRoughness, double newMetal) {
        if (!(newRoughness >= 0.05 && newRoughness <= 1 && newMetal >= 0 && newMetal <= 1)) {
            throw new IllegalArgumentException(
                    "texture '"
                            + name
                            + "': roughness is "
                            + newRoughness
                            + " and metal "
                            + newMetal
                            + ", expected 0.05..1 and 0..1");
        }
        return new Texture(name, width, height, argb, tileMetres, newRoughness, newMetal, opacity);
    }

    /**
     * The same picture on a surface that lets light through. What is behind it is seen; it casts no
     * shadow and cannot be picked.
     *
     * @param share 0 (nothing of it is seen) .. 1 (nothing behind it is seen)
     * @return a copy that shares the pixels
     * @throws IllegalArgumentException if the number is out of range
     */
    public Texture opacity(double share) {
        if (!(share >= 0 && share <= 1)) {
            throw new IllegalArgumentException(
                    "texture '" + name + "': opacity is " + share + ", expected 0..1");
        }
        return new Texture(name, width, height, argb, tileMetres, roughness, metal, share);
    }

    /**
     * How much of what is behind the surface it hides.
     *
     * @return 0..1; 1 for what is solid
     */
    public double opacity() {
        return opacity;
    }

    /**
     * How rough the surface is.
     *
     * @return 0.05..1
     */
    public double roughness() {
        return roughness;
    }

    /**
     * How much of the surface is bare metal.
     *
     * @return 0..1
     */
    public double metal() {
        return metal;
    }

    /**
     * Textures are equal if they share their pixels, not if they merely look alike, and are tiled
     * alike.
     */
    @Override
    @SuppressWarnings("ReferenceEquality") // Sharing is what is meant.
    public boolean equals(@Nullable Object other) {
        return other instanceof Texture that
                && that.argb == argb
                && that.tileMetres == tileMetres
                && that.roughness == roughness
                && that.metal == metal
                && that.opacity == opacity;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * System.identityHashCode(argb) + Double.hashCode(tileMetres))
                + Double.hashCode(roughness + 2 * metal + 4 * opacity);
    }

    @Override
    public String toString() {
        return "Texture[" + name + ", " + width + " x " + height + "]";
    }
}
