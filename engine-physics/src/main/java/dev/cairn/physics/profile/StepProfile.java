package dev.cairn.physics.profile;

import dev.cairn.core.profile.SystemProfile;

/**
 * How long each stage of the physics step took. Off until {@link #enable} is called; then a step
 * reads the clock once per stage, some 20 ns each. While a recording of the JDK Flight Recorder has
 * the event {@code dev.cairn.PhysicsStep} switched on, each step writes one, whether enabled here
 * or not.
 *
 * <p>Times are wall time of the simulation thread, so they include waiting for the other workers.
 * Simulation thread only; allocates nothing.
 */
public interface StepProfile {
    /** Times the steps that follow. */
    void enable();

    /** Stops; what was measured stays readable. */
    void disable();

    /** Forgets what was measured. */
    void reset();

    /**
     * The steps that were timed.
     *
     * @return count since the last reset
     */
    long steps();

    /**
     * Duration of a stage in the last timed step.
     *
     * @param stage which
     * @return ns; 0 if no step was timed
     */
    long lastNanos(StepStage stage);

    /**
     * Mean duration of a stage.
     *
     * @param stage which
     * @return s per timed step; 0 if no step was timed
     */
    double meanSeconds(StepStage stage);

    /**
     * The times of all systems of the world, the physics among them. On, off and forgotten with
     * this profile; a recording alone does not switch them on.
     *
     * @return the same object each time
     */
    SystemProfile systems();
}
