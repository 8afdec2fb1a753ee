package dev.cairn.physics;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.ecs.World;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.narrowphase.wide.BoxWarmUp;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.solver.wide.Lanes;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;

/** Describes a world. One thread at a time. */
public final class PhysicsWorldBuilder {
    private static final int WARM_UP_BODIES = 768;
    private static final int WARM_UP_TICKS = 180;
    private static final double WORLD_SHARE = 0.1;

    private double gravityX;
    private double gravityY = -9.81;
    private double gravityZ;
    private @Nullable Jobs jobs;
    private int workers;
    private PhysicsSettings settings = PhysicsSettings.DEFAULT;
    private long seed;
    private final List<EcsSystem> systems = new ArrayList<>();

    PhysicsWorldBuilder() {}

    /**
     * Sets the gravity; (0, -9.81, 0) by default.
     *
     * @param x m/s², finite
     * @param y m/s², finite
     * @param z m/s², finite
     * @return this
     */
    public PhysicsWorldBuilder gravity(double x, double y, double z) {
        Checks.finite("gravity x", x);
        Checks.finite("gravity y", y);
        Checks.finite("gravity z", z);
        gravityX = x;
        gravityY = y;
        gravityZ = z;
        return this;
    }

    /**
     * Sets the gravity.
     *
     * @param gravity m/s², finite
     * @return this
     */
    public PhysicsWorldBuilder gravity(Vector3dc gravity) {
        Checks.notNull("gravity", gravity);
        return gravity(gravity.x(), gravity.y(), gravity.z());
    }

    /**
     * Sets how many threads work at a step, the caller included; by default as many as there are
     * processors. The results do not depend on it.
     *
     * @param count 1 to {@link Jobs#MAX_WORKERS}
     * @return this
     */
    public PhysicsWorldBuilder workers(int count) {
        workers = Checks.between("workers", count, 1, Jobs.MAX_WORKERS);
        jobs = null;
        return this;
    }

    /**
     * Gives the workers, instead of {@link #workers}. The caller closes them, after the world.
     *
     * @param value the workers
     * @return this
     */
    public PhysicsWorldBuilder jobs(Jobs value) {
        jobs = Checks.notNull("jobs", value);
        return this;
    }

    /**
     * Sets the solver's sub-steps of a tick; 4 by default.
     *
     * @param count 1 to 64
     * @return this
     */
    public PhysicsWorldBuilder substeps(int count) {
        settings = settings.withSubsteps(count);
        return this;
    }

    /**
     * Says whether bodies that have come to rest fall asleep; true by default. A body asleep costs
     * nothing and wakes as soon as anything happens to it. Measurements of accuracy want false, so
     * that what they see at rest is the solver's doing.
     *
     * @param value false to keep all bodies awake
     * @return this
     */
    public PhysicsWorldBuilder sleeping(boolean value) {
        settings = settings.withSleeping(value);
        return this;
    }

    /**
     * Sets all tunables.
     *
     * @param value the settings
     * @return this
     */
    public PhysicsWorldBuilder settings(PhysicsSettings value) {
        settings = Checks.notNull("settings", value);
        return this;
    }

    /**
     * Sets the seed of the systems' random streams; 0 by default. The physics itself uses none.
     *
     * @param value any
     * @return this
     */
    public PhysicsWorldBuilder seed(long value) {
        seed = value;
        return this;
    }

    /**
     * Adds systems of the user to the schedule, beside the physics.
     *
     * @param values systems; the order of registration does not matter
     * @return this
     */
    public PhysicsWorldBuilder systems(EcsSystem... values) {
        Checks.notNull("systems", values);
        for (EcsSystem system : values) {
            systems.add(Checks.notNull("system", system));
        }
        return this;
    }

    /**
     * Makes the world.
     *
     * @return an empty world
     */
    public PhysicsWorld build() {
        PhysicsSystem physics = new PhysicsSystem(settings, gravityX, gravityY, gravityZ);
        List<EcsSystem> all = new ArrayList<>(systems);
        all.add(physics);
        World.Builder builder = World.builder().systems(all.toArray(new EcsSystem[0])).seed(seed);
        if (jobs != null) {
            builder.jobs(jobs);
        } else {
            builder.workers(workers == 0 ? Jobs.defaultWorkers() : workers);
        }
        return new PhysicsWorld(physics, builder.build(), systems.toArray(new EcsSystem[0]));
    }

    /**
     * Brings the engine's code to speed for worlds like this, for those who would rather wait at a
     * loading screen than have slower first seconds: steps a small world of its own, and then has
     * the vector kernels compiled. Takes some five seconds of one core, once in a process; later
     * calls take a tenth of that. What worlds compute does not depend on it. Any thread; allocates.
     *
     * @param progress told the share that is done, ascending from 0 to 1, in the caller's thread
     */
    public void warmUp(DoubleConsumer progress) {
        Checks.notNull("progress", progress);
        progress.accept(0);
        try (PhysicsWorld world = new PhysicsWorldBuilder().settings(settings).workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
            for (int i = 0; i < WARM_UP_BODIES; i++) {
                double x = 1.1 * (i % 8);
                int layer = i / 64;
                double y = 0.6 + 1.1 * layer;
                double z = 1.1 * (i / 8 % 8);
                Shape shape =
                        switch (i % 4) {
                            case 0 -> Sphere.of(0.5);
                            case 1 -> Capsule.of(0.3, 0.2);
                            default -> Box.cubeOfHalfExtent(0.5);
                        };
                world.add(Body.dynamic().shape(shape).at(x, y, z));
            }
            for (int tick = 1; tick <= WARM_UP_TICKS; tick++) {
                world.step(1.0 / 60.0);
                progress.accept(WORLD_SHARE * tick / WARM_UP_TICKS);
            }
        }
        BoxWarmUp.await();
        progress.accept(0.4);
        Lanes.await(settings.lanes(), true);
        progress.accept(0.7);
        Lanes.await(settings.lanes(), false);
        progress.accept(1);
    }
}
