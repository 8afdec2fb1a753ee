/**
 * Bodies whose only contact is with a static body: five corrections that follow closed forms, and a
 * bound.
 *
 * <p>Such a body is free in all but a few directions, so more is known of it than of a heap: the
 * inelastic impact of landing points at its own time, sweeps until its impulses agree, the
 * trapezoidal correction of its path, a turn on one corner as pinned there, and rolling on a rim
 * without slip. And a static body does no work, so the body's energy is bounded, whatever the
 * passes did. All run in the sub-step of the body alone and see no other.
 */
@NullMarked
package dev.cairn.physics.solver.single;

import org.jspecify.annotations.NullMarked;
