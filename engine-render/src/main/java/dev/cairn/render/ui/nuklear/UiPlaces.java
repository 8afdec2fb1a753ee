package dev.cairn.render.ui.nuklear;

import org.jspecify.annotations.Nullable;
import org.lwjgl.nuklear.NkRect;

import java.util.HashMap;
import java.util.Map;

/** Where widgets and panels were drawn last, by label. Logical pixels. */
final class UiPlaces {
    private final Map<String, double[]> known = new HashMap<>();

    /** Remembers it; what is returned stays the same array for the same label. */
    double[] put(String label, double left, double top, double width, double height) {
        double[] at = known.get(label);
        if (at == null) {
            at = new double[4];
            known.put(label, at);
        }
        at[0] = left;
        at[1] = top;
        at[2] = width;
        at[3] = height;
        return at;
    }

    /** The same, of real pixels; so many of them are a logical one. */
    double[] put(String label, NkRect pixels, double scale) {
        double s = scale;
        return put(label, pixels.x() / s, pixels.y() / s, pixels.w() / s, pixels.h() / s);
    }

    /** Left, top, width, height in an array of its own; null if it was never drawn. */
    double @Nullable [] of(String label) {
        double[] at = known.get(label);
        return at == null ? null : at.clone();
    }
}
