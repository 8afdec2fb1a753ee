/** Sub-stepped soft contacts; see {@link dev.cairn.physics.solver.ContactSolver}. */
@NullMarked
package dev.cairn.physics.solver;

import org.jspecify.annotations.NullMarked;
