package dev.cairn.samples.editor;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Numbers as text that can be typed. While a text is no number the value stays, and the text too,
 * so that it can be finished. Window thread.
 */
final class Fields {
    private final Map<String, String> typed = new HashMap<>();

    /** Forgets unfinished texts: something else is selected. */
    void forget() {
        typed.clear();
    }

    /**
     * A field for a number.
     *
     * @return what was typed if it is a finite number, or the same bits as before
     */
    double number(Ui ui, String label, double value) {
        String shown = typed.get(label);
        Double meant = shown == null ? null : parse(shown);
        if (shown == null || (meant != null && meant != value)) {
            // Untouched, or changed elsewhere meanwhile.
            typed.remove(label);
            shown = text(value);
        }
        String now = ui.textField(label, shown);
        if (now.equals(shown)) {
            return value;
        }
        typed.put(label, now);
        Double parsed = parse(now);
        return parsed == null ? value : parsed;
    }

    /**
     * A field for a colour, {@code #RRGGBB}.
     *
     * @return what was typed if it is a colour, or the same as before
     */
    @Nullable Integer rgb(Ui ui, String label, @Nullable Integer value) {
        String shown = typed.get(label);
        Integer meant = shown == null ? null : parseRgb(shown);
        if (shown == null || (meant != null && !meant.equals(value))) {
            typed.remove(label);
            shown = value == null ? "" : String.format(Locale.ROOT, "#%06X", value & 0xFFFFFF);
        }
        String now = ui.textField(label, shown);
        if (now.equals(shown)) {
            return value;
        }
        typed.put(label, now);
        Integer parsed = parseRgb(now);
        return parsed == null ? value : parsed;
    }

    static @Nullable Integer parseRgb(String text) {
        String digits = text.strip().replaceFirst("^#", "");
        return digits.matches("[0-9A-Fa-f]{6}") ? (Integer) Integer.parseInt(digits, 16) : null;
    }

    /** Three fields, for x, y and z. */
    Xyz xyz(Ui ui, String label, Xyz value) {
        double x = number(ui, label + " x", value.x());
        double y = number(ui, label + " y", value.y());
        double z = number(ui, label + " z", value.z());
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
