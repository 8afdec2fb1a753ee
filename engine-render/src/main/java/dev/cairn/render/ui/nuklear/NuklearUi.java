package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;
import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkRect;
import org.lwjgl.nuklear.NkVec2;
import org.lwjgl.system.MemoryUtil;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * {@link Ui} by Nuklear. One frame is events to {@link #input}, {@link #begin}, widgets, {@link
 * #paint}. Everything that Nuklear keeps lies in one block of memory that is made once.
 */
public final class NuklearUi implements Ui, AutoCloseable {
    private static final int MEMORY_BYTES = 4 << 20;
    private static final double ROW = 24;
    private static final double LINE = 19;
    private static final double PLOT = 46;
    private static final double PICTURE = 31;

    /** Padding and rounding of a button, see {@link UiStyle}. */
    private static final double BUTTON_INSET = 10;

    private final double scale;
    private final UiFont font;
    private final UiGeometry geometry;
    private final UiPainter painter;
    private final UiCross cross;
    private final UiPlot plots;
    private final ByteBuffer memory = MemoryUtil.memAlignedAlloc(64, MEMORY_BYTES);
    private final NkContext context = NkContext.calloc();
    private final NkRect rect = NkRect.calloc();
    private final NkVec2 vector = NkVec2.calloc();
    private final NkColor first = NkColor.calloc();
    private final UiText letters = new UiText();

    /** Room for a number that Nuklear changes; an array on the heap would be wrapped each time. */
    private final long numbers = MemoryUtil.nmemAllocChecked(8);

    private final UiShares shares = new UiShares();
    private final UiPictures pictures = new UiPictures(context);
    private final UiPace pace = new UiPace();
    private final UiPlaces places = new UiPlaces();
    private final UiSections sections = new UiSections();
    private final SliderText sliderText = new SliderText();
    private final NuklearInput input = new NuklearInput(context, vector);
    private final UiFields fields = new UiFields(context, input);
    private final UiDrag drag = new UiDrag(context, input);
    private int pixelWidth;
    private int pixelHeight;
    private String panelNow = "";
    private float panelTop;
    private float panelBottom;
    private final UiPanels panels = new UiPanels();
    private boolean panelOpen;
    private int columns;
    private int cell;

    /**
     * Bakes letters and compiles the shader; with a current context.
     *
     * @param scale real pixels to a logical one
     */
    public NuklearUi(double scale) {
        this.scale = scale;
        font = new UiFont(scale);
        geometry = new UiGeometry(memory, font.whiteTexel());
        painter = new UiPainter(geometry);
        nk_init_fixed(context, memory, font.regular());
        UiStyle.apply(context, scale);
        cross = new UiCross(context, scale);
        plots = new UiPlot(context, scale);
    }

    /**
     * Where events go.
     *
     * @return the panels' keyboard and mouse
     */
    public NuklearInput input() {
        return input;
    }

    /**
     * Whether the mouse belongs to the panels: it is over one, or moves one of their sliders.
     *
     * @return true if nobody else should act on it
     */
    public boolean wantsMouse() {
        return nk_window_is_any_hovered(context) || nk_item_is_any_active(context);
    }

    /**
     * Whether keys belong to the panels: a text is edited.
     *
     * @return true if nobody else should act on them
     */
    public boolean wantsKeys() {
        return fields.isEditing();
    }

    /** Has the text that is edited keep what it is, and keys go elsewhere from now on. */
    public void endEditing() {
        fields.endEditing();
    }

    /**
     * Lets texts be cut, copied and pasted; without, they are not.
     *
     * @param from what is in the clipboard, empty for no text
     * @param to puts a text there
     */
    public void clipboard(Supplier<String> from, Consumer<String> to) {
        fields.clipboard(from, to);
    }

    // Frame ------------------------------------------------------------------------------------

    /**
     * Begins a frame.
     *
     * @param width of the picture, real pixels
     * @param height of the picture, real pixels
     * @param nowNanos of {@link System#nanoTime}
     */
    public void begin(int width, int height, long nowNanos) {
        pixelWidth = width;
        pixelHeight = height;
        pace.begin(width, height, nowNanos, input.wasStirred());
    }

    @Override
    public boolean keep() {
        return pace.keep();
    }

    /** Before the first widget of a frame, and when none came; false if what is there stays. */
    private boolean makes() {
        if (!pace.begins()) {
            return pace.makes();
        }
        fields.nextFrame();
        letters.nextFrame();
        panels.nextFrame();
        return true;
    }

    /** Draws all panels into the bound framebuffer. */
    public void paint() {
        boolean made = makes();
        painter.draw(made ? context : null, pixelWidth, pixelHeight);
        if (made) {
            nk_clear(context);
            fields.frameDone();
            pace.done();
        }
    }

    @Override
    public double width() {
        return pixelWidth / scale;
    }

    @Override
    public double height() {
        return pixelHeight / scale;
    }

    @Override
    public double scale() {
        return scale;
    }

    // Panels -----------------------------------------------------------------------------------

    @Override
    public boolean panel(
            String title, double left, double top, double panelWidth, double panelHeight) {
        if (!makes()) {
            return false;
        }
        panelNow = title;
        rect.set(px(left), px(top), px(Math.max(panelWidth, 1)), px(Math.max(panelHeight, 1)));
        panelTop = rect.y();
        panelBottom = panelTop + rect.h();
        places.put(title, left, top, panelWidth, panelHeight);
        panels.add(left, top, panelWidth, panelHeight);
        nk_style_push_font(context, font.title());
        panelOpen =
                nnk_begin(
                        context.address(),
                        letters.of(title),
                        rect.address(),
                        NK_WINDOW_TITLE | NK_WINDOW_BORDER | NK_WINDOW_MINIMIZABLE);
        nk_style_pop_font(context);
        columns(1);
        return panelOpen;
    }

    private float px(double logical) {
        return (float) Math.rint(logical * scale);
    }

    @Override
    public void endPanel() {
        if (makes()) {
            nk_end(context);
        }
    }

    @Override
    public void columns(int count) {
        columns = Math.max(1, count);
        cell = 0;
    }

    /** Starts a row where the last one is full. */
    private void cell(double height) {
        if (cell % columns == 0) {
            nk_layout_row_dynamic(context, px(height), columns);
        }
        cell++;
    }

    private void row(double height, int count, long shares) {
        columns(1);
        nnk_layout_row(context.address(), NK_DYNAMIC, px(height), count, shares);
    }

    private double[] remember(String label) {
        nk_widget_bounds(context, rect);
        return places.put(label, rect, scale);
    }

    @Override
    public double @Nullable [] boundsOf(String label) {
        return places.of(label);
    }

    private void hint(String text) {
        if (!text.isEmpty() && nk_widget_is_hovered(context)) {
            nnk_tooltip(context.address(), letters.of(text));
        }
    }

    // Text -------------------------------------------------------------------------------------

    private void write(CharSequence text, int align) {
        nnk_label(context.address(), fitted(text, 0), align);
    }

    private void write(CharSequence text, int argb, int align) {
        UiStyle.set(first, argb);
        nnk_label_colored(context.address(), fitted(text, 0), align, first.address());
    }

    /** A text that fits the next widget, less so much on either side; none where none is seen. */
    private long fitted(CharSequence text, double inset) {
        nk_widget_bounds(context, rect);
        if (rect.y() > panelBottom || rect.y() + rect.h() < panelTop) {
            return letters.of("");
        }
        return letters.fitted(text, font.regularWidths(), rect.w() - 2 * inset * scale);
    }

    @Override
    public int shortened() {
        return letters.shortened();
    }

    @Override
    public long changes() {
        return geometry.changes();
    }

    @Override
    public int draws() {
        return geometry.batches();
    }

    @Override
    public int overlapping() {
        return panels.overlapping();
    }

    @Override
    public void label(CharSequence text) {
        cell(LINE);
        write(text, NK_TEXT_LEFT);
    }

    @Override
    public void label(CharSequence text, int rgb) {
        cell(LINE);
        write(text, 0xFF000000 | rgb, NK_TEXT_LEFT);
    }

    @Override
    public void value(CharSequence name, CharSequence value) {
        row(LINE, 2, shares.value);
        write(name, UiStyle.DIM, NK_TEXT_LEFT);
        write(value, NK_TEXT_RIGHT);
    }

    @Override
    public void heading(CharSequence text) {
        columns(1);
        nk_layout_row_dynamic(context, px(ROW), 1);
        nk_style_push_font(context, font.title());
        write(text, UiStyle.ACCENT, NK_TEXT_LEFT);
        nk_style_pop_font(context);
    }

    @Override
    public void text(CharSequence text) {
        columns(1);
        // Padding, border and scroll bar of a panel, and what an open section is set in.
        double width = nk_window_get_width(context) - 36 * scale;
        int rows = UiText.rows(text, font.regularWidths(), width);
        nk_layout_row_dynamic(context, px(LINE * rows), 1);
        UiStyle.set(first, UiStyle.DIM);
        nnk_label_colored_wrap(context.address(), letters.of(text), first.address());
    }

    @Override
    public boolean button(String label) {
        cell(ROW);
        remember(label);
        return nnk_button_label(context.address(), fitted(label, BUTTON_INSET));
    }

    @Override
    public boolean valueButton(String label, CharSequence value) {
        row(ROW, 2, shares.button);
        write(label, NK_TEXT_LEFT);
        remember(label);
        return nnk_button_label(context.address(), fitted(value, BUTTON_INSET));
    }

    @Override
    public boolean checkbox(String label, boolean checked) {
        cell(ROW - 2);
        remember(label);
        return nnk_check_label(context.address(), fitted(label, (ROW - 2) / 2 + 3), checked);
    }

    @Override
    public boolean isHeld(String label) {
        return drag.isHeld(panelNow, label);
    }

    @Override
    public double slider(
            String label, double value, double min, double max, double step, String hint) {
        if (!(max > min)) {
            value(label, sliderText.of(label, value));
            return value;
        }
        row(ROW, 3, shares.slider);
        hint(hint);
        write(label, NK_TEXT_LEFT);
        double[] at = remember(label);
        hint(hint);
        double moved = value;
        double share = SliderScale.share(min, max, value);
        if (drag.begins(panelNow, label)) {
            moved = drag.moved(at, scale, value, min, max, step);
            share = drag.share();
        }
        MemoryUtil.memPutFloat(numbers, (float) share);
        nnk_slider_float(context.address(), 0, numbers, 1, 0.001f);
        write(sliderText.of(label, moved), NK_TEXT_RIGHT);
        return moved;
    }

    @Override
    public int choice(String label, List<String> options, int selected) {
        row(ROW, 2, shares.choice);
        write(label, NK_TEXT_LEFT);
        double[] at = remember(label);
        int chosen = selected;
        // Down to the lower edge of the picture, and scrolled if that is too near.
        double below = height() - at[1] - at[3] - 8;
        double wanted = Math.clamp(12 + (ROW + 4) * options.size(), 3 * ROW, 320);
        vector.set(px(at[2]), px(Math.max(Math.min(wanted, below), 3 * ROW)));
        if (nnk_combo_begin_label(
                context.address(), letters.of(options.get(selected)), vector.address())) {
            nk_layout_row_dynamic(context, px(ROW), 1);
            for (int i = 0; i < options.size(); i++) {
                if (nnk_combo_item_label(
                        context.address(), letters.of(options.get(i)), NK_TEXT_LEFT)) {
                    chosen = i;
                }
            }
            nk_combo_end(context);
        }
        return chosen;
    }

    @Override
    public boolean item(String label, boolean selected, String hint) {
        cell(ROW - 2);
        return select(label, selected, hint);
    }

    private boolean select(String label, boolean selected, String hint) {
        remember(label);
        hint(hint);
        return nnk_select_label(context.address(), fitted(label, 8), NK_TEXT_LEFT, selected)
                != selected;
    }

    @Override
    public boolean item(String label, boolean selected, String hint, Part picture) {
        row(PICTURE, 2, shares.picture);
        boolean chosen = pictures.draw(picture);
        return select(label, selected, hint) || chosen;
    }

    @Override
    public boolean section(String title, boolean open) {
        columns(1);
        remember(title);
        return nnk_tree_state_push(
                context.address(), NK_TREE_TAB, letters.of(title), sections.state(title, open));
    }

    /**
     * Opens and closes sections as they are in panels of another scale; before the first frame.
     *
     * @param other the panels that were there before, not closed yet
     */
    public void openAs(NuklearUi other) {
        sections.openAs(other.sections);
    }

    @Override
    public void endSection() {
        nk_tree_state_pop(context);
        columns(1);
    }

    @Override
    public void plot(
            String label, CharSequence value, float[] values, int begin, int count, int rgb) {
        value(label, value);
        nk_layout_row_dynamic(context, px(PLOT), 1);
        plots.curve(values, begin, count, rgb);
    }

    @Override
    public String textField(String label, String content, boolean doubtful) {
        row(ROW, 2, shares.choice);
        if (doubtful) {
            write(label, UiStyle.DOUBT, NK_TEXT_LEFT);
        } else {
            write(label, NK_TEXT_LEFT);
        }
        remember(label);
        return fields.edit(label, content);
    }

    @Override
    public void cross(double x, double y, int rgb) {
        if (makes()) {
            cross.draw(x, y, rgb);
        }
    }

    @Override
    public void close() {
        nk_free(context);
        painter.close();
        geometry.close();
        font.close();
        MemoryUtil.memAlignedFree(memory);
        fields.close();
        context.free();
        rect.free();
        vector.free();
        first.free();
        cross.close();
        plots.close();
        pictures.close();
        shares.close();
        letters.close();
        MemoryUtil.nmemFree(numbers);
        sections.close();
    }
}
