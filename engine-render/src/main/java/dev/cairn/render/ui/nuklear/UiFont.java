package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.NK_FONT_ATLAS_RGBA32;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_add_default;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_add_from_memory;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_bake;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_begin;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_clear;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_end;
import static org.lwjgl.nuklear.Nuklear.nk_font_atlas_init;
import static org.lwjgl.nuklear.Nuklear.nk_font_config;
import static org.lwjgl.nuklear.Nuklear.nk_font_find_glyph;
import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_RGBA;
import static org.lwjgl.opengl.GL11.GL_RGBA8;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_BYTE;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameteri;

import dev.cairn.render.gl.GlObjects;

import org.jspecify.annotations.Nullable;
import org.lwjgl.nuklear.NkAllocator;
import org.lwjgl.nuklear.NkDrawNullTexture;
import org.lwjgl.nuklear.NkFont;
import org.lwjgl.nuklear.NkFontAtlas;
import org.lwjgl.nuklear.NkFontConfig;
import org.lwjgl.nuklear.NkFontGlyph;
import org.lwjgl.nuklear.NkHandle;
import org.lwjgl.nuklear.NkUserFont;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.Objects;

/**
 * Letters in a texture: Roboto (Christian Robertson, Apache-2.0) where its jar is on the class
 * path, else the bitmap font that Nuklear carries (ProggyClean, Tristan Grimmer, MIT).
 */
final class UiFont implements AutoCloseable {
    private static final String FOLDER = "/com/formdev/flatlaf/fonts/roboto/";
    private static final double REGULAR_SIZE = 15;
    private static final double TITLE_SIZE = 15;

    /**
     * First and last letter of what is baked: Latin with the letters of Europe's languages, Greek,
     * Cyrillic, and dashes, quotes and signs of text. Each other letter is drawn as "?".
     */
    private static final int[] BAKED = {
        ' ', 0x17F, 0x218, 0x21B, 0x386, 0x3CE, 0x400, 0x45F, 0x490, 0x491, 0x2010, 0x2026, 0x20AC,
        0x20AC, 0x2212, 0x2212
    };

    /** Letters whose widths are known by their number: up to the last one of Cyrillic. */
    private static final int LETTERS = 0x492;

    private final NkAllocator allocator = NkAllocator.calloc();
    private final NkFontAtlas atlas = NkFontAtlas.calloc();
    private final NkDrawNullTexture whiteTexel = NkDrawNullTexture.calloc();

    /** {@link #BAKED}, ended by 0; Nuklear looks letters up by it. */
    private final IntBuffer ranges = MemoryUtil.memAllocInt(BAKED.length + 1);

    private final NkUserFont regular;
    private final NkUserFont title;
    private final int texture;

    /** Widths of the letters that are baked, real pixels, by their number. */
    private final float[] regularWidths;

    private final float[] titleWidths;

    /**
     * Bakes the letters.
     *
     * @param scale real pixels to a logical one
     */
    UiFont(double scale) {
        ranges.put(BAKED).put(0).flip();
        allocator.alloc((handle, old, size) -> MemoryUtil.nmemAllocChecked(size));
        allocator.mfree((handle, pointer) -> MemoryUtil.nmemFree(pointer));
        nk_font_atlas_init(atlas, allocator);
        nk_font_atlas_begin(atlas);
        NkFont first = add("Roboto-Regular.ttf", REGULAR_SIZE * scale);
        NkFont second = add("Roboto-Medium.ttf", TITLE_SIZE * scale);
        texture = GlObjects.texture();
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer width = stack.mallocInt(1);
            IntBuffer height = stack.mallocInt(1);
            ByteBuffer image =
                    Objects.requireNonNull(
                            nk_font_atlas_bake(atlas, width, height, NK_FONT_ATLAS_RGBA32),
                            "the letters of the user interface cannot be baked: out of memory");
            glBindTexture(GL_TEXTURE_2D, texture);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            glTexImage2D(
                    GL_TEXTURE_2D,
                    0,
                    GL_RGBA8,
                    width.get(0),
                    height.get(0),
                    0,
                    GL_RGBA,
                    GL_UNSIGNED_BYTE,
                    image);
            nk_font_atlas_end(atlas, NkHandle.malloc(stack).id(texture), whiteTexel);
        }
        regular = first.handle();
        title = second.handle();
        regularWidths = widths(first);
        titleWidths = widths(second);
    }

    private static float[] widths(NkFont font) {
        float[] widths = new float[LETTERS];
        for (int letter = ' '; letter < LETTERS; letter++) {
            NkFontGlyph glyph = nk_font_find_glyph(font, letter);
            widths[letter] = glyph == null ? 0 : glyph.xadvance();
        }
        return widths;
    }

    float[] regularWidths() {
        return regularWidths;
    }

    float[] titleWidths() {
        return titleWidths;
    }

    private NkFont add(String file, double pixels) {
        ByteBuffer bytes = resource(FOLDER + file);
        try (MemoryStack stack = MemoryStack.stackPush()) {
            NkFontConfig config = NkFontConfig.calloc(stack);
            nk_font_config((float) pixels, config);
            if (bytes != null) {
                config.range(ranges);
            }
            NkFont font =
                    bytes == null
                            ? nk_font_atlas_add_default(atlas, (float) pixels, config)
                            : nk_font_atlas_add_from_memory(atlas, bytes, (float) pixels, config);
            return Objects.requireNonNull(
                    font, "the font of the user interface cannot be read: " + file);
        } finally {
            MemoryUtil.memFree(bytes); // the atlas has its own copy
        }
    }

    private static @Nullable ByteBuffer resource(String path) {
        try (InputStream in = UiFont.class.getResourceAsStream(path)) {
            if (in == null) {
                return null;
            }
            byte[] bytes = in.readAllBytes();
            ByteBuffer copy = MemoryUtil.memAlloc(bytes.length);
            copy.put(bytes).flip();
            return copy;
        } catch (IOException e) {
            throw new UncheckedIOException("the font " + path + " cannot be read", e);
        }
    }

    NkUserFont regular() {
        return regular;
    }

    NkUserFont title() {
        return title;
    }

    NkDrawNullTexture whiteTexel() {
        return whiteTexel;
    }

    @Override
    public void close() {
        nk_font_atlas_clear(atlas);
        MemoryUtil.memFree(ranges);
        GlObjects.deleteTexture(texture);
        whiteTexel.free();
        atlas.free();
        Objects.requireNonNull(allocator.alloc()).free();
        Objects.requireNonNull(allocator.mfree()).free();
        allocator.free();
    }
}
