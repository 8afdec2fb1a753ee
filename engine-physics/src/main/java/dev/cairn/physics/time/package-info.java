/**
 * What a world as a value is good for: going back, trying futures, and playing over a network.
 *
 * <p>All of it stands on two promises: {@code PhysicsWorld.restore} gives back every bit that the
 * next step depends on, and a step is a function of these bits. So a past tick need not be kept if
 * an earlier state and the inputs since are; and two machines that agree on inputs agree on worlds.
 *
 * <ul>
 *   <li>{@link dev.cairn.physics.time.History}: the last ticks as differences, within a bound of
 *       memory.
 *   <li>{@link dev.cairn.physics.time.Recorder}, {@link dev.cairn.physics.time.Recording}, {@link
 *       dev.cairn.physics.time.Replay}: a run with what was done in it, as a file; run again, and
 *       compared.
 *   <li>{@link dev.cairn.physics.time.Rollback}: predict with the inputs that are known, and rewind
 *       and step again when others arrive. After T. Cannon, GGPO, 2009.
 *   <li>{@link dev.cairn.physics.time.Ensemble}: many futures of one state, beside each other.
 *   <li>{@link dev.cairn.physics.time.Forks}: many forks that wait and share what has not changed.
 * </ul>
 */
@NullMarked
package dev.cairn.physics.time;

import org.jspecify.annotations.NullMarked;
