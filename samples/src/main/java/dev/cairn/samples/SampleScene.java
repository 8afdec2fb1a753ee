package dev.cairn.samples;

import dev.cairn.core.ecs.EcsSystem;

import java.util.List;

/**
 * One scene: what it is called, what can be set, and the script that builds it.
 *
 * <p>The script knows neither window nor runner; it speaks to a {@link SceneBuilder}, so the same
 * lines serve the window, the headless runner, the tests and the benchmarks. Immutable; any thread
 * may use it.
 *
 * @param id short name on the command line: lower-case letters, digits, hyphens
 * @param title a few words for a window's title
 * @param description one or two sentences: what is there and what should be seen
 * @param group heading in lists
 * @param parameters what the user may set, in the order of the list
 * @param ticks length of a headless run where the user gives none, in ticks of 1/60 s
 * @param pictureTick the tick that is worth a picture
 * @param script builds the scene
 * @param systems what acts in the scene's world beside the rigid bodies
 */
public record SampleScene(
        String id,
        String title,
        String description,
        String group,
        List<Parameter> parameters,
        int ticks,
        int pictureTick,
        Script script,
        Systems systems) {

    /** Gravity of every scene, m/s², along -y. */
    public static final double GRAVITY = 9.81;

    /** Length of one tick in every scene, s. */
    public static final double STEP_SECONDS = 1.0 / 60;

    /** Copies the list and checks the id. */
    public SampleScene {
        if (!id.matches("[a-z0-9]+(-[a-z0-9]+)*")) {
            throw new IllegalArgumentException(
                    "scene id \"" + id + "\": use lower-case letters, digits and hyphens");
        }
        if (ticks < 1 || pictureTick < 0 || pictureTick > ticks) {
            throw new IllegalArgumentException(
                    "scene %s: ticks %d, pictureTick %d; want 0 <= pictureTick <= ticks"
                            .formatted(id, ticks, pictureTick));
        }
        parameters = List.copyOf(parameters);
    }

    /**
     * A scene of rigid bodies alone.
     *
     * @param id short name on the command line: lower-case letters, digits, hyphens
     * @param title a few words for a window's title
     * @param description one or two sentences: what is there and what should be seen
     * @param group heading in lists
     * @param parameters what the user may set, in the order of the list
     * @param ticks length of a headless run where the user gives none, in ticks of 1/60 s
     * @param pictureTick the tick that is worth a picture
     * @param script builds the scene
     */
    public SampleScene(
            String id,
            String title,
            String description,
            String group,
            List<Parameter> parameters,
            int ticks,
            int pictureTick,
            Script script) {
        this(
                id,
                title,
                description,
                group,
                parameters,
                ticks,
                pictureTick,
                script,
                options -> List.of());
    }

    /** Makes the systems that a scene's world needs. */
    @FunctionalInterface
    public interface Systems {
        /**
         * Makes them.
         *
         * @param options values of the scene's parameters
         * @return new systems, of different names
         */
        List<EcsSystem> of(SceneOptions options);
    }

    /** Builds a scene: bodies, camera, hooks, error metrics. */
    @FunctionalInterface
    public interface Script {
        /**
         * Adds all that the scene consists of. Called on the simulation thread, before the first
         * tick.
         *
         * @param scene the world under construction, with the values of the parameters
         */
        void build(SceneBuilder scene);
    }

    /**
     * The systems that a world must be built with for this scene.
     *
     * @param options values of the scene's parameters
     * @return new ones; none for most scenes
     */
    public EcsSystem[] systems(SceneOptions options) {
        return systems.of(options).toArray(new EcsSystem[0]);
    }

    /**
     * Builds the scene.
     *
     * @param builder a builder around an empty world, made with options and {@link
     *     #systems(SceneOptions) systems} of this scene
     * @return the same builder, which now holds bodies, hooks and metrics
     * @throws IllegalArgumentException if the world lacks a system of the scene
     */
    public SceneBuilder build(SceneBuilder builder) {
        for (EcsSystem system : systems.of(builder.options())) {
            builder.needs(id, system.name());
        }
        script.build(builder);
        return builder;
    }
}
