package dev.cairn.benchmarks.compare.measure;

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
 * @param maxSubsteps the largest number of sub-steps that a full run takes
 * @param scaling true if it has enough bodies for several workers
 * @param lookCost how much longer overlaps take to measure than between boxes
 */
public record Case(
        String id,
        String title,
        SampleScene scene,
        Map<String, String> settings,
        Map<String, String> quick,
        int ticks,
        String metric,
        String error,
        double failure,
        String truth,
        int maxSubsteps,
        boolean scaling,
        int lookCost) {

    /** Name of the metric that the judge measures itself: deepest overlap in the last quarter. */
    public static final String REST_OVERLAP = "restOverlapMetres";

    /** Number of sub-steps of scenes that are not limited. */
    public static final int MOST_SUBSTEPS = 32;

    public Case {
        settings = Map.copyOf(settings);
        quick = Map.copyOf(quick);
    }

    /** Returns a small scene with a closed form. */
    public static Case small(
            String id,
            String title,
            String scene,
            Map<String, String> settings,
            int ticks,
            String metric,
            String error,
            double failure,
            String truth) {
        return new Case(
                id,
                title,
                SceneRegistry.get(scene),
                settings,
                Map.of(),
                ticks,
                metric,
                error,
                failure,
                truth,
                MOST_SUBSTEPS,
                false,
                1);
    }

    /** Returns this scene as one of many bodies. */
    public Case large(int mostSubsteps, int costOfLooks, Map<String, String> quickSettings) {
        return new Case(
                id,
                title,
                scene,
                settings,
                quickSettings,
                ticks,
                metric,
                error,
                failure,
                truth,
                mostSubsteps,
                true,
                costOfLooks);
    }

    public static List<Case> all() {
        return Cases.ALL;
    }

    public static Case of(String id) {
        List<String> known = new ArrayList<>();
        for (Case one : Cases.ALL) {
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
    public Case with(Map<String, String> values) {
        Map<String, String> merged = new TreeMap<>(settings);
        merged.putAll(values);
        return new Case(
                id,
                title,
                scene,
                merged,
                quick,
                ticks,
                metric,
                error,
                failure,
                truth,
                maxSubsteps,
                scaling,
                lookCost);
    }

    public SceneOptions options() {
        return SceneOptions.of(scene, settings, SceneOptions.DEFAULT_SEED, null);
    }
}
