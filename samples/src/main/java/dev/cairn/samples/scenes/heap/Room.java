package dev.cairn.samples.scenes.heap;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;

/**
 * Two balls and two boxes, thrown and dropped between four walls. Truth: nothing leaves the room.
 */
public final class Room {
    private static final double HALF = 4;
    private static final double WALL = 0.25;
    private static final double HEIGHT = 1.5;

    private Room() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "room",
                "Room",
                "Two balls and two boxes are thrown and dropped in a room; the wall towards the"
                        + " camera is of glass.",
                "motion",
                List.of(
                        Parameter.real("speed", 5, 0, 20, "speed of the thrown bodies, m/s"),
                        Parameter.real("height", 3, 1, 20, "height of the dropped bodies, m"),
                        Parameter.real("friction", 0.5, 0, 10, "Coulomb coefficient"),
                        Parameter.real("restitution", 0.5, 0, 1, "coefficient of restitution")),
                360,
                100,
                Room::build);
    }

    private static void build(SceneBuilder scene) {
        double friction = scene.get("friction");
        double restitution = scene.get("restitution");
        double speed = scene.get("speed");
        double height = scene.get("height");
        scene.floor(HALF + 2 * WALL, HALF + 2 * WALL, friction, restitution);
        Material material = Palette.material(friction, restitution);
        Box side = Box.ofHalfExtents(WALL, HEIGHT, HALF);
        Box front = Box.ofHalfExtents(HALF + 2 * WALL, HEIGHT, WALL);
        scene.add(side, Model.ground(side).color(Palette.STONE), wall(-HALF - WALL, 0, material));
        scene.add(side, Model.ground(side).color(Palette.STONE), wall(HALF + WALL, 0, material));
        scene.add(front, Model.ground(front).color(Palette.STONE), wall(0, -HALF - WALL, material));
        scene.addGlass(front, wall(0, HALF + WALL, material));

        Shape ball = Sphere.of(0.35);
        Shape box = Box.ofHalfExtents(0.4, 0.3, 0.5);
        BodyRef[] thrown = {
            scene.add(
                    ball,
                    Palette.body(0),
                    Body.dynamic()
                            .at(-3, 1, -1)
                            .velocity(speed, 2, 0.4 * speed)
                            .mass(1)
                            .material(material)
                            .name("thrown ball")),
            scene.add(
                    ball,
                    Palette.body(1),
                    Body.dynamic()
                            .at(1.5, height, 0)
                            .mass(1)
                            .material(material)
                            .name("dropped ball")),
            scene.add(
                    box,
                    Palette.body(2),
                    Body.dynamic()
                            .at(2.8, 1.2, 1.5)
                            .velocity(-speed, 1, -0.3 * speed)
                            .angularVelocity(1, 2, 3)
                            .mass(2)
                            .material(material)
                            .name("thrown box")),
            scene.add(
                    box,
                    Palette.body(3),
                    Body.dynamic()
                            .at(-1, height, -1.5)
                            .rotationAbout(1, 0, 1, 0.6)
                            .mass(2)
                            .material(material)
                            .name("dropped box")),
        };
        scene.view(new SceneView(2.5, 6.5, 11, 0, 0.4, 0));
        scene.error("escapedBodies", () -> escaped(thrown));
    }

    private static Body wall(double x, double z, Material material) {
        return Body.fixed().at(x, HEIGHT, z).material(material).name("wall");
    }

    private static double escaped(BodyRef[] bodies) {
        int out = 0;
        for (BodyRef body : bodies) {
            Vector3d at = body.position();
            if (Math.abs(at.x) > HALF || Math.abs(at.z) > HALF || at.y < 0) {
                out++;
            }
        }
        return out;
    }
}
