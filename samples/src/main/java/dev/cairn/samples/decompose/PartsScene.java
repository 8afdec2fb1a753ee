package dev.cairn.samples.decompose;

import dev.cairn.physics.Material;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.decomposition.Decomposition;
import dev.cairn.samples.Palette;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.BodySpec;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.MeshParts;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** A scene of a decomposed mesh: a body of its parts that falls, and its parts pulled apart. */
final class PartsScene {
    /** Parts stand so many times as far from the middle as in the body. */
    private static final double APART = 1.4;

    private PartsScene() {}

    static SceneFile of(String name, Decomposition made) {
        double[] box = box(made);
        double size = Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
        Xyz middle =
                new Xyz(0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), 0.5 * (box[2] + box[5]));
        List<EntitySpec> entities = new ArrayList<>();
        entities.add(
                EntitySpec.of(
                                "ground",
                                BodyKind.FIXED,
                                new BoxShape(new Xyz(4 * size, 0.1 * size, 4 * size)))
                        .at(new Xyz(0, -0.1 * size, 0), Turn.NONE)
                        .withLook(LookSpec.DEFAULT.withRgb(Palette.STONE)));
        entities.add(
                body(name, made)
                        .at(
                                new Xyz(
                                        -0.75 * size - middle.x(),
                                        0.3 * size - box[1],
                                        -middle.z()),
                                Turn.NONE));
        // the lowest part stands above the ground by a fifth of the size
        double up = 0.2 * size + APART * 0.5 * (box[4] - box[1]);
        int index = 0;
        for (ConvexHull part : made.parts()) {
            Vector3d c = part.centreOfMass(new Vector3d());
            double far = APART - 1;
            entities.add(
                    EntitySpec.of("part " + index, BodyKind.NONE, hull(part))
                            .at(
                                    new Xyz(
                                            0.85 * size - middle.x() + far * (c.x - middle.x()),
                                            up - middle.y() + far * (c.y - middle.y()),
                                            -middle.z() + far * (c.z - middle.z())),
                                    Turn.NONE)
                            .withLook(LookSpec.DEFAULT.withRgb(Palette.body(index++))));
        }
        return SceneFile.empty("Parts of " + name)
                .withEntities(entities)
                .withCamera(
                        new CameraSpec(
                                new Xyz(0.4 * size, 1.6 * size, 3.4 * size),
                                new Xyz(0.1 * size, 0.55 * size, 0),
                                50));
    }

    private static EntitySpec body(String name, Decomposition made) {
        List<PartSpec> parts = new ArrayList<>();
        made.parts().forEach(part -> parts.add(PartSpec.of(hull(part))));
        BodySpec physics = BodySpec.DEFAULT.withParts(parts);
        EntitySpec body =
                EntitySpec.of(name, BodyKind.DYNAMIC, parts.get(0).shape())
                        .withLook(LookSpec.DEFAULT.withRgb(Palette.body(0)));
        MassProperties p = MeshParts.mass(made, Material.DEFAULT.density(), null);
        if (p == null) {
            return body.withPhysics(physics);
        }
        return body.withPhysics(
                        physics.withInertia(
                                        new Xyz(p.ixx(), p.iyy(), p.izz()),
                                        new Xyz(p.ixy(), p.ixz(), p.iyz()))
                                .withCentre(new Xyz(p.comX(), p.comY(), p.comZ())))
                .withMaterial(Material.DEFAULT, p.mass());
    }

    private static HullShape hull(ConvexHull part) {
        double[] v = part.vertices();
        List<Xyz> points = new ArrayList<>();
        for (int i = 0; i < v.length; i += 3) {
            points.add(new Xyz(v[i], v[i + 1], v[i + 2]));
        }
        return new HullShape(points);
    }

    private static double[] box(Decomposition made) {
        double far = Double.POSITIVE_INFINITY;
        double[] box = {far, far, far, -far, -far, -far};
        for (ConvexHull part : made.parts()) {
            double[] v = part.vertices();
            for (int i = 0; i < v.length; i++) {
                box[i % 3] = Math.min(box[i % 3], v[i]);
                box[i % 3 + 3] = Math.max(box[i % 3 + 3], v[i]);
            }
        }
        return box;
    }
}
