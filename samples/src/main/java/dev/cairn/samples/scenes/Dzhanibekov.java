package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Free bodies that turn over and over, without gravity: Dzhanibekov's wing nut.
 *
 * <p>Truth: about the middle axis of inertia a spin is unstable, so the body turns over in regular
 * intervals; about the others it is stable; the angular momentum of each stays what it was.
 */
public final class Dzhanibekov {
    private Dzhanibekov() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "dzhanibekov",
                "Dzhanibekov",
                "Three equal plates spin about their three axes, without gravity; the one in the"
                        + " middle turns over again and again.",
                "motion",
                List.of(
                        Parameter.real("spin", 6, 0, 100, "angular speed, rad/s"),
                        Parameter.real(
                                "nudge", 0.01, 0, 10, "angular speed about the other axes, rad/s")),
                900,
                170,
                Dzhanibekov::build);
    }

    private static void build(SceneBuilder scene) {
        scene.world().setGravity(0, 0, 0);
        scene.floor(8, 4, 0.6, 0);
        Box plate = Box.ofHalfExtents(0.9, 0.3, 0.08);
        double spin = scene.get("spin");
        double nudge = scene.get("nudge");
        List<BodyRef> bodies = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            BodyRef body =
                    scene.add(
                            plate,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(2.6 * (i - 1), 1.6, 0)
                                    .angularVelocity(
                                            i == 0 ? spin : nudge,
                                            i == 1 ? spin : nudge,
                                            i == 2 ? spin : nudge)
                                    .name("plate about axis " + i));
            bodies.add(body);
            starts.add(momentum(body));
        }
        scene.view(new SceneView(1.5, 3.2, 7.5, 0, 1.5, 0));
        scene.error(
                "momentumRelative",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < bodies.size(); i++) {
                        Vector3d start = starts.get(i);
                        if (start.lengthSquared() > 0) {
                            worst =
                                    Math.max(
                                            worst,
                                            momentum(bodies.get(i)).distance(start)
                                                    / start.length());
                        }
                    }
                    return worst;
                });
    }

    /** R I R^T w of a box of even density. */
    private static Vector3d momentum(BodyRef body) {
        Box box = (Box) body.shape();
        double xx = box.halfX() * box.halfX();
        double yy = box.halfY() * box.halfY();
        double zz = box.halfZ() * box.halfZ();
        Quaterniond q = body.orientation();
        Vector3d w = q.transformInverse(body.angularVelocity());
        w.mul(yy + zz, xx + zz, xx + yy).mul(body.mass() / 3);
        return q.transform(w);
    }
}
