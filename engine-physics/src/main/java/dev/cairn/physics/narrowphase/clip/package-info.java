/**
 * From a reference feature and an incident one to contact points.
 *
 * <p>Problem: two faces that lie on each other touch in a polygon; the solver wants up to four of
 * its points, each with a separation and an id that is the same in the next tick.
 *
 * <pre>
 *    incident face ─▶ cut by the sides of the ─▶ drop what is beyond ─▶ four that hold the deepest
 *                     reference face             the margin             and span most area
 * </pre>
 *
 * <p>Each side of the polygon remembers what it came from, so each corner is exactly a vertex of
 * either shape or an edge of A crossing an edge of B. Discs and lines are clipped by {@link
 * dev.cairn.physics.narrowphase.clip.Overlay}, polygons by {@link
 * dev.cairn.physics.narrowphase.clip.Clipper}.
 *
 * <p>What stands on flat ground with a triangle that is level with its neighbours touches with the
 * nearest corner of these, too ({@link dev.cairn.physics.narrowphase.clip.LevelCorner}).
 *
 * <p>Invariants: ids do not depend on which shape is the reference. A corner on a side plane up to
 * a tolerance is not cut, and for a point of the last tick the tolerance is larger, so that flush
 * faces keep their points. Where an edge crosses a side depends on these two alone, not on the
 * order of cuts, so a mirror image has the mirrored bits.
 *
 * <p>Source: I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping" (1974).
 */
@NullMarked
package dev.cairn.physics.narrowphase.clip;

import org.jspecify.annotations.NullMarked;
