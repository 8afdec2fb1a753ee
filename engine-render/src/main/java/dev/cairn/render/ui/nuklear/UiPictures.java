package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;
import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_LINEAR_MIPMAP_LINEAR;
import static org.lwjgl.opengl.GL11.GL_RGBA8;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL12.GL_BGRA;
import static org.lwjgl.opengl.GL12.GL_UNSIGNED_INT_8_8_8_8_REV;
import static org.lwjgl.opengl.GL30.glGenerateMipmap;

import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.mesh.Texture;
import dev.cairn.render.ui.Ui;

import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkImage;
import org.lwjgl.nuklear.NkRect;
import org.lwjgl.system.MemoryUtil;

import java.nio.IntBuffer;
import java.util.IdentityHashMap;

/**
 * Parts of pictures in the widget at hand; a sheet goes to graphics memory when it is first seen.
 */
final class UiPictures implements AutoCloseable {
    private final NkContext context;
    private final IdentityHashMap<Texture, Integer> sheets = new IdentityHashMap<>();
    private final NkRect rect = NkRect.calloc();
    private final NkRect part = NkRect.calloc();
    private final NkImage image = NkImage.calloc();
    private final NkColor white = NkColor.calloc();

    UiPictures(NkContext context) {
        this.context = context;
        UiStyle.set(white, 0xFFFFFFFF);
    }

    /** Draws it as wide and high as the widget, and says whether it was clicked. */
    boolean draw(Ui.Part picture) {
        boolean clicked = nnk_widget_is_mouse_clicked(context.address(), NK_BUTTON_LEFT);
        if (nnk_widget(rect.address(), context.address()) == NK_WIDGET_INVALID) {
            return false; // scrolled out of sight
        }
        Texture sheet = picture.sheet();
        Integer known = sheets.get(sheet);
        if (known == null) {
            known = upload(sheet);
            sheets.put(sheet, known);
        }
        part.set(picture.left(), picture.top(), picture.width(), picture.height());
        nnk_subimage_id(
                known,
                (short) sheet.width(),
                (short) sheet.height(),
                part.address(),
                image.address());
        long canvas = nnk_window_get_canvas(context.address());
        nnk_draw_image(canvas, rect.address(), image.address(), white.address());
        return clicked;
    }

    /** Shown as it is: the panels are drawn with the screen's own numbers. */
    private static int upload(Texture sheet) {
        int id = GlObjects.texture();
        glBindTexture(GL_TEXTURE_2D, id);
        IntBuffer pixels = MemoryUtil.memAllocInt(sheet.width() * sheet.height());
        try {
            pixels.put(sheet.argb()).flip();
            glTexImage2D(
                    GL_TEXTURE_2D,
                    0,
                    GL_RGBA8,
                    sheet.width(),
                    sheet.height(),
                    0,
                    GL_BGRA,
                    GL_UNSIGNED_INT_8_8_8_8_REV,
                    pixels);
        } finally {
            MemoryUtil.memFree(pixels);
        }
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        return id;
    }

    @Override
    public void close() {
        sheets.values().forEach(GlObjects::deleteTexture);
        rect.free();
        part.free();
        image.free();
        white.free();
    }
}
