package dev.cairn.samples.accuracy;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Map;

/**
 * One run of a case at one number of sub-steps: makes the worlds, steps them by ticks of 1/60 s
 * with one worker and without sleep, and counts what that costs. One thread.
 */
public final class Trial {
    /** Length of a tick, s. */
    static final double TICK = SampleScene.STEP_SECONDS;

    /** Gravity of most cases, m/s². */
    static final double GRAVITY = SampleScene.GRAVITY;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final int substeps;
    private final Precision precision;
    private final int directFrom;
    private long cpuNanos;
    private long bodySteps;
    private int moving;

    /**
     * A run.
     *
     * @param substeps sub-steps of a tick, 1 to 32
     */
    public Trial(int substeps) {
        this(substeps, Precision.AUTO, PhysicsSettings.DEFAULT.tuning().count(Tunable.DIRECT_FROM));
    }

    /**
     * A run in a precision, with or without direct solves.
     *
     * @param substeps sub-steps of a tick, 1 to 32
     * @param precision of the contacts' numbers
     * @param directFrom see {@link PhysicsSettings}
     */
    public Trial(int substeps, Precision precision, int directFrom) {
        this.substeps = substeps;
        this.precision = precision;
        this.directFrom = directFrom;
    }

    int substeps() {
        return substeps;
    }

    /** A run of the same case at twice as many sub-steps, for orders of convergence. */
    Trial finer() {
        return new Trial(2 * substeps, precision, directFrom);
    }

    /**
     * What a body costs a tick of 1/60 s.
     *
     * @return µs of the stepping thread, or NaN if less than 20 ms were measured
     */
    public double microsPerBodyStep() {
        return cpuNanos < 20_000_000 ? Double.NaN : cpuNanos / 1e3 / bodySteps;
    }

    /** The engine's defaults but for the sub-steps. */
    PhysicsSettings settings() {
        return PhysicsSettings.DEFAULT
                .withSubsteps(substeps)
                .with(Tunable.DIRECT_FROM, directFrom)
                .withPrecision(precision)
                .withSleeping(false);
    }

    PhysicsWorld world(double gx, double gy, double gz) {
        return world(settings(), gx, gy, gz);
    }

    PhysicsWorld world(PhysicsSettings settings, double gx, double gy, double gz) {
        moving = -1;
        return PhysicsWorld.builder().gravity(gx, gy, gz).workers(1).settings(settings).build();
    }

    /** A world where everything bounces, however slowly it comes. */
    PhysicsWorld bouncy(double gy) {
        return world(settings().withRestitutionThreshold(0), 0, gy, 0);
    }

    void step(PhysicsWorld world) {
        step(world, TICK);
    }

    void step(PhysicsWorld world, double seconds) {
        if (moving < 0) {
            moving = 0;
            for (BodyRef body : world.bodies()) {
                moving += body.isFixed() ? 0 : 1;
            }
        }
        long start = THREADS.getCurrentThreadCpuTime();
        world.step(seconds);
        cpuNanos += THREADS.getCurrentThreadCpuTime() - start;
        bodySteps += moving;
    }

    void run(PhysicsWorld world, double seconds) {
        for (long n = StrictMath.round(seconds / TICK); n > 0; n--) {
            step(world);
        }
    }

    /**
     * Error metrics of a scene.
     *
     * @param values by name; those that do not apply are missing
     */
    record Errors(Map<String, Double> values) {
        double get(String name) {
            Double value = values.get(name);
            return value == null ? Double.NaN : value;
        }
    }

    /** Looks at a scene while it runs. */
    interface Look {
        /**
         * Called every half second.
         *
         * @return false to end the run
         */
        boolean at(double seconds, Errors errors);
    }

    /** A scene of the registry after some seconds: its error metrics by name. */
    Errors scene(String id, double seconds, Map<String, String> parameters) {
        return scene(id, seconds, parameters, (time, errors) -> true);
    }

    Errors scene(String id, double seconds, Map<String, String> parameters, Look look) {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.of(scene, parameters, SceneOptions.DEFAULT_SEED, null);
        try (PhysicsWorld world = world(0, -GRAVITY, 0)) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            long ticks = StrictMath.round(seconds / TICK);
            for (long n = 1; n <= ticks; n++) {
                built.beforeTick();
                step(world);
                built.afterTick();
                if (n % 30 == 0 && !look.at(n * TICK, new Errors(built.errors()))) {
                    break;
                }
            }
            return new Errors(built.errors());
        }
    }

    /** Friction and restitution, equal on both sides of every contact of a case. */
    static Material surface(double friction, double restitution) {
        return new Material(friction, restitution, 1000);
    }

    /** A fixed plate whose upper side is y = 0. */
    static BodyRef floor(PhysicsWorld world, Material surface) {
        return world.add(
                Body.fixed()
                        .shape(Box.ofHalfExtents(100, 1, 100))
                        .at(0, -1, 0)
                        .material(surface)
                        .name("floor"));
    }
}
