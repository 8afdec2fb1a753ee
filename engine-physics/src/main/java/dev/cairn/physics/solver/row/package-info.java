/**
 * Constraint rows: the contacts of a tick as numbers for sweeps.
 *
 * <p>A row is one contact of up to four points with its friction. Rows of a colour lie in groups of
 * as many as a vector has lanes, field by field, so that a field of a group is one load and a pass
 * over a colour is one stream through memory. Rows are doubles, or floats for large islands; {@link
 * dev.cairn.physics.solver.row.RowWindow} shows a single row as doubles in either case. Rolling
 * friction, which few scenes use, has rows of its own beside them.
 *
 * <p>Nothing here solves anything: the numbers are filled, swept and emptied by the kernels.
 */
@NullMarked
package dev.cairn.physics.solver.row;

import org.jspecify.annotations.NullMarked;
