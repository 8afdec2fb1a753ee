/**
 * Batches of pairs of boxes.
 *
 * <p>Problem: most pairs of a pile are boxes on boxes, and most of those are a face on a face. They
 * are decided by fifteen axes without branches, which suits lanes; what follows branches by pair.
 *
 * <pre>
 *   32 pairs ─▶ axes in lanes ─▶ reference face ─▶ clip in lanes ─▶ four points ─▶ world axes
 *                                     │ edges, corners, other polygons
 *                                     ▼
 *                               pair by pair, or NarrowPhase
 * </pre>
 *
 * <p>Invariants: {@link dev.cairn.physics.narrowphase.box.BoxContacts} gives the points that {@link
 * dev.cairn.physics.narrowphase.NarrowPhase} gives, with lanes and without; every number is formed
 * by the same operations in the same order. Nothing is allocated.
 *
 * <p>Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree" (1996); I. E. Sutherland, G. W.
 * Hodgman, "Reentrant polygon clipping" (1974).
 */
@NullMarked
package dev.cairn.physics.narrowphase.box;

import org.jspecify.annotations.NullMarked;
