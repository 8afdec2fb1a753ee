package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.Objects;

/** Where two states differ. */
final class Differences {
    private Differences() {}

    /** The first difference, as a sentence; null if there is none. */
    static @Nullable String first(WorldState a, WorldState b) {
        int common = Math.min(a.entries, b.entries);
        for (int e = 0; e < common; e++) {
            if (!a.names[e].equals(b.names[e]) || a.kinds[e] != b.kinds[e]) {
                return "one has " + a.path(e) + " where the other has " + b.path(e);
            }
            String found = entry(a, e, b, e);
            if (found != null) {
                return found;
            }
        }
        if (a.entries != b.entries) {
            WorldState longer = a.entries > b.entries ? a : b;
            return "only one of them has " + longer.path(common);
        }
        return null;
    }

    /** The same among entries whose path begins with a prefix. */
    static @Nullable String within(WorldState a, WorldState b, String prefix) {
        int k = 0;
        for (int e = 0; e < a.entries; e++) {
            if (!a.path(e).startsWith(prefix)) {
                continue;
            }
            while (k < b.entries && !b.path(k).equals(a.path(e))) {
                k++;
            }
            if (k == b.entries) {
                return "only one of them has " + a.path(e);
            }
            String found = entry(a, e, b, k++);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private static @Nullable String entry(WorldState a, int e, WorldState b, int f) {
        if (a.kinds[e] == WorldState.SECTION) {
            return null;
        }
        int width = WorldState.WIDTH[a.kinds[e]];
        int count = Math.min(a.counts[e], b.counts[f]);
        if (width == 0) {
            for (int i = 0; i < count; i++) {
                Object x = a.objects[a.at[e] + i];
                Object y = b.objects[b.at[f] + i];
                if (!Objects.equals(x, y)) {
                    return element(a, e, i) + ": " + x + " and " + y;
                }
            }
        } else {
            int length = width * count;
            int at =
                    Arrays.mismatch(
                            a.bytes, a.at[e], a.at[e] + length, b.bytes, b.at[f], b.at[f] + length);
            if (at >= 0) {
                int i = at / width;
                return element(a, e, i) + ": " + text(a, e, i) + " and " + text(b, f, i);
            }
        }
        return a.counts[e] == b.counts[f]
                ? null
                : a.path(e) + " has " + a.counts[e] + " and " + b.counts[f] + " elements";
    }

    private static String element(WorldState s, int e, int i) {
        return s.kinds[e] <= WorldState.REFERENCE ? s.path(e) : s.path(e) + "[" + i + "]";
    }

    private static String text(WorldState s, int e, int i) {
        int at = s.at[e] + WorldState.WIDTH[s.kinds[e]] * i;
        return switch (s.kinds[e]) {
            case WorldState.INT, WorldState.INTS ->
                    Integer.toString(s.memory.get(StateWriter.INTS, at));
            case WorldState.LONG, WorldState.LONGS ->
                    Long.toString(s.memory.get(StateWriter.LONGS, at));
            case WorldState.DOUBLE, WorldState.DOUBLES ->
                    Double.toString(s.memory.get(StateWriter.DOUBLES, at));
            case WorldState.FLOATS -> Float.toString(s.memory.get(StateWriter.FLOATS, at));
            default -> Byte.toString(s.bytes[at]);
        };
    }
}
