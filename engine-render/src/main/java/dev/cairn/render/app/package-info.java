/**
 * The program around a world: window, threads, pictures.
 *
 * <p><b>Problem.</b> A user writes {@code initScene} and {@code update} and wants a window in which
 * the scene lives, keys that do things, and, on a machine without a display, a picture. Drawing
 * must never slow the physics, nor the physics the drawing.
 *
 * <p><b>Invariants.</b> All OpenGL and all window events are on the main thread (macOS demands it).
 * The world, {@code initScene}, {@code update} and bound functions are on the simulation thread.
 * Between them go only immutable models, whole snapshots (one way, by a triple buffer) and posted
 * actions (the other way, by a queue); the camera is the one shared object, and each of its calls
 * is atomic. Pausing stops the physics, not the drawing, the camera or the bindings. If the
 * simulation fails, the window closes and {@code start} throws its exception; nothing hangs.
 *
 * <pre>
 *   main thread                                        simulation thread
 *   window events --press, release, scroll--&gt; queue --&gt; bindings
 *        |                                              update(seconds)
 *      camera                                           physics.step(seconds)
 *        |                                                 |
 *   draw(snapshot, alpha) &lt;------- triple buffer -------- publish
 * </pre>
 *
 * <p><b>Source.</b> Fixed steps with an accumulator and interpolated drawing: Fiedler, "Fix your
 * timestep!" (2004).
 */
@NullMarked
package dev.cairn.render.app;

import org.jspecify.annotations.NullMarked;
