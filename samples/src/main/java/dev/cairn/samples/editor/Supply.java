package dev.cairn.samples.editor;

import dev.cairn.render.mesh.ObjFormatException;
import dev.cairn.render.mesh.ObjReader;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** What the editor offers to be placed, and the scene it begins with. Stateless. */
final class Supply {
    /** Something to place. */
    record Item(String name, BodyKind body, ShapeSpec shape) {}

    static final List<Item> ITEMS =
            List.of(
                    new Item("box", BodyKind.DYNAMIC, new BoxShape(new Xyz(0.5, 0.5, 0.5))),
                    new Item("ball", BodyKind.DYNAMIC, new SphereShape(0.5)),
                    new Item("capsule", BodyKind.DYNAMIC, new TurnedShape("capsule", 0.3, 0.4)),
                    new Item("cylinder", BodyKind.DYNAMIC, new TurnedShape("cylinder", 0.5, 0.5)),
                    new Item("cone", BodyKind.DYNAMIC, new TurnedShape("cone", 0.5, 0.5)),
                    new Item("plank", BodyKind.DYNAMIC, new BoxShape(new Xyz(1.5, 0.1, 0.4))),
                    new Item(
                            "pyramid",
                            BodyKind.DYNAMIC,
                            new HullShape(
                                    List.of(
                                            new Xyz(-0.5, 0, -0.5),
                                            new Xyz(0.5, 0, -0.5),
                                            new Xyz(0.5, 0, 0.5),
                                            new Xyz(-0.5, 0, 0.5),
                                            new Xyz(0, 1, 0)))),
                    new Item(
                            "wedge",
                            BodyKind.FIXED,
                            new HullShape(
                                    List.of(
                                            new Xyz(-1.5, 0, -1),
                                            new Xyz(1.5, 0, -1),
                                            new Xyz(-1.5, 1.2, -1),
                                            new Xyz(-1.5, 0, 1),
                                            new Xyz(1.5, 0, 1),
                                            new Xyz(-1.5, 1.2, 1)))),
                    new Item("wall", BodyKind.FIXED, new BoxShape(new Xyz(2, 1, 0.15))),
                    new Item("half-space", BodyKind.FIXED, new GroundShape()),
                    new Item(
                            "hull",
                            BodyKind.DYNAMIC,
                            new HullShape(
                                    List.of(
                                            new Xyz(-0.6, 0, -0.4),
                                            new Xyz(0.6, 0, -0.4),
                                            new Xyz(0.4, 0, 0.5),
                                            new Xyz(-0.4, 0, 0.5),
                                            new Xyz(-0.3, 0.8, -0.2),
                                            new Xyz(0.3, 0.6, 0.2)))));

    /** The cube that stands in for any mesh. */
    static final EntitySpec ANY_MESH =
            EntitySpec.of("mesh", BodyKind.DYNAMIC, new MeshShape("any.obj"));

    private Supply() {}

    /** The least height in a mesh file, in its own frame, m; that of the cube if it is broken. */
    private static double lowest(Path file) {
        double lowest = Double.POSITIVE_INFINITY;
        try {
            double[] points = ObjReader.read(file).points();
            for (int i = 1; i < points.length; i += 3) {
                lowest = Math.min(lowest, points[i]);
            }
        } catch (ObjFormatException broken) {
            return Sizes.of(ANY_MESH).low().y(); // The loader says what is wrong with it.
        }
        return lowest;
    }

    /**
     * A mesh file with its lowest point where that of the cube was which stood in for it. Throws
     * IllegalArgumentException if there is no such file.
     */
    static EntitySpec mesh(Path folder, String path, Xyz at) {
        if (!Files.isRegularFile(folder.resolve(path))) {
            throw new IllegalArgumentException(
                    "%s: expected an .obj file, relative to %s; there is none"
                            .formatted(path, folder));
        }
        String name = String.valueOf(Path.of(path).getFileName()).replace(".obj", "");
        double raised = at.y() + Sizes.of(ANY_MESH).low().y() - lowest(folder.resolve(path));
        return EntitySpec.of(name, BodyKind.DYNAMIC, new MeshShape(path.replace('\\', '/')))
                .at(new Xyz(at.x(), raised, at.z()), Turn.NONE);
    }

    /** A fixed floor with one-metre squares, its upper side at y = 0. */
    static SceneFile emptyScene() {
        EntitySpec floor =
                EntitySpec.of("floor", BodyKind.FIXED, new BoxShape(new Xyz(20, 0.5, 20)))
                        .at(new Xyz(0, -0.5, 0), Turn.NONE)
                        .withLook(
                                LookSpec.DEFAULT.withRgb(0xC9CDD2).withTexture("builtin:grid", 2));
        return SceneFile.empty("new scene").withEntities(List.of(floor));
    }
}
