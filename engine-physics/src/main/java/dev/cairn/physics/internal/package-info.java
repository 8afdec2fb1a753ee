/**
 * The working arrays of the step.
 *
 * <p>Problem: the step touches every body and every contact several times per tick; objects would
 * cost a cache miss each. So bodies and contacts are rows of plain arrays, indexed by a slot, and
 * every phase of the step is a loop over slots.
 *
 * <p>Invariants: a slot of a body is stable for the body's life; contacts are dense and their order
 * is a function of the world's history alone, never of the number of workers. Arrays grow between
 * phases, never inside one.
 */
@NullMarked
package dev.cairn.physics.internal;

import org.jspecify.annotations.NullMarked;
