package dev.cairn.render.ui;

import dev.cairn.render.mesh.Texture;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * Panels of widgets over the picture, in immediate mode: each frame the application says what is
 * there, and each call draws a widget and returns what the user did with it.
 *
 * <pre>{@code
 * if (ui.panel("Ball", 12, 12, 260, 200)) {
 *     mass = ui.slider("mass", mass, 0.1, 100, 0, "kg");
 *     if (ui.button("Throw")) { post(this::throwBall); }
 * }
 * ui.endPanel();
 * }</pre>
 *
 * <p>A frame that shows the same makes no garbage; for numbers that change there is {@link
 * TextBuffer}.
 *
 * <p>Lengths are logical pixels: {@link #scale()} real ones each, so that a layout is as readable
 * on a screen of double density. The origin is the upper left corner. Window thread, inside {@code
 * Application.panels} only.
 */
public interface Ui {
    /**
     * Width of the window.
     *
     * @return logical pixels
     */
    double width();

    /**
     * Height of the window.
     *
     * @return logical pixels
     */
    double height();

    /**
     * Real pixels to a logical one.
     *
     * @return 0.5..4
     */
    double scale();

    /**
     * Lets all panels stay as they are drawn, so that this frame costs next to nothing: for who
     * shows what may be a tenth of a second old. To be called before the first panel of a frame.
     * They are made anew after a tenth of a second, when the window's size changes, and for a fifth
     * of a second after the user did something: pressed, typed, turned the wheel, moved the mouse
     * over a panel.
     *
     * @return true if they stay in this frame: {@link #panel} returns false then
     */
    boolean keep();

    /**
     * Begins a panel with a title bar by which the user can fold it. Call {@link #endPanel} in any
     * case.
     *
     * @param title heading; also what tells panels apart, at most 60 letters
     * @param left its left edge
     * @param top its upper edge
     * @param panelWidth its width
     * @param panelHeight its height; what does not fit scrolls
     * @return false if it is folded, or stays by {@link #keep}: leave its widgets out
     */
    boolean panel(String title, double left, double top, double panelWidth, double panelHeight);

    /** Ends the panel. */
    void endPanel();

    /**
     * Puts the next widgets beside each other.
     *
     * @param columns how many to a row, at least 1; widgets of their own row such as {@link
     *     #slider} and {@link #text} end this
     */
    void columns(int columns);

    /**
     * One line of text.
     *
     * @param text the text, cut off where the panel ends
     */
    void label(CharSequence text);

    /**
     * One line of text in a colour.
     *
     * @param text the text
     * @param rgb 0xRRGGBB in sRGB
     */
    void label(CharSequence text, int rgb);

    /**
     * A name on the left and a value on the right, on a row of their own.
     *
     * @param name dimmed
     * @param value bright
     */
    void value(CharSequence name, CharSequence value);

    /**
     * A heading on a row of its own, with space above.
     *
     * @param text the heading
     */
    void heading(CharSequence text);

    /**
     * Text on as many rows of its own as it needs.
     *
     * @param text words, wrapped between them
     */
    void text(CharSequence text);

    /**
     * A button.
     *
     * @param label what is written on it
     * @return true once for each click
     */
    boolean button(String label);

    /**
     * A name on the left and a button with a value on the right, on a row of their own.
     *
     * @param label name of the value; what {@link #boundsOf} knows the button by
     * @param value what is written on the button
     * @return true once for each click
     */
    boolean valueButton(String label, CharSequence value);

    /**
     * A box to tick.
     *
     * @param label what is written beside it
     * @param checked its present state
     * @return its new state
     */
    boolean checkbox(String label, boolean checked);

    /**
     * A slider with its name on the left and its value on the right, on a row of its own. Where
     * {@code min > 0} and {@code max > 1000 min} it is logarithmic.
     *
     * @param label name of the value
     * @param value present value, shown even where it lies outside the bounds
     * @param min left end
     * @param max right end, above min
     * @param step the value is a multiple of this; 0 = any value, rounded to three digits
     * @param hint shown while the mouse is over it, such as meaning and unit; may be empty
     * @return the value, moved by the user or the same bits as before
     */
    double slider(String label, double value, double min, double max, double step, String hint);

    /**
     * Whether the user holds a slider of the present panel with the mouse, moved or not.
     *
     * @param label name of the slider
     * @return true from the press on until the frame after the release
     */
    boolean isHeld(String label);

    /**
     * A list that opens on a click, on a row of its own.
     *
     * @param label its name
     * @param options what can be chosen
     * @param selected index of what is chosen
     * @return index of what is chosen now
     */
    int choice(String label, List<String> options, int selected);

    /**
     * A line of a list that can be chosen.
     *
     * @param label what is written on it
     * @param selected whether it is the chosen one
     * @param hint shown while the mouse is over it; may be empty
     * @return true once when the user chooses it
     */
    boolean item(String label, boolean selected, String hint);

    /**
     * A line of a list with a picture before it; a click on either chooses it.
     *
     * @param label what is written on it
     * @param selected whether it is the chosen one
     * @param hint shown while the mouse is over it; may be empty
     * @param picture what is shown, as 16:9
     * @return true once when the user chooses it
     */
    boolean item(String label, boolean selected, String hint, Part picture);

    /**
     * A part of a picture; made once, not in each frame.
     *
     * @param sheet the whole picture
     * @param left pixels from its left edge
     * @param top pixels from its upper edge
     * @param width pixels
     * @param height pixels
     */
    record Part(Texture sheet, int left, int top, int width, int height) {
        /** Checks that it lies on the sheet. */
        public Part {
            if (left < 0
                    || top < 0
                    || width < 1
                    || height < 1
                    || left + width > sheet.width()
                    || top + height > sheet.height()) {
                throw new IllegalArgumentException(
                        "part is %d x %d at %d, %d, expected inside of %d x %d of %s"
                                .formatted(
                                        width,
                                        height,
                                        left,
                                        top,
                                        sheet.width(),
                                        sheet.height(),
                                        sheet));
            }
        }
    }

    /**
     * A heading that opens and closes what is below it.
     *
     * @param title the heading; its state is kept by this name
     * @param open whether it is open the first time
     * @return true if it is open: draw what is below, then call {@link #endSection}
     */
    boolean section(String title, boolean open);

    /** Ends an open section; not to be called for a closed one. */
    void endSection();

    /**
     * A curve, with its name above.
     *
     * @param label its name
     * @param value the present value, written on the right
     * @param values a ring of values, not changed meanwhile
     * @param first index of the oldest
     * @param count how many, at most {@code values.length}; values that are NaN are left out
     * @param rgb colour of the curve
     */
    void plot(String label, CharSequence value, float[] values, int first, int count, int rgb);

    /**
     * A line of text that the user can edit, on a row of its own. While it is edited, keys go to
     * it.
     *
     * @param label its name; what tells fields apart
     * @param content present text
     * @return the text, edited or the same object
     */
    default String textField(String label, String content) {
        return textField(label, content, false);
    }

    /**
     * A field whose name can be marked.
     *
     * @param label its name; what tells fields apart
     * @param content present text
     * @param doubtful whether the name is written in red: the text means nothing, so that what it
     *     stands for is still as before
     * @return the text, edited or the same object
     */
    String textField(String label, String content, boolean doubtful);

    /**
     * A cross over the picture, outside all panels.
     *
     * @param x its centre
     * @param y its centre
     * @param rgb its colour
     */
    void cross(double x, double y, int rgb);

    /**
     * How many texts of the last frame did not fit their place and ended in "...", for tests.
     *
     * @return the count
     */
    int shortened();

    /**
     * How many pairs of panels overlapped in the last frame, for tests.
     *
     * @return the count
     */
    int overlapping();

    /**
     * How many frames so far differed from the frame before; the others are drawn from what is in
     * graphics memory already. For tests.
     *
     * @return the count
     */
    long changes();

    /**
     * How many draw calls the panels of the last frame took, for tests.
     *
     * @return the count
     */
    int draws();

    /**
     * Where a widget was drawn last, for tests and guided tours.
     *
     * @param label what was passed to the call that drew it
     * @return left, top, width, height in logical pixels, or null if it was never drawn; the part
     *     that the user can move for a slider
     */
    double @Nullable [] boundsOf(String label);
}
