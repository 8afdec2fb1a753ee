package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;

import org.jspecify.annotations.Nullable;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;

/**
 * A work-precision diagram as SVG: error against CPU time, both logarithmic, one curve per engine.
 * Failures are crosses at the top edge. Colours are those of Okabe and Ito, told apart by colour
 * blind readers, and markers differ as well.
 */
final class Diagram {
    /** Errors below are drawn here: rounding of double is all that is left. */
    static final double FLOOR = 1e-16;

    private static final Map<Engine, Color> COLOURS = new EnumMap<>(Engine.class);

    static {
        COLOURS.put(Engine.CAIRN, new Color(0xD55E00));
        COLOURS.put(Engine.JOLT, new Color(0x0072B2));
        COLOURS.put(Engine.BULLET, new Color(0x009E73));
        COLOURS.put(Engine.PHYSX, new Color(0x000000));
        COLOURS.put(Engine.ODE4J, new Color(0xCC79A7));
        COLOURS.put(Engine.JBULLET, new Color(0xE69F00));
        COLOURS.put(Engine.BOX3D, new Color(0x56B4E9));
    }

    private Diagram() {}

    /** Draws one curve per engine from the points of one scene and one number of workers. */
    static String svg(
            List<Results.Point> points,
            String yTitle,
            Function<Results.Point, @Nullable Double> error)
            throws IOException {
        Map<Engine, List<Results.Point>> good = new EnumMap<>(Engine.class);
        Map<Engine, List<Results.Point>> bad = new EnumMap<>(Engine.class);
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
                good.computeIfAbsent(point.engine(), _ -> new ArrayList<>()).add(point);
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
        double bottom = decade(lowest, Math::floor);
        double top = Math.max(10 * bottom, decade(highest, Math::ceil));

        XYChart chart =
                new XYChartBuilder()
                        .width(860)
                        .height(460)
                        .xAxisTitle(
                                "CPU time per body and tick of 1/60 s, \u00B5s   (left is better)")
                        .yAxisTitle(yTitle + "   (down is better)")
                        .build();
        style(chart.getStyler());
        chart.getStyler().setYAxisMin(bottom).setYAxisMax(top);
        if (cheapest < dearest) {
            chart.getStyler().setXAxisMin(decade(cheapest, Math::floor));
            chart.getStyler().setXAxisMax(decade(dearest, Math::ceil));
        }
        // Labels stand a fortieth of the diagram above their points.
        double lift = StrictMath.pow(top / bottom, 1.0 / 40);
        for (Engine engine : Engine.values()) {
            List<Results.Point> curve = good.get(engine);
            if (curve != null) {
                double[] y = new double[curve.size()];
                for (int i = 0; i < y.length; i++) {
                    Double value = error.apply(curve.get(i));
                    y[i] = Math.max(FLOOR, value == null ? FLOOR : value);
                }
                double[] x = costs(curve);
                XYSeries series = chart.addSeries(engine.title(), x, y);
                paint(series, engine);
                for (int i : ends(x.length)) {
                    String text = "N=" + curve.get(i).substeps();
                    chart.addAnnotation(new AnnotationText(text, x[i], y[i] * lift, false));
                }
            }
            List<Results.Point> failures = bad.get(engine);
            if (failures != null) {
                double[] y = new double[failures.size()];
                Arrays.fill(y, top);
                XYSeries series = chart.addSeries(engine.title() + ", failed", costs(failures), y);
                paint(series, engine);
                series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
                series.setMarker(SeriesMarkers.CROSS);
            }
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        VectorGraphicsEncoder.saveVectorGraphic(
                chart, out, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        return out.toString(StandardCharsets.UTF_8);
    }

    /** Returns the power of ten next to a value. */
    private static double decade(double value, DoubleUnaryOperator rounding) {
        return StrictMath.pow(10, rounding.applyAsDouble(StrictMath.log10(value)));
    }

    /** Returns the first and the last index. */
    private static int[] ends(int length) {
        return length == 1 ? new int[] {0} : new int[] {0, length - 1};
    }

    private static double[] costs(List<Results.Point> points) {
        return points.stream().mapToDouble(Results.Point::cpuMicros).toArray();
    }

    private static void paint(XYSeries series, Engine engine) {
        Color colour = COLOURS.getOrDefault(engine, Color.GRAY);
        series.setLineColor(colour);
        series.setMarkerColor(colour);
        series.setLineStyle(new BasicStroke(engine == Engine.CAIRN ? 2.6f : 1.5f));
        series.setMarker(
                switch (engine) {
                    case CAIRN -> SeriesMarkers.CIRCLE;
                    case JOLT -> SeriesMarkers.SQUARE;
                    case BULLET -> SeriesMarkers.DIAMOND;
                    case PHYSX -> SeriesMarkers.TRIANGLE_UP;
                    case ODE4J -> SeriesMarkers.TRIANGLE_DOWN;
                    case JBULLET -> SeriesMarkers.PLUS;
                    case BOX3D -> SeriesMarkers.CROSS;
                });
    }

    private static void style(XYStyler styler) {
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
        styler.setXAxisLogarithmic(true);
        styler.setYAxisLogarithmic(true);
        styler.setChartBackgroundColor(Color.WHITE);
        styler.setPlotBackgroundColor(Color.WHITE);
        styler.setPlotBorderColor(Color.GRAY);
        styler.setPlotGridLinesColor(new Color(0xDDDDDD));
        styler.setAxisTitleFont(font);
        styler.setAxisTickLabelsFont(font);
        styler.setLegendFont(font);
        styler.setLegendPosition(Styler.LegendPosition.OutsideE);
        styler.setLegendBorderColor(Color.WHITE);
        styler.setAnnotationTextFont(font.deriveFont(10f));
        styler.setMarkerSize(8);
        styler.setDefaultSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Line);
        styler.setChartTitleVisible(false);
    }
}
