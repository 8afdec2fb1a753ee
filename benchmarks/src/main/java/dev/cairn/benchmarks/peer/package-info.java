/**
 * Other engines behind one interface, so that the same scene runs in each.
 *
 * <p><b>Problem.</b> Two engines can be compared only if they simulate the same thing. Engines
 * differ in what a body is (where its origin lies, what its inertia is, how two frictions mix, what
 * is damped or put to sleep unasked), and each of these differences can pass for speed or for
 * accuracy.
 *
 * <pre>
 *   samples' script ──► Cairn world ──► SceneDescription ──► CairnPeer, JoltPeer, OdePeer ...
 *      (one builder)     (read back)    poses, shapes,            │ step
 *                             ▲         mass, inertia, mu, e      ▼
 *                             └──────────── poses ◄───────── readPoses
 *                        truths and overlaps are measured here, for every engine
 * </pre>
 *
 * <p><b>Invariants.</b> There is one builder per scene: the one that samples and tests use. The
 * description is read back from the world that it built, through the public façade, and is all that
 * an adapter sees. Poses are those of the centre of mass. Mass and inertia are handed over as
 * numbers, never recomputed by the peer. Sleeping and damping are off in all engines. What an
 * adapter cannot set it says in {@link dev.cairn.benchmarks.peer.Peer#notes}, and the report prints
 * it. Every other setting is the engine's own default. An engine whose jar or native library is
 * absent fails with a {@link dev.cairn.benchmarks.peer.MissingEngineException} and harms nobody.
 *
 * <p><b>One knob.</b> A tick of 1/60 s is cut into N sub-steps. Cairn and engines with sub-steps of
 * their own get the number; the others are stepped N times by 1/(60 N) s.
 *
 * <p>Sources: the protocol follows SimBenchmark (Leggedrobotics 2018, one description for all
 * engines) and the Gazebo boxes study (Peters 2014, poses logged first, metrics after).
 */
@NullMarked
package dev.cairn.benchmarks.peer;

import org.jspecify.annotations.NullMarked;
