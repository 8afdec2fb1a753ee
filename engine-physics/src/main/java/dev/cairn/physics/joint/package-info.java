/**
 * Joints: what holds two bodies together and lets them move in some ways only.
 *
 * <p>A {@link dev.cairn.physics.joint.Joint} describes one and {@code PhysicsWorld.add} makes it; a
 * {@link dev.cairn.physics.joint.JointRef} changes and asks the one that was made; {@link
 * dev.cairn.physics.joint.Joints} has all of a world and tells which broke.
 *
 * <p>There is one kind of joint. It has a frame in each of its bodies, equal when it is made, and
 * six ways in which the frame in B may move against that in A: {@link
 * dev.cairn.physics.joint.JointAxis#X}, Y and Z along the axes of A's frame, the twist of B about
 * its own x, and the swing of that axis about A's y and z. Each way is free, locked or limited, and
 * may have a motor and a spring. Hinge, slider, ball and the others are settings of these; a rod, a
 * rope and the cross of a universal joint have a way of their own beside them.
 *
 * <p>How they are solved is the matter of {@code solver.joint} and of docs/joints.md.
 */
@NullMarked
package dev.cairn.physics.joint;

import org.jspecify.annotations.NullMarked;
