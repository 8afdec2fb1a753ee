/**
 * The price list: what one more body, pair, point, row or event costs, and whether features that a
 * scene does not need cost anything.
 *
 * <p><b>Problem.</b> One time per scene does not tell what it is made of. Here scenes are drawn at
 * random, their parts counted, and the times fitted by a sum of prices.
 *
 * <pre>
 *   Mix (random numbers of parts) ──► world ──► CPU time of a tick, counts ──► LeastSquares ──► table
 *   Ladder (one feature on / off, interleaved) ──► ratio with its interval ──► table
 * </pre>
 *
 * <p><b>Invariants.</b> CPU time of one thread, one worker. Counts are those of the engine's own
 * façade. The intervals are of 95 %.
 *
 * <p>Source: accuracy catalogue, section 5.
 */
@NullMarked
package dev.cairn.benchmarks.cost;

import org.jspecify.annotations.NullMarked;
