package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.List;

/**
 * Every kind of shape, dropped into a room whose floor is a half-space. Truth: nothing leaves the
 * room and nothing sinks into the floor.
 */
public final class Shapes {
    private static final double HALF = 3;
    private static final double HEIGHT = 1;
    private static final double WALL = 0.15;

    private Shapes() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "shapes",
                "All shapes",
                "Balls, boxes, capsules, cylinders, cones and hulls fall into a room whose floor is"
                        + " a half-space.",
                "motion",
                List.of(
                        Parameter.count("each", 4, 1, 40, "bodies of each kind"),
                        Parameter.real("friction", 0.5, 0, 10, "Coulomb coefficient"),
                        Parameter.real("restitution", 0.1, 0, 1, "coefficient of restitution")),
                420,
                150,
                Shapes::build);
    }

    private static void build(SceneBuilder scene) {
        Material material = Palette.material(scene.get("friction"), scene.get("restitution"));
        Shape ground = HalfSpace.of();
        scene.add(
                ground,
                Model.ground(ground),
                Body.fixed().at(0, 0, 0).material(material).name("ground"));
        Box side = Box.ofHalfExtents(WALL, HEIGHT, HALF);
        Box front = Box.ofHalfExtents(HALF + 2 * WALL, HEIGHT, WALL);
        Model stone = Model.ground(side).color(Palette.STONE);
        scene.add(side, stone, wall(-HALF - WALL, 0, material));
        scene.add(side, stone, wall(HALF + WALL, 0, material));
        scene.add(front, Model.ground(front).color(Palette.STONE), wall(0, -HALF - WALL, material));
        scene.addGlass(front, wall(0, HALF + WALL, material));
        Shape[] kinds = kinds();
        int count = scene.count("each") * kinds.length;
        BodyRef[] bodies = new BodyRef[count];
        for (int i = 0; i < count; i++) {
            // layers of four by four
            int layer = i / 16;
            int row = i % 16 / 4;
            int column = i % 4;
            bodies[i] =
                    scene.add(
                            kinds[i % kinds.length],
                            Palette.body(i % kinds.length),
                            Body.dynamic()
                                    .at(1.2 * column - 1.8, 0.9 + 1.1 * layer, 1.2 * row - 1.8)
                                    .rotation(turn(scene))
                                    .material(material)
                                    .name("body " + i));
        }
        scene.view(new SceneView(2.2, 4.6, 7.6, 0, 0.3, -0.2));
        scene.error("escapedBodies", () -> escaped(bodies));
    }

    private static Shape[] kinds() {
        Quaterniond turned = new Quaterniond().rotationZ(0.5 * Math.PI);
        return new Shape[] {
            Capsule.of(0.2, 0.25),
            Cylinder.of(0.3, 0.3),
            Cone.of(0.35, 0.35),
            Sphere.of(0.3),
            Box.ofHalfExtents(0.35, 0.2, 0.28),
            Cylinder.of(0.4, 0.08),
            ConvexHull.of(
                    new double[] {
                        0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0, 0, -0.4
                    }),
            Cylinder.of(0.12, 0.4).moved(0, 0.1, 0, turned),
        };
    }

    private static Quaterniond turn(SceneBuilder scene) {
        return new Quaterniond(
                        scene.random(-0.5, 0.5),
                        scene.random(-0.5, 0.5),
                        scene.random(-0.5, 0.5),
                        scene.random(-0.5, 0.5))
                .normalize();
    }

    private static Body wall(double x, double z, Material material) {
        return Body.fixed().at(x, HEIGHT, z).material(material).name("wall");
    }

    private static double escaped(BodyRef[] bodies) {
        int out = 0;
        for (BodyRef body : bodies) {
            Vector3d at = body.centreOfMass(new Vector3d());
            if (Math.abs(at.x) > HALF || Math.abs(at.z) > HALF || at.y < 0) {
                out++;
            }
        }
        return out;
    }
}
