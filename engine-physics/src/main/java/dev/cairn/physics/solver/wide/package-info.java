/**
 * The same arithmetic as in the scalar kernels for a vector of rows at once.
 *
 * <p>Rows of a colour share no body that moves, so a lane is a row and the bits are those of the
 * scalar kernels, for any number of lanes. Kernels call the Vector API directly and are small
 * enough to be compiled alone; a helper that takes or returns a vector would put it on the heap.
 * Until they are compiled the scalar kernels run; a thread of its own compiles them on made-up
 * rows.
 */
@NullMarked
package dev.cairn.physics.solver.wide;

import org.jspecify.annotations.NullMarked;
