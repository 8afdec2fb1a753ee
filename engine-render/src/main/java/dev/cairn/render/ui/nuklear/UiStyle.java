package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkStyle;
import org.lwjgl.nuklear.NkStyleButton;
import org.lwjgl.nuklear.NkStyleScrollbar;
import org.lwjgl.nuklear.NkStyleSlider;
import org.lwjgl.nuklear.NkStyleWindow;
import org.lwjgl.nuklear.NkVec2;
import org.lwjgl.system.MemoryStack;

/** The look: dark glass, one accent, round buttons, room to breathe. Colours are 0xAARRGGBB. */
final class UiStyle {
    static final int TEXT = 0xFFE8EAED;
    static final int DIM = 0xFF9AA4B2;
    static final int ACCENT = 0xFF4FA3E3;
    static final int DOUBT = 0xFFFF7A7A;

    private static final int WINDOW = 0xEC181C23;
    private static final int HEADER = 0xF0232A35;
    private static final int BORDER = 0xFF323B49;
    private static final int FIELD = 0xFF2B3340;
    private static final int FIELD_HOVER = 0xFF364153;
    private static final int BUTTON = 0xFF34506B;
    private static final int BUTTON_HOVER = 0xFF3F6488;
    private static final int BUTTON_ACTIVE = 0xFF4F7DA8;
    private static final int ACCENT_HOVER = 0xFF74BBF0;
    private static final int ACCENT_ACTIVE = 0xFF9AD0F7;

    private UiStyle() {}

    static void apply(NkContext context, double scale) {
        colours(context);
        NkStyle style = context.style();
        window(style.window(), scale);
        buttons(style.button(), scale);
        slider(style.slider(), scale);
        scrollbar(style.scrollv(), scale);
        scrollbar(style.scrollh(), scale);
        style.checkbox().padding(at -> size(at, 4 * scale, 4 * scale)).spacing((float) (6 * scale));
        style.checkbox().border(0);
        style.selectable().rounding((float) (4 * scale));
        style.selectable().padding(at -> size(at, 8 * scale, 2 * scale));
        style.combo().rounding((float) (4 * scale)).border(0);
        style.combo().content_padding(at -> size(at, 8 * scale, 4 * scale));
        style.combo().button_padding(at -> size(at, 2 * scale, 6 * scale));
        style.edit().rounding((float) (4 * scale)).border((float) scale);
        style.edit().padding(at -> size(at, 6 * scale, 4 * scale));
        style.tab().rounding((float) (4 * scale)).border(0);
        style.tab().padding(at -> size(at, 4 * scale, 4 * scale));
        style.tab().spacing(at -> size(at, 4 * scale, 4 * scale));
        style.tab().indent((float) (4 * scale));
    }

    private static void colours(NkContext context) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            NkColor.Buffer table = NkColor.malloc(NK_COLOR_COUNT, stack);
            for (int i = 0; i < NK_COLOR_COUNT; i++) {
                set(table.get(i), FIELD);
            }
            set(table.get(NK_COLOR_TEXT), TEXT);
            set(table.get(NK_COLOR_WINDOW), WINDOW);
            set(table.get(NK_COLOR_HEADER), HEADER);
            set(table.get(NK_COLOR_BORDER), BORDER);
            set(table.get(NK_COLOR_BUTTON), BUTTON);
            set(table.get(NK_COLOR_BUTTON_HOVER), BUTTON_HOVER);
            set(table.get(NK_COLOR_BUTTON_ACTIVE), BUTTON_ACTIVE);
            set(table.get(NK_COLOR_TOGGLE_HOVER), FIELD_HOVER);
            set(table.get(NK_COLOR_TOGGLE_CURSOR), ACCENT);
            set(table.get(NK_COLOR_SELECT), 0x00000000);
            set(table.get(NK_COLOR_SELECT_ACTIVE), 0xFF2C5F8A);
            set(table.get(NK_COLOR_SLIDER_CURSOR), ACCENT);
            set(table.get(NK_COLOR_SLIDER_CURSOR_HOVER), ACCENT_HOVER);
            set(table.get(NK_COLOR_SLIDER_CURSOR_ACTIVE), ACCENT_ACTIVE);
            set(table.get(NK_COLOR_EDIT), 0xFF12151B);
            set(table.get(NK_COLOR_EDIT_CURSOR), TEXT);
            set(table.get(NK_COLOR_CHART), 0xFF12151B);
            set(table.get(NK_COLOR_CHART_COLOR), ACCENT);
            set(table.get(NK_COLOR_CHART_COLOR_HIGHLIGHT), ACCENT_ACTIVE);
            set(table.get(NK_COLOR_SCROLLBAR), 0x00000000);
            set(table.get(NK_COLOR_SCROLLBAR_CURSOR), 0xFF3B4657);
            set(table.get(NK_COLOR_SCROLLBAR_CURSOR_HOVER), 0xFF4B586C);
            set(table.get(NK_COLOR_SCROLLBAR_CURSOR_ACTIVE), 0xFF5D6C84);
            set(table.get(NK_COLOR_TAB_HEADER), 0xFF222934);
            nk_style_from_table(context, table);
        }
    }

    private static void window(NkStyleWindow window, double scale) {
        // Nuklear draws the title bar square: round corners below it would show the scene between.
        window.rounding(0).border((float) scale);
        window.padding(at -> size(at, 10 * scale, 8 * scale));
        window.spacing(at -> size(at, 6 * scale, 5 * scale));
        window.scrollbar_size(at -> size(at, 8 * scale, 8 * scale));
        window.group_padding(at -> size(at, 2 * scale, 2 * scale));
        window.combo_padding(at -> size(at, 4 * scale, 4 * scale));
        window.tooltip_padding(at -> size(at, 8 * scale, 5 * scale));
        window.tooltip_offset(at -> size(at, 14 * scale, 14 * scale));
        window.min_row_height_padding((float) (6 * scale));
        window.header().padding(at -> size(at, 6 * scale, 3 * scale));
        window.header().label_padding(at -> size(at, 4 * scale, 2 * scale));
        window.header().minimize_button().padding(at -> size(at, 7 * scale, 7 * scale));
        window.header().minimize_symbol(NK_SYMBOL_TRIANGLE_DOWN);
        window.header().maximize_symbol(NK_SYMBOL_TRIANGLE_RIGHT);
        set(window.tooltip_border_color(), BORDER);
    }

    private static void buttons(NkStyleButton button, double scale) {
        button.rounding((float) (4 * scale)).border(0);
        button.padding(at -> size(at, 6 * scale, 3 * scale));
    }

    private static void slider(NkStyleSlider slider, double scale) {
        slider.bar_height((float) (4 * scale)).rounding((float) (2 * scale));
        slider.cursor_size(at -> size(at, 14 * scale, 14 * scale));
        slider.padding(at -> size(at, 2 * scale, 4 * scale));
        set(slider.bar_filled(), 0xFF3878AB);
    }

    private static void scrollbar(NkStyleScrollbar bar, double scale) {
        bar.rounding((float) (4 * scale)).rounding_cursor((float) (4 * scale));
        bar.border(0).border_cursor(0);
    }

    private static void size(NkVec2 at, double x, double y) {
        at.set((float) x, (float) y);
    }

    static NkColor set(NkColor to, int argb) {
        return to.set((byte) (argb >> 16), (byte) (argb >> 8), (byte) argb, (byte) (argb >>> 24));
    }
}
