package dev.cairn.samples.accuracy;

import dev.cairn.samples.accuracy.AccuracyCase.Metric;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Writes rows as Markdown and as CSV. Stateless. */
final class AccuracyText {
    private AccuracyText() {}

    /** Three digits at most: 0, 1.23, 1.2e-7; – where nothing was run or nothing can be said. */
    static String number(double value) {
        if (Double.isNaN(value)) {
            return "–";
        }
        if (Double.isInfinite(value)) {
            return value > 0 ? "fails" : "-∞";
        }
        if (value == 0) {
            return "0";
        }
        double size = Math.abs(value);
        if (size >= 0.01 && size < 1000) {
            return String.format(
                    Locale.ROOT, size < 0.1 ? "%.4f" : size < 10 ? "%.3f" : "%.1f", value);
        }
        return String.format(Locale.ROOT, "%.1e", value).replace("e-0", "e-").replace("e+0", "e");
    }

    static String csv(List<AccuracyRow> rows) {
        StringBuilder text = new StringBuilder("case,metric,unit");
        for (int n : AccuracyCommand.SUBSTEPS) {
            text.append(",substeps_").append(n);
        }
        text.append(",bar,holds,micros_per_body_step\n");
        for (AccuracyRow row : rows) {
            for (int m = 0; m < row.of().metrics().size(); m++) {
                Metric metric = row.of().metrics().get(m);
                text.append(row.of().id()).append(",\"").append(metric.name()).append("\",");
                text.append(metric.unit());
                for (int n : AccuracyCommand.SUBSTEPS) {
                    double[] at = row.values().get(n);
                    text.append(',').append(at == null ? "" : Double.toString(at[m]));
                }
                text.append(',').append(metric.bar()).append(',').append(row.holds(m));
                text.append(',').append(row.micros()).append('\n');
            }
        }
        return text.toString();
    }

    /** The tables, a group of cases each, then what each case is. */
    static String markdown(List<AccuracyRow> rows) {
        StringBuilder text = new StringBuilder();
        String group = "";
        for (AccuracyRow row : rows) {
            String now = row.of().id().substring(0, 1);
            if (!now.equals(group)) {
                group = now;
                text.append("\n## ").append(group).append(". ").append(groupName(group));
                text.append("\n\n| case | error | 1 | 2 | 4 | 8 | 16 | bar | holds | µs |");
                text.append(" best published |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
            }
            for (int m = 0; m < row.of().metrics().size(); m++) {
                line(text, row, m);
            }
        }
        text.append("\n## What each case is\n\n| case | set-up | truth |\n|---|---|---|\n");
        for (AccuracyRow row : rows) {
            text.append("| ").append(row.of().id()).append(" | ").append(row.of().setup());
            text.append(" | ").append(row.of().truth()).append(" |\n");
        }
        return text.toString();
    }

    private static void line(StringBuilder text, AccuracyRow row, int m) {
        Metric metric = row.of().metrics().get(m);
        List<String> cells = new ArrayList<>();
        cells.add(m == 0 ? row.of().id() + " " + row.of().title() : "");
        cells.add(metric.name() + (metric.unit().isEmpty() ? "" : ", " + metric.unit()));
        for (int n : AccuracyCommand.SUBSTEPS) {
            double[] at = row.values().get(n);
            cells.add(at == null ? "" : number(at[m]));
        }
        boolean judged = Double.isFinite(metric.bar());
        cells.add(judged ? number(metric.bar()) : "");
        cells.add(judged ? row.holds(m) ? "yes" : "**no**" : "");
        cells.add(m == 0 ? number(row.micros()) : "");
        cells.add(m == 0 ? row.of().published() : "");
        text.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    private static String groupName(String letter) {
        return switch (letter) {
            case "A" -> "Free motion";
            case "B" -> "Impact";
            case "C" -> "Friction";
            case "D" -> "Rocking and spinning bodies";
            case "E" -> "Stacks, piles, structures";
            case "F" -> "Fast and spinning bodies";
            case "H" -> "Scale, place, mirror";
            case "I" -> "Conservation";
            default -> letter;
        };
    }
}
