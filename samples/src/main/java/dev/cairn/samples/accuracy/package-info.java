/**
 * The accuracy table: cases with a truth from outside the engine, run at 1 to 16 sub-steps.
 *
 * <p>{@code samples accuracy} runs them and writes {@code docs/accuracy.md}. Truths are closed
 * forms, elliptic integrals by the arithmetic-geometric mean, quadratures, or Runge-Kutta
 * references that share no code with the engine.
 */
@NullMarked
package dev.cairn.samples.accuracy;

import org.jspecify.annotations.NullMarked;
