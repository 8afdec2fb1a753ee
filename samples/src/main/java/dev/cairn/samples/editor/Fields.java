package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Numbers as text that can be typed. While a text is no number the value stays, and the text too,
 * so that it can be finished; its name is red then. Texts are made anew only when they or their
 * values change, so that a frame in which nothing is typed makes no garbage. Window thread.
 */
final class Fields {
    /** What the user typed: its text and the value that it means, NaN where it means none. */
    private static final class Typed {
        private final String text;
        private final double meant;

        /** The value that was there, until the new one is; it stays where that is refused. */
        private double old;

        private Typed(String text, double meant, double old) {
            this.text = text;
            this.meant = meant;
            this.old = old;
        }
    }

    /** A field that nobody types into: the bits of a value, and the text that shows it. */
    private static final class Shown {
        private long bits;
        private String text = "";
    }

    private static final int NO_COLOUR = -1;

    /** Letters of a number; the longest that a double is written with has 24. */
    private static final int MOST_LETTERS = 60;

    private static final Pattern DECIMAL = Pattern.compile("[-+0-9.eE]+");

    private final Map<String, Typed> typed = new HashMap<>();
    private final Map<String, Shown> untouched = new HashMap<>();
    private final Map<String, String[]> axes = new HashMap<>();

    /** Forgets unfinished texts: something else is selected. */
    void forget() {
        typed.clear();
        untouched.clear();
    }

    /**
     * A field for a number.
     *
     * @return what was typed if it is a finite number, or the same bits as before
     */
    double number(Ui ui, String label, double value) {
        Typed before = typed(label, value);
        String shown = before == null ? untouched(label, value) : before.text;
        String now = ui.textField(label, shown, before != null && before.meant != value);
        if (now.equals(shown) || now.length() > MOST_LETTERS) {
            return value;
        }
        Double parsed = parse(now);
        typed.put(label, new Typed(now, parsed == null ? Double.NaN : parsed, value));
        return parsed == null ? value : parsed;
    }

    /** What was typed, unless the value was changed elsewhere meanwhile. */
    private @Nullable Typed typed(String label, double value) {
        Typed before = typed.get(label);
        if (before != null && value == before.meant) {
            before.old = Double.NaN;
        } else if (before != null && value != before.old) {
            typed.remove(label);
            return null;
        }
        return before;
    }

    private String untouched(String label, double value) {
        long bits = Double.doubleToRawLongBits(value);
        Shown shown = untouched.get(label);
        if (shown == null || shown.bits != bits) {
            shown = new Shown();
            shown.bits = bits;
            shown.text = text(value);
            untouched.put(label, shown);
        }
        return shown.text;
    }

    /**
     * A field for a colour, {@code #RRGGBB}.
     *
     * @return what was typed if it is a colour, or the same as before
     */
    @Nullable Integer rgb(Ui ui, String label, @Nullable Integer value) {
        int known = value == null ? NO_COLOUR : value & 0xFFFFFF;
        Typed before = typed(label, known);
        String shown = before == null ? untouchedRgb(label, known) : before.text;
        String now = ui.textField(label, shown, before != null && before.meant != known);
        if (now.equals(shown) || now.length() > MOST_LETTERS) {
            return value;
        }
        Integer parsed = parseRgb(now);
        typed.put(label, new Typed(now, parsed == null ? Double.NaN : parsed, known));
        return parsed == null ? value : parsed;
    }

    private String untouchedRgb(String label, int rgb) {
        Shown shown = untouched.get(label);
        if (shown == null || shown.bits != rgb) {
            shown = new Shown();
            shown.bits = rgb;
            shown.text = rgb == NO_COLOUR ? "" : String.format(Locale.ROOT, "#%06X", rgb);
            untouched.put(label, shown);
        }
        return shown.text;
    }

    static @Nullable Integer parseRgb(String text) {
        String digits = text.strip().replaceFirst("^#", "");
        return digits.matches("[0-9A-Fa-f]{6}") ? (Integer) Integer.parseInt(digits, 16) : null;
    }

    /**
     * Three fields, for x, y and z.
     *
     * @return what was typed, or the same object as before
     */
    Xyz xyz(Ui ui, String label, Xyz value) {
        String[] names = axes.get(label);
        if (names == null) {
            names = new String[] {label + " x", label + " y", label + " z"};
            axes.put(label, names);
        }
        double x = number(ui, names[0], value.x());
        double y = number(ui, names[1], value.y());
        double z = number(ui, names[2], value.z());
        boolean same =
                Double.compare(x, value.x()) == 0
                        && Double.compare(y, value.y()) == 0
                        && Double.compare(z, value.z()) == 0;
        return same ? value : new Xyz(x, y, z);
    }

    /** A number in decimals, with a point or a comma; -0 is 0. Null for what is none. */
    static @Nullable Double parse(String text) {
        String digits = text.strip().replace(',', '.');
        if (!DECIMAL.matcher(digits).matches()) {
            return null;
        }
        try {
            double value = Double.parseDouble(digits) + 0.0; // -0 + 0 = 0
            return Double.isFinite(value) ? value : null;
        } catch (NumberFormatException unfinished) {
            return null;
        }
    }

    /** Up to six decimals: enough to read, and not what is stored. */
    static String text(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e9) {
            return Long.toString((long) value);
        }
        if (Math.abs(value) >= 1e9 || Math.abs(value) < 1e-5) {
            return Double.toString(value);
        }
        return String.format(Locale.ROOT, "%.6f", value).replaceAll("0+$", "");
    }
}
