package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;

import java.util.Map;

/**
 * What an engine's error in a scene is made of: one thing is refined in turn, from N = 4 on, and
 * the error that is left is noted.
 *
 * @param scene id of the case
 * @param engine the engine
 * @param errors by what was refined; a refinement that the engine does not offer is absent
 */
record Budget(String scene, Engine engine, Map<String, Double> errors) {
    /** Nothing refined: the defaults at N = 4. */
    static final String BASE = "default, N = 4";

    /** Contacts found in every sub-step, for engines that find them once a tick. */
    static final String CONTACTS = "contacts in each sub-step";

    /** Eight times the solver's iterations. */
    static final String SOLVER = "8 x iterations";

    /** Sub-steps a sixteenth as long: integrator and solver in time. */
    static final String STEP = "16 x sub-steps";

    /** All of it. */
    static final String ALL = "all of these";
}
