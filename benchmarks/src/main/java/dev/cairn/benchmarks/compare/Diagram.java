package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;

import org.jspecify.annotations.Nullable;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * A work-precision diagram as SVG: error against CPU time, both logarithmic; a full curve per
 * engine with its own defaults, a dashed one with its best effort. Failures are crosses at the top
 * edge.
 */
final class Diagram {
    /** Errors below are drawn here: rounding of double is all that is left. */
    static final double FLOOR = 1e-16;

    /** Labels nearer to each other than this, as shares of the diagram, are not written. */
    private static final double LABEL_WIDTH = 0.055;

    private static final double LABEL_HEIGHT = 0.045;

    private final Function<Results.Point, @Nullable Double> error;
    private final List<double[]> labels = new ArrayList<>();
    private double bottom;
    private double top;
    private double left;
    private double right;

    private Diagram(Function<Results.Point, @Nullable Double> error) {
        this.error = error;
    }

    /** Draws the curves from the points of one scene and one number of workers. */
    static String svg(
            List<Results.Point> points,
            String title,
            String yTitle,
            Function<Results.Point, @Nullable Double> error)
            throws IOException {
        return new Diagram(error).draw(points, title, yTitle);
    }

    private String draw(List<Results.Point> points, String title, String yTitle)
            throws IOException {
        Map<String, List<Results.Point>> good = new LinkedHashMap<>();
        Map<Engine, List<Results.Point>> bad = new LinkedHashMap<>();
        double lowest = Double.POSITIVE_INFINITY;
        double highest = 0;
        double cheapest = Double.POSITIVE_INFINITY;
        double dearest = 0;
        for (Results.Point point : points) {
            if (Double.isNaN(point.cpuMicros())) {
                continue;
            }
            cheapest = Math.min(cheapest, point.cpuMicros());
            dearest = Math.max(dearest, point.cpuMicros());
            Double value = error.apply(point);
            if (point.failure() == null && value != null) {
                good.computeIfAbsent(point.title(), _ -> new ArrayList<>()).add(point);
                lowest = Math.min(lowest, Math.max(FLOOR, value));
                highest = Math.max(highest, Math.max(FLOOR, value));
            } else {
                bad.computeIfAbsent(point.engine(), _ -> new ArrayList<>()).add(point);
            }
        }
        if (good.isEmpty()) {
            lowest = 0.1;
            highest = 1;
        }
        bottom = Charts.decade(lowest, Math::floor);
        // A decade of air, so that crosses at the top edge are not taken for the worst numbers.
        top = Math.max(10 * bottom, 10 * Charts.decade(highest, Math::ceil));
        left = Charts.decade(cheapest, Math::floor);
        right = Math.max(10 * left, Charts.decade(dearest, Math::ceil));
        XYChart chart =
                Charts.chart(
                        title,
                        "CPU time per body and tick of 1/60 s, \u00B5s   (left is better)",
                        yTitle + "   (down is better)");
        chart.getStyler().setXAxisLogarithmic(true);
        chart.getStyler().setYAxisLogarithmic(true);
        chart.getStyler().setYAxisMin(bottom).setYAxisMax(top);
        if (cheapest <= dearest) {
            chart.getStyler().setXAxisMin(left);
            chart.getStyler().setXAxisMax(right);
        }
        good.values().forEach(curve -> curve(chart, curve));
        bad.forEach((engine, failures) -> {
            double[] y = new double[failures.size()];
            Arrays.fill(y, top);
            XYSeries series = chart.addSeries(engine.title() + ", failed", costs(failures), y);
            Charts.paint(series, engine, false);
            series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
            series.setMarker(SeriesMarkers.CROSS);
        });
        return Charts.svg(chart);
    }

    private void curve(XYChart chart, List<Results.Point> curve) {
        double[] y = new double[curve.size()];
        for (int i = 0; i < y.length; i++) {
            Double value = error.apply(curve.get(i));
            y[i] = Math.max(FLOOR, value == null ? FLOOR : value);
        }
        double[] x = costs(curve);
        Results.Point first = curve.getFirst();
        Charts.paint(chart.addSeries(first.title(), x, y), first.engine(), first.best());
        if (!first.best()) {
            label(chart, first, x[0], y[0]);
            if (x.length > 1) {
                label(chart, curve.getLast(), x[x.length - 1], y[x.length - 1]);
            }
        }
    }

    /** Writes N above a point, or below, or not at all where another label is. */
    private void label(XYChart chart, Results.Point point, double x, double y) {
        double u = StrictMath.log(x / left) / StrictMath.log(right / left);
        double v = StrictMath.log(y / bottom) / StrictMath.log(top / bottom);
        for (double lift : new double[] {0.03, -0.03}) {
            double at = v + lift;
            boolean free = at > 0.01 && at < 0.97;
            for (double[] other : labels) {
                free &=
                        Math.abs(other[0] - u) > LABEL_WIDTH
                                || Math.abs(other[1] - at) > LABEL_HEIGHT;
            }
            if (free) {
                labels.add(new double[] {u, at});
                chart.addAnnotation(
                        new AnnotationText(
                                "N=" + point.substeps(),
                                x,
                                bottom * StrictMath.pow(top / bottom, at),
                                false));
                return;
            }
        }
    }

    private static double[] costs(List<Results.Point> points) {
        return points.stream().mapToDouble(Results.Point::cpuMicros).toArray();
    }
}
