/**
 * The tables of surfaces made of triangles, which the narrow phase and the queries read.
 *
 * <p>Problem: a level has a million triangles, a body meets ten of them, and what it meets must not
 * depend on where one triangle ends and the next begins. So a surface is asked for the triangles in
 * a box, in a fixed order, and knows of each edge and corner whether anything can touch it there:
 * on a flat or hollow edge nothing can, for the neighbour is in the way.
 *
 * <pre>
 *   vertices, indices ─▶ weld ─▶ leave out degenerate ones ─▶ sort by halves into a flat tree ─▶ edges
 *                                                              ({@link dev.cairn.physics.shape.mesh.MeshBuilder})
 * </pre>
 *
 * <p>A height field is such a surface too ({@link dev.cairn.physics.shape.mesh.FieldTriangles}),
 * with nothing stored but the samples and a pyramid of bounds ({@link
 * dev.cairn.physics.shape.mesh.SampleGrid}).
 *
 * <p>Invariants: immutable after it is built; triangles are numbered in the order of the tree, or
 * of the cells, and a box query tells them ascending; a box in the tree, rounded outwards to float,
 * holds its triangles.
 */
@NullMarked
package dev.cairn.physics.shape.mesh;

import org.jspecify.annotations.NullMarked;
