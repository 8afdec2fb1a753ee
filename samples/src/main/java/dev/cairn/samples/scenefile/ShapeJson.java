package dev.cairn.samples.scenefile;

import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.SurfaceShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Shapes in a scene file. Stateless; any thread. */
final class ShapeJson {
    static final List<String> SHAPES =
            List.of(
                    "box",
                    "sphere",
                    "capsule",
                    "cylinder",
                    "cone",
                    "half-space",
                    "hull",
                    "mesh",
                    "triangles",
                    "moved");

    private ShapeJson() {}

    static ShapeSpec read(JsonNode node) {
        Map<String, JsonNode> any =
                node.fields(
                        "a shape",
                        List.of(
                                "type",
                                "halfExtents",
                                "radius",
                                "halfHeight",
                                "points",
                                "file",
                                "as",
                                "triangles",
                                "twoSided",
                                "shape",
                                "position",
                                "rotation"));
        JsonNode type = node.required(any, "type");
        return switch (type.text("the kind of shape")) {
            case "box" -> {
                Map<String, JsonNode> in = node.fields("a box", List.of("type", "halfExtents"));
                yield new BoxShape(node.required(in, "halfExtents").xyz("half the sizes"));
            }
            case "sphere" -> {
                Map<String, JsonNode> in = node.fields("a sphere", List.of("type", "radius"));
                yield new SphereShape(node.required(in, "radius").positive("a radius in metres"));
            }
            case "hull" -> {
                Map<String, JsonNode> in = node.fields("a hull", List.of("type", "points"));
                List<Xyz> points = new ArrayList<>();
                for (JsonNode point : node.required(in, "points").items("a list of points")) {
                    points.add(point.xyz("a point"));
                }
                yield new HullShape(points);
            }
            case "capsule", "cylinder", "cone" -> {
                String word = type.text("the kind of shape");
                Map<String, JsonNode> in =
                        node.fields("a " + word, List.of("type", "radius", "halfHeight"));
                yield new TurnedShape(
                        word,
                        node.required(in, "radius").positive("a radius in metres"),
                        node.required(in, "halfHeight").positive("half a height in metres"));
            }
            case "half-space" -> {
                node.fields("a half-space", List.of("type"));
                yield new GroundShape();
            }
            case "moved" -> {
                Map<String, JsonNode> in =
                        node.fields(
                                "a moved shape", List.of("type", "shape", "position", "rotation"));
                JsonNode within = node.required(in, "shape");
                ShapeSpec inner = read(within);
                if (inner instanceof MeshShape) {
                    throw within.wrong("a shape that is no mesh", "a mesh");
                }
                yield new MovedShape(
                        inner,
                        node.required(in, "position").xyz("a place in metres"),
                        SceneReader.rotation(node.required(in, "rotation")));
            }
            case "mesh" -> {
                Map<String, JsonNode> in = node.fields("a mesh", List.of("type", "file", "as"));
                yield new MeshShape(
                        node.required(in, "file").text("the path of an .obj file"),
                        in.containsKey("as") && isLevel(in.get("as")));
            }
            case "triangles" -> {
                Map<String, JsonNode> in =
                        node.fields(
                                "a surface", List.of("type", "points", "triangles", "twoSided"));
                List<Xyz> points = new ArrayList<>();
                for (JsonNode point : node.required(in, "points").items("a list of points")) {
                    points.add(point.xyz("a point"));
                }
                List<Integer> corners = new ArrayList<>();
                String what = "a list of vertex numbers, three for each triangle";
                for (JsonNode corner : node.required(in, "triangles").items(what)) {
                    corners.add(corner.whole(0, points.size() - 1));
                }
                yield new SurfaceShape(
                        points, corners, in.containsKey("twoSided") && in.get("twoSided").truth());
            }
            default -> {
                String near = type.nearestOf(SHAPES);
                throw type.wrong(
                        "one of the shapes "
                                + String.join(", ", SHAPES)
                                + (near == null ? "" : " (did you mean " + near + "?)"),
                        type.shown());
            }
        };
    }

    private static boolean isLevel(JsonNode node) {
        String what = "\"hull\" or \"level\"";
        return switch (node.text(what)) {
            case "hull" -> false;
            case "level" -> true;
            default -> throw node.wrong(what, node.shown());
        };
    }
}
