package dev.cairn.samples.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.samples.scenefile.EntitySpec.Driven;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** The fields {@code controls} and {@code camera} of an entity, read and written. Stateless. */
final class DrivenJson {
    static final List<String> CONTROL = List.of("key", "mouse", "does", "along", "axes");
    static final List<String> MOUNT = List.of("offset", "looks");

    private DrivenJson() {}

    static Driven read(Map<String, JsonNode> entity) {
        JsonNode controls = entity.get("controls");
        JsonNode camera = entity.get("camera");
        List<Control> list = new ArrayList<>();
        if (controls != null) {
            for (JsonNode control : controls.items("a list of controls")) {
                list.add(control(control));
            }
        }
        return new Driven(list, camera == null ? null : mount(camera));
    }

    private static Control control(JsonNode node) {
        Map<String, JsonNode> in = node.fields("a control", CONTROL);
        JsonNode key = in.get("key");
        JsonNode mouse = in.get("mouse");
        if ((key == null) == (mouse == null)) {
            throw node.wrong("a field \"key\" or a field \"mouse\"", node.shown());
        }
        Xyz along = node.required(in, "along").xyz("a vector");
        JsonNode axes = in.get("axes");
        return new Control(
                key == null ? null : one(key, Key.class),
                mouse == null ? null : one(mouse, MouseButton.class),
                one(node.required(in, "does"), Control.Effect.class),
                axes == null ? Control.Axes.VIEW : one(axes, Control.Axes.class),
                along.x(),
                along.y(),
                along.z());
    }

    /** A constant by its name, in capitals for triggers and in small letters for the rest. */
    private static <E extends Enum<E>> E one(JsonNode node, Class<E> type) {
        boolean small = type == Control.Effect.class || type == Control.Axes.class;
        List<String> names =
                Arrays.stream(type.getEnumConstants())
                        .map(small ? DrivenJson::word : Enum::name)
                        .toList();
        String what =
                type == Key.class
                        ? "the name of a key such as UP, SPACE, J or DIGIT_1"
                        : "one of " + String.join(", ", names);
        int index = names.indexOf(node.text(what));
        if (index < 0) {
            String written = node.text(what);
            String near =
                    names.stream()
                            .filter(written::equalsIgnoreCase)
                            .findFirst()
                            .orElse(node.nearestOf(names));
            throw node.wrong(
                    what + (near == null ? "" : " (did you mean " + near + "?)"), node.shown());
        }
        return type.getEnumConstants()[index];
    }

    private static String word(Enum<?> constant) {
        return constant.name().toLowerCase(java.util.Locale.ROOT);
    }

    private static CameraMount mount(JsonNode node) {
        Map<String, JsonNode> in = node.fields("the camera's place", MOUNT);
        Xyz at = node.required(in, "offset").xyz("a place beside the entity");
        JsonNode looks = in.get("looks");
        try {
            return new CameraMount(at.x(), at.y(), at.z(), looks == null || looks.truth());
        } catch (IllegalArgumentException refused) {
            throw refused instanceof SceneFileException told ? told : node.refused(refused);
        }
    }

    static void write(Driven driven, JsonObject out) {
        if (!driven.controls().isEmpty()) {
            JsonArray controls = new JsonArray();
            driven.controls().forEach(control -> controls.add(write(control)));
            out.add("controls", controls);
        }
        @Nullable CameraMount camera = driven.camera();
        if (camera != null) {
            JsonObject mount = new JsonObject();
            mount.add("offset", SceneWriter.xyz(new Xyz(camera.x(), camera.y(), camera.z())));
            mount.addProperty("looks", camera.looks());
            out.add("camera", mount);
        }
    }

    private static JsonObject write(Control control) {
        JsonObject out = new JsonObject();
        if (control.key() != null) {
            out.addProperty("key", control.key().name());
        } else {
            out.addProperty("mouse", String.valueOf(control.button()));
        }
        out.addProperty("does", control.effect().word());
        out.add("along", SceneWriter.xyz(new Xyz(control.x(), control.y(), control.z())));
        out.addProperty("axes", control.axes().word());
        return out;
    }
}
