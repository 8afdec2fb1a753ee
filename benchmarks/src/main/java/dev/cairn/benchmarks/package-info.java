/**
 * JMH suites, with the engines beside Cairn that a user would otherwise pick, in the same run.
 *
 * <p><b>Rules.</b> A suite is named by what a user does, not by what a class does. Rivals do equal
 * work: the same fields of the same types are written from the same inputs, and what was written
 * outlives the measurement, so that nothing can be left out by the compiler. Rivals are used as
 * their manuals say, and single-threaded as they are; Cairn's figure to compare is the one with one
 * worker, and it is that of whole ticks: schedule, double buffering and commit included.
 *
 * <pre>
 *   java -jar benchmarks/target/benchmarks.jar EcsIterate
 *   java -jar benchmarks/target/benchmarks.jar -prof gc JobsDispatch
 * </pre>
 *
 * <p>A smoke test runs every benchmark once in the normal build. See {@code docs/benchmarks.md}.
 */
@NullMarked
package dev.cairn.benchmarks;

import org.jspecify.annotations.NullMarked;
