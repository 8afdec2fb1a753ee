package dev.cairn.samples.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;

import dev.cairn.physics.Body;
import dev.cairn.physics.Material;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** What a body is made of and has, read and written: colliders, materials, filters. Stateless. */
final class BodyJson {
    static final List<String> COLLIDER =
            List.of(
                    "shape",
                    "position",
                    "rotation",
                    "material",
                    "filter",
                    "sensor",
                    "surfaceVelocity",
                    "userData");
    static final List<String> MATERIAL =
            List.of(
                    "friction",
                    "restitution",
                    "density",
                    "rollingArm",
                    "frictionMix",
                    "restitutionMix",
                    "surfaceVelocity");
    static final List<String> FILTER = List.of("category", "mask", "except", "group");
    static final List<String> DAMPING = List.of("linear", "angular");

    /** A mask of more layers is written by those that it leaves out. */
    private static final int MANY = Long.SIZE / 2;

    private BodyJson() {}

    static BodySpec read(Map<String, JsonNode> in, List<String> layers) {
        BodySpec base = BodySpec.DEFAULT;
        List<PartSpec> parts = new ArrayList<>();
        if (in.containsKey("colliders")) {
            JsonNode list = in.get("colliders");
            for (JsonNode part : list.items("a list of colliders")) {
                parts.add(part(part, layers));
            }
            if (parts.isEmpty()) {
                throw list.wrong("at least one collider", "none");
            }
        }
        double linear = 0;
        double angular = 0;
        if (in.containsKey("damping")) {
            Map<String, JsonNode> damping = in.get("damping").fields("the damping", DAMPING);
            linear = rate(damping.get("linear"));
            angular = rate(damping.get("angular"));
        }
        return new BodySpec(
                parts,
                in.containsKey("filter") ? filter(in.get("filter"), layers) : base.filter(),
                in.containsKey("inertia") ? in.get("inertia").xyz("an inertia in kg m2") : null,
                products(in),
                in.containsKey("centreOfMass") ? in.get("centreOfMass").xyz("a place") : null,
                in.containsKey("gravityScale")
                        ? in.get("gravityScale").number("a factor")
                        : base.gravityScale(),
                linear,
                angular,
                in.containsKey("speedLimit")
                        ? in.get("speedLimit").positive("a speed in m/s")
                        : base.speedLimit(),
                in.containsKey("locks") ? locks(in.get("locks")) : base.locks(),
                !in.containsKey("canSleep") || in.get("canSleep").truth(),
                userData(in.get("userData")));
    }

    private static @Nullable Object userData(@Nullable JsonNode node) {
        if (node == null) {
            return null;
        }
        return node.isText() ? node.text("a word") : (Object) node.number("a word or a number");
    }

    private static JsonPrimitive userData(Object data) {
        return data instanceof String word
                ? new JsonPrimitive(word)
                : SceneWriter.number((Double) data);
    }

    private static double rate(@Nullable JsonNode node) {
        if (node == null) {
            return 0;
        }
        double rate = node.atLeastZero("a rate in 1/s");
        if (rate > 1e6) {
            throw node.wrong("at most 1e6 1/s", node.shown());
        }
        return rate;
    }

    private static PartSpec part(JsonNode node, List<String> layers) {
        Map<String, JsonNode> in = node.fields("a collider", COLLIDER);
        return new PartSpec(
                ShapeJson.read(node.required(in, "shape")),
                in.containsKey("position") ? in.get("position").xyz("a place") : Xyz.ZERO,
                in.containsKey("rotation") ? SceneReader.rotation(in.get("rotation")) : Turn.NONE,
                in.containsKey("material") ? material(in.get("material")) : null,
                in.containsKey("filter") ? filter(in.get("filter"), layers) : null,
                in.containsKey("sensor") && in.get("sensor").truth(),
                in.containsKey("surfaceVelocity")
                        ? in.get("surfaceVelocity").xyz("a velocity")
                        : null,
                userData(in.get("userData")));
    }

    /** Refuses what no world would take, where it stands. */
    static void check(JsonNode node, EntitySpec made, Map<String, JsonNode> in) {
        List<PartSpec> parts = made.physics().parts();
        List<JsonNode> nodes =
                parts.isEmpty()
                        ? List.of()
                        : node.required(in, "colliders").items("a list of colliders");
        for (int i = 0; i < parts.size(); i++) {
            PartSpec part = parts.get(i);
            if (EntityRules.wantsOneShape(made, part)) {
                throw nodes.get(i).wrong(EntityRules.ONE_SHAPE, "parts");
            }
            if (!(part.shape() instanceof MeshShape)) {
                try {
                    part.collider(part.shape().collider(made.scale()), 1);
                } catch (IllegalArgumentException refusal) {
                    throw nodes.get(i).refused(refusal);
                }
            }
        }
        JsonNode inertia = in.get("inertia");
        if (inertia != null) {
            try {
                made.physics().tell(Body.dynamic());
            } catch (IllegalArgumentException refusal) {
                throw inertia.refused(refusal);
            }
        }
    }

    private static Xyz products(Map<String, JsonNode> in) {
        JsonNode products = in.get("productsOfInertia");
        if (products == null) {
            return Xyz.ZERO;
        }
        if (!in.containsKey("inertia")) {
            throw products.wrong("an inertia that they belong to", "none");
        }
        return products.xyz("products of inertia in kg m2");
    }

    static Material material(JsonNode node) {
        Map<String, JsonNode> in = node.fields("a material", MATERIAL);
        Material base = Material.DEFAULT;
        double restitution = base.restitution();
        JsonNode bounce = in.get("restitution");
        if (bounce != null) {
            restitution = bounce.number("a number from 0 to 1");
            if (!(restitution >= 0 && restitution <= 1)) {
                throw bounce.wrong("a number from 0 to 1", bounce.shown());
            }
        }
        Xyz run =
                in.containsKey("surfaceVelocity")
                        ? in.get("surfaceVelocity").xyz("a velocity")
                        : Xyz.ZERO;
        return new Material(
                in.containsKey("friction")
                        ? in.get("friction").atLeastZero("a number")
                        : base.friction(),
                restitution,
                in.containsKey("density")
                        ? in.get("density").positive("a density in kg/m3")
                        : base.density(),
                in.containsKey("rollingArm")
                        ? in.get("rollingArm").atLeastZero("a length in metres")
                        : base.rollingArm(),
                mix(in.get("frictionMix")),
                mix(in.get("restitutionMix")),
                run.x(),
                run.y(),
                run.z());
    }

    private static Mix mix(@Nullable JsonNode node) {
        return node == null ? Mix.DEFAULT : one(node, Mix.values());
    }

    private static List<Lock> locks(JsonNode node) {
        List<Lock> locks = new ArrayList<>();
        for (JsonNode lock : node.items("a list of locks")) {
            locks.add(one(lock, Lock.values()));
        }
        return locks;
    }

    private static <E extends Enum<E>> E one(JsonNode node, E[] all) {
        List<String> words = Arrays.stream(all).map(BodyJson::word).toList();
        String what = "one of " + String.join(", ", words);
        int index = words.indexOf(node.text(what));
        if (index < 0) {
            String near = node.nearestOf(words);
            throw node.wrong(
                    what + (near == null ? "" : " (did you mean " + near + "?)"), node.shown());
        }
        return all[index];
    }

    /** A constant's name as a word of the file: {@code MOVE_X} is moveX. */
    static String word(Enum<?> constant) {
        String[] words = constant.name().toLowerCase(Locale.ROOT).split("_", -1);
        return words.length == 1 ? words[0] : words[0] + words[1].toUpperCase(Locale.ROOT);
    }

    private static Filter filter(JsonNode node, List<String> layers) {
        Map<String, JsonNode> in = node.fields("a filter", FILTER);
        Filter base = Filter.ALL;
        JsonNode mask = in.get("mask");
        JsonNode except = in.get("except");
        if (mask != null && except != null) {
            throw node.wrong("a field \"mask\" or a field \"except\"", "both");
        }
        return new Filter(
                in.containsKey("category") ? bits(in.get("category"), layers) : base.category(),
                mask != null
                        ? bits(mask, layers)
                        : except != null ? ~bits(except, layers) : base.mask(),
                in.containsKey("group")
                        ? in.get("group").whole(Integer.MIN_VALUE, Integer.MAX_VALUE)
                        : base.group());
    }

    private static long bits(JsonNode node, List<String> layers) {
        long bits = 0;
        for (JsonNode layer : node.items("a list of layers, by name or number")) {
            bits |= 1L << (layer.isText() ? named(layer, layers) : layer.whole(0, Long.SIZE - 1));
        }
        return bits;
    }

    private static int named(JsonNode node, List<String> layers) {
        int bit = layers.indexOf(node.text("a layer"));
        if (bit < 0) {
            String near = node.nearestOf(layers);
            throw node.wrong(
                    "one of the scene's layers "
                            + String.join(", ", layers)
                            + (near == null ? "" : " (did you mean " + near + "?)"),
                    node.shown());
        }
        return bit;
    }

    static void write(BodySpec body, List<String> layers, JsonObject out) {
        BodySpec base = BodySpec.DEFAULT;
        if (!body.filter().equals(base.filter())) {
            out.add("filter", filter(body.filter(), layers));
        }
        if (body.inertia() != null) {
            out.add("inertia", SceneWriter.xyz(body.inertia()));
        }
        if (!body.products().equals(Xyz.ZERO)) {
            out.add("productsOfInertia", SceneWriter.xyz(body.products()));
        }
        if (body.centre() != null) {
            out.add("centreOfMass", SceneWriter.xyz(body.centre()));
        }
        if (!body.canSleep()) {
            out.addProperty("canSleep", false);
        }
        if (body.userData() != null) {
            out.add("userData", userData(body.userData()));
        }
        if (body.gravityScale() != base.gravityScale()) {
            out.add("gravityScale", SceneWriter.number(body.gravityScale()));
        }
        if (body.linearDamping() != 0 || body.angularDamping() != 0) {
            JsonObject damping = new JsonObject();
            damping.add("linear", SceneWriter.number(body.linearDamping()));
            damping.add("angular", SceneWriter.number(body.angularDamping()));
            out.add("damping", damping);
        }
        if (body.speedLimit() != base.speedLimit()) {
            out.add("speedLimit", SceneWriter.number(body.speedLimit()));
        }
        if (!body.locks().isEmpty()) {
            JsonArray locks = new JsonArray();
            body.locks().forEach(lock -> locks.add(word(lock)));
            out.add("locks", locks);
        }
    }

    static JsonArray colliders(List<PartSpec> parts, List<String> layers) {
        JsonArray out = new JsonArray();
        parts.forEach(part -> out.add(collider(part, layers)));
        return out;
    }

    private static JsonObject collider(PartSpec part, List<String> layers) {
        JsonObject out = new JsonObject();
        out.add("shape", ShapeJson.write(part.shape()));
        if (!part.position().equals(Xyz.ZERO)) {
            out.add("position", SceneWriter.xyz(part.position()));
        }
        if (!part.rotation().equals(Turn.NONE)) {
            out.add("rotation", SceneWriter.turn(part.rotation()));
        }
        if (part.material() != null) {
            out.add("material", material(part.material()));
        }
        if (part.filter() != null) {
            out.add("filter", filter(part.filter(), layers));
        }
        if (part.sensor()) {
            out.addProperty("sensor", true);
        }
        if (part.surfaceVelocity() != null) {
            out.add("surfaceVelocity", SceneWriter.xyz(part.surfaceVelocity()));
        }
        if (part.userData() != null) {
            out.add("userData", userData(part.userData()));
        }
        return out;
    }

    static JsonObject material(Material material) {
        JsonObject out = new JsonObject();
        out.add("friction", SceneWriter.number(material.friction()));
        out.add("restitution", SceneWriter.number(material.restitution()));
        out.add("density", SceneWriter.number(material.density()));
        if (material.rollingArm() > 0) {
            out.add("rollingArm", SceneWriter.number(material.rollingArm()));
        }
        if (material.frictionMix() != Mix.DEFAULT) {
            out.addProperty("frictionMix", word(material.frictionMix()));
        }
        if (material.restitutionMix() != Mix.DEFAULT) {
            out.addProperty("restitutionMix", word(material.restitutionMix()));
        }
        Xyz run = new Xyz(material.surfaceX(), material.surfaceY(), material.surfaceZ());
        if (!run.equals(Xyz.ZERO)) {
            out.add("surfaceVelocity", SceneWriter.xyz(run));
        }
        return out;
    }

    private static JsonObject filter(Filter filter, List<String> layers) {
        JsonObject out = new JsonObject();
        out.add("category", layers(filter.category(), layers));
        if (Long.bitCount(filter.mask()) > MANY) {
            if (filter.mask() != -1) {
                out.add("except", layers(~filter.mask(), layers));
            }
        } else {
            out.add("mask", layers(filter.mask(), layers));
        }
        if (filter.group() != 0) {
            out.add("group", SceneWriter.number(filter.group()));
        }
        return out;
    }

    private static JsonArray layers(long bits, List<String> layers) {
        JsonArray out = new JsonArray();
        for (int bit = 0; bit < Long.SIZE; bit++) {
            if ((bits >>> bit & 1) != 0) {
                out.add(
                        bit < layers.size()
                                ? new JsonPrimitive(layers.get(bit))
                                : new JsonPrimitive(bit));
            }
        }
        return out;
    }
}
