package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Numbers as text that can be typed. While a text is no number the value stays, and the text too,
 * so that it can be finished. Texts are made anew only when they or their values change, so that a
 * frame in which nothing is typed makes no garbage. Window thread.
 */
final class Fields {
    /** What the user typed: its text and the value that it means, NaN where it means none. */
    private record Typed(String text, double value) {}

    /** A field that nobody types into: the bits of a value, and the text that shows it. */
    private static final class Shown {
        private long bits;
        private String text = "";
    }

    private static final int NO_COLOUR = -1;

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
        Typed before = typed.get(label);
        if (before != null && !Double.isNaN(before.value) && before.value != value) {
            // Changed elsewhere meanwhile.
            typed.remove(label);
            before = null;
        }
        String shown = before == null ? untouched(label, value) : before.text;
        String now = ui.textField(label, shown);
        if (now.equals(shown)) {
            return value;
        }
        Double parsed = parse(now);
        typed.put(label, new Typed(now, parsed == null ? Double.NaN : parsed));
        return parsed == null ? value : parsed;
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
        Typed before = typed.get(label);
        if (before != null && !Double.isNaN(before.value) && before.value != known) {
            typed.remove(label);
            before = null;
        }
        String shown = before == null ? untouchedRgb(label, known) : before.text;
        String now = ui.textField(label, shown);
        if (now.equals(shown)) {
            return value;
        }
        Integer parsed = parseRgb(now);
        typed.put(label, new Typed(now, parsed == null ? Double.NaN : parsed));
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

    static @Nullable Double parse(String text) {
        try {
            double value = Double.parseDouble(text.strip());
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
