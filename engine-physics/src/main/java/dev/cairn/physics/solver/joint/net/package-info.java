/**
 * Nets of balls, which joints hold together at points.
 *
 * <p>{@link dev.cairn.physics.solver.joint.net.JointPaths} lays joints in paths; {@link
 * dev.cairn.physics.solver.joint.net.PathFactors} inverts what the joints of a path do to each
 * other; {@link dev.cairn.physics.solver.joint.net.NetBodies} holds the numbers of the bodies, and
 * {@link dev.cairn.physics.solver.joint.net.PointNet} those of the joints, and solves a net by
 * conjugate gradients with these. It knows nothing of assemblies; {@code solver.joint.NetSolve}
 * takes them through a sub-step with it.
 */
@NullMarked
package dev.cairn.physics.solver.joint.net;

import org.jspecify.annotations.NullMarked;
