package dev.cairn.samples.scenefile;

import dev.cairn.render.camera.Light;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.SceneFile.TickSpec;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Reads scene files. Stateless; any thread. The fields are those of {@code docs/scene-files.md}.
 */
public final class SceneReader {
    /** A larger file is refused before it is read. */
    public static final long MAX_BYTES = 256L << 20;

    static final List<String> SCENE =
            List.of(
                    "format",
                    "version",
                    "name",
                    "description",
                    "gravity",
                    "tick",
                    "camera",
                    "light",
                    "state",
                    "layers",
                    "entities",
                    "joints");
    static final List<String> TICK = List.of("seconds", "substeps", "ticks", "pictureTick");
    static final List<String> CAMERA = List.of("eye", "target", "fieldOfViewDegrees");
    static final List<String> LIGHT =
            List.of(
                    "sunDirection",
                    "sun",
                    "sky",
                    "ground",
                    "zenith",
                    "horizon",
                    "hazeMetres",
                    "shadows");
    static final List<String> ENTITY =
            List.of(
                    "name",
                    "body",
                    "shape",
                    "colliders",
                    "position",
                    "rotation",
                    "scale",
                    "material",
                    "mass",
                    "velocity",
                    "angularVelocity",
                    "filter",
                    "inertia",
                    "productsOfInertia",
                    "centreOfMass",
                    "gravityScale",
                    "damping",
                    "speedLimit",
                    "locks",
                    "canSleep",
                    "userData",
                    "look",
                    "controls",
                    "camera");
    static final List<String> ROTATION = List.of("axis", "degrees");
    static final List<String> LOOK =
            List.of("visible", "color", "texture", "tileMetres", "mesh", "meshScale");

    private SceneReader() {}

    /**
     * Reads a file.
     *
     * @param file where it is
     * @return the scene
     * @throws SceneFileException if it cannot be read or is no scene; the message names the place
     */
    public static SceneFile read(Path file) {
        String name = file.toString();
        if (!Files.isRegularFile(file)) {
            throw new SceneFileException(
                    name,
                    0,
                    "$",
                    "expected a scene file (.json), found "
                            + (Files.isDirectory(file) ? "a folder" : "nothing there"),
                    null);
        }
        try {
            long bytes = Files.size(file);
            if (bytes > MAX_BYTES) {
                throw new SceneFileException(
                        name,
                        0,
                        "$",
                        "expected at most %d bytes, found %d".formatted(MAX_BYTES, bytes),
                        null);
            }
            return parse(name, Files.readString(file));
        } catch (CharacterCodingException notText) {
            throw new SceneFileException(
                    name, 0, "$", "expected text in UTF-8, found other bytes", notText);
        } catch (IOException unreadable) {
            throw new SceneFileException(
                    name, 0, "$", "expected a readable file, found: " + unreadable, unreadable);
        }
    }

    /**
     * Reads a scene from text.
     *
     * @param file name for messages
     * @param text the document
     * @return the scene
     * @throws SceneFileException if it is no scene; the message names the place
     */
    public static SceneFile parse(String file, String text) {
        JsonNode root = JsonNode.parse(file, text);
        Map<String, JsonNode> in = root.fields("a scene", SCENE);
        JsonNode format = root.required(in, "format");
        if (!format.text("\"" + SceneFile.FORMAT + "\"").equals(SceneFile.FORMAT)) {
            throw format.wrong("\"" + SceneFile.FORMAT + "\"", format.shown());
        }
        root.required(in, "version").whole(1, SceneFile.VERSION);
        SceneFile empty = SceneFile.empty("");
        List<String> layers = in.containsKey("layers") ? layers(in.get("layers")) : List.of();
        List<EntitySpec> entities = new ArrayList<>();
        for (JsonNode entity : root.required(in, "entities").items("a list of entities")) {
            entities.add(entity(entity, layers));
        }
        List<JointSpec> joints = new ArrayList<>();
        if (in.containsKey("joints")) {
            for (JsonNode joint : in.get("joints").items("a list of joints")) {
                joints.add(JointJson.read(joint, entities.size()));
            }
        }
        return new SceneFile(
                in.containsKey("name") ? in.get("name").text("a name") : "",
                in.containsKey("description") ? in.get("description").text("a description") : "",
                in.containsKey("gravity") ? in.get("gravity").xyz("gravity") : empty.gravity(),
                in.containsKey("tick") ? tick(in.get("tick")) : empty.tick(),
                in.containsKey("camera") ? camera(in.get("camera")) : empty.camera(),
                in.containsKey("light") ? light(in.get("light")) : empty.light(),
                entities,
                joints,
                layers,
                in.containsKey("state") ? state(in.get("state")) : null);
    }

    private static List<String> layers(JsonNode node) {
        List<String> names = new ArrayList<>();
        for (JsonNode name : node.items("a list of names")) {
            if (names.contains(name.text("a name"))) {
                throw name.wrong("each layer once", name.shown() + " again");
            }
            names.add(name.text("a name"));
        }
        if (names.size() > Long.SIZE) {
            throw node.wrong("at most 64 layers", String.valueOf(names.size()));
        }
        return names;
    }

    private static String state(JsonNode node) {
        String what = "the path of a saved moment of this scene, which ends in .cairn";
        String path = node.text(what);
        if (!path.endsWith(".cairn")) {
            throw node.wrong(what, node.shown());
        }
        return path;
    }

    private static TickSpec tick(JsonNode node) {
        Map<String, JsonNode> in = node.fields("the tick", TICK);
        TickSpec base = TickSpec.DEFAULT;
        double seconds = base.seconds();
        JsonNode length = in.get("seconds");
        if (length != null) {
            seconds = length.positive("a length in seconds");
            if (seconds > 1) {
                throw length.wrong("at most 1 s", length.shown());
            }
        }
        int ticks = in.containsKey("ticks") ? in.get("ticks").whole(1, 10_000_000) : base.ticks();
        return new TickSpec(
                seconds,
                in.containsKey("substeps") ? in.get("substeps").whole(1, 64) : base.substeps(),
                ticks,
                in.containsKey("pictureTick")
                        ? in.get("pictureTick").whole(0, ticks)
                        : Math.min(ticks, base.pictureTick()));
    }

    private static CameraSpec camera(JsonNode node) {
        Map<String, JsonNode> in = node.fields("the camera", CAMERA);
        CameraSpec base = CameraSpec.DEFAULT;
        double degrees = base.fieldOfViewDegrees();
        JsonNode angle = in.get("fieldOfViewDegrees");
        if (angle != null) {
            degrees = angle.number("an angle in degrees");
            if (!(degrees >= 2 && degrees <= 170)) {
                throw angle.wrong("an angle from 2 to 170 degrees", angle.shown());
            }
        }
        return new CameraSpec(
                in.containsKey("eye") ? in.get("eye").xyz("a place") : base.eye(),
                in.containsKey("target") ? in.get("target").xyz("a place") : base.target(),
                degrees);
    }

    private static Light light(JsonNode node) {
        Map<String, JsonNode> in = node.fields("the light", LIGHT);
        Light base = Light.DAYLIGHT;
        Xyz direction = new Xyz(base.sunX(), base.sunY(), base.sunZ());
        if (in.containsKey("sunDirection")) {
            direction = in.get("sunDirection").xyz("the direction to the sun");
            if (direction.x() == 0 && direction.y() == 0 && direction.z() == 0) {
                throw in.get("sunDirection").wrong("a direction", "[0, 0, 0]");
            }
            try {
                base.from(direction.x(), direction.y(), direction.z());
            } catch (IllegalArgumentException refusal) {
                throw in.get("sunDirection").refused(refusal);
            }
        }
        Xyz sun = strength(in.get("sun"), new Xyz(base.sunRed(), base.sunGreen(), base.sunBlue()));
        Xyz sky = strength(in.get("sky"), new Xyz(base.skyRed(), base.skyGreen(), base.skyBlue()));
        Xyz ground =
                strength(
                        in.get("ground"),
                        new Xyz(base.groundRed(), base.groundGreen(), base.groundBlue()));
        return new Light(
                direction.x(),
                direction.y(),
                direction.z(),
                sun.x(),
                sun.y(),
                sun.z(),
                sky.x(),
                sky.y(),
                sky.z(),
                ground.x(),
                ground.y(),
                ground.z(),
                in.containsKey("zenith") ? in.get("zenith").rgb() : base.zenithRgb(),
                in.containsKey("horizon") ? in.get("horizon").rgb() : base.horizonRgb(),
                in.containsKey("hazeMetres")
                        ? in.get("hazeMetres").atLeastZero("a distance")
                        : base.hazeMetres(),
                in.containsKey("shadows") ? in.get("shadows").truth() : base.shadows());
    }

    private static Xyz strength(@org.jspecify.annotations.Nullable JsonNode node, Xyz base) {
        if (node == null) {
            return base;
        }
        Xyz light = node.xyz("linear light [red, green, blue]");
        if (!(light.x() >= 0 && light.y() >= 0 && light.z() >= 0)) {
            throw node.wrong("light of at least 0", light.toString());
        }
        return light;
    }

    private static EntitySpec entity(JsonNode node, List<String> layers) {
        Map<String, JsonNode> in = node.fields("an entity", ENTITY);
        if (in.containsKey("shape") && in.containsKey("colliders")) {
            throw node.wrong("a field \"shape\" or a field \"colliders\"", "both");
        }
        BodySpec physics = BodyJson.read(in, layers);
        EntitySpec base =
                EntitySpec.of(
                        in.containsKey("name") ? in.get("name").text("a name") : "",
                        in.containsKey("body") ? body(in.get("body")) : BodyKind.DYNAMIC,
                        physics.parts().isEmpty()
                                ? ShapeJson.read(node.required(in, "shape"))
                                : physics.parts().get(0).shape());
        EntitySpec placed =
                base.at(
                        in.containsKey("position")
                                ? in.get("position").xyz("a position")
                                : base.position(),
                        in.containsKey("rotation") ? rotation(in.get("rotation")) : Turn.NONE);
        Xyz scale = in.containsKey("scale") ? scale(in.get("scale")) : Xyz.ONE;
        boolean isUniform = scale.x() == scale.y() && scale.x() == scale.z();
        if (!isUniform && !physics.parts().isEmpty()) {
            throw node.required(in, "scale")
                    .wrong("three equal factors for an entity of colliders", scale.toString());
        }
        EntitySpec made =
                placed.withScale(scale)
                        .withMaterial(
                                in.containsKey("material")
                                        ? BodyJson.material(in.get("material"))
                                        : base.material(),
                                in.containsKey("mass")
                                        ? (Double) in.get("mass").positive("a mass in kg")
                                        : null)
                        .moving(
                                in.containsKey("velocity")
                                        ? in.get("velocity").xyz("a velocity")
                                        : Xyz.ZERO,
                                in.containsKey("angularVelocity")
                                        ? in.get("angularVelocity").xyz("an angular velocity")
                                        : Xyz.ZERO)
                        .withLook(in.containsKey("look") ? look(in.get("look")) : base.look())
                        .withDriven(DrivenJson.read(in))
                        .withPhysics(physics);
        for (PartSpec part : made.parts()) {
            if (EntityRules.wantsSolid(made, part)) {
                throw node.required(in, in.containsKey("shape") ? "shape" : "colliders")
                        .wrong(EntityRules.SOLID, part.shape().type());
            }
        }
        if (physics.parts().isEmpty() && !(made.shape() instanceof MeshShape)) {
            try {
                // Made once more by the loader; here only so that a refusal can name the line.
                made.shape().collider(scale);
            } catch (IllegalArgumentException refusal) {
                throw node.required(in, "shape").refused(refusal);
            }
        }
        BodyJson.check(node, made, in);
        return made;
    }

    private static BodyKind body(JsonNode node) {
        String word = node.text("\"dynamic\", \"fixed\", \"kinematic\" or \"none\"");
        for (BodyKind kind : BodyKind.values()) {
            if (kind.word().equals(word)) {
                return kind;
            }
        }
        throw node.wrong("\"dynamic\", \"fixed\", \"kinematic\" or \"none\"", node.shown());
    }

    static Turn rotation(JsonNode node) {
        try {
            if (node.isObject()) {
                Map<String, JsonNode> in = node.fields("a rotation", ROTATION);
                return Turn.about(
                        node.required(in, "axis").xyz("an axis"),
                        node.required(in, "degrees").number("an angle in degrees"));
            }
            String what = "a quaternion [x, y, z, w] or {\"axis\": [x, y, z], \"degrees\": d}";
            List<JsonNode> q = node.items(what);
            if (q.size() != 4) {
                throw node.wrong(what, node.shown());
            }
            return new Turn(
                    q.get(0).number("a number"),
                    q.get(1).number("a number"),
                    q.get(2).number("a number"),
                    q.get(3).number("a number"));
        } catch (SceneFileException told) {
            throw told;
        } catch (IllegalArgumentException refusal) {
            throw node.refused(refusal);
        }
    }

    private static Xyz scale(JsonNode node) {
        Xyz scale = node.xyz("factors");
        if (!(scale.x() > 0 && scale.y() > 0 && scale.z() > 0)) {
            throw node.wrong("factors above 0", scale.toString());
        }
        return scale;
    }

    private static LookSpec look(JsonNode node) {
        Map<String, JsonNode> in = node.fields("a look", LOOK);
        String texture = null;
        if (in.containsKey("texture")) {
            JsonNode where = in.get("texture");
            texture = where.text("the path of a picture");
            String wanted = EntityRules.texture(texture);
            if (!wanted.isEmpty()) {
                throw where.wrong(wanted, where.shown());
            }
        }
        return new LookSpec(
                !in.containsKey("visible") || in.get("visible").truth(),
                in.containsKey("color") ? (Integer) in.get("color").rgb() : null,
                texture,
                in.containsKey("tileMetres")
                        ? in.get("tileMetres").atLeastZero("a length in metres")
                        : 0,
                in.containsKey("mesh") ? in.get("mesh").text("the path of an .obj file") : null,
                in.containsKey("meshScale") ? scale(in.get("meshScale")) : Xyz.ONE);
    }
}
