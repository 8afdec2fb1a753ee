/**
 * Bodies as the solver holds them, and how they move without contacts.
 *
 * <p>A body is 16 doubles in a row: velocity, weighted angular velocity, movement since the start
 * of the tick, inverse mass. Angular velocities are weighted by a root of the inverse inertia,
 * {@code I^-1 = L L^T}: {@code L^-1 w} takes the same arm on both sides of a constraint.
 *
 * <p>A body without contacts flies its parabola in one go; free rotation is exact for isotropic
 * bodies and a symmetric composition with a rational tangent for the others, so that momentum is
 * kept to rounding and no trigonometry is called. Locked axes and damping are projections and means
 * of exponentials. This package knows of no constraint.
 *
 * <p>Sources: R. McLachlan, A. Zanna, "The discrete Moser-Veselov algorithm for the free rigid
 * body" (2005); E. Hairer, G. Vilmart, "Preprocessed discrete Moser-Veselov algorithm" (2006).
 */
@NullMarked
package dev.cairn.physics.solver.body;

import org.jspecify.annotations.NullMarked;
