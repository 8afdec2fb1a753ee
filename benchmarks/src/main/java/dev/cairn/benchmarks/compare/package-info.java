/**
 * The speed-against-error report: scenes x engines x sub-steps, measured by one protocol and drawn
 * as work-precision diagrams.
 *
 * <p><b>Problem.</b> A time without an error says nothing, for an engine can be made as fast as one
 * likes by being wrong; an error without a time says as little. A work-precision diagram shows
 * both: each engine is a curve whose points are its sub-steps, down is more accurate, left is
 * cheaper, and the curve nearest to the lower left wins.
 *
 * <pre>
 *   Compare ──► EngineProcess (one JVM per engine and scene) ──► Worker
 *      │          JSON lines over stdin/stdout                     │ judge: run the ticks, teleport a
 *      │                                                           │   mirror of the scene to the
 *      │   round 1: A B C, round 2: B C A, ...                     │   poses, ask the scene's own
 *      ▼                                                           │   truths and Penetration
 *   Results ──► CSV, JSON, SVG, one HTML page                      ▼ time: step, nothing else
 * </pre>
 *
 * <p><b>Invariants.</b> Errors and times come from separate runs. Every engine's error is computed
 * by the same code, in double, from its poses alone. Rounds are interleaved, so that a slow minute
 * of the machine hits all engines. The first tick, the building of the scene and the reading of
 * poses are never in a time. What fails is reported and drawn at the top edge of the diagram, never
 * dropped; an engine that crashes or is absent costs its own points only.
 *
 * <p>Cost on the diagrams is CPU time per movable body and tick of 1/60 s, of the one stepping
 * thread plus the collector's pauses: it hardly moves when somebody else uses the machine. Wall
 * times are in the tables.
 *
 * <p>One measurement is a chapter of its own, {@code compare.measure}; here is what to measure, in
 * which order, and what is made of it.
 *
 * <p>Sources: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (work-precision
 * diagrams); SimBenchmark, Leggedrobotics 2018 (accuracy against cost for engines, separate runs).
 */
@NullMarked
package dev.cairn.benchmarks.compare;

import org.jspecify.annotations.NullMarked;
