/**
 * The samples: every scene once, in one registry, for the window, the headless runner, the tests
 * and the benchmarks.
 *
 * <h2>Problem</h2>
 *
 * <p>A scene that is written three times, as a demo, as a test and as a benchmark, is three scenes,
 * and the numbers of one say nothing about the others. And a demo that looks right proves little: a
 * box that slides "about that far" may be ten percent off.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   SceneRegistry ── SampleScene ── script ──▶ SceneBuilder ──▶ PhysicsWorld
 *        │             (id, parameters)          │ bodies, camera, hooks, truths
 *        │                                       │
 *   Main ┼─ Sandbox ────── steps, draws ─────────┤
 *        └─ SceneRun ───── steps, measures ──────┘──▶ SceneReport ──▶ table, JSON, picture
 *                              │
 *                Penetration, AllocationMeter: look at the engine from outside
 * </pre>
 *
 * <h2>Invariants</h2>
 *
 * <ul>
 *   <li>A script knows neither window nor runner, and needs no GL.
 *   <li>What a scene does is a function of its parameters and its seed: same digest for every
 *       number of workers.
 *   <li>Measures are taken outside the engine. {@link dev.cairn.samples.overlap.Penetration}
 *       recomputes overlaps from poses and shapes by separating axes in double and calls nothing of
 *       the narrow phase; the truths are closed forms.
 *   <li>A mistake of the user is one line that teaches, and exit code 2.
 * </ul>
 *
 * <h2>Sources</h2>
 *
 * <p>Scenes as registry entries that serve test bed and benchmark alike: the sample browsers of
 * Box2D, Box3D and Jolt. {@code pyramid} with base 100 is Box3D's {@code large_pyramid}. Closed
 * forms: any text on classical mechanics; each scene writes its own beside the code.
 */
@NullMarked
package dev.cairn.samples;

import org.jspecify.annotations.NullMarked;
