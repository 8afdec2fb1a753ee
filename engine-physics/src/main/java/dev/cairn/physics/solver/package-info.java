/**
 * Motion and contact of one tick: sub-stepped soft contacts, wide over the contacts of a colour.
 *
 * <p>Problem: bodies that touch must not sink into each other, must stick and slide as friction
 * says, must bounce as restitution says, and must come to rest; towers couple all of them. A rigid
 * solve of all contacts is slow and has no unique answer, a soft one sags. So the tick is cut into
 * short sub-steps, each of which sweeps once over all contacts with an over-damped soft step, and
 * takes the velocity of that push out again:
 *
 * <pre>
 *   collect ─ contacts with points get a batch, a colour and a place; bodies without any fly at once
 *   load    ─ bodies at rest under a load are solved with that load's inertia, see
 *             {@code SupportAnalysis}
 *   prepare ─ weighted arms, effective masses, friction block; the bodies' first warm start
 *   start   ─ once, for what is put up at rest: impulses that hold it, before anything moves
 *   sub-step, four times:
 *     impacts  bounces, each at its own time, before anything is solved
 *     land     points that land, of bodies on one static contact: their impact, at its own time
 *     kick     v += h (g + f/m), then the warm start of all contacts of a body at once
 *     bias     normals, soft: overlap is pushed out, gaps close at most to zero
 *     drift    x += h v under load, the parabola without; free rotation, exact or of order 6
 *     renew    levers of now, for rows of bodies that turn or pass each other
 *     relax    normals, hard, without push; then twist and friction at the patch's centre; then
 *              rolling friction, only of rows whose materials have it, see {@code RollingFriction}
 *     direct   after bias and relax: all contacts of a long, slender island at rest together, see
 *              {@code DirectSolve}
 *     finish   what the contacts did is the next warm start; bodies on one static contact: trapezoid,
 *              on one corner of theirs: pinned there, see {@code PinnedCorner}
 *   store   ─ impulses, totals, and what resting points have learnt of their load
 * </pre>
 *
 * <p>Colours: no two contacts of a colour move the same body, so a colour may be solved at once, by
 * lanes and by workers, with one result. Batches: islands that fit the cache go through the whole
 * tick on one worker; what is larger is cut into domains that fit, solved a pass or two at a time
 * with what lies between them in lockstep. A row lies in memory with its group, field by field, so
 * that a field of a group is one vector. Angular velocities are weighted by a root of the inverse
 * inertia: an arm then is three numbers that serve both ways. The warm start costs nothing per
 * contact: a body keeps the sum of what its contacts did.
 *
 * <p>Precision: bodies are doubles. The rows of small islands are, too, those of large ones are
 * floats, see {@code Batches}. Then the sweeps see velocities and movements rounded, and what they
 * change is added to the state; the classes whose names begin with Single are made from the others
 * by {@code build/Twins.java}.
 *
 * <p>Invariants: a contact's impulse on A is the exact negative of that on B, and the reported
 * totals are all the momentum that was exchanged; friction stays in its circle; normal impulses
 * never pull; impacts add no energy. The order of solving is that of the colours, which is a
 * function of the contacts' order; the wide sweeps and the scalar ones do the same operations, so
 * the bits depend neither on the workers nor on the lanes. A scene without restitution runs no
 * impact, one without friction no tangent rows, one without rolling friction asks once a range of
 * rows. Steps use + - * / and square roots only, and allocate nothing once the wide kernels are
 * compiled, which is done beside the first ticks.
 *
 * <p>Sources: E. Catto, Solver2D and the Soft Step solver (2023-24); M. Macklin et al., "Small
 * Steps in Physics Simulation" (2019); E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid
 * bodies with stacking" (2003) for impacts before contacts; R. McLachlan, A. Zanna (2005) and E.
 * Hairer, G. Vilmart (2006) for the rotation; M. Powell and M. Hestenes (1969) for the offset; A.
 * Aitken (1926) and D. Anderson (1965) for the leaps of {@code StaticStart}; M. Silcowitz, S.
 * Niebe, K. Erleben (2010) for solves between sweeps. How it works: {@code docs/solver.md};
 * figures: {@code docs/notebook}.
 */
@NullMarked
package dev.cairn.physics.solver;

import org.jspecify.annotations.NullMarked;
