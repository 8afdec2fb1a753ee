/**
 * One measurement: a scene in an engine, in a JVM of its own, judged or timed.
 *
 * <p><b>Problem.</b> Engines crash, hang, keep threads and warm each other's code, and each tells
 * its own story about its errors. So each runs in a process that may die, is asked by lines of
 * JSON, and hands over nothing but poses, velocities and times.
 *
 * <pre>
 *   EngineProcess  ── ask: Protocol ──►  Worker (main class of the engine's JVM)
 *        ▲                                  │ Case: what to build     Judge: how wrong it is
 *        └── answer, or how it died ◄───────┘ CpuClock: what it cost
 *   Machine: what all of this ran on        Probe: is an engine there at all
 * </pre>
 *
 * <p><b>Invariants.</b> The judge sees poses and velocities alone, and is the same code for all.
 * Nothing but the step itself is timed. An engine that is silent beyond its time is ended, and the
 * answer says so. Nothing here knows which measurements are asked for, or what is made of them.
 */
@NullMarked
package dev.cairn.benchmarks.compare.measure;

import org.jspecify.annotations.NullMarked;
