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

    /** Gson tells its caller how to read what is no JSON; the author of a file cannot. */
    private static final Pattern SETTING =
            Pattern.compile("Use JsonReader\\.setStrictness\\(\\S+ to accept |\\s*See http\\S*");

    private static final int SHOWN = 40;

    /** Values in a document: some 110 bytes each. */
    private static final int MAX_VALUES = 4_000_000;

    private final Document document;

    /** How many values of the document begin before this one. */
    private final int ordinal;

    private final @Nullable JsonNode parent;

    /** Its name in the parent, or null, and its place in the parent's list. */
    private final @Nullable String name;

    private final int index;

    /** A Map, a List, a Literal, a String, a Boolean, or {@code Null}. */
    private Object value = Null.NULL;

    private record Literal(String text) {}

    /** What is read. Where a value stands is found when it is asked for, by reading again. */
    private static final class Document {
        final String file;
        final String text;
        int values;

        Document(String file, String text) {
            this.file = file;
            this.text = text;
        }

        JsonReader reader() {
            JsonReader in = new JsonReader(new StringReader(text));
            in.setStrictness(Strictness.STRICT);
            return in;
        }

        /** The line of a value, from 1; 0 if it is not found. */
        int line(int ordinal) {
            JsonReader in = reader();
            try {
                for (int n = -1; ; ) {
                    JsonToken token = in.peek();
                    boolean isValue =
                            switch (token) {
                                case NAME, END_OBJECT, END_ARRAY, END_DOCUMENT -> false;
                                default -> true;
                            };
                    if (token == JsonToken.END_DOCUMENT || (isValue && ++n == ordinal)) {
                        return lineOf(in);
                    }
                    switch (token) {
                        case BEGIN_OBJECT -> in.beginObject();
                        case END_OBJECT -> in.endObject();
                        case BEGIN_ARRAY -> in.beginArray();
                        case END_ARRAY -> in.endArray();
                        default -> in.skipValue();
                    }
                }
            } catch (IOException | JsonParseException | IllegalStateException malformed) {
                return lineOf(in);
            }
        }
    }

    private enum Null {
        NULL
    }

    private JsonNode(
            Document document, @Nullable JsonNode parent, @Nullable String name, int index) {
        this.document = document;
        this.parent = parent;
        this.name = name;
        this.index = index;
        ordinal = document.values++;
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
        Document document = new Document(file, text);
        JsonReader in = document.reader();
        try {
            JsonNode root = new JsonNode(document, null, null, 0);
            root.read(in);
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
            String what = known ? place.group(1) : said;
            throw new SceneFileException(
                    file,
                    known ? Integer.parseInt(place.group(2)) : lineOf(in),
                    known && !place.group(3).isEmpty() ? place.group(3) : "$",
                    "expected JSON (RFC 8259), found: " + cut(SETTING.matcher(what).replaceAll("")),
                    malformed);
        }
    }

    private static int lineOf(JsonReader in) {
        Matcher place = PLACE.matcher(in.toString());
        return place.matches() ? Integer.parseInt(place.group(2)) : 0;
    }

    private void read(JsonReader in) throws IOException {
        if (ordinal == MAX_VALUES) {
            throw wrong("at most " + MAX_VALUES + " values", "more");
        }
        JsonToken token = in.peek();
        value =
                switch (token) {
                    case BEGIN_OBJECT -> object(in);
                    case BEGIN_ARRAY -> array(in);
                    case NUMBER -> new Literal(in.nextString());
                    case STRING -> in.nextString();
                    case BOOLEAN -> in.nextBoolean();
                    case NULL -> {
                        in.nextNull();
                        yield Null.NULL;
                    }
                    default -> throw wrong("a value", String.valueOf(token));
                };
    }

    private Map<String, JsonNode> object(JsonReader in) throws IOException {
        Map<String, JsonNode> fields = new LinkedHashMap<>();
        in.beginObject();
        while (in.hasNext()) {
            String key = in.nextName();
            JsonNode field = new JsonNode(document, this, key, 0);
            field.read(in);
            if (fields.put(key, field) != null) {
                throw field.wrong("each field once", "\"" + cut(key) + "\" again");
            }
        }
        in.endObject();
        return fields;
    }

    private List<JsonNode> array(JsonReader in) throws IOException {
        List<JsonNode> items = new ArrayList<>();
        in.beginArray();
        while (in.hasNext()) {
            JsonNode item = new JsonNode(document, this, null, items.size());
            item.read(in);
            items.add(item);
        }
        in.endArray();
        return items;
    }

    /** Where the value is, from the document's root. */
    private String path() {
        JsonNode above = parent;
        if (above == null) {
            return "$";
        }
        return above.path() + (name != null ? "." + name : "[" + index + "]");
    }

    private SceneFileException failure(String message, @Nullable Throwable cause) {
        return new SceneFileException(
                document.file, document.line(ordinal), path(), message, cause);
    }

    /** The exception for this place; the caller throws it. */
    SceneFileException wrong(String expected, String found) {
        return failure("expected " + expected + ", found " + found, null);
    }

    /** The exception for a value that was refused further on, in the words of the refusal. */
    SceneFileException refused(RuntimeException cause) {
        return failure(String.valueOf(cause.getMessage()), cause);
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

    boolean isText() {
        return value instanceof String;
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
        return path() + " = " + shown();
    }
}
