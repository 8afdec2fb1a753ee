package dev.cairn.samples.scenefile;

import com.google.gson.JsonParseException;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;

import dev.cairn.samples.Nearest;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A value of a JSON document that knows where it stands, so that whoever finds it wrong can say so.
 * Numbers stay the text of the file until they are asked for.
 */
final class JsonNode {
    /** Gson tells its place only in words: "... at line 3 column 7 path $.entities[2]". */
    private static final Pattern PLACE =
            Pattern.compile("(?s)(.*?)\\s*at line (\\d+) column \\d+ path (\\S*).*");

    private static final int SHOWN = 40;

    private final String file;
    private final int line;
    private final String path;

    /** A Map, a List, a Literal, a String, a Boolean, or {@code Null}. */
    private final Object value;

    private record Literal(String text) {}

    private enum Null {
        NULL
    }

    private JsonNode(String file, int line, String path, Object value) {
        this.file = file;
        this.line = line;
        this.path = path;
        this.value = value;
    }

    /**
     * Parses a document: strict JSON, one value, no name twice in an object.
     *
     * @param file name for messages
     * @param text what is in it
     * @return the document's value
     * @throws SceneFileException if it is no JSON
     */
    static JsonNode parse(String file, String text) {
        JsonReader in = new JsonReader(new StringReader(text));
        in.setStrictness(Strictness.STRICT);
        try {
            JsonNode root = read(file, in, "$");
            if (in.peek() != JsonToken.END_DOCUMENT) {
                throw new SceneFileException(
                        file,
                        lineOf(in),
                        "$",
                        "expected the end of the file, found more after the document",
                        null);
            }
            return root;
        } catch (IOException | JsonParseException | IllegalStateException malformed) {
            String said = String.valueOf(malformed.getMessage()).lines().findFirst().orElse("");
            Matcher place = PLACE.matcher(said);
            boolean known = place.matches();
            throw new SceneFileException(
                    file,
                    known ? Integer.parseInt(place.group(2)) : lineOf(in),
                    known && !place.group(3).isEmpty() ? place.group(3) : "$",
                    "expected JSON (RFC 8259), found: " + (known ? place.group(1) : said),
                    malformed);
        }
    }

    private static int lineOf(JsonReader in) {
        Matcher place = PLACE.matcher(in.toString());
        return place.matches() ? Integer.parseInt(place.group(2)) : 0;
    }

    private static JsonNode read(String file, JsonReader in, String path) throws IOException {
        JsonToken token = in.peek();
        int line = lineOf(in);
        Object value =
                switch (token) {
                    case BEGIN_OBJECT -> object(file, in, path);
                    case BEGIN_ARRAY -> array(file, in, path);
                    case NUMBER -> new Literal(in.nextString());
                    case STRING -> in.nextString();
                    case BOOLEAN -> in.nextBoolean();
                    case NULL -> {
                        in.nextNull();
                        yield Null.NULL;
                    }
                    default ->
                            throw new SceneFileException(
                                    file, line, path, "expected a value, found " + token, null);
                };
        return new JsonNode(file, line, path, value);
    }

    private static Map<String, JsonNode> object(String file, JsonReader in, String path)
            throws IOException {
        Map<String, JsonNode> fields = new LinkedHashMap<>();
        in.beginObject();
        while (in.hasNext()) {
            String name = in.nextName();
            JsonNode field = read(file, in, path + "." + name);
            if (fields.put(name, field) != null) {
                throw field.wrong("each field once", "\"" + name + "\" again");
            }
        }
        in.endObject();
        return fields;
    }

    private static List<JsonNode> array(String file, JsonReader in, String path)
            throws IOException {
        List<JsonNode> items = new ArrayList<>();
        in.beginArray();
        while (in.hasNext()) {
            items.add(read(file, in, path + "[" + items.size() + "]"));
        }
        in.endArray();
        return items;
    }

    /** The exception for this place; the caller throws it. */
    SceneFileException wrong(String expected, String found) {
        return new SceneFileException(
                file, line, path, "expected " + expected + ", found " + found, null);
    }

    /** The exception for a value that was refused further on, in the words of the refusal. */
    SceneFileException refused(RuntimeException cause) {
        return new SceneFileException(file, line, path, String.valueOf(cause.getMessage()), cause);
    }

    /** The value in a few words, for messages. */
    String shown() {
        return switch (value) {
            case Map<?, ?> fields -> "an object with " + names(fields);
            case List<?> items -> "a list of " + items.size();
            case Literal(String text) -> cut(text);
            case String text -> "\"" + cut(text) + "\"";
            case Null _ -> "null";
            default -> value.toString();
        };
    }

    private static String names(Map<?, ?> fields) {
        if (fields.isEmpty()) {
            return "no fields";
        }
        return "the fields "
                + cut(String.join(", ", fields.keySet().stream().map(String::valueOf).toList()));
    }

    private static String cut(String text) {
        String printable = text.replaceAll("\\p{Cntrl}", "?");
        return printable.length() > SHOWN ? printable.substring(0, SHOWN) + "..." : printable;
    }

    /** The fields of an object, none of which may be unknown. */
    @SuppressWarnings("unchecked") // Only object() makes maps.
    Map<String, JsonNode> fields(String what, List<String> known) {
        if (!(value instanceof Map)) {
            throw wrong(what + " as an object", shown());
        }
        Map<String, JsonNode> fields = (Map<String, JsonNode>) value;
        fields.forEach((name, field) -> {
            if (!known.contains(name)) {
                throw field.wrong(
                        "one of the fields " + String.join(", ", known) + Nearest.hint(name, known),
                        "the unknown field \"" + cut(name) + "\"");
            }
        });
        return fields;
    }

    /** A field that must be there. */
    JsonNode required(Map<String, JsonNode> fields, String name) {
        JsonNode field = fields.get(name);
        if (field == null) {
            throw wrong("a field \"" + name + "\"", shown());
        }
        return field;
    }

    @SuppressWarnings("unchecked") // Only array() makes lists.
    List<JsonNode> items(String what) {
        if (!(value instanceof List)) {
            throw wrong(what, shown());
        }
        return (List<JsonNode>) value;
    }

    boolean isObject() {
        return value instanceof Map;
    }

    String text(String what) {
        if (value instanceof String text) {
            return text;
        }
        throw wrong(what + " in quotes", shown());
    }

    boolean truth() {
        if (value instanceof Boolean truth) {
            return truth;
        }
        throw wrong("true or false", shown());
    }

    /** A finite number. */
    double number(String what) {
        if (value instanceof Literal(String text)) {
            double number = Double.parseDouble(text);
            if (Double.isFinite(number)) {
                return number;
            }
            throw wrong(what + " within +-1.797e308", shown());
        }
        throw wrong(what, shown());
    }

    double positive(String what) {
        double number = number(what + " above 0");
        if (number > 0) {
            return number;
        }
        throw wrong(what + " above 0", shown());
    }

    double atLeastZero(String what) {
        double number = number(what + " of at least 0");
        if (number >= 0) {
            return number;
        }
        throw wrong(what + " of at least 0", shown());
    }

    int whole(int min, int max) {
        String what = "a whole number from %d to %d".formatted(min, max);
        double number = number(what);
        if (number == Math.rint(number) && number >= min && number <= max) {
            return (int) number;
        }
        throw wrong(what, shown());
    }

    Xyz xyz(String what) {
        String expected = what + " as three numbers [x, y, z]";
        List<JsonNode> items = items(expected);
        if (items.size() != 3) {
            throw wrong(expected, shown());
        }
        return new Xyz(
                items.get(0).number("a number"),
                items.get(1).number("a number"),
                items.get(2).number("a number"));
    }

    /** A colour as #RRGGBB. */
    int rgb() {
        if (value instanceof String text && text.matches("#[0-9a-fA-F]{6}")) {
            return Integer.parseInt(text.substring(1), 16);
        }
        throw wrong("a colour as \"#RRGGBB\"", shown());
    }

    @Nullable String nearestOf(List<String> known) {
        return value instanceof String text ? Nearest.of(text, known) : null;
    }

    @Override
    public String toString() {
        return path + " = " + shown();
    }
}
