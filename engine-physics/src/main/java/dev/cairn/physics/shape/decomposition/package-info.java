/**
 * Approximate convex decomposition: a few convex parts that are nearly a mesh.
 *
 * <p>Problem: what moves is convex, or several convex shapes on one body. A mug, a horseshoe or a
 * jack comes as triangles; its parts have to be found, few of them, with an error that is known.
 *
 * <pre>
 *   mesh ─▶ solid ─▶ cut the part with the largest error ─▶ merge what may be one part ─▶ measure
 *           (tree)    (a plane, until all are within)        (until none may)              (bounds)
 * </pre>
 *
 * <p><b>The error.</b> For a part H of a solid M it is max over x in H of dist(x, M), in metres:
 * how far something can be pushed off by what is not there. It is measured in all of H, not on its
 * surface alone, so a hollow that is open or closed counts as well, by branch and bound with the
 * signed distance ({@link dev.cairn.physics.shape.decomposition.HullGap}); the result has the
 * largest distance found and a bound that none exceeds. The other way, M is covered: each part is a
 * hull of points among which are all extreme points of its piece, less those that are nearer to it
 * than 1/8 of the allowed error, and the largest of these distances is told as well.
 *
 * <p><b>Pieces without caps.</b> A piece is the solid in a convex cell. Its extreme points are
 * corners of the surface that the cell leaves, or corners of the cell that are inside ({@link
 * dev.cairn.physics.shape.decomposition.Piece}). So a cut needs no closing of the mesh, holes and
 * overlaps do no harm, and planes may go through faces and edges. Inside is where rays count more
 * crossings one way than the other.
 *
 * <p><b>Cuts.</b> The part with the largest error is cut by the plane that leaves least volume in
 * the two hulls, of those at faces and hollow edges deep below its hull, across the axes, and some
 * drawn ones ({@link dev.cairn.physics.shape.decomposition.Cuts}). Twice as many parts as are
 * wanted may be made; then pairs are merged that add least volume, first until there are few
 * enough, and then as long as the error stays allowed.
 *
 * <p>Invariants: the same bits for any number of workers, for each plane is judged alone and ties
 * go to the first; all tolerances are shares of the size; nothing is capped silently: what exceeds
 * the allowed error is told by the result.
 *
 * <p>Sources: J.-M. Lien, N. M. Amato, "Approximate convex decomposition of polyhedra", SPM (2007),
 * for cutting at the deepest notch; K. Mamou, F. Ghorbel, "A simple and efficient approach for 3D
 * mesh approximate convex decomposition", ICIP (2009), for merging; X. Wei, M. Liu, Z. Ling, H. Su,
 * "Approximate convex decomposition for 3D meshes with collision-aware concavity and tree search",
 * ACM TOG 41 (2022), for cuts of the mesh itself and an error that counts the inside.
 */
@NullMarked
package dev.cairn.physics.shape.decomposition;

import org.jspecify.annotations.NullMarked;
