package dev.cairn.samples.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;

import dev.cairn.physics.Material;
import dev.cairn.render.camera.Light;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Writes scene files: fields in the order of {@link SceneReader}'s lists, what has its default left
 * out, one line for what is short. Stateless; any thread.
 */
public final class SceneWriter {
    private static final int WIDTH = 100;

    /** A surrogate without its other half. */
    private static final Pattern HALF = Pattern.compile("[\\uD800-\\uDFFF]");

    private SceneWriter() {}

    /**
     * Writes a file, through a neighbour that is renamed at the end, so that a full disk does not
     * cost the old file. A folder of that name stays.
     *
     * @param scene what to write
     * @param file where
     * @throws UncheckedIOException if it cannot be written
     */
    public static void write(SceneFile scene, Path file) {
        Path whole = file.toAbsolutePath();
        Path part = whole.resolveSibling(whole.getFileName() + ".part");
        try {
            if (Files.isDirectory(whole)) {
                // An empty one would be replaced.
                throw new FileSystemException(whole.toString(), null, "it is a folder");
            }
            try {
                Files.writeString(part, text(scene));
                Files.move(part, whole, StandardCopyOption.REPLACE_EXISTING);
            } finally {
                Files.deleteIfExists(part);
            }
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "the scene %s was not saved: %s".formatted(file, why(unwritable)), unwritable);
        }
    }

    /** Of the commonest the message is the path alone. */
    private static String why(IOException unwritable) {
        return switch (unwritable) {
            case NoSuchFileException _ -> "there is no such folder";
            case AccessDeniedException _ -> "it may not be written there";
            case FileSystemException other when other.getReason() != null -> other.getReason();
            default -> String.valueOf(unwritable.getMessage());
        };
    }

    /**
     * A scene as JSON.
     *
     * @param scene what to write
     * @return the document, ending in a line feed
     */
    public static String text(SceneFile scene) {
        JsonObject out = new JsonObject();
        out.addProperty("format", SceneFile.FORMAT);
        out.add("version", number(SceneFile.VERSION));
        out.addProperty("name", scene.name());
        if (!scene.description().isEmpty()) {
            out.addProperty("description", scene.description());
        }
        out.add("gravity", xyz(scene.gravity()));
        JsonObject tick = new JsonObject();
        tick.add("seconds", number(scene.tick().seconds()));
        tick.add("substeps", number(scene.tick().substeps()));
        tick.add("ticks", number(scene.tick().ticks()));
        tick.add("pictureTick", number(scene.tick().pictureTick()));
        out.add("tick", tick);
        JsonObject camera = new JsonObject();
        camera.add("eye", xyz(scene.camera().eye()));
        camera.add("target", xyz(scene.camera().target()));
        camera.add("fieldOfViewDegrees", number(scene.camera().fieldOfViewDegrees()));
        out.add("camera", camera);
        out.add("light", light(scene.light()));
        if (scene.state() != null) {
            out.addProperty("state", scene.state());
        }
        if (!scene.layers().isEmpty()) {
            JsonArray layers = new JsonArray();
            scene.layers().forEach(layers::add);
            out.add("layers", layers);
        }
        JsonArray entities = new JsonArray();
        scene.entities().forEach(entity -> entities.add(entity(entity, scene.layers())));
        out.add("entities", entities);
        if (!scene.joints().isEmpty()) {
            JsonArray joints = new JsonArray();
            scene.joints().forEach(joint -> joints.add(JointJson.write(joint)));
            out.add("joints", joints);
        }
        StringBuilder text = new StringBuilder();
        put(text, out, 0);
        return escaped(text.append('\n'));
    }

    /**
     * Half a letter outside of the first 65,536 has no bytes in UTF-8, and is written by number.
     */
    private static String escaped(CharSequence text) {
        return HALF.matcher(text)
                .replaceAll(half -> String.format("\\\\u%04x", (int) half.group().charAt(0)));
    }

    private static JsonObject light(Light light) {
        JsonObject out = new JsonObject();
        out.add("sunDirection", xyz(new Xyz(light.sunX(), light.sunY(), light.sunZ())));
        out.add("sun", xyz(new Xyz(light.sunRed(), light.sunGreen(), light.sunBlue())));
        out.add("sky", xyz(new Xyz(light.skyRed(), light.skyGreen(), light.skyBlue())));
        out.add("ground", xyz(new Xyz(light.groundRed(), light.groundGreen(), light.groundBlue())));
        out.addProperty("zenith", rgb(light.zenithRgb()));
        out.addProperty("horizon", rgb(light.horizonRgb()));
        out.add("hazeMetres", number(light.hazeMetres()));
        out.addProperty("shadows", light.shadows());
        return out;
    }

    private static JsonObject entity(EntitySpec entity, List<String> layers) {
        JsonObject out = new JsonObject();
        if (!entity.name().isEmpty()) {
            out.addProperty("name", entity.name());
        }
        out.addProperty("body", entity.body().word());
        if (entity.physics().parts().isEmpty()) {
            out.add("shape", ShapeJson.write(entity.shape()));
        } else {
            out.add("colliders", BodyJson.colliders(entity.physics().parts(), layers));
        }
        if (!entity.position().equals(Xyz.ZERO)) {
            out.add("position", xyz(entity.position()));
        }
        Turn turn = entity.rotation();
        if (!turn.equals(Turn.NONE)) {
            out.add("rotation", turn(turn));
        }
        if (!entity.scale().equals(Xyz.ONE)) {
            out.add("scale", xyz(entity.scale()));
        }
        if (!entity.material().equals(Material.DEFAULT)) {
            out.add("material", BodyJson.material(entity.material()));
        }
        if (entity.mass() != null) {
            out.add("mass", number(entity.mass()));
        }
        if (!entity.velocity().equals(Xyz.ZERO)) {
            out.add("velocity", xyz(entity.velocity()));
        }
        if (!entity.angularVelocity().equals(Xyz.ZERO)) {
            out.add("angularVelocity", xyz(entity.angularVelocity()));
        }
        BodyJson.write(entity.physics(), layers, out);
        if (!entity.look().equals(LookSpec.DEFAULT)) {
            out.add("look", look(entity.look()));
        }
        DrivenJson.write(entity.driven(), out);
        return out;
    }

    private static JsonObject look(LookSpec look) {
        JsonObject out = new JsonObject();
        if (!look.visible()) {
            out.addProperty("visible", false);
        }
        if (look.rgb() != null) {
            out.addProperty("color", rgb(look.rgb()));
        }
        if (look.texture() != null) {
            out.addProperty("texture", look.texture());
        }
        if (look.tileMetres() != 0) {
            out.add("tileMetres", number(look.tileMetres()));
        }
        if (look.mesh() != null) {
            out.addProperty("mesh", look.mesh());
        }
        if (!look.meshScale().equals(Xyz.ONE)) {
            out.add("meshScale", xyz(look.meshScale()));
        }
        return out;
    }

    static JsonArray turn(Turn turn) {
        JsonArray q = new JsonArray();
        q.add(number(turn.x()));
        q.add(number(turn.y()));
        q.add(number(turn.z()));
        q.add(number(turn.w()));
        return q;
    }

    static JsonArray xyz(Xyz value) {
        JsonArray out = new JsonArray();
        out.add(number(value.x()));
        out.add(number(value.y()));
        out.add(number(value.z()));
        return out;
    }

    private static String rgb(int value) {
        return String.format(Locale.ROOT, "#%06X", value & 0xFFFFFF);
    }

    /** The shortest decimal that reads back as the same double; 2 and not 2.0. */
    static JsonPrimitive number(double value) {
        boolean whole =
                value == Math.rint(value)
                        && Math.abs(value) < 1e15
                        && Double.doubleToRawLongBits(value) != Long.MIN_VALUE;
        return whole ? new JsonPrimitive((long) value) : new JsonPrimitive(value);
    }

    /** One line where that is short, otherwise one line per member. */
    private static void put(StringBuilder text, JsonElement element, int indent) {
        String line = line(element);
        boolean small = indent + line.length() <= WIDTH && indent > 0;
        if (small || element.isJsonPrimitive()) {
            text.append(line);
            return;
        }
        String inner = "\n" + " ".repeat(indent + 2);
        String separator = inner;
        if (element.isJsonArray()) {
            text.append('[');
            for (JsonElement item : element.getAsJsonArray()) {
                text.append(separator);
                put(text, item, indent + 2);
                separator = "," + inner;
            }
            text.append('\n').append(" ".repeat(indent)).append(']');
            return;
        }
        text.append('{');
        for (Map.Entry<String, JsonElement> field : element.getAsJsonObject().entrySet()) {
            text.append(separator).append('"').append(field.getKey()).append("\": ");
            put(text, field.getValue(), indent + 2);
            separator = "," + inner;
        }
        text.append('\n').append(" ".repeat(indent)).append('}');
    }

    private static String line(JsonElement element) {
        if (element.isJsonArray()) {
            return "["
                    + String.join(
                            ", ",
                            element.getAsJsonArray().asList().stream()
                                    .map(SceneWriter::line)
                                    .toList())
                    + "]";
        }
        if (element.isJsonObject()) {
            return "{"
                    + String.join(
                            ", ",
                            element.getAsJsonObject().entrySet().stream()
                                    .map(field ->
                                            "\"" + field.getKey() + "\": " + line(field.getValue()))
                                    .toList())
                    + "}";
        }
        return element.toString();
    }
}
