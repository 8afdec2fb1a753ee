/**
 * Motion and contact of one tick: sub-stepped soft contacts in double.
 *
 * <p>Problem: bodies that touch must not sink into each other, must stick and slide as friction
 * says, must bounce as restitution says, and must come to rest; towers couple all of them. A rigid
 * solve of all contacts is slow and has no unique answer, a soft one sags. So the tick is cut into
 * short sub-steps, each of which sweeps once over all contacts with an over-damped soft step, and
 * takes the velocity of that push out again:
 *
 * <pre>
 *   collect ─ contacts with points become flat rows; bodies without any fly their whole tick at once
 *   load    ─ what rests under a load is solved with that load's inertia, while it rests
 *   prepare ─ effective masses, levers, friction block; warm start of the last sub-step
 *   sub-step, four times:
 *     impacts  bounces, each at its own time, before anything is solved
 *     kick     v += h (g + f/m)
 *     warm     v += M⁻¹ Jᵀ λ
 *     bias     normals, soft: overlap is pushed out, gaps close at most to zero
 *     drift    x += h v under load, the parabola without; free rotation by Strang splitting
 *     relax    normals, hard, without push; then twist and friction at the patch's centre
 *     glide    bodies on one static contact: trapezoid along its plane
 *   store   ─ impulses, totals, and what resting points have learnt of their load
 * </pre>
 *
 * <p>Invariants: a contact's impulse on A is the exact negative of that on B, and the reported
 * totals are all the momentum that was exchanged; friction stays in its circle; normal impulses
 * never pull; impacts add no energy. Rows are solved in the order of the contact store by one
 * thread, bodies in blocks by all, so the bits do not depend on the number of workers. A scene
 * without restitution runs no impact, one without friction no tangent rows. Steps use + - * / and
 * square roots only, and allocate nothing.
 *
 * <p>The seam for a wide solver: {@code ConstraintRows} is the whole input of a sweep besides the
 * bodies' velocities; kernels are static methods over its arrays.
 *
 * <p>Sources: E. Catto, Solver2D and the Soft Step solver (2023-24); M. Macklin et al., "Small
 * Steps in Physics Simulation" (2019); E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex rigid
 * bodies with stacking" (2003) for impacts before contacts; R. McLachlan (1993) for the splitting;
 * M. Powell and M. Hestenes (1969) for the offset. Figures: {@code docs/solver.md}.
 */
@NullMarked
package dev.cairn.physics.solver;

import org.jspecify.annotations.NullMarked;
