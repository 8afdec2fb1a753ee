package dev.cairn.samples;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes reports: as a table for people, as JSON for programs. Stateless. */
final class ReportText {
    private static final Gson GSON =
            new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

    private ReportText() {}

    /**
     * Returns the JSON of one report as an object, of several as an array; ends in a line break.
     */
    static String json(List<SceneReport> reports) {
        JsonElement root;
        if (reports.size() == 1) {
            root = object(reports.get(0));
        } else {
            JsonArray array = new JsonArray();
            reports.forEach(report -> array.add(object(report)));
            root = array;
        }
        return GSON.toJson(root) + "\n";
    }

    private static JsonObject object(SceneReport report) {
        JsonObject object = new JsonObject();
        object.addProperty("scene", report.scene());
        JsonObject parameters = new JsonObject();
        for (Map.Entry<String, Object> entry : report.parameters().entrySet()) {
            if (entry.getValue() instanceof Number number) {
                parameters.add(entry.getKey(), number(number.doubleValue()));
            } else {
                parameters.addProperty(entry.getKey(), entry.getValue().toString());
            }
        }
        object.add("parameters", parameters);
        object.addProperty("bodies", report.bodies());
        object.addProperty("ticks", report.ticks());
        object.addProperty("workers", report.workers());
        object.addProperty("lanes", report.lanes());
        object.add("tickMillisMedian", number(report.tickMillisMedian()));
        object.add("tickMillisP99", number(report.tickMillisP99()));
        object.addProperty("contacts", report.contacts());
        object.add("kineticEnergy", number(report.kineticEnergy()));
        object.add("maxPenetrationMetres", number(report.maxPenetrationMetres()));
        JsonObject errors = new JsonObject();
        report.errors().forEach((name, value) -> errors.add(name, number(value)));
        object.add("errors", errors);
        object.addProperty("digest", report.digest());
        object.add("allocatedBytesPerTick", number(report.allocatedBytesPerTick()));
        object.add("stageMicros", micros(report.stageMicros()));
        object.add("systemMicros", micros(report.systemMicros()));
        return object;
    }

    private static JsonObject micros(Map<String, Double> times) {
        JsonObject object = new JsonObject();
        times.forEach((name, value) -> object.add(name, number(Math.rint(1e3 * value) / 1e3)));
        return object;
    }

    /**
     * JSON has no NaN and no infinity; both become null. Whole numbers are written without a point.
     */
    private static JsonElement number(double value) {
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return JsonNull.INSTANCE;
        }
        boolean whole = value == Math.rint(value) && Math.abs(value) < 1e15;
        return whole ? new JsonPrimitive((long) value) : new JsonPrimitive(value);
    }

    /** Returns the table, one line per report; ends in a line break. */
    static String table(List<SceneReport> reports) {
        List<String[]> rows = new ArrayList<>();
        rows.add(
                new String[] {
                    "scene",
                    "bodies",
                    "ticks",
                    "ms/tick",
                    "p99 ms",
                    "contacts",
                    "energy J",
                    "overlap mm",
                    "B/tick",
                    "digest",
                    "errors"
                });
        for (SceneReport report : reports) {
            rows.add(
                    new String[] {
                        report.scene(),
                        Integer.toString(report.bodies()),
                        Integer.toString(report.ticks()),
                        fixed(3, report.tickMillisMedian()),
                        fixed(3, report.tickMillisP99()),
                        Integer.toString(report.contacts()),
                        digits(report.kineticEnergy()),
                        digits(1000 * report.maxPenetrationMetres()),
                        fixed(0, report.allocatedBytesPerTick()),
                        report.digest(),
                        errors(report)
                    });
        }
        return layOut(rows);
    }

    private static String errors(SceneReport report) {
        List<String> parts = new ArrayList<>();
        report.errors().forEach((name, value) -> parts.add(name + " " + digits(value)));
        return parts.isEmpty() ? "-" : String.join(", ", parts);
    }

    private static String fixed(int places, double value) {
        return String.format(Locale.ROOT, "%." + places + "f", value);
    }

    /** Three digits, in whatever notation is short. */
    private static String digits(double value) {
        if (value == 0) {
            return "0";
        }
        double size = Math.abs(value);
        return String.format(Locale.ROOT, size >= 1e5 || size < 1e-3 ? "%.1e" : "%.3g", value);
    }

    /**
     * Columns as wide as their widest cell; numbers to the right, the first and the last two
     * columns to the left.
     */
    private static String layOut(List<String[]> rows) {
        int columns = rows.get(0).length;
        int[] widths = new int[columns];
        for (String[] row : rows) {
            for (int c = 0; c < columns; c++) {
                widths[c] = Math.max(widths[c], row[c].length());
            }
        }
        StringBuilder text = new StringBuilder();
        for (String[] row : rows) {
            StringBuilder line = new StringBuilder();
            for (int c = 0; c < columns; c++) {
                String padding = " ".repeat(widths[c] - row[c].length());
                boolean left = c == 0 || c >= columns - 2;
                line.append(left ? row[c] + padding : padding + row[c]).append("  ");
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }
}
