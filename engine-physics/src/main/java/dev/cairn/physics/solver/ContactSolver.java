package dev.cairn.physics.solver;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

/** Solves one tick of motion and contact; simulation thread; allocates only when a store has grown. */
public final class ContactSolver {
    private final SolverSettings settings;

    /**
     * A solver without memory of contacts; one per world.
     *
     * @param settings the tunables
     */
    public ContactSolver(SolverSettings settings) {
        this.settings = settings;
    }

    /** The tunables. */
    public SolverSettings settings() {
        return settings;
    }

    /**
     * Moves all bodies by one tick.
     *
     * @param bodies poses and velocities, read and written; forces and torques are read
     * @param contacts rows of this tick; impulses are read as warm start and written
     * @param gravityX world, m/s²
     * @param gravityY world, m/s²
     * @param gravityZ world, m/s²
     * @param stepSeconds length of the tick, s, above 0
     * @param jobs runs the loops over bodies in blocks
     */
    public void step(
            BodyStore bodies,
            ContactStore contacts,
            double gravityX,
            double gravityY,
            double gravityZ,
            double stepSeconds,
            Jobs jobs) {
        throw new UnsupportedOperationException("under construction");
    }
}
