/**
 * Joints in the solver.
 *
 * <p>{@link dev.cairn.physics.solver.joint.JointMath} tells what the rows of a joint measure and
 * their derivatives. {@link dev.cairn.physics.solver.joint.Assemblies} finds what hangs together by
 * joints; {@link dev.cairn.physics.solver.joint.Elimination} orders an assembly so that little is
 * filled, {@link dev.cairn.physics.solver.joint.BlockFactors} holds and factors its matrix, and
 * {@link dev.cairn.physics.solver.joint.JointSolve} takes it through a sub-step. An assembly that
 * touches nothing is taken through the whole tick by {@link
 * dev.cairn.physics.solver.joint.AssemblyFlight}; with contacts the two halves of a sub-step follow
 * the sweeps of the bias and of the relax pass. What is too dense for factors takes the same steps,
 * with {@link dev.cairn.physics.solver.joint.ConjugateGradients} in their place.
 *
 * <p>The method, and what it costs, is in docs/joints.md.
 */
@NullMarked
package dev.cairn.physics.solver.joint;

import org.jspecify.annotations.NullMarked;
