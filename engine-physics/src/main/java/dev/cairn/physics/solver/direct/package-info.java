/**
 * Long, slender islands at rest, solved by elimination.
 *
 * <p>A sweep carries knowledge on by a contact or so; a column of hundreds falls before it has
 * learnt of its load. So the contacts of such an island are solved together: bodies in the order of
 * Cuthill and McKee, blocks of six, a skyline {@code L D L^T}. One sweep follows; what is worse
 * than before is taken back. It costs what the island's width says and runs for no other.
 *
 * <p>Source: M. Silcowitz, S. Niebe, K. Erleben (2010) for solves between sweeps.
 */
@NullMarked
package dev.cairn.physics.solver.direct;

import org.jspecify.annotations.NullMarked;
