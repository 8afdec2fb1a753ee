/**
 * Headline figures of this engine over time: a few numbers per commit, kept as JSON and compared
 * with those of an earlier commit. A report for people, not a gate: it never fails a build.
 *
 * <p>Figures: cheapest cost that reaches an error (cost@tol), best error within a cost
 * (err@budget), and the digest of the state, which changes with any change of behaviour. Two costs
 * differ if they are further apart than three times their measured noise.
 *
 * <p>Source: accuracy catalogue, section 3.1.
 */
@NullMarked
package dev.cairn.benchmarks.regress;

import org.jspecify.annotations.NullMarked;
