package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Equal blocks pushed off in all directions slide to a stop.
 *
 * <p>Truth: each stops after {@code v²/(2 mu g)}, on the line that it was pushed along: they end on
 * a circle. Friction pyramids make a star of it, and of long blocks so does friction that is drawn
 * back from what would stop them: they tip more easily across than along.
 */
public final class FrictionStop {
    private static final double HALF = 0.15;
    private static final double HALF_HEIGHT = 0.05;
    private static final double START = 1.5;

    private FrictionStop() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "friction-stop",
                "Friction in all directions",
                "Blocks pushed off in all directions stop on a circle.",
                "friction",
                List.of(
                        Parameter.count("blocks", 24, 1, 24, "number of blocks"),
                        Parameter.real("speed", 5, 0, 20, "speed at the start, m/s"),
                        Parameter.real("friction", 0.5, 0.05, 10, "Coulomb coefficient"),
                        Parameter.real("length", 0.3, 0.1, 2, "length of a block along x, m")),
                180,
                120,
                FrictionStop::build);
    }

    private static void build(SceneBuilder scene) {
        int count = scene.count("blocks");
        double speed = scene.get("speed");
        double friction = scene.get("friction");
        double distance = speed * speed / (2 * friction * SampleScene.GRAVITY);
        scene.floor(distance + 4, distance + 4, friction, 0);
        Box shape = Box.ofHalfExtents(scene.get("length") / 2, HALF_HEIGHT, HALF);
        List<BodyRef> blocks = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double angle = 2 * StrictMath.PI * i / count;
            double x = StrictMath.cos(angle);
            double z = StrictMath.sin(angle);
            blocks.add(
                    scene.add(
                            shape,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(START * x, HALF_HEIGHT, START * z)
                                    .velocity(speed * x, 0, speed * z)
                                    .material(Palette.material(friction, 0))
                                    .name("block " + i)));
        }
        double far = 1.5 * distance + 3;
        scene.view(new SceneView(0, 0.9 * far, far, 0, 0, 0));
        double stopped = speed / (friction * SampleScene.GRAVITY) + 0.1;
        Ramp.Metric worst = new Ramp.Metric();
        Vector3d at = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            if (seconds < stopped || distance == 0) {
                return;
            }
            double error = 0;
            for (int i = 0; i < count; i++) {
                double angle = 2 * StrictMath.PI * i / count;
                double reach = START + distance;
                blocks.get(i).position(at);
                double dx = at.x - reach * StrictMath.cos(angle);
                double dz = at.z - reach * StrictMath.sin(angle);
                error = Math.max(error, StrictMath.sqrt(dx * dx + dz * dz) / distance);
            }
            worst.set(error);
        });
        scene.error("distanceRelative", worst::get);
    }
}
