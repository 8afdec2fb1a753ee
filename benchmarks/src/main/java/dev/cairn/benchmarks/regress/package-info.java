/**
 * Headline figures of this engine over time: a few numbers per commit, kept as JSON and compared
 * with those of an earlier commit. A report for people, not a gate: it never fails a build.
 *
 * <p>Figures: cheapest cost that reaches an error (cost@tol), best error within a cost
 * (err@budget), the error at N = 4, what a fresh JVM takes for the first ticks, and the digest of
 * the state, which changes with any change of behaviour.
 *
 * <p>One JVM compiles the same code otherwise than the next, so a commit is measured in several,
 * and a figure that hangs on a clock counts as changed only if every run of one commit lies beyond
 * every run of the other, and the medians are 3 % apart. If nothing has changed, five runs and five
 * come to lie so in 2 of the 252 orders that are possible, for each figure (Mann and Whitney 1947,
 * the extreme of their U); this holds whatever the distribution is, as long as the runs of both are
 * taken in turns.
 *
 * <p>Source: accuracy catalogue, section 3.1.
 */
@NullMarked
package dev.cairn.benchmarks.regress;

import org.jspecify.annotations.NullMarked;
