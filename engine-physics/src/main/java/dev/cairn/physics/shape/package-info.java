/**
 * Convex shapes with exact mass properties.
 *
 * <p>Problem: a rigid body needs a volume, a centre of mass and an inertia tensor that are right to
 * the last digits, and the narrow phase needs true features (vertices, edges, faces) with exact
 * planes, not a triangle soup.
 *
 * <p>Polyhedra ({@link dev.cairn.physics.shape.Box}, {@link dev.cairn.physics.shape.ConvexHull})
 * carry one polyhedron: vertices, edges, merged faces, all of it relative to the centre of mass, so
 * that a body's position is the position of its centre of mass and rotation never moves it. Round
 * shapes ({@link dev.cairn.physics.shape.Sphere}, {@link dev.cairn.physics.shape.Capsule}) are a
 * point or a segment with a radius; {@link dev.cairn.physics.shape.Cylinder} and {@link
 * dev.cairn.physics.shape.Cone} are two discs, one of them a point for the cone, with all between
 * them; {@link dev.cairn.physics.shape.HalfSpace} is the ground without end. {@link
 * dev.cairn.physics.shape.Moved} places any of them in a body's frame. Levels are surfaces: {@link
 * dev.cairn.physics.shape.TriangleMesh}, and {@link dev.cairn.physics.shape.HeightField}, whose
 * triangles are computed from samples.
 *
 * <pre>
 *   user points ─▶ quickhull ─▶ merge coplanar faces ─▶ integrate mass ─▶ shift by the centre of mass ─▶ Polyhedron
 *   shape frame                                          (exact, in double)                              body frame
 * </pre>
 *
 * <p>Invariants: shapes are immutable and may be shared by any number of bodies and threads. Every
 * tolerance is a fraction of the shape's own extent, so a shape scaled by a power of two is the
 * same shape with other exponents. A degenerate input is a {@link
 * dev.cairn.physics.shape.DegenerateShapeException} that says what is wrong, never a guess.
 *
 * <p>Sources: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The quickhull algorithm for convex hulls",
 * ACM TOMS 22 (1996); B. Mirtich, "Fast and accurate computation of polyhedral mass properties",
 * JGT 1 (1996); D. Eberly, "Polyhedral mass properties" (2002), for the integrals over tetrahedra.
 */
@NullMarked
package dev.cairn.physics.shape;

import org.jspecify.annotations.NullMarked;
