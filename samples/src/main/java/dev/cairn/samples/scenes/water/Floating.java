package dev.cairn.samples.scenes.water;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneView;
import dev.cairn.samples.weather.Buoyancy;
import dev.cairn.samples.weather.Hull;
import dev.cairn.samples.weather.Wind;

import org.joml.Vector3d;

import java.util.Arrays;
import java.util.List;

/**
 * Cubes of different densities that float and drift: water and wind are systems of the ECS, beside
 * rigid bodies that know of neither.
 *
 * <p>Truths, for a cube of edge H and density {@code rho} in water of density {@code rho_w}. It
 * rests at the depth {@code rho H / rho_w} (Archimedes). Lifted out of it, it heaves as a spring of
 * stiffness {@code rho_w g H²} under the mass {@code rho H³}, with the period {@code 2 pi sqrt(rho
 * H / (rho_w g))}; what the water would take along as added mass is left out, and so are waves. The
 * wind u takes it along by {@code m v' = c (u - v)}, so that after n ticks of h {@code v = u (1 -
 * (1 - c h/m)^n)}.
 */
public final class Floating {
    private static final double HALF = 0.5;
    private static final double EDGE = 2 * HALF;
    private static final double[] DENSITIES = {100, 300, 500, 700, 900};
    private static final double DRAG = 60;
    private static final double LIFTED = 0.15;
    private static final double HEAVER = 500;
    private static final int WATER_RGB = 0x2F6690;

    private Floating() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "buoyancy",
                "Buoyancy and wind",
                "Cubes of 100 to 900 kg/m³ float as deep as their weight says and drift with the"
                        + " wind, the light ones first; the last one heaves.",
                "water",
                List.of(
                        Parameter.real("water", 1000, 950, 2000, "density of the water, kg/m³"),
                        Parameter.real("wind", 3, -10, 10, "speed of the air along x, m/s")),
                600,
                240,
                Floating::build,
                options ->
                        List.of(
                                new Buoyancy(option(options, "water"), SampleScene.GRAVITY),
                                new Wind(option(options, "wind"), 0)));
    }

    private static double option(SceneOptions options, String name) {
        return options.values().getOrDefault(name, Double.NaN);
    }

    private static void build(SceneBuilder scene) {
        double water = scene.get("water");
        BodyRef[] cubes = new BodyRef[DENSITIES.length];
        double[] depths = new double[cubes.length];
        for (int i = 0; i < cubes.length; i++) {
            depths[i] = EDGE * DENSITIES[i] / water;
            cubes[i] = cube(scene, i, DENSITIES[i], HALF - depths[i]);
        }
        double rest = HALF - EDGE * HEAVER / water;
        BodyRef heaver = cube(scene, cubes.length, HEAVER, rest + LIFTED);
        Box surface = Box.ofHalfExtents(400, 0.005, 400);
        scene.addVisual(Pose.at(0, -0.005, 0), new Visual(Model.of(surface).color(WATER_RGB)));
        scene.view(new SceneView(3, 4.5, 11, 3, 0, 0));
        truths(scene, cubes, depths, new Heaving(heaver, rest, water));
    }

    private static BodyRef cube(SceneBuilder scene, int place, double density, double y) {
        return scene.add(
                Box.cubeOfEdge(EDGE),
                Palette.body(place),
                Body.dynamic()
                        .mass(density * EDGE * EDGE * EDGE)
                        .at(0, y, 1.5 * place - 4)
                        .name("cube of " + Math.round(density) + " kg/m³")
                        .with(new Hull(EDGE * EDGE, HALF, DRAG), Force.ZERO));
    }

    private static void truths(
            SceneBuilder scene, BodyRef[] cubes, double[] depths, Heaving heaving) {
        double[] worst = new double[2];
        double wind = scene.get("wind");
        double[] calm = new double[cubes.length];
        Arrays.fill(calm, 1);
        Vector3d at = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            for (int i = 0; i < cubes.length; i++) {
                double depth = HALF - cubes[i].position(at).y;
                worst[0] = Math.max(worst[0], Math.abs(depth - depths[i]));
                calm[i] *=
                        1 - DRAG * SampleScene.STEP_SECONDS / (DENSITIES[i] * EDGE * EDGE * EDGE);
                double truth = wind * (1 - calm[i]);
                worst[1] = Math.max(worst[1], Math.abs(cubes[i].velocity(at).x - truth));
            }
            heaving.note(seconds);
        });
        scene.error("depthMetres", () -> worst[0]);
        scene.error("driftMetresPerSecond", () -> worst[1]);
        scene.error("periodRelative", heaving::error);
    }

    /** Measures the period of a cube from the times at which it passes its place of rest. */
    private static final class Heaving {
        private final BodyRef cube;
        private final double rest;
        private final double period;
        private final Vector3d at = new Vector3d();
        private double before = LIFTED;
        private double first;
        private double last;
        private int crossings;

        Heaving(BodyRef cube, double rest, double water) {
            this.cube = cube;
            this.rest = rest;
            period = 2 * Math.PI * Math.sqrt(HEAVER * EDGE / (water * SampleScene.GRAVITY));
        }

        void note(double seconds) {
            double now = cube.position(at).y - rest;
            if (before > 0 && now <= 0) {
                last = seconds - SampleScene.STEP_SECONDS * now / (now - before);
                first = crossings == 0 ? last : first;
                crossings++;
            }
            before = now;
        }

        double error() {
            return crossings < 2 ? Double.NaN : (last - first) / (crossings - 1) / period - 1;
        }
    }
}
