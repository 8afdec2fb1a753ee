package dev.cairn.benchmarks.narrowphase;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.NarrowPhase.Method;

import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;

import java.awt.Color;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Error of the signed distance against the CPU time of a query, with tolerance and iteration cap
 * swept. The truth is brute force over all face normals and edge pairs. Prints a table and, given a
 * folder, writes {@code narrow-phase-boxes.svg} and {@code narrow-phase-hulls.svg} there.
 *
 * <p>{@code java --add-modules=jdk.incubator.vector -jar benchmarks.jar narrow-phase docs/images}
 */
public final class ErrorAgainstTime {
    private static final double[] TOLERANCES = {1e-1, 1e-2, 1e-4, 1e-8, 0};
    private static final int[] CAPS = {1, 2, 3, 4, 6, 8, 12, 16};
    private static final int NO_CAP = Integer.MAX_VALUE;

    /** Errors below are drawn here: rounding of double is all that is left. */
    private static final double FLOOR = 1e-17;

    /** Repetitions whose fastest counts. */
    private static final int REPETITIONS = 150;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private ErrorAgainstTime() {}

    /** One setting. */
    private record Point(
            PairSet.Kind kind,
            Method method,
            double tolerance,
            int cap,
            double mean,
            double worst,
            double nanos) {}

    /**
     * Measures.
     *
     * @param args a folder for the pictures, or nothing; or {@code times} and kinds, see {@link
     *     PairTimes}
     * @throws IOException if the picture cannot be written
     */
    public static void main(String[] args) throws IOException {
        if (args.length > 0 && args[0].equals("times")) {
            PairTimes.main(Arrays.copyOfRange(args, 1, args.length));
            return;
        }
        System.out.printf(
                Locale.ROOT,
                "%-14s %-12s %9s %5s %11s %11s %8s%n",
                "pairs",
                "method",
                "tolerance",
                "cap",
                "mean error",
                "worst",
                "ns");
        for (PairSet.Kind kind :
                new PairSet.Kind[] {PairSet.Kind.TUMBLED_BOXES, PairSet.Kind.HULLS_32}) {
            List<Point> points = sweep(kind);
            points.forEach(ErrorAgainstTime::print);
            if (args.length > 0) {
                draw(points, Path.of(args[0]), kind);
            }
        }
    }

    private static List<Point> sweep(PairSet.Kind kind) {
        PairSet set = new PairSet(kind, 7);
        double[] truth = new double[PairSet.SIZE];
        for (int i = 0; i < truth.length; i++) {
            truth[i] = BruteForce.depth(set, i);
        }
        measure(set, kind, truth, Method.GENERAL, 0, NO_CAP);
        List<Point> points = new ArrayList<>();
        for (double tolerance : TOLERANCES) {
            points.add(measure(set, kind, truth, Method.GENERAL, tolerance, NO_CAP));
        }
        for (int cap : CAPS) {
            points.add(measure(set, kind, truth, Method.GENERAL, 0, cap));
        }
        if (kind == PairSet.Kind.TUMBLED_BOXES) {
            points.add(measure(set, kind, truth, Method.SPECIALISED, 0, NO_CAP));
        }
        return points;
    }

    private static Point measure(
            PairSet set,
            PairSet.Kind kind,
            double[] truth,
            Method method,
            double tolerance,
            int cap) {
        NarrowPhase n = new NarrowPhase(method, tolerance, cap);
        double sum = 0;
        double worst = 0;
        for (int i = 0; i < PairSet.SIZE; i++) {
            double size = set.a[i].outerRadius() + set.b[i].outerRadius();
            double error = Math.abs(set.distance(i, n) - truth[i]) / size;
            sum += error;
            worst = Math.max(worst, error);
        }
        double fastest = Double.MAX_VALUE;
        double keep = 0;
        for (int k = 0; k < REPETITIONS; k++) {
            long begin = THREADS.getCurrentThreadCpuTime();
            for (int round = 0; round < 4; round++) {
                for (int i = 0; i < PairSet.SIZE; i++) {
                    keep += set.distance(i, n);
                }
            }
            long nanos = THREADS.getCurrentThreadCpuTime() - begin;
            fastest = Math.min(fastest, nanos / (4.0 * PairSet.SIZE));
        }
        if (Double.isNaN(keep)) {
            throw new IllegalStateException("a distance of " + kind + " is NaN");
        }
        return new Point(kind, method, tolerance, cap, sum / PairSet.SIZE, worst, fastest);
    }

    private static void print(Point p) {
        System.out.printf(
                Locale.ROOT,
                "%-14s %-12s %9s %5s %11.2g %11.2g %8.0f%n",
                p.kind,
                p.method,
                p.tolerance == 0 ? "least" : String.format(Locale.ROOT, "%.0e", p.tolerance),
                p.cap == NO_CAP ? "none" : Integer.toString(p.cap),
                p.mean,
                p.worst,
                p.nanos);
    }

    private static void draw(List<Point> points, Path folder, PairSet.Kind kind)
            throws IOException {
        XYChart chart =
                new XYChartBuilder()
                        .width(760)
                        .height(420)
                        .title(kind == PairSet.Kind.HULLS_32 ? "hulls of 32 points" : "boxes")
                        .xAxisTitle("CPU time per query, ns")
                        .yAxisTitle("mean error of the depth, of the pair's size: power of ten")
                        .build();
        chart.getStyler().setXAxisMin(0.0);
        chart.getStyler().setYAxisMin(Math.log10(FLOOR)).setYAxisMax(0.0);
        chart.getStyler().setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
        add(
                chart,
                "GENERAL, tolerance",
                points.stream()
                        .filter(p -> p.method == Method.GENERAL && p.cap == NO_CAP)
                        .toList());
        add(
                chart,
                "GENERAL, cap",
                points.stream()
                        .filter(p -> p.method == Method.GENERAL && p.cap != NO_CAP)
                        .toList());
        add(
                chart,
                "SPECIALISED",
                points.stream().filter(p -> p.method == Method.SPECIALISED).toList());
        String name = kind == PairSet.Kind.HULLS_32 ? "hulls" : "boxes";
        Files.createDirectories(folder);
        Path file = folder.resolve("narrow-phase-" + name + ".svg");
        VectorGraphicsEncoder.saveVectorGraphic(
                chart, file.toString(), VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        // Letters are outlines with eleven digits; a tenth of a pixel will do.
        String drawing = Files.readString(file);
        Files.writeString(file, drawing.replaceAll("(\\.\\d)\\d+", "$1"));
    }

    private static void add(XYChart chart, String name, List<Point> points) {
        if (points.isEmpty()) {
            return;
        }
        double[] x = points.stream().mapToDouble(Point::nanos).toArray();
        double[] y =
                points.stream().mapToDouble(p -> Math.log10(Math.max(FLOOR, p.mean()))).toArray();
        chart.addSeries(name, x, y);
    }
}
