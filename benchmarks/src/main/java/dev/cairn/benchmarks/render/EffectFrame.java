package dev.cairn.benchmarks.render;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Model;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Wall time of a whole picture, drawn to its end, with each effect alone, without each, with none
 * and with all: what they cost on the graphics processor, or on the rasteriser in its place. A
 * floor of 80 x 80 m, boxes on it, four samples a pixel.
 */
public final class EffectFrame {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final int ROUNDS = 15;
    private static final List<String> NAMES =
            List.of(
                    "soft-shadows",
                    "occlusion",
                    "reflections",
                    "filmic",
                    "horizon",
                    "sky-light",
                    "cascades",
                    "antialiasing");

    private EffectFrame() {}

    /**
     * Measures and prints a table.
     *
     * @param args number of boxes, 200 if there is none, and frames to a round, 1 if there is none
     */
    public static void main(String[] args) {
        int bodies = args.length > 0 ? Integer.parseInt(args[0]) : 200;
        int frames = args.length > 1 ? Integer.parseInt(args[1]) : 1;
        try (Offscreen view = Offscreen.open(WIDTH, HEIGHT);
                World world = World.builder().workers(1).build()) {
            System.out.printf(
                    Locale.ROOT,
                    "renderer: %s%n%d boxes, %d x %d pixels; ms of wall time per picture, best and"
                            + " median of %d rounds of %d%n",
                    view.renderer(),
                    bodies,
                    WIDTH,
                    HEIGHT,
                    ROUNDS,
                    frames);
            fill(world, bodies);
            SnapshotExchange exchange = new SnapshotExchange();
            exchange.publish(world);
            PoseSnapshot snapshot = exchange.latest();
            System.out.println("effects                        best   median   by plain");
            double plain = row(view, snapshot, "plain", "plain", frames, 0);
            for (String name : NAMES) {
                row(view, snapshot, name, name, frames, plain);
            }
            for (String name : NAMES) {
                String others =
                        String.join(",", NAMES.stream().filter(n -> !n.equals(name)).toList());
                row(view, snapshot, "all but " + name, others, frames, plain);
            }
            row(view, snapshot, "all", "all", frames, plain);
        }
    }

    private static void fill(World world, int bodies) {
        SplittableRandom random = new SplittableRandom(1);
        Model floor = Model.ground(Box.ofHalfExtents(40, 0.5, 40));
        world.spawn(Pose.at(0, -0.5, 0), new Visual(floor));
        for (int i = 0; i < bodies; i++) {
            double half = random.nextDouble(0.3, 0.8);
            Model model = Model.of(Box.cubeOfHalfExtent(half)).color(random.nextInt(1 << 24));
            world.spawn(
                    Pose.at(random.nextDouble(-9, 9), half, random.nextDouble(-9, 9)),
                    new Visual(model));
        }
    }

    private static double row(
            Offscreen view,
            PoseSnapshot snapshot,
            String title,
            String effects,
            int frames,
            double plain) {
        view.effects(Effects.named(effects));
        double[] millis = new double[ROUNDS];
        for (int round = -3; round < ROUNDS; round++) {
            long start = System.nanoTime();
            for (int frame = 0; frame < frames; frame++) {
                // Another view each time, as in a window.
                double angle = 0.5 + 0.01 * (round * frames + frame);
                Camera camera =
                        new Camera().lookAt(16 * Math.sin(angle), 7, 16 * Math.cos(angle), 0, 0, 0);
                view.draw(snapshot, 1, camera, Light.DAYLIGHT);
            }
            view.finish();
            millis[Math.max(round, 0)] = (System.nanoTime() - start) * 1e-6 / frames;
        }
        Arrays.sort(millis);
        System.out.printf(
                Locale.ROOT,
                "%-26s  %8.3f %8.3f   %8.2f%n",
                title,
                millis[0],
                millis[ROUNDS / 2],
                plain > 0 ? millis[0] / plain : 1.0);
        return millis[0];
    }
}
