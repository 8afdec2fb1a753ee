package dev.cairn.samples.scenefile;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.render.camera.Light;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Set;

/**
 * A scene as data. Immutable; equal scenes are written as equal files.
 *
 * @param name a few words for the window's title
 * @param description what is there and what should be seen; may be empty
 * @param gravity m/s²
 * @param tick the run's lengths
 * @param camera from where it is seen
 * @param light in which light
 * @param entities what is there, in the order of creation
 * @param joints what holds entities together, in the order of creation
 * @param layers names of the bits of filters, from the lowest on, at most 64
 * @param state file of a saved moment of this scene, with which it begins; null for what the
 *     entities say
 */
public record SceneFile(
        String name,
        String description,
        Xyz gravity,
        TickSpec tick,
        CameraSpec camera,
        Light light,
        List<EntitySpec> entities,
        List<JointSpec> joints,
        List<String> layers,
        @Nullable String state) {
    /** The value of {@code format} in every file. */
    public static final String FORMAT = "cairn-scene";

    /** The version that is written, and the newest that is read. */
    public static final int VERSION = 1;

    /** Copies the lists. */
    public SceneFile {
        entities = List.copyOf(entities);
        joints = List.copyOf(joints);
        layers = List.copyOf(layers);
        if (layers.size() > Long.SIZE || Set.copyOf(layers).size() != layers.size()) {
            throw new IllegalArgumentException(
                    "layers are %s, expected at most 64 different names".formatted(layers));
        }
    }

    /**
     * A scene without joints.
     *
     * @param name a few words for the window's title
     * @param description what is there and what should be seen; may be empty
     * @param gravity m/s²
     * @param tick the run's lengths
     * @param camera from where it is seen
     * @param light in which light
     * @param entities what is there, in the order of creation
     */
    public SceneFile(
            String name,
            String description,
            Xyz gravity,
            TickSpec tick,
            CameraSpec camera,
            Light light,
            List<EntitySpec> entities) {
        this(name, description, gravity, tick, camera, light, entities, List.of(), List.of(), null);
    }

    /**
     * An empty scene with gravity and daylight.
     *
     * @param name its name
     * @return the scene
     */
    public static SceneFile empty(String name) {
        return new SceneFile(
                name,
                "",
                new Xyz(0, -9.81, 0),
                TickSpec.DEFAULT,
                CameraSpec.DEFAULT,
                Light.DAYLIGHT,
                List.of());
    }

    /**
     * The same with other things in it.
     *
     * @param value the things
     * @return a copy
     */
    public SceneFile withEntities(List<EntitySpec> value) {
        return new SceneFile(
                name, description, gravity, tick, camera, light, value, joints, layers, state);
    }

    /**
     * The same, held together otherwise.
     *
     * @param value the joints
     * @return a copy
     */
    public SceneFile withJoints(List<JointSpec> value) {
        return new SceneFile(
                name, description, gravity, tick, camera, light, entities, value, layers, state);
    }

    /**
     * The same with other names of layers.
     *
     * @param value names of the bits of filters
     * @return a copy
     */
    public SceneFile withLayers(List<String> value) {
        return new SceneFile(
                name, description, gravity, tick, camera, light, entities, joints, value, state);
    }

    /**
     * The same, run otherwise.
     *
     * @param value the run's lengths
     * @return a copy
     */
    public SceneFile withTick(TickSpec value) {
        return new SceneFile(
                name, description, gravity, value, camera, light, entities, joints, layers, state);
    }

    /**
     * The same with another description.
     *
     * @param value what is there and what should be seen; may be empty
     * @return a copy
     */
    public SceneFile withDescription(String value) {
        return new SceneFile(
                name, value, gravity, tick, camera, light, entities, joints, layers, state);
    }

    /**
     * The same seen from elsewhere.
     *
     * @param value the camera
     * @return a copy
     */
    public SceneFile withCamera(CameraSpec value) {
        return new SceneFile(
                name, description, gravity, tick, value, light, entities, joints, layers, state);
    }

    /**
     * The same with another beginning.
     *
     * @param value file of a saved moment, or null for what the entities say
     * @return a copy
     */
    public SceneFile withState(@Nullable String value) {
        return new SceneFile(
                name, description, gravity, tick, camera, light, entities, joints, layers, value);
    }

    /**
     * The lengths of a run.
     *
     * @param seconds length of a tick, s, &gt; 0
     * @param substeps sub-steps of the solver per tick, 1..64
     * @param ticks length of a run without a window, ticks, at least 1
     * @param pictureTick the tick that is worth a picture, 0..ticks
     */
    public record TickSpec(double seconds, int substeps, int ticks, int pictureTick) {
        /** Sixty ticks a second, five seconds, a picture after two. */
        public static final TickSpec DEFAULT =
                new TickSpec(1.0 / 60, PhysicsSettings.DEFAULT.substeps(), 300, 120);

        /** Checks the ranges. */
        public TickSpec {
            if (!(seconds > 0 && seconds <= 1)) {
                throw new IllegalArgumentException(
                        "tick of %s s, expected above 0 and at most 1".formatted(seconds));
            }
            if (substeps < 1 || substeps > 64) {
                throw new IllegalArgumentException(
                        "substeps is %d, expected 1..64".formatted(substeps));
            }
            if (ticks < 1 || pictureTick < 0 || pictureTick > ticks) {
                throw new IllegalArgumentException(
                        "ticks is %d and pictureTick %d, expected 0 <= pictureTick <= ticks"
                                .formatted(ticks, pictureTick));
            }
        }
    }

    /**
     * From where a scene is seen.
     *
     * @param eye the camera's place, world, m
     * @param target what it looks at, world, m
     * @param fieldOfViewDegrees angle between the upper and the lower edge of the picture
     */
    public record CameraSpec(Xyz eye, Xyz target, double fieldOfViewDegrees) {
        /** From the front, a little above. */
        public static final CameraSpec DEFAULT =
                new CameraSpec(new Xyz(0, 4, 14), new Xyz(0, 1, 0), 50);
    }
}
