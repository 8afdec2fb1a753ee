package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/** {@code docs/scene.schema.json} says what the reader takes: the same fields, the same bounds. */
class SceneSchemaTest {
    private static final String HEAD = "{\"format\": \"cairn-scene\", \"version\": 1, ";

    /** The keywords of JSON Schema that the file uses; any other fails. */
    private static final Set<String> KEYWORDS =
            Set.of(
                    "$schema",
                    "title",
                    "description",
                    "$defs",
                    "type",
                    "required",
                    "additionalProperties",
                    "properties",
                    "const",
                    "enum",
                    "items",
                    "minItems",
                    "maxItems",
                    "minimum",
                    "maximum",
                    "exclusiveMinimum",
                    "pattern",
                    "oneOf",
                    "$ref");

    private static JsonObject schema() throws IOException {
        for (Path at : List.of(Path.of("docs"), Path.of("..", "docs"))) {
            Path file = at.resolve("scene.schema.json");
            if (Files.exists(file)) {
                return JsonParser.parseString(Files.readString(file)).getAsJsonObject();
            }
        }
        return fail("docs/scene.schema.json is not there");
    }

    private static boolean valid(JsonObject root, JsonObject rule, JsonElement value) {
        for (String keyword : rule.keySet()) {
            assertTrue(KEYWORDS.contains(keyword), "keyword " + keyword);
        }
        if (rule.has("$ref")) {
            String name = rule.get("$ref").getAsString().replace("#/$defs/", "");
            return valid(root, root.getAsJsonObject("$defs").getAsJsonObject(name), value);
        }
        if (rule.has("const") && !same(rule.get("const"), value)) {
            return false;
        }
        if (rule.has("enum")
                && rule.getAsJsonArray("enum").asList().stream().noneMatch(e -> same(e, value))) {
            return false;
        }
        if (rule.has("oneOf")) {
            long fits =
                    rule.getAsJsonArray("oneOf").asList().stream()
                            .filter(one -> valid(root, one.getAsJsonObject(), value))
                            .count();
            if (fits != 1) {
                return false;
            }
        }
        String type = rule.has("type") ? rule.get("type").getAsString() : "";
        return switch (type) {
            case "object" -> value.isJsonObject() && object(root, rule, value.getAsJsonObject());
            case "array" -> value.isJsonArray() && array(root, rule, value);
            case "number", "integer" -> number(rule, value, type.equals("integer"));
            case "string" ->
                    value.isJsonPrimitive()
                            && value.getAsJsonPrimitive().isString()
                            && (!rule.has("pattern")
                                    || value.getAsString()
                                            .matches(rule.get("pattern").getAsString()));
            case "boolean" -> value.isJsonPrimitive() && value.getAsJsonPrimitive().isBoolean();
            default -> required(rule, value);
        };
    }

    private static boolean same(JsonElement a, JsonElement b) {
        return a.equals(b);
    }

    private static boolean required(JsonObject rule, JsonElement value) {
        return !rule.has("required")
                || rule.getAsJsonArray("required").asList().stream()
                        .allMatch(name -> value.getAsJsonObject().has(name.getAsString()));
    }

    private static boolean object(JsonObject root, JsonObject rule, JsonObject value) {
        JsonObject known = rule.getAsJsonObject("properties");
        for (String name : value.keySet()) {
            if (!known.has(name) || !valid(root, known.getAsJsonObject(name), value.get(name))) {
                return false;
            }
        }
        return required(rule, value);
    }

    private static boolean array(JsonObject root, JsonObject rule, JsonElement value) {
        int size = value.getAsJsonArray().size();
        return (!rule.has("minItems") || size >= rule.get("minItems").getAsInt())
                && (!rule.has("maxItems") || size <= rule.get("maxItems").getAsInt())
                && value.getAsJsonArray().asList().stream()
                        .allMatch(item -> valid(root, rule.getAsJsonObject("items"), item));
    }

    private static boolean number(JsonObject rule, JsonElement value, boolean whole) {
        if (!value.isJsonPrimitive() || !value.getAsJsonPrimitive().isNumber()) {
            return false;
        }
        double number = value.getAsDouble();
        return (!whole || number == Math.rint(number))
                && (!rule.has("minimum") || number >= rule.get("minimum").getAsDouble())
                && (!rule.has("maximum") || number <= rule.get("maximum").getAsDouble())
                && (!rule.has("exclusiveMinimum")
                        || number > rule.get("exclusiveMinimum").getAsDouble());
    }

    @Test
    void whatIsWrittenFitsTheSchema() throws IOException {
        JsonObject root = schema();
        for (String id :
                List.of(
                        "room",
                        "pyramid",
                        "slope-ball",
                        "shapes",
                        "obj-drop",
                        "car",
                        "door",
                        "compound-pile",
                        "conveyor",
                        "one-way")) {
            SampleScene scene = SceneRegistry.get(id);
            String text =
                    SceneWriter.text(
                            SceneExport.of(scene, SceneOptions.defaults(scene), 4, Path.of("")));
            assertTrue(valid(root, root, JsonParser.parseString(text)), id);
        }
    }

    @Test
    void theSchemaNamesTheFieldsOfTheReader() throws IOException {
        JsonObject root = schema();
        JsonObject fields = root.getAsJsonObject("properties");
        assertEquals(Set.copyOf(SceneReader.SCENE), fields.keySet());
        assertEquals(Set.copyOf(SceneReader.TICK), names(fields, "tick"));
        assertEquals(Set.copyOf(SceneReader.CAMERA), names(fields, "camera"));
        assertEquals(Set.copyOf(SceneReader.LIGHT), names(fields, "light"));
        JsonObject defs = root.getAsJsonObject("$defs");
        assertEquals(Set.copyOf(SceneReader.ENTITY), names(defs, "entity"));
        JsonObject entity = defs.getAsJsonObject("entity").getAsJsonObject("properties");
        assertEquals(Set.copyOf(BodyJson.MATERIAL), names(defs, "material"));
        assertEquals(Set.copyOf(BodyJson.COLLIDER), names(defs, "collider"));
        assertEquals(Set.copyOf(BodyJson.FILTER), names(defs, "filter"));
        assertEquals(Set.copyOf(BodyJson.DAMPING), names(entity, "damping"));
        assertEquals(Set.copyOf(SceneReader.LOOK), names(entity, "look"));
        assertEquals(Set.copyOf(DrivenJson.CONTROL), names(defs, "control"));
        assertEquals(Set.copyOf(DrivenJson.MOUNT), names(entity, "camera"));
        assertEquals(Set.copyOf(JointJson.JOINT), names(defs, "joint"));
        assertEquals(Set.copyOf(JointJson.AXIS), names(defs, "axis"));
        JsonObject joint = defs.getAsJsonObject("joint").getAsJsonObject("properties");
        assertEquals(Set.copyOf(JointJson.AXES), names(joint, "axes"));
        JsonObject axis = defs.getAsJsonObject("axis").getAsJsonObject("properties");
        assertEquals(Set.copyOf(JointJson.MOTOR), names(axis, "motor"));
        assertEquals(Set.copyOf(JointJson.SPRING), names(axis, "spring"));
    }

    private static Set<String> names(JsonObject of, String name) {
        return of.getAsJsonObject(name).getAsJsonObject("properties").keySet();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1}}]",
                "\"entities\": [], \"tick\": {\"seconds\": 1, \"substeps\": 64}",
                "\"entities\": [{\"shape\": {\"type\": \"half-space\"}, \"body\": \"fixed\","
                        + " \"rotation\": {\"axis\": [1, 0, 0], \"degrees\": 9}}]",
                "\"entities\": [{\"shape\": {\"type\": \"box\", \"halfExtents\": [1, 1, 1]},"
                        + " \"controls\": [{\"key\": \"UP\", \"does\": \"push\", \"along\": [0, 0,"
                        + " -9]}], \"camera\": {\"offset\": [0, 1, 3]}}]"
            })
    void bothTakeWhatIsRight(String fields) throws IOException {
        JsonObject root = schema();
        assertTrue(valid(root, root, JsonParser.parseString(HEAD + fields + "}")));
        SceneReader.parse("test", HEAD + fields + "}");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"name\": \"no entities\"",
                "\"entities\": {}",
                "\"entities\": [], \"gravty\": [0, 0, 0]",
                "\"entities\": [], \"gravity\": [0, 0]",
                "\"entities\": [], \"tick\": {\"seconds\": 0}",
                "\"entities\": [], \"tick\": {\"substeps\": 1.5}",
                "\"entities\": [], \"camera\": {\"fieldOfViewDegrees\": 171}",
                "\"entities\": [], \"light\": {\"horizon\": \"blue\"}",
                "\"entities\": [{}]",
                "\"entities\": [{\"shape\": {\"type\": \"ball\", \"radius\": 1}}]",
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 0}}]",
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1, \"points\":"
                        + " []}}]",
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1}, \"mass\": -1}]",
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1}, \"material\":"
                        + " {\"restitution\": 2}}]",
                "\"entities\": [{\"shape\": {\"type\": \"sphere\", \"radius\": 1}, \"controls\":"
                        + " [{\"key\": \"A\", \"mouse\": \"LEFT\", \"does\": \"push\", \"along\":"
                        + " [0, 0, 1]}]}]"
            })
    void bothRefuseWhatIsWrong(String fields) throws IOException {
        JsonObject root = schema();
        String text = HEAD + fields + "}";
        assertFalse(valid(root, root, JsonParser.parseString(text)));
        assertThrows(SceneFileException.class, () -> SceneReader.parse("test", text));
    }
}
