/**
 * What a collider is like, beside its shape: what it collides with.
 *
 * <p>Problem: a body is one thing to the laws of motion, but what it is made of meets the world
 * piece by piece. A collider is a shape on a body; most bodies have one.
 *
 * <pre>
 *   category bits ─┐
 *   mask bits      ├─▶ {@link dev.cairn.physics.collider.Filter}: do two colliders meet?
 *   group          ┘         ▲
 *   names of layers ─▶ {@link dev.cairn.physics.collider.Layers}
 * </pre>
 *
 * <p>Invariants: everything here is immutable and says what, never how: the world copies it. The
 * rule of two filters is symmetric. A pair that is refused gets no contact row, so it costs the
 * broad phase and nothing else.
 *
 * <p>Source: category, mask and group as in Box2D (Erin Catto).
 */
@NullMarked
package dev.cairn.physics.collider;

import org.jspecify.annotations.NullMarked;
