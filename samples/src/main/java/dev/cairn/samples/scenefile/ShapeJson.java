package dev.cairn.samples.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.FieldShape;
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

/** Reads and writes what an entity is shaped like. Stateless; any thread. */
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
                    "heights",
                    "moved");

    private static final List<String> HEIGHTS =
            List.of("type", "samplesX", "stepX", "stepZ", "thickness", "heights", "holes");

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
                                "parts",
                                "error",
                                "triangles",
                                "twoSided",
                                "samplesX",
                                "stepX",
                                "stepZ",
                                "heights",
                                "holes",
                                "thickness",
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
                Map<String, JsonNode> in =
                        node.fields("a mesh", List.of("type", "file", "as", "parts", "error"));
                try {
                    yield new MeshShape(
                            node.required(in, "file").text("the path of an .obj file"),
                            in.containsKey("as") ? as(in.get("as")) : As.HULL,
                            in.containsKey("parts")
                                    ? in.get("parts").whole(1, Decomposer.MOST_PARTS)
                                    : MeshShape.PARTS,
                            in.containsKey("error")
                                    ? in.get("error").positive("a share of the longest side")
                                    : MeshShape.ERROR);
                } catch (IllegalArgumentException refusal) {
                    throw node.refused(refusal);
                }
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
            case "heights" -> heights(node);
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

    private static As as(JsonNode node) {
        String what = "\"hull\", \"level\" or \"parts\"";
        return switch (node.text(what)) {
            case "hull" -> As.HULL;
            case "level" -> As.LEVEL;
            case "parts" -> As.PARTS;
            default -> throw node.wrong(what, node.shown());
        };
    }

    private static FieldShape heights(JsonNode node) {
        Map<String, JsonNode> in = node.fields("a height field", HEIGHTS);
        JsonNode list = node.required(in, "heights");
        String what = "a list of heights in metres, by rows along x";
        List<Double> heights = new ArrayList<>();
        for (JsonNode height : list.items(what)) {
            heights.add(height.number("a height in metres"));
        }
        int samplesX = node.required(in, "samplesX").whole(2, 1 << 20);
        if (heights.isEmpty() || heights.size() % samplesX != 0) {
            throw list.wrong("rows of " + samplesX + " heights", heights.size() + " heights");
        }
        double stepX = node.required(in, "stepX").positive("a step in metres");
        double stepZ = node.required(in, "stepZ").positive("a step in metres");
        List<FieldShape.Cells> holes = new ArrayList<>();
        if (in.containsKey("holes")) {
            for (JsonNode hole : in.get("holes").items("a list of holes")) {
                String cells = "[x, z, wide, deep] in cells";
                List<JsonNode> four = hole.items(cells);
                if (four.size() != 4) {
                    throw hole.wrong(cells, hole.shown());
                }
                holes.add(
                        new FieldShape.Cells(
                                four.get(0).whole(0, 1 << 29),
                                four.get(1).whole(0, 1 << 29),
                                four.get(2).whole(1, 1 << 29),
                                four.get(3).whole(1, 1 << 29)));
            }
        }
        double thickness =
                in.containsKey("thickness")
                        ? in.get("thickness").atLeastZero("a thickness in metres")
                        : Math.max(stepX, stepZ);
        return new FieldShape(samplesX, stepX, stepZ, thickness, heights, holes);
    }

    static JsonObject write(ShapeSpec shape) {
        JsonObject out = new JsonObject();
        out.addProperty("type", shape.type());
        switch (shape) {
            case BoxShape(Xyz half) -> out.add("halfExtents", SceneWriter.xyz(half));
            case SphereShape(double radius) -> out.add("radius", SceneWriter.number(radius));
            case HullShape hull -> {
                JsonArray points = new JsonArray();
                hull.points().forEach(point -> points.add(SceneWriter.xyz(point)));
                out.add("points", points);
            }
            case TurnedShape(String type, double radius, double half) -> {
                out.add("radius", SceneWriter.number(radius));
                out.add("halfHeight", SceneWriter.number(half));
            }
            case GroundShape() -> {}
            case MovedShape(ShapeSpec inner, Xyz at, Turn turn) -> {
                out.add("shape", write(inner));
                out.add("position", SceneWriter.xyz(at));
                out.add("rotation", SceneWriter.turn(turn));
            }
            case MeshShape(String file, As as, int parts, double error) -> {
                out.addProperty("file", file);
                if (as != As.HULL) {
                    out.addProperty("as", as == As.LEVEL ? "level" : "parts");
                }
                if (parts != MeshShape.PARTS) {
                    out.addProperty("parts", parts);
                }
                if (error != MeshShape.ERROR) {
                    out.add("error", SceneWriter.number(error));
                }
            }
            case SurfaceShape surface -> {
                JsonArray points = new JsonArray();
                surface.points().forEach(point -> points.add(SceneWriter.xyz(point)));
                out.add("points", points);
                JsonArray triangles = new JsonArray();
                surface.triangles().forEach(corner -> triangles.add(corner));
                out.add("triangles", triangles);
                if (surface.twoSided()) {
                    out.addProperty("twoSided", true);
                }
            }
            case FieldShape field -> {
                out.addProperty("samplesX", field.samplesX());
                out.add("stepX", SceneWriter.number(field.stepX()));
                out.add("stepZ", SceneWriter.number(field.stepZ()));
                if (field.thickness() != Math.max(field.stepX(), field.stepZ())) {
                    out.add("thickness", SceneWriter.number(field.thickness()));
                }
                JsonArray heights = new JsonArray();
                field.heights().forEach(height -> heights.add(SceneWriter.number(height)));
                out.add("heights", heights);
                if (!field.holes().isEmpty()) {
                    out.add("holes", holes(field.holes()));
                }
            }
        }
        return out;
    }

    private static JsonArray holes(List<FieldShape.Cells> holes) {
        JsonArray out = new JsonArray();
        for (FieldShape.Cells hole : holes) {
            JsonArray four = new JsonArray();
            four.add(hole.x());
            four.add(hole.z());
            four.add(hole.wide());
            four.add(hole.deep());
            out.add(four);
        }
        return out;
    }
}
