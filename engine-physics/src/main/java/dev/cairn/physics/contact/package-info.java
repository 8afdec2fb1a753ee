/**
 * The life of a contact: from near to touching to apart.
 *
 * <p>Problem: the solver converges because it starts from last tick's impulses. So a pair keeps its
 * row as long as the fat boxes overlap, and a point keeps its impulse as long as its features
 * touch.
 *
 * <pre>
 *   bounds ─▶ needed and fat boxes, in blocks of bodies          ({@link dev.cairn.physics.contact.BoundsStage})
 *   rows   ─▶ drop those whose boxes parted, in row order;
 *             append new pairs in merge order                     ({@link dev.cairn.physics.contact.ContactRows})
 *   points ─▶ narrow phase, in blocks of rows, one writer a row;
 *             impulses carried over by feature id                 ({@link dev.cairn.physics.contact.ManifoldStage})
 *   touch  ─▶ after the solve: began and ended, in row order       ({@link dev.cairn.physics.contact.TouchEvents})
 * </pre>
 *
 * <p>Invariants: row order is a function of history: the last rows take the places of those that
 * leave, additions come last. Each ended event had a began event before, and each began event is
 * followed by an ended one, the removal of a body included.
 *
 * <p>How near is near? No absolute slop. A pair is looked at up to a margin of {@code
 * speculativeTime} ticks of relative motion (velocities with this tick's gravity and forces, and
 * turning, which cannot reach out farther than from the inner to the outer ball), plus {@code
 * speculativeFraction} of the smaller inner radius. The needed box of each body covers its share.
 *
 * <p>Source: persistent manifolds by feature id and speculative margins as in Box2D and Box3D (E.
 * Catto).
 */
@NullMarked
package dev.cairn.physics.contact;

import org.jspecify.annotations.NullMarked;
