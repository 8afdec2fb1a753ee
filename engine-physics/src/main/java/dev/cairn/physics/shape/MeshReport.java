package dev.cairn.physics.shape;

/**
 * What was found in the triangles of a {@link TriangleMesh} when it was made. None of it is an
 * error: a mesh with holes or flipped triangles works, and collides as it is.
 *
 * @param triangles how many it has
 * @param degenerate numbers of the triangles that were left out, since they have no area: two
 *     corners are at one place, or all are on a line; ascending
 * @param weldedVertices how many vertices were at the place of another one, and became that one
 * @param openEdges sides of one triangle only: a closed surface has none. Where a side ends in the
 *     middle of another one (a T-joint) both count
 * @param crowdedEdges sides that more than two triangles share
 * @param flippedEdges sides whose two triangles do not agree on which side is out: one of them is
 *     wound the wrong way
 */
public record MeshReport(
        int triangles,
        java.util.List<Integer> degenerate,
        int weldedVertices,
        int openEdges,
        int crowdedEdges,
        int flippedEdges) {
    /**
     * Whether the surface has an inside: no open, crowded or flipped edges.
     *
     * @return true if so
     */
    public boolean isClosed() {
        return openEdges == 0 && crowdedEdges == 0 && flippedEdges == 0;
    }
}
