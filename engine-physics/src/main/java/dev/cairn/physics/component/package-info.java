/**
 * The components of a body's entity: what other systems of the ECS may read of the physics.
 *
 * <p>Problem: physics is one system among others. What it tells them, and what they tell it, are
 * columns like all others, so that a system needs to know no class of the physics but these
 * records.
 *
 * <p>Invariants: plain records of primitives in world axes and SI units; each has one writer.
 */
@NullMarked
package dev.cairn.physics.component;

import org.jspecify.annotations.NullMarked;
