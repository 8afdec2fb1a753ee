package dev.cairn.benchmarks.render;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * CPU time of one frame on the drawing thread: update, culling, upload and submission of boxes and
 * balls, with shadows, into 64 x 36 pixels. Three cases: the picture stands still; the camera moves
 * within a tick (culling and lists of slots); each frame brings a new tick (poses too).
 */
public final class RenderFrame {
    private static final int FRAMES = 200;
    private static final int ROUNDS = 7;
    private static final double SPREAD = 30;

    private RenderFrame() {}

    /**
     * Measures and prints a table.
     *
     * @param args numbers of bodies; 1000 and 10000 if there are none
     */
    public static void main(String[] args) {
        try (Offscreen view = Offscreen.open(64, 36)) {
            System.out.println("renderer: " + view.renderer());
            if (!view.renderer().startsWith("NOOP")) {
                System.out.println(
                        "the times hold the rasteriser's vertices; set GALLIUM_NOOP=1 to leave"
                                + " them out");
            }
            System.out.println(
                    "CPU time of the drawing thread, ms per frame, median of "
                            + ROUNDS
                            + " rounds of "
                            + FRAMES
                            + " frames");
            System.out.println(" bodies    drawn    still   camera moves   new tick");
            int[] counts =
                    args.length == 0
                            ? new int[] {1000, 10_000}
                            : Arrays.stream(args).mapToInt(Integer::parseInt).toArray();
            for (int bodies : counts) {
                measure(view, bodies);
            }
        }
    }

    private static void measure(Offscreen view, int bodies) {
        SplittableRandom random = new SplittableRandom(1);
        SnapshotExchange exchange = new SnapshotExchange();
        try (World world = World.builder().workers(1).build()) {
            for (int i = 0; i < bodies; i++) {
                Model model =
                        Model.of(i % 2 == 0 ? Meshes.CUBE : Meshes.BALL)
                                .scale(0.3)
                                .color(random.nextInt(1 << 24));
                world.spawn(
                        Pose.at(
                                random.nextDouble(-SPREAD, SPREAD),
                                random.nextDouble(-SPREAD, SPREAD),
                                random.nextDouble(-SPREAD, SPREAD)),
                        new Visual(model));
            }
            double[] still = new double[ROUNDS];
            double[] moving = new double[ROUNDS];
            double[] ticking = new double[ROUNDS];
            for (int round = -3; round < ROUNDS; round++) {
                int at = Math.max(round, 0);
                still[at] = round(view, world, exchange, false, false);
                moving[at] = round(view, world, exchange, true, false);
                ticking[at] = round(view, world, exchange, true, true);
            }
            System.out.println(
                    String.format(
                            Locale.ROOT,
                            "%7d  %7d  %7.3f  %13.3f  %9.3f",
                            bodies,
                            view.drawn(),
                            median(still),
                            median(moving),
                            median(ticking)));
        }
    }

    /** CPU milliseconds per frame. */
    private static double round(
            Offscreen view, World world, SnapshotExchange exchange, boolean moves, boolean ticks) {
        var threads = ManagementFactory.getThreadMXBean();
        Camera camera = new Camera();
        exchange.publish(world);
        PoseSnapshot snapshot = exchange.latest();
        long nanos = 0;
        for (int frame = 0; frame < FRAMES; frame++) {
            if (ticks) {
                world.step(1.0 / 60);
                exchange.publish(world);
                snapshot = exchange.latest();
            }
            double angle = moves ? frame * 0.01 : 0;
            camera.lookAt(50 * Math.sin(angle), 12, 50 * Math.cos(angle), 0, 0, 0);
            long start = threads.getCurrentThreadCpuTime();
            view.draw(snapshot, 0.5, camera, Light.DAYLIGHT);
            nanos += threads.getCurrentThreadCpuTime() - start;
        }
        return nanos * 1e-6 / FRAMES;
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
