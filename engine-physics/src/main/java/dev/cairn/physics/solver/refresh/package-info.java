/**
 * Jacobians of rows whose bodies turn or pass each other within a tick.
 *
 * <p>Arms and normals hold for the pose at which they were computed. Where bodies turn or slide by
 * more than rounding within a tick, the rows are filled anew after each drift, and the warm start
 * is taken out with the old arms and put back with the new ones. Rows at rest are left alone.
 */
@NullMarked
package dev.cairn.physics.solver.refresh;

import org.jspecify.annotations.NullMarked;
