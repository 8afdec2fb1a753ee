/**
 * The scenes, one script per file, each with its closed form beside it where there is one.
 *
 * <h2>Invariants</h2>
 *
 * <ul>
 *   <li>A script sets up with {@code StrictMath} and the scene's own random stream only, so that
 *       the first tick has the same bits everywhere.
 *   <li>World frame: y is up, slopes fall towards +x, the camera looks along -z. Metres, kilograms,
 *       seconds.
 *   <li>A truth says where it ends: a box that left its ramp, a ball that hit the ground, a stack
 *       that still falls. Beyond, its metric is left out of the report rather than wrong.
 *   <li>Hooks do not allocate, so that what is measured as the engine's garbage is the engine's.
 * </ul>
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *          n  = (sin a, cos a, 0)
 *          ↑ ┌──┐                        in flight     s = v t + g sin a t²/2
 *      ╲   ╱ │  │ ↘ t = (cos a, -sin a)  at the impact v' = v - mu v_n, not below 0
 *        ╲   └──┘                        sliding       a = g (sin a - mu cos a)
 *          ╲  a                          rolling       a = g sin a / (1 + I / m r²)
 * </pre>
 *
 * <h2>Sources</h2>
 *
 * <p>Coulomb's law of friction and Newton's of restitution, as in any text on mechanics; the
 * pyramid is the benchmark {@code large_pyramid} of Box3D (Erin Catto), whose numbers others have
 * measured too.
 */
@NullMarked
package dev.cairn.samples.scenes;

import org.jspecify.annotations.NullMarked;
