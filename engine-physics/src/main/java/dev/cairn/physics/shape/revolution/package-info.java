/**
 * Solids of revolution as collision sees them.
 *
 * <p>Problem: capsules, cylinders and cones have closed forms of their own, but what collides them
 * needs no more than two discs and a radius, and no code behind the shapes should ask for a class.
 *
 * <p>Invariants: {@link dev.cairn.physics.shape.revolution.Discs} are about the centre of mass and
 * do not change; a ball has none, as it has no axis.
 */
@NullMarked
package dev.cairn.physics.shape.revolution;

import org.jspecify.annotations.NullMarked;
