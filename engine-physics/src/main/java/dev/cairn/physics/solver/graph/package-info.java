/**
 * What is solved together, and in what order: from a list of contacts to batches, colours and
 * places.
 *
 * <pre>
 *   Collector ─ EdgeFacts: what each edge is, read in blocks ─ PairOrder: an order by bodies ─
 *   Batches: islands that fit a cache, Domains of those that do not ─ Colouring: no two rows of a
 *   colour move the same body ─ places in memory
 * </pre>
 *
 * <p>All of it is a function of the contacts and of the order of their bodies; what workers decide
 * is only which of them takes which batch. What has not changed since the last tick is kept.
 *
 * <p>Sources: E. Catto, Box3D's constraint graph (2025); C. Farhat, "A simple and efficient
 * automatic FEM domain decomposer" (1988).
 */
@NullMarked
package dev.cairn.physics.solver.graph;

import org.jspecify.annotations.NullMarked;
