package dev.cairn.physics;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.ecs.World;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.Checks;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/** Describes a world. One thread at a time. */
public final class PhysicsWorldBuilder {
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
}
