package dev.cairn.samples.decompose;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.MeshReport;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.physics.shape.decomposition.Decomposition;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.ObjFormatException;
import dev.cairn.render.mesh.ObjReader;
import dev.cairn.samples.scenefile.MeshParts;
import dev.cairn.samples.scenefile.SceneWriter;

import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.DoubleConsumer;

/** {@code samples --decompose}: convex parts of an .obj file as a scene. Main thread. */
@Command(
        name = "samples --decompose",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        usageHelpWidth = 100,
        description = {
            "Makes a few convex parts of the triangles of an .obj file, tells their error, and",
            "writes a scene in which a body of these parts falls; the parts are shown beside it.",
        },
        footer = {
            "",
            "Examples:",
            "  samples --decompose mug.obj --out mug.json --picture mug.png",
            "  samples --decompose mug.obj --parts 32 --error 0.01 --out mug.json",
            "",
            "Exit codes: 0 done; 1 the error is larger than was allowed, more parts would be"
                    + " needed;",
            "2 the options or the file make no sense."
        })
public final class DecomposeCommand {
    private static final int BAR_WIDTH = 100;
    private static final int BAR_STEPS = 1000;

    @Option(names = "--decompose", paramLabel = "FILE.obj", required = true)
    Path file = Path.of("");

    @Option(names = "--parts", description = "Most parts; 32 by default.")
    int parts = 32;

    @Option(
            names = "--error",
            description =
                    "How far a part may go beyond the mesh, a share of its longest side; 0.01 by"
                            + " default.")
    double error = 0.01;

    @Option(
            names = "--size",
            paramLabel = "METRES",
            description = "Length that the longest side gets; as in the file by default.")
    @Nullable Double size;

    @Option(names = "--seed", description = "Seed of the planes that are drawn; 0 by default.")
    long seed;

    @Option(names = "--workers", description = "Threads; the parts do not depend on it.")
    int workers = Jobs.defaultWorkers();

    @Option(names = "--out", paramLabel = "FILE.json", description = "The scene file to write.")
    @Nullable Path out;

    @Option(
            names = "--picture",
            paramLabel = "FILE.png",
            description = "Draws the scene; goes with --out.")
    @Nullable Path picture;

    private DecomposeCommand() {}

    /** Runs a scene file: the samples' own command line. */
    @FunctionalInterface
    public interface Samples {
        /**
         * Runs it.
         *
         * @param arguments options
         * @return the exit code
         */
        int run(String... arguments);
    }

    /**
     * Runs the command.
     *
     * @param arguments all options
     * @param out standard output: what was made
     * @param err standard error: progress and refusals
     * @param terminal whether a person watches, who gets a progress bar
     * @param samples draws a scene file
     * @return the exit code
     */
    public static int run(
            String[] arguments,
            PrintStream out,
            PrintStream err,
            boolean terminal,
            Samples samples) {
        DecomposeCommand command = new DecomposeCommand();
        CommandLine line = new CommandLine(command);
        try {
            CommandLine.ParseResult parsed = line.parseArgs(arguments);
            if (parsed.isUsageHelpRequested()) {
                line.usage(out);
                return 0;
            }
            return command.run(out, err, terminal, samples);
        } catch (CommandLine.ParameterException | IllegalArgumentException wrong) {
            err.println(wrong.getMessage() + "; samples --decompose --help lists the options");
            return 2;
        }
    }

    private int run(PrintStream told, PrintStream err, boolean terminal, Samples samples) {
        if (picture != null && out == null) {
            throw new IllegalArgumentException(
                    "--picture %s: draws the scene of --out FILE.json; give one"
                            .formatted(picture));
        }
        if (workers < 1 || workers > Jobs.MAX_WORKERS) {
            throw new IllegalArgumentException(
                    "--workers %d: expected 1..%d".formatted(workers, Jobs.MAX_WORKERS));
        }
        Path folder = out == null ? null : out.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new IllegalArgumentException(
                    "--out %s: cannot write there; name a file in a folder that exists"
                            .formatted(out));
        }
        TriangleMesh mesh = mesh();
        long begin = System.nanoTime();
        Decomposition made = decompose(mesh, err, terminal);
        double seconds = 1e-9 * (System.nanoTime() - begin);
        tell(mesh, made, seconds, told);
        if (out != null) {
            SceneWriter.write(PartsScene.of(String.valueOf(file.getFileName()), made), out);
            told.println(
                    "Scene: " + out.toAbsolutePath() + "   (samples --scene-file " + out + ")");
        }
        if (picture != null) {
            int code =
                    samples.run(
                            "--headless",
                            "--scene-file",
                            String.valueOf(out),
                            "--ticks",
                            "1",
                            "--picture",
                            picture.toString());
            if (code != 0) {
                return code;
            }
        }
        return made.isWithinAllowed() ? 0 : 1;
    }

    private TriangleMesh mesh() {
        try {
            Mesh drawn = ObjReader.read(file);
            double factor = size == null ? 1 : size / longestSide(drawn.points());
            if (!(factor > 0 && factor <= Double.MAX_VALUE)) {
                throw new IllegalArgumentException("--size %s: expected above 0".formatted(size));
            }
            return MeshParts.surface(drawn, factor, factor, factor);
        } catch (ObjFormatException | DegenerateShapeException | UncheckedIOException broken) {
            throw new IllegalArgumentException(
                    "--decompose %s: %s".formatted(file, broken.getMessage()), broken);
        }
    }

    private static double longestSide(double[] points) {
        double longest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < points.length; i += 3) {
                low = Math.min(low, points[i]);
                high = Math.max(high, points[i]);
            }
            longest = Math.max(longest, high - low);
        }
        return longest;
    }

    private Decomposition decompose(TriangleMesh mesh, PrintStream err, boolean terminal) {
        try (Jobs jobs = Jobs.of(workers);
                ProgressBar bar = terminal ? bar(err) : null) {
            DoubleConsumer progress =
                    share -> {
                        if (bar != null) {
                            bar.stepTo(Math.round(share * BAR_STEPS));
                        }
                    };
            return Decomposer.of(mesh)
                    .parts(parts)
                    .error(error)
                    .seed(seed)
                    .progress(progress)
                    .run(jobs);
        } catch (DegenerateShapeException flat) {
            throw new IllegalArgumentException(
                    "--decompose %s: no solid: %s".formatted(file, flat.getMessage()), flat);
        }
    }

    private void tell(TriangleMesh mesh, Decomposition made, double seconds, PrintStream told) {
        int corners = 0;
        for (ConvexHull part : made.parts()) {
            corners += part.vertices().length / 3;
        }
        told.printf(
                "%s: %d triangles, %d parts with %d corners, %.1f s%n",
                file, mesh.report().triangles(), made.parts().size(), corners, seconds);
        told.printf(
                "  beyond the mesh  %.4g m (at most %.4g), allowed %.4g%s%n",
                made.beyond(),
                made.beyondAtMost(),
                made.allowed(),
                made.isWithinAllowed() ? "" : ": more parts, or more error, would be needed");
        told.printf("  short of it      %.4g m%n", made.missing());
        MassProperties solid = MeshParts.mass(made, 1, null);
        if (solid != null) {
            told.printf("  volume           %.6g m3 of %.6g%n", made.volume(), solid.mass());
        } else {
            MeshReport report = mesh.report();
            told.printf(
                    "  not closed, or inside out: %d open, %d crowded, %d flipped edges; the mass"
                            + " is that of the parts%n",
                    report.openEdges(), report.crowdedEdges(), report.flippedEdges());
        }
    }

    private static ProgressBar bar(PrintStream err) {
        return new ProgressBarBuilder()
                .setTaskName("parts")
                .setInitialMax(BAR_STEPS)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(100)
                .setConsumer(new ConsoleProgressBarConsumer(err, BAR_WIDTH))
                .build();
    }
}
