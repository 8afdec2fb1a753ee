package dev.cairn.benchmarks.compare;

import com.google.gson.GsonBuilder;

import dev.cairn.benchmarks.Spread;
import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;

/**
 * What was found.
 *
 * @param machine what it ran on, by name
 * @param settings how it was run, by name
 * @param points one per scene, engine, number of workers and number of sub-steps
 */
record Results(
        Map<String, String> machine,
        Map<String, String> settings,
        List<Point> points,
        List<Budget> budgets,
        List<Cold> colds) {

    /**
     * One point of a diagram.
     *
     * @param scene id of the case
     * @param parameters of the scene
     * @param engine the engine
     * @param peer how it is set
     * @param judged the error run
     * @param rounds the timed runs, in order
     */
    record Point(
            String scene,
            Map<String, String> parameters,
            Engine engine,
            PeerSettings peer,
            Protocol.Answer judged,
            List<Protocol.Answer> rounds) {

        int workers() {
            return peer.workers();
        }

        int substeps() {
            return peer.substeps();
        }

        boolean best() {
            return peer.tuning() == PeerSettings.Tuning.BEST;
        }

        /** Returns the engine, and whose settings if not its own. */
        String title() {
            return engine.title() + (best() ? ", best effort" : "");
        }

        /** Returns why there is no number, or null. */
        @Nullable String failure() {
            if (judged.failure() != null) {
                return judged.failure();
            }
            for (Protocol.Answer round : rounds) {
                if (round.failure() != null) {
                    return "while timed: " + round.failure();
                }
            }
            return null;
        }

        /** CPU time per movable body and tick, microseconds: median of the rounds, or NaN. */
        double cpuMicros() {
            if (rounds.isEmpty() && tooSlow(judged)) {
                Double roughly = judged.cpuMicros();
                return roughly == null ? Double.NaN : roughly;
            }
            return quantile(Protocol.Answer::cpuMicros, 0.5);
        }

        double cpuLow() {
            return quantile(Protocol.Answer::cpuMicros, 0);
        }

        double cpuHigh() {
            return quantile(Protocol.Answer::cpuMicros, 1);
        }

        double medianMillis() {
            return quantile(Protocol.Answer::medianMillis, 0.5);
        }

        double p99Millis() {
            return quantile(Protocol.Answer::p99Millis, 0.5);
        }

        private double quantile(Function<Protocol.Answer, @Nullable Double> value, double share) {
            List<Double> found = new ArrayList<>();
            for (Protocol.Answer round : rounds) {
                Double one = value.apply(round);
                if (one != null) {
                    found.add(one);
                }
            }
            if (found.isEmpty() || share == 0.5) {
                return Spread.median(found);
            }
            double[] sorted = found.stream().mapToDouble(Double::doubleValue).sorted().toArray();
            return sorted[(int) Math.round(share * (sorted.length - 1))];
        }
    }

    /**
     * A cold start.
     *
     * @param scene id of the case
     * @param engine the engine
     * @param ticks pairs of ms since the start of the JVM and ms of a tick around then
     * @param figures what {@link ColdStart} found, by name
     */
    record Cold(String scene, Engine engine, List<Double> ticks, Map<String, Double> figures) {}

    /** Says whether an error run was stopped because it took too long. */
    static boolean tooSlow(Protocol.Answer judged) {
        return judged.failure() != null && judged.failure().startsWith("too slow");
    }

    /** Says whether an error run was stopped, or left out, because it takes too long. */
    static boolean slow(Protocol.Answer judged) {
        return tooSlow(judged)
                || (judged.failure() != null && judged.failure().startsWith("not run"));
    }

    /** Returns the scenes of the points, in order. */
    List<Case> scenes() {
        return points.stream().map(Point::scene).distinct().map(Case::of).toList();
    }

    /** Returns the number of sub-steps nearest to 4 from below, or the smallest. */
    int usualSubsteps() {
        return Schedule.scalingSubsteps(points.stream().map(Point::substeps).toList());
    }

    List<Point> of(String scene) {
        return points.stream().filter(point -> point.scene().equals(scene)).toList();
    }

    void writeJson(Path file) throws IOException {
        Files.writeString(file, new GsonBuilder().setPrettyPrinting().create().toJson(this));
    }

    void writeCsv(Path file) throws IOException {
        StringBuilder text =
                new StringBuilder(
                        "scene,parameters,engine,version,settings,workers,substeps,metric,error,"
                                + "deepest_overlap_m,contact_pairs,contact_points,movable_bodies,"
                                + "cpu_us_per_body_tick,cpu_us_low,cpu_us_high,wall_ms_median,"
                                + "wall_ms_p99,rounds,failure\n");
        for (Point point : points) {
            Object[] cells = {
                point.scene(),
                point.parameters(),
                point.engine().id(),
                point.engine().version(),
                point.best() ? "best" : "default",
                point.workers(),
                point.substeps(),
                Case.of(point.scene()).metric(),
                point.judged().error(),
                point.judged().deepest(),
                known(point.judged().pairs()),
                known(point.judged().points()),
                point.judged().bodies(),
                point.cpuMicros(),
                point.cpuLow(),
                point.cpuHigh(),
                point.medianMillis(),
                point.p99Millis(),
                point.rounds().size(),
                point.failure()
            };
            text.append(String.join(",", Arrays.stream(cells).map(Results::cell).toList()));
            text.append('\n');
        }
        Files.writeString(file, text, StandardCharsets.UTF_8);
    }

    private static @Nullable Integer known(int count) {
        return count < 0 ? null : count;
    }

    private static String cell(@Nullable Object value) {
        if (value == null) {
            return "";
        }
        if (value instanceof Double number) {
            return number.isNaN() ? "" : String.format(Locale.ROOT, "%.6g", number);
        }
        String text = value.toString();
        return text.matches("[^\",\n]*") ? text : "\"" + text.replace("\"", "\"\"") + "\"";
    }
}
