package dev.cairn.samples;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Locale;

/** Finds what the user may have meant, by edit distance. Stateless. */
public final class Nearest {
    private Nearest() {}

    /**
     * Words the suggestion.
     *
     * @param typed what the user wrote
     * @param known what it may have been
     * @return {@code " (did you mean X?)"}, or nothing if nothing is near
     */
    public static String hint(String typed, List<String> known) {
        String nearest = of(typed, known);
        return nearest == null ? "" : " (did you mean " + nearest + "?)";
    }

    /**
     * Finds the known word that is nearest to what was typed.
     *
     * @param typed what the user wrote
     * @param known what it may have been
     * @return the nearest, or null if all are far away
     */
    public static @Nullable String of(String typed, List<String> known) {
        String wanted = typed.toLowerCase(Locale.ROOT);
        String best = null;
        int bestDistance = Integer.MAX_VALUE;
        for (String word : known) {
            int distance =
                    word.startsWith(wanted) || (word.contains(wanted) && wanted.length() > 2)
                            ? 1
                            : distance(wanted, word);
            if (distance < bestDistance) {
                bestDistance = distance;
                best = word;
            }
        }
        return bestDistance <= Math.max(2, typed.length() / 2) ? best : null;
    }

    /** Levenshtein's distance, by the two-row table of Wagner and Fischer (1974). */
    static int distance(String a, String b) {
        int[] previous = new int[b.length() + 1];
        int[] current = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            current[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                current[j] = Math.min(replaced, 1 + Math.min(previous[j], current[j - 1]));
            }
            int[] swap = previous;
            previous = current;
            current = swap;
        }
        return previous[b.length()];
    }
}
