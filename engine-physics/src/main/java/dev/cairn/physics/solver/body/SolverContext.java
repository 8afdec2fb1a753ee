package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.tuning.Tuning;

/** What all passes of the tick in work share. Written by the simulation thread between passes. */
public final class SolverContext {
    public final SolverBodies body = new SolverBodies();

    /** World, m/s². */
    public final double[] gravity = new double[3];

    public Tuning settings;
    public BodyStore bodies = new BodyStore();
    public ContactStore contacts = new ContactStore();

    /** See {@link Batches#order}. */
    public int[] order = {};

    /** Length of the tick, s. */
    public double step;

    /** Length of a sub-step, s. */
    public double subStep;

    /** This sub-step over the last tick's: the scale of the impulses that are kept. */
    public double impulseScale = 1;

    /** The sub-step that softness goes by over the last tick's. */
    public double softScale = 1;

    /** Whether bodies have the inertia of their load. */
    public boolean loaded;

    /** Whether a contact is of a light body and a heavy one, see {@link SolverBodies#isLight}. */
    public boolean hasLight;

    public SolverContext(Tuning settings) {
        this.settings = settings;
    }

    /** Size of gravity, m/s². */
    public double weight() {
        return Math.sqrt(
                gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    }
}
