/**
 * Several contacts that are one: between points and solve, rows that stand for others.
 *
 * <p>Problem: a level is made of tiles, a body of parts. Each contact alone is right, and yet their
 * sum is not: the side of the next tile stops a body that slides over it, and how parts share the
 * weight of their body follows from the order in which they are swept. What touches is the surface
 * that the pieces make.
 *
 * <pre>
 *   wholes  ─▶ parts of one body that make a convex shape: one row of that shape           ({@link dev.cairn.physics.contact.seam.WholeStage})
 *   seams   ─▶ one collider on neighbours that stand still against each other: one row of
 *              the plane that they make; contacts inside of it are left out                ({@link dev.cairn.physics.contact.seam.SeamStage})
 *   patches ─▶ parts of a body that is not convex, along one normal: one row of the corners ({@link dev.cairn.physics.contact.seam.PatchStage})
 *   solve
 *   and in the order from last to first the rows get their impulses back
 * </pre>
 *
 * <p>Invariants: a row that another one stands for has the negative of its number of points, from
 * join to part; afterwards all rows are as the narrow phase left them, with impulses whose sum is
 * that of the rows that stood for them. What a joined row is, is geometry: support functions,
 * comparisons, and one length below which coordinates are equal, for they were rounded.
 */
@NullMarked
package dev.cairn.physics.contact.seam;

import org.jspecify.annotations.NullMarked;
