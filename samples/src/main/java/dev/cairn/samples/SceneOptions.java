package dev.cairn.samples;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What the user chose for one scene: a value for each of its parameters, a seed, perhaps a mesh
 * file. Immutable.
 *
 * @param values value of every parameter of the scene, in the scene's order
 * @param seed seed of everything random in the scene
 * @param obj mesh file of {@code --obj}, or null
 */
public record SceneOptions(Map<String, Double> values, long seed, @Nullable Path obj) {

    /** Seed where the user gives none. */
    public static final long DEFAULT_SEED = 1;

    /** Copies the map; its order is kept. */
    public SceneOptions {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /**
     * Returns a scene's own defaults.
     *
     * @param scene the scene
     * @return its options where the user chose nothing
     */
    public static SceneOptions defaults(SampleScene scene) {
        return of(scene, Map.of(), DEFAULT_SEED, null);
    }

    /**
     * Returns a scene's defaults with some values replaced.
     *
     * @param scene the scene
     * @param settings texts by parameter name, as the user typed them
     * @param seed seed of everything random
     * @param obj mesh file, or null
     * @return the checked options
     * @throws UsageException if a name is unknown or a value is out of its bounds
     */
    public static SceneOptions of(
            SampleScene scene, Map<String, String> settings, long seed, @Nullable Path obj) {
        Map<String, Double> values = new LinkedHashMap<>();
        List<String> names = new ArrayList<>();
        for (Parameter parameter : scene.parameters()) {
            String text = settings.get(parameter.name());
            names.add(parameter.name());
            values.put(
                    parameter.name(),
                    text == null ? parameter.defaultValue() : parameter.parse(scene.id(), text));
        }
        for (String name : settings.keySet()) {
            if (!values.containsKey(name)) {
                throw new UsageException(
                        "--set %s: scene %s has no parameter of this name%s; it has: %s"
                                .formatted(
                                        name,
                                        scene.id(),
                                        Nearest.hint(name, names),
                                        names.isEmpty() ? "none" : String.join(", ", names)));
            }
        }
        return new SceneOptions(values, seed, obj);
    }
}
