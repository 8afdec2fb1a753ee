package dev.cairn.samples.sandbox;

import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Which scene of the list is shown, and with which parameters. Simulation thread. */
final class SceneChoice {
    private final List<SampleScene> scenes;
    private final Map<String, SceneOptions> options;
    private int index;

    /**
     * The first scene of a list.
     *
     * @param scenes at least one
     * @param options by scene id; who has none gets its defaults
     */
    SceneChoice(List<SampleScene> scenes, Map<String, SceneOptions> options) {
        this.scenes = scenes;
        this.options = new HashMap<>(options);
    }

    int index() {
        return index;
    }

    SampleScene scene() {
        return scenes.get(index);
    }

    SceneOptions options() {
        // No lambda: this is asked for in each tick, which makes no garbage.
        SceneOptions known = options.get(scene().id());
        if (known == null) {
            known = SceneOptions.defaults(scene());
            options.put(scene().id(), known);
        }
        return known;
    }

    /** Chooses by place in the list, which wraps around. */
    void show(int wanted) {
        index = Math.floorMod(wanted, scenes.size());
    }

    /** Chooses one of the list, or else the first. */
    void show(SampleScene scene) {
        index = Math.max(0, scenes.indexOf(scene));
    }

    /** Changes a parameter. */
    void set(String parameter, double value) {
        Map<String, Double> values = new LinkedHashMap<>(options().values());
        values.put(parameter, value);
        put(values);
    }

    /** Puts all parameters of the scene back. */
    void setDefaults() {
        put(SceneOptions.defaults(scene()).values());
    }

    private void put(Map<String, Double> values) {
        SceneOptions old = options();
        options.put(scene().id(), new SceneOptions(values, old.seed(), old.obj()));
    }
}
