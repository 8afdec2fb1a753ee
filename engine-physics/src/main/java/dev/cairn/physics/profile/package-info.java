/**
 * Where the time of a step goes.
 *
 * <p>Problem: who tunes a scene wants to know which stage of the physics takes how long, without a
 * profiler, and a step that nobody times should pay nothing for the question.
 *
 * <p>Invariants: the stages are those of {@code PhysicsSystem}, in its order; nothing that is
 * measured here reaches the state of the world.
 */
@NullMarked
package dev.cairn.physics.profile;

import org.jspecify.annotations.NullMarked;
