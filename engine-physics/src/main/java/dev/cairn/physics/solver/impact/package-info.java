/**
 * Bounces, each at its own time, before anything else is solved in a sub-step.
 *
 * <p>Balls meet one after the other in the order of their times; bodies with more points take one
 * impact over all of them. No impact adds energy. A scene without restitution runs none of it.
 *
 * <p>Source: E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid bodies with stacking" (2003).
 */
@NullMarked
package dev.cairn.physics.solver.impact;

import org.jspecify.annotations.NullMarked;
