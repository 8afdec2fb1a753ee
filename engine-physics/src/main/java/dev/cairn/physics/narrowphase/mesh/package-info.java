/**
 * One convex shape against a surface of triangles: all contacts of the pair, one for each direction
 * in which something pushes.
 *
 * <p>Problem: a body that slides over a floor of triangles must not feel where one ends and the
 * next begins. Collided one by one, the rim of each triangle stops it, for a triangle does not know
 * its neighbour.
 *
 * <pre>
 *   triangles in the body's box ─▶ faces: planes whose triangles the body's points are over    ({@link dev.cairn.physics.narrowphase.mesh.FaceRegions})
 *                               ─▶ ridges that can't be touched, by a support point each       ({@link dev.cairn.physics.narrowphase.mesh.RidgeCulling})
 *                               ─▶ of others the best normal, in closed form                   ({@link dev.cairn.physics.narrowphase.mesh.RidgeArc})
 *                               ─▶ flats over ridges of a face that separates most: cut        ({@link dev.cairn.physics.narrowphase.mesh.RimPoints})
 *                               ─▶ other edges and corners: the general way of two hulls,      ({@link dev.cairn.physics.narrowphase.mesh.RimSearch})
 *                                  kept if the normal is in the cone of the surface there      ({@link dev.cairn.physics.narrowphase.mesh.NormalCone})
 *                               ─▶ contacts, each with one normal                              ({@link dev.cairn.physics.narrowphase.mesh.MeshContact})
 * </pre>
 *
 * <p>The rule: at a point p of the surface a normal m is possible if no part of the surface at p
 * goes towards m, m . (w - p) &lt;= 0 for the corners w of all triangles that touch p. This is the
 * polar of the tangent cone. On a flat edge it leaves the face normal, on a hollow edge nothing, on
 * a ridge the normals between its two faces; vertices that do not match (T-joints) and soups of
 * triangles are no special case, for it asks for places and not for neighbours. Triangles of one
 * plane make one contact, so a floor of any triangles gives the points of a plane.
 *
 * <p>Invariants: all is computed in axes of the mesh from the centre of the convex shape. Contacts
 * come in the order of their first triangle, faces first.
 *
 * <p>Sources: normal cones of polyhedra as in G. van den Bergen, "Collision Detection in
 * Interactive 3D Environments" (2003); that inner edges are to be told from active ones, as Jolt
 * (J. Rouwe) and Box3D (E. Catto) do.
 */
@NullMarked
package dev.cairn.physics.narrowphase.mesh;

import org.jspecify.annotations.NullMarked;
