/**
 * Rigid bodies: what a user meets.
 *
 * <p>Problem: a game or a study has bodies that fall, collide, rest and roll, and wants to say so
 * in a few lines, and to get the same bits on any machine with any number of workers.
 *
 * <pre>
 *  PhysicsWorld ── World (ECS) ── PhysicsSystem, one tick:
 *
 *    registry   entities that are gone leave the working arrays
 *    bounds   fat boxes that a body has left are moved in the tree        (dev.cairn.physics.broadphase)
 *    pairs    moved boxes ask both trees; new pairs join, old ones leave  (dev.cairn.physics.contact)
 *    collide  manifolds of all pairs, impulses carried over by feature id (dev.cairn.physics.narrowphase)
 *    solve    sub-steps: velocities, contacts, poses                      (dev.cairn.physics.solver)
 *    guard    a body that is no longer finite is stopped and fixed
 *    events   pairs that began or ceased to touch, in contact order
 *    publish  Pose and Velocity columns of the next state
 * </pre>
 *
 * <p>Invariants: a body lives exactly as long as its entity has {@code Pose}, {@code Velocity} and
 * {@code RigidBody}; each stage writes only places that its block index determines; every order
 * (slots, pairs, contacts, events) is a function of the history of calls. A bad argument is refused
 * with the value, its bound and a remedy, and changes nothing.
 *
 * <p>Source: the order of the step follows Box3D's (Erin Catto), with a pair list instead of graph
 * buckets.
 */
@NullMarked
package dev.cairn.physics;

import org.jspecify.annotations.NullMarked;
