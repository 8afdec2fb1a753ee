/**
 * The numbers of the step that may be tuned, each declared once.
 *
 * <p>Problem: a tunable has a name, a unit, a range, a default and a reason, and is wanted by
 * users, stages, ladders of ablation and tests. Here {@link dev.cairn.physics.tuning.Tunable}
 * declares all of that in one place, and {@link dev.cairn.physics.tuning.Tuning} is an immutable
 * set of values. Adding a tunable adds a constant, and breaks no caller.
 *
 * <p>Most users need none of it: what a scene decides on is in {@code PhysicsSettings}.
 */
@NullMarked
package dev.cairn.physics.tuning;

import org.jspecify.annotations.NullMarked;
