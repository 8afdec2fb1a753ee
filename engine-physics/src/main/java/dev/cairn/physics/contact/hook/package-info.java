/**
 * What users change of contacts between the narrow phase and the solve.
 *
 * <p>Problem: a one-way platform lets through from below, a belt carries what lies on it, ice rubs
 * less under a skate. None of these follows from shapes and materials, and all of them must be
 * known before rows are solved.
 *
 * <pre>
 *   hook  ─▶ the user's own rule, in blocks of rows: disable, friction, restitution   ({@link dev.cairn.physics.contact.hook.HookStage})
 *   belts ─▶ surface velocities of the two colliders, along the contact              ({@link dev.cairn.physics.contact.hook.BeltStage})
 * </pre>
 *
 * <p>Invariants: a row is changed by the worker of its block only, in row order; a world without
 * hooks and belts does not come here.
 */
@NullMarked
package dev.cairn.physics.contact.hook;

import org.jspecify.annotations.NullMarked;
