package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;

import java.util.List;
import java.util.SplittableRandom;

/**
 * Panels without a window in which all sections are open, and one widget of a frame is used: a
 * button is clicked, a box ticked, a slider moved, a field typed into.
 */
final class RandomUi implements Ui {
    /** What people, and people who mean harm, type into fields. */
    static final List<String> TYPED =
            List.of(
                    "",
                    "0",
                    "-0",
                    "1",
                    "2",
                    "0.3",
                    "-1",
                    "10",
                    "0.001",
                    "1e-6",
                    "1e-9",
                    "1e-300",
                    "4.9e-324",
                    "1e6",
                    "1e9",
                    "-1e9",
                    "1e16",
                    "1e150",
                    "1e300",
                    "-1e300",
                    "1.7976931348623157e308",
                    "NaN",
                    "Infinity",
                    "1,5",
                    "1e",
                    "--",
                    "#FF8800",
                    "#12",
                    "\u0000",
                    "ünï \ud83d\ude00 \u202e",
                    "\ud83d",
                    "a\nb\t\"c\\",
                    "%s %d %n",
                    "x.json",
                    "y.json",
                    "sub/z.json",
                    "none/z.json",
                    "wrong.json",
                    "\u0000.json",
                    "tetra.obj",
                    "wrong.obj",
                    "wrong.png",
                    "builtin:wood",
                    "x".repeat(100));

    private final double width;
    private final double height;
    private SplittableRandom random = new SplittableRandom(0);
    private int wanted;
    private int widgets;
    private int widgetsBefore = 1;
    private String used = "";

    RandomUi(double width, double height) {
        this.width = width;
        this.height = height;
    }

    /** The next frame: uses one of the widgets, or none if the number is negative. */
    void begin(SplittableRandom numbers, boolean uses) {
        random = numbers;
        wanted = uses ? numbers.nextInt(Math.max(1, widgets)) : -1;
        widgetsBefore = widgets;
        widgets = 0;
        used = "";
    }

    /** What was used in this frame. */
    String used() {
        return used;
    }

    int widgets() {
        return widgetsBefore;
    }

    private boolean uses(String kind, String label) {
        // A folder: what is saved shall stay in that of the test.
        boolean is = widgets++ == wanted && !label.endsWith("/") && !label.startsWith("Up");
        used = is ? kind + " \"" + label + "\"" : used;
        return is;
    }

    @Override
    public double width() {
        return width;
    }

    @Override
    public double height() {
        return height;
    }

    @Override
    public double scale() {
        return 1;
    }

    @Override
    public boolean keep() {
        return false;
    }

    @Override
    public boolean panel(String title, double x, double y, double wide, double high) {
        return true;
    }

    @Override
    public void endPanel() {}

    @Override
    public void columns(int columns) {}

    @Override
    public void label(CharSequence text) {
        text.length();
    }

    @Override
    public void label(CharSequence text, int rgb) {
        text.length();
    }

    @Override
    public void value(CharSequence name, CharSequence value) {
        value.length();
    }

    @Override
    public void heading(CharSequence text) {
        text.length();
    }

    @Override
    public void text(CharSequence text) {
        text.length();
    }

    @Override
    public boolean button(String label) {
        return uses("button", label);
    }

    @Override
    public boolean valueButton(String label, CharSequence value) {
        return uses("button", label);
    }

    @Override
    public boolean checkbox(String label, boolean checked) {
        return uses("box", label) != checked;
    }

    @Override
    public double slider(
            String label, double value, double min, double max, double step, String hint) {
        if (!uses("slider", label)) {
            return value;
        }
        double to =
                random.nextInt(4) == 0
                        ? min
                        : random.nextInt(4) == 0 ? max : random.nextDouble(min, max);
        to = step > 0 ? Math.rint(to / step) * step : to;
        used += " to " + to;
        return to;
    }

    @Override
    public boolean isHeld(String label) {
        return false;
    }

    @Override
    public int choice(String label, List<String> options, int selected) {
        int to = uses("choice", label) ? random.nextInt(options.size()) : selected;
        used = to != selected ? used + " to " + options.get(to) : used;
        return to;
    }

    @Override
    public boolean item(String label, boolean selected, String hint) {
        return uses("item", label);
    }

    @Override
    public boolean item(String label, boolean selected, String hint, Part picture) {
        return uses("item", label);
    }

    @Override
    public boolean section(String title, boolean open) {
        return true;
    }

    @Override
    public void endSection() {}

    @Override
    public void plot(
            String label, CharSequence value, float[] values, int first, int count, int rgb) {}

    @Override
    public String textField(String label, String content, boolean doubtful) {
        if (!uses("field", label)) {
            return content;
        }
        String typed = TYPED.get(random.nextInt(TYPED.size()));
        used += " is made \"" + typed + "\"";
        return typed;
    }

    @Override
    public void cross(double x, double y, int rgb) {}

    @Override
    public int shortened() {
        return 0;
    }

    @Override
    public int overlapping() {
        return 0;
    }

    @Override
    public long changes() {
        return 0;
    }

    @Override
    public int draws() {
        return 0;
    }

    @Override
    public double[] boundsOf(String label) {
        return null;
    }
}
