package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.tuning.Tuning;

/** What all passes of the tick in work share. Written by the simulation thread between passes. */
final class Tick {
    final SolverBodies body = new SolverBodies();

    /** World, m/s². */
    final double[] gravity = new double[3];

    Tuning settings;
    BodyStore bodies = new BodyStore();
    ContactStore contacts = new ContactStore();

    /** See {@link Batches#order}. */
    int[] order = {};

    /** Length of the tick, s. */
    double step;

    /** Length of a sub-step, s. */
    double subStep;

    /** This sub-step over the last tick's: the scale of the impulses that are kept. */
    double impulseScale = 1;

    /** Whether bodies have the inertia of their load. */
    boolean loaded;

    Tick(Tuning settings) {
        this.settings = settings;
    }

    /** Size of gravity, m/s². */
    double weight() {
        return Math.sqrt(
                gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    }
}
