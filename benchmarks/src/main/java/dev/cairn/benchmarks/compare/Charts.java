package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;

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
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleUnaryOperator;

/**
 * What all diagrams share, and the simple ones. Colours are those of Okabe and Ito, told apart by
 * colour blind readers, and markers differ as well.
 */
final class Charts {
    private static final Map<Engine, Color> COLOURS = new EnumMap<>(Engine.class);

    static {
        COLOURS.put(Engine.CAIRN, new Color(0xD55E00));
        COLOURS.put(Engine.CAIRN_SINGLE, new Color(0xF0E442));
        COLOURS.put(Engine.JOLT, new Color(0x0072B2));
        COLOURS.put(Engine.BULLET, new Color(0x009E73));
        COLOURS.put(Engine.PHYSX, new Color(0x000000));
        COLOURS.put(Engine.ODE4J, new Color(0xCC79A7));
        COLOURS.put(Engine.JBULLET, new Color(0xE69F00));
        COLOURS.put(Engine.BOX3D, new Color(0x56B4E9));
    }

    private Charts() {}

    static XYChart chart(String title, String xTitle, String yTitle) {
        XYChart chart =
                new XYChartBuilder()
                        .width(960)
                        .height(500)
                        .title(title)
                        .xAxisTitle(xTitle)
                        .yAxisTitle(yTitle)
                        .build();
        XYStyler styler = chart.getStyler();
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
        styler.setChartBackgroundColor(Color.WHITE);
        styler.setPlotBackgroundColor(Color.WHITE);
        styler.setPlotBorderColor(Color.GRAY);
        styler.setPlotGridLinesColor(new Color(0xEEEEEE));
        styler.setPlotGridLinesStroke(new BasicStroke(1));
        styler.setChartTitleBoxVisible(false);
        styler.setChartTitleFont(font.deriveFont(Font.BOLD, 15f));
        styler.setAxisTitleFont(font);
        styler.setAxisTickLabelsFont(font);
        styler.setLegendFont(font.deriveFont(12f));
        styler.setLegendPosition(Styler.LegendPosition.OutsideE);
        styler.setLegendBorderColor(Color.WHITE);
        styler.setAnnotationTextFont(font.deriveFont(10f));
        styler.setMarkerSize(7);
        styler.setDefaultSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Line);
        return chart;
    }

    /** Gives a series its engine's colour and marker; dashed and without markers if asked. */
    static void paint(XYSeries series, Engine engine, boolean dashed) {
        Color colour = COLOURS.getOrDefault(engine, Color.GRAY);
        series.setLineColor(colour);
        series.setMarkerColor(colour);
        float width = engine.isCairn() ? 2.6f : 1.5f;
        if (dashed) {
            series.setLineStyle(
                    new BasicStroke(
                            width,
                            BasicStroke.CAP_BUTT,
                            BasicStroke.JOIN_ROUND,
                            1,
                            new float[] {5, 4},
                            0));
        } else {
            series.setLineStyle(new BasicStroke(width));
        }
        series.setMarker(
                switch (engine) {
                    case CAIRN -> SeriesMarkers.CIRCLE;
                    case CAIRN_SINGLE -> SeriesMarkers.OVAL;
                    case JOLT -> SeriesMarkers.SQUARE;
                    case BULLET -> SeriesMarkers.DIAMOND;
                    case PHYSX -> SeriesMarkers.TRIANGLE_UP;
                    case ODE4J -> SeriesMarkers.TRIANGLE_DOWN;
                    case JBULLET -> SeriesMarkers.PLUS;
                    case BOX3D -> SeriesMarkers.TRAPEZOID;
                });
    }

    static String svg(XYChart chart) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        VectorGraphicsEncoder.saveVectorGraphic(
                chart, out, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        return out.toString(StandardCharsets.UTF_8);
    }

    /** Returns the power of ten next to a value. */
    static double decade(double value, DoubleUnaryOperator rounding) {
        return StrictMath.pow(10, rounding.applyAsDouble(StrictMath.log10(value)));
    }

    /**
     * Draws wall time of a tick against workers, of the points with one number of sub-steps and of
     * the engines that have several workers.
     */
    static String scaling(String title, List<Results.Point> points) throws IOException {
        XYChart chart =
                chart(title, "workers (threads)", "wall time of a tick, ms   (down is better)");
        Map<Engine, TreeMap<Integer, Double>> curves = new EnumMap<>(Engine.class);
        for (Results.Point point : points) {
            if (!point.best() && !Double.isNaN(point.medianMillis())) {
                curves.computeIfAbsent(point.engine(), _ -> new TreeMap<>())
                        .put(point.workers(), point.medianMillis());
            }
        }
        curves.values().removeIf(curve -> curve.size() < 2);
        curves.forEach((engine, curve) -> {
            double[] x = curve.keySet().stream().mapToDouble(Integer::doubleValue).toArray();
            double[] y = curve.values().stream().mapToDouble(Double::doubleValue).toArray();
            paint(chart.addSeries(engine.title(), x, y), engine, false);
        });
        int most = curves.values().stream().mapToInt(TreeMap::lastKey).max().orElse(1);
        chart.getStyler().setXAxisMin(0.0).setXAxisMax(most + 1.0).setYAxisMin(0.0);
        // XChart widens the spacing of ticks until no label comes twice: here, to whole numbers.
        chart.setCustomXAxisTickLabelsFormatter(
                x -> x < 0.5 ? " " : x > most + 0.5 ? "  " : String.valueOf(Math.round(x)));
        chart.setCustomYAxisTickLabelsFormatter(Html::number);
        return svg(chart);
    }

    /** Draws the time of a tick against the time since the start of the JVM. */
    static String cold(String title, List<Results.Cold> starts) throws IOException {
        XYChart chart =
                chart(
                        "Cold start: " + title + ", N = 4",
                        "seconds since the start of the JVM",
                        "time of a tick, ms   (down is better)");
        for (Results.Cold start : starts) {
            int n = start.ticks().size() / 2;
            if (n == 0) {
                continue;
            }
            double[] x = new double[n];
            double[] y = new double[n];
            for (int i = 0; i < n; i++) {
                x[i] = start.ticks().get(2 * i) / 1e3;
                y[i] = start.ticks().get(2 * i + 1);
            }
            paint(chart.addSeries(start.engine().title(), x, y), start.engine(), false);
        }
        chart.getStyler().setXAxisLogarithmic(true);
        chart.getStyler().setYAxisLogarithmic(true);
        chart.getStyler().setXAxisDecimalPattern("0.0");
        return svg(chart);
    }
}
