/**
 * The faces, edges and vertices of convex polyhedra, as tables that the narrow phase reads.
 *
 * <p>Problem: clipping, separating axes and support points ask for neighbours and planes many times
 * for each pair of shapes, and a user of a shape for none of them. So the tables are a package of
 * their own which knows no shape; {@link dev.cairn.physics.shape.polyhedron.Polyhedral} is the way
 * from a shape to them.
 *
 * <p>Invariants: immutable; every edge lies in exactly two faces; all is relative to the centre of
 * mass, which is inside.
 */
@NullMarked
package dev.cairn.physics.shape.polyhedron;

import org.jspecify.annotations.NullMarked;
