package dev.cairn.benchmarks.compare;

import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * One scene of the report: what to build, for how long, and which of its errors is drawn.
 *
 * @param id name on the command line
 * @param title heading in the report
 * @param scene its script
 * @param settings the scene's parameters that are set
 * @param quick parameters set besides in a quick run
 * @param ticks length, in ticks of 1/60 s
 * @param metric the scene's error metric that is drawn
 * @param error what the metric is, with its unit
 * @param failure an error above this is a failure, not a number
 * @param truth what is known about the scene
 */
record Case(
        String id,
        String title,
        SampleScene scene,
        Map<String, String> settings,
        Map<String, String> quick,
        int ticks,
        String metric,
        String error,
        double failure,
        String truth) {

    private static final List<Case> ALL =
            List.of(
                    new Case(
                            "free-flight",
                            "Free flight",
                            SceneRegistry.get("free-fall"),
                            Map.of("height", "100"),
                            Map.of(),
                            90,
                            "positionMetres",
                            "largest distance from the parabola, m",
                            10,
                            "Five spinning bodies follow x0 + v0 t + g t²/2 for 1.5 s. A"
                                + " first-order integrator (semi-implicit Euler) is off by g T h/2"
                                + " at the end: 0.123 m at N = 1."),
                    new Case(
                            "slope",
                            "Box slides down a slope",
                            SceneRegistry.get("slope-box"),
                            Map.of(
                                    "angle",
                                    "20",
                                    "friction",
                                    "0.2",
                                    "drop",
                                    "0",
                                    "speed",
                                    "0",
                                    "length",
                                    "14"),
                            Map.of(),
                            180,
                            "distanceRelative",
                            "distance error, share of the distance",
                            0.5,
                            "A box on 20 degrees with mu = 0.2 starts from rest: s = g (sin - mu"
                                    + " cos) t²/2, 6.80 m after 3 s."),
                    new Case(
                            "roll",
                            "Ball rolls down a slope",
                            SceneRegistry.get("slope-ball"),
                            Map.of("restitution", "0", "length", "14"),
                            Map.of(),
                            150,
                            "rollRelative",
                            "distance error, share of the distance",
                            0.5,
                            "A solid ball on 15 degrees rolls without slipping: s = 5/7 g sin"
                                    + " t²/2."),
                    new Case(
                            "bounce",
                            "Bouncing ball",
                            Bounce.scene(),
                            Map.of(),
                            Map.of(),
                            120,
                            "heightRelative",
                            "RMS height error, share of the height",
                            0.5,
                            "A ball falls 1 m and bounces with e = 0.7: parabolas between impacts,"
                                    + " apexes e² of the one before."),
                    new Case(
                            "stack-4",
                            "Stack of four",
                            SceneRegistry.get("stack-4"),
                            Map.of(),
                            Map.of(),
                            300,
                            "sagMetres",
                            "largest height error at rest, m",
                            0.25,
                            "Four 1 m boxes fall onto each other and stand: centres at 0.5, 1.5,"
                                    + " 2.5, 3.5 m."),
                    new Case(
                            "cubes-18",
                            "Eighteen cubes",
                            SceneRegistry.get("cubes-18"),
                            Map.of(),
                            Map.of(),
                            240,
                            "sagMetres",
                            "largest height error at rest, m",
                            0.25,
                            "Nine columns of two 1 m cubes fall a little and stand: centres at 0.5"
                                    + " and 1.5 m."),
                    new Case(
                            "pyramid",
                            "Pyramid",
                            SceneRegistry.get("pyramid"),
                            Map.of("base", "20"),
                            Map.of("base", "10"),
                            200,
                            "driftMetres",
                            "largest displacement, m",
                            0.5,
                            "A one-thick pyramid of 1 m boxes, touching from the start, stands as"
                                    + " built. More than half a box off is a collapse."));

    Case {
        settings = Map.copyOf(settings);
        quick = Map.copyOf(quick);
    }

    static List<Case> all() {
        return ALL;
    }

    static Case of(String id) {
        List<String> known = new ArrayList<>();
        for (Case one : ALL) {
            if (one.id.equals(id)) {
                return one;
            }
            known.add(one.id);
        }
        throw new IllegalArgumentException(
                "scene \"%s\": there is none; known are %s"
                        .formatted(id, String.join(", ", known)));
    }

    /** Returns this scene with other values of its parameters. */
    Case with(Map<String, String> values) {
        Map<String, String> merged = new TreeMap<>(settings);
        merged.putAll(values);
        return new Case(id, title, scene, merged, quick, ticks, metric, error, failure, truth);
    }

    SceneOptions options() {
        return SceneOptions.of(scene, settings, SceneOptions.DEFAULT_SEED, null);
    }
}
