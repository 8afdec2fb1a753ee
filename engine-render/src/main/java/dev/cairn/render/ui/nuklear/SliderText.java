package dev.cairn.render.ui.nuklear;

import dev.cairn.render.ui.TextBuffer;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** Numbers as a slider shows them, made anew only when they change; whole ones without garbage. */
final class SliderText {
    private static final class Entry {
        private double value = Double.NaN;
        private final TextBuffer text = new TextBuffer();
    }

    private final Map<String, Entry> known = new HashMap<>();

    CharSequence of(String label, double value) {
        Entry entry = known.computeIfAbsent(label, key -> new Entry());
        if (entry.value != value) {
            entry.value = value;
            entry.text.clear();
            if (value == Math.rint(value) && Math.abs(value) < 1e6) {
                entry.text.put((long) value);
            } else {
                entry.text.put(text(value));
            }
        }
        return entry.text;
    }

    private static String text(double value) {
        double size = Math.abs(value);
        if (size >= 1e5 || size < 1e-3) {
            return String.format(Locale.ROOT, "%.2e", value);
        }
        return String.format(Locale.ROOT, "%.4g", value)
                .replaceAll("(\\.\\d*?)0+$", "$1")
                .replaceAll("\\.$", "");
    }

    /** The nearest multiple of the step, or three digits where the step is 0. */
    static double round(double value, double step) {
        if (step > 0) {
            return Math.rint(value / step) * step;
        }
        if (value == 0) {
            return 0;
        }
        double unit = Math.pow(10, Math.floor(Math.log10(Math.abs(value))) - 2);
        return Math.rint(value / unit) * unit;
    }
}
