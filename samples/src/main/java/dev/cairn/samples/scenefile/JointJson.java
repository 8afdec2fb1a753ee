package dev.cairn.samples.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The joints of a scene, read and written. What is infinite is left out. Stateless. */
final class JointJson {
    static final List<String> JOINT =
            List.of(
                    "type",
                    "name",
                    "a",
                    "b",
                    "parameters",
                    "points",
                    "closed",
                    "at",
                    "anchors",
                    "axis",
                    "secondAxis",
                    "axes",
                    "length",
                    "collide",
                    "breakForce",
                    "breakTorque",
                    "on");
    static final List<String> AXES =
            List.of("x", "y", "z", "twist", "swingY", "swingZ", "cone", "distance", "path");
    static final List<String> AXIS = List.of("locked", "limits", "motor", "spring");
    static final List<String> MOTOR = List.of("speed", "most");
    static final List<String> SPRING =
            List.of("target", "hertz", "dampingRatio", "stiffness", "damping", "most");

    private JointJson() {}

    // Reading -------------------------------------------------------------------------------------

    static JointSpec read(JsonNode node, int entities) {
        Map<String, JsonNode> in = node.fields("a joint", JOINT);
        JsonNode type = node.required(in, "type");
        String kinds = "one of " + String.join(", ", JointSpec.KINDS);
        if (!JointSpec.KINDS.contains(type.text(kinds))) {
            throw type.wrong(kinds, type.shown());
        }
        if (in.containsKey("at") && in.containsKey("anchors")) {
            throw node.wrong("a field \"at\" or a field \"anchors\"", node.shown());
        }
        Xyz a = in.containsKey("at") ? in.get("at").xyz("a place") : null;
        Xyz b = a;
        JsonNode anchors = in.get("anchors");
        if (anchors != null) {
            List<JsonNode> two = anchors.items("two places, of a and of b");
            if (two.size() != 2) {
                throw anchors.wrong("two places, of a and of b", anchors.shown());
            }
            a = two.get(0).xyz("a place");
            b = two.get(1).xyz("a place");
        }
        JsonNode axes = in.get("axes");
        JsonNode axis = in.get("axis");
        JsonNode second = in.get("secondAxis");
        return new JointSpec(
                type.text(kinds),
                in.containsKey("name") ? in.get("name").text("a name") : "",
                node.required(in, "a").whole(0, entities - 1),
                node.required(in, "b").whole(0, entities - 1),
                parameters(node, in, type.text(kinds)),
                new JointSpec.Place(
                        a,
                        b,
                        axis == null ? JointSpec.Place.DEFAULT.axis() : axis.xyz("an axis"),
                        second == null ? null : second.xyz("an axis")),
                axes == null ? List.of() : axes(axes),
                in.containsKey("length") ? in.get("length").positive("a length in metres") : 0,
                in.containsKey("collide") && in.get("collide").truth(),
                most(in.get("breakForce")),
                most(in.get("breakTorque")),
                !in.containsKey("on") || in.get("on").truth());
    }

    private static List<Double> parameters(JsonNode node, Map<String, JsonNode> in, String kind) {
        if (kind.equals("path")) {
            return path(node, in);
        }
        for (String word : List.of("points", "closed")) {
            if (in.containsKey(word)) {
                throw in.get(word).wrong("no points of a " + kind, in.get(word).shown());
            }
        }
        int wanted = JointSpec.parameters(kind);
        if (wanted == 0 && !in.containsKey("parameters")) {
            return List.of();
        }
        JsonNode list = node.required(in, "parameters");
        String what = wanted + " numbers for a " + kind;
        List<Double> numbers = new ArrayList<>();
        for (JsonNode number : list.items(what)) {
            numbers.add(number.number(what));
        }
        if (numbers.size() != wanted) {
            throw list.wrong(what, list.shown());
        }
        return numbers;
    }

    /** Whether it is closed, and its points. */
    private static List<Double> path(JsonNode node, Map<String, JsonNode> in) {
        boolean isClosed = in.containsKey("closed") && in.get("closed").truth();
        int least = isClosed ? 3 : 2;
        String what = "at least %d points of a path".formatted(least);
        JsonNode list = node.required(in, "points");
        List<JsonNode> points = list.items(what);
        if (points.size() < least) {
            throw list.wrong(what, list.shown());
        }
        List<Double> numbers = new ArrayList<>(List.of(isClosed ? 1.0 : 0.0));
        for (JsonNode point : points) {
            Xyz p = point.xyz("a point of the path");
            numbers.addAll(List.of(p.x(), p.y(), p.z()));
        }
        return numbers;
    }

    private static double most(@Nullable JsonNode node) {
        return node == null ? Double.POSITIVE_INFINITY : node.positive("a force or torque");
    }

    private static List<JointSpec.Axis> axes(JsonNode node) {
        Map<String, JsonNode> in = node.fields("what is done about axes", AXES);
        List<JointSpec.Axis> axes = new ArrayList<>();
        for (JointAxis axis : JointAxis.values()) {
            JsonNode one = in.get(word(axis));
            if (one != null) {
                axes.add(new JointSpec.Axis(axis, axis(one)));
            }
        }
        return axes;
    }

    private static AxisState axis(JsonNode node) {
        Map<String, JsonNode> in = node.fields("an axis", AXIS);
        boolean isLocked = in.containsKey("locked") && in.get("locked").truth();
        double lower = 0;
        double upper = 0;
        JsonNode limits = in.get("limits");
        if (limits != null) {
            List<JsonNode> two = limits.items("a lower and an upper limit");
            if (two.size() != 2) {
                throw limits.wrong("a lower and an upper limit", limits.shown());
            }
            lower = limit(two.get(0), Double.NEGATIVE_INFINITY);
            upper = limit(two.get(1), Double.POSITIVE_INFINITY);
        }
        Map<String, JsonNode> motor =
                in.containsKey("motor") ? in.get("motor").fields("a motor", MOTOR) : Map.of();
        Map<String, JsonNode> spring =
                in.containsKey("spring") ? in.get("spring").fields("a spring", SPRING) : Map.of();
        boolean isDriven = in.containsKey("motor");
        boolean isSprung = in.containsKey("spring");
        boolean isAbsolute = spring.containsKey("stiffness") || spring.containsKey("damping");
        return new AxisState(
                isLocked,
                limits != null,
                lower,
                upper,
                isDriven,
                isDriven && motor.containsKey("speed") ? motor.get("speed").number("a speed") : 0,
                isDriven ? most(motor.get("most")) : 0,
                isSprung,
                number(spring.get("target")),
                isAbsolute ? number(spring.get("stiffness")) : number(spring.get("hertz")),
                isAbsolute ? number(spring.get("damping")) : number(spring.get("dampingRatio")),
                isAbsolute,
                isSprung ? most(spring.get("most")) : 0);
    }

    private static double number(@Nullable JsonNode node) {
        return node == null ? 0 : node.number("a number");
    }

    /** A number, or the word "none". */
    private static double limit(JsonNode node, double none) {
        return node.shown().equals("\"none\"") ? none : node.number("a number or \"none\"");
    }

    // Writing -------------------------------------------------------------------------------------

    static JsonObject write(JointSpec joint) {
        JsonObject out = new JsonObject();
        out.addProperty("type", joint.kind());
        if (!joint.name().isEmpty()) {
            out.addProperty("name", joint.name());
        }
        out.add("a", SceneWriter.number(joint.a()));
        out.add("b", SceneWriter.number(joint.b()));
        if (joint.kind().equals("path")) {
            path(joint.parameters(), out);
        } else if (!joint.parameters().isEmpty()) {
            JsonArray numbers = new JsonArray();
            joint.parameters().forEach(number -> numbers.add(SceneWriter.number(number)));
            out.add("parameters", numbers);
        }
        Xyz pa = joint.place().anchorA();
        Xyz pb = joint.place().anchorB();
        if (pa != null && pb != null) {
            if (pa.equals(pb)) {
                out.add("at", SceneWriter.xyz(pa));
            } else {
                JsonArray two = new JsonArray();
                two.add(SceneWriter.xyz(pa));
                two.add(SceneWriter.xyz(pb));
                out.add("anchors", two);
            }
        }
        if (!joint.place().axis().equals(JointSpec.Place.DEFAULT.axis())) {
            out.add("axis", SceneWriter.xyz(joint.place().axis()));
        }
        Xyz second = joint.place().secondAxis();
        if (second != null) {
            out.add("secondAxis", SceneWriter.xyz(second));
        }
        if (!joint.axes().isEmpty()) {
            JsonObject axes = new JsonObject();
            for (JointSpec.Axis axis : joint.axes()) {
                axes.add(word(axis.axis()), axis(axis.state()));
            }
            out.add("axes", axes);
        }
        if (joint.length() > 0) {
            out.add("length", SceneWriter.number(joint.length()));
        }
        if (joint.collides()) {
            out.addProperty("collide", true);
        }
        most(out, "breakForce", joint.breakForce());
        most(out, "breakTorque", joint.breakTorque());
        if (!joint.isOn()) {
            out.addProperty("on", false);
        }
        return out;
    }

    private static void path(List<Double> numbers, JsonObject out) {
        JsonArray points = new JsonArray();
        for (int i = 1; i + 2 < numbers.size(); i += 3) {
            points.add(
                    SceneWriter.xyz(
                            new Xyz(numbers.get(i), numbers.get(i + 1), numbers.get(i + 2))));
        }
        out.add("points", points);
        if (numbers.get(0) != 0) {
            out.addProperty("closed", true);
        }
    }

    private static void most(JsonObject out, String name, double value) {
        if (value != Double.POSITIVE_INFINITY) {
            out.add(name, SceneWriter.number(value));
        }
    }

    private static JsonObject axis(AxisState s) {
        JsonObject out = new JsonObject();
        if (s.isLocked()) {
            out.addProperty("locked", true);
        }
        if (s.isLimited()) {
            JsonArray two = new JsonArray();
            for (double limit : new double[] {s.lower(), s.upper()}) {
                if (Double.isInfinite(limit)) {
                    two.add("none");
                } else {
                    two.add(SceneWriter.number(limit));
                }
            }
            out.add("limits", two);
        }
        if (s.isDriven()) {
            JsonObject motor = new JsonObject();
            motor.add("speed", SceneWriter.number(s.speed()));
            most(motor, "most", s.motorMost());
            out.add("motor", motor);
        }
        if (s.isSprung()) {
            JsonObject spring = new JsonObject();
            spring.add("target", SceneWriter.number(s.target()));
            spring.add(s.isAbsolute() ? "stiffness" : "hertz", SceneWriter.number(s.stiffness()));
            spring.add(
                    s.isAbsolute() ? "damping" : "dampingRatio", SceneWriter.number(s.damping()));
            most(spring, "most", s.springMost());
            out.add("spring", spring);
        }
        return out;
    }

    private static String word(JointAxis axis) {
        return switch (axis) {
            case X -> "x";
            case Y -> "y";
            case Z -> "z";
            case TWIST -> "twist";
            case SWING_Y -> "swingY";
            case SWING_Z -> "swingZ";
            case CONE -> "cone";
            case DISTANCE -> "distance";
            case PATH -> "path";
        };
    }
}
