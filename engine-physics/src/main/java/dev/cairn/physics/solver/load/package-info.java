/**
 * What rests on what, and what follows from it.
 *
 * <p>A sweep from the top of a heap to its ground finds the load of each body at rest. Its inertia
 * in the solver follows that load, so that a tower is as well conditioned as a single body; where a
 * load has gone at once, the contacts below are swept further; and what is put up at rest is swept
 * until its impulses hold it before anything moves, with leaps between.
 *
 * <p>Sources: own study; D. Anderson (1965) and A. Aitken (1926) for the leaps.
 */
@NullMarked
package dev.cairn.physics.solver.load;

import org.jspecify.annotations.NullMarked;
