package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.LevelFaces;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The corner with which a polyhedron stands on flat ground beside those of the face that looks at
 * it. A body rests on three corners; where these are of one triangle, and the next triangle is
 * level with it but for micrometres, a fourth corner bears as the body sways, and which triangle
 * looks more at the ground changes with each sway. A contact with one of them alone would drop a
 * corner that bears, and the body would tip over the edge for a tick.
 *
 * <p>It is the corner of {@link LevelFaces} that is nearest to the ground. A triangle takes it if
 * it is hardly farther than the triangle's own, a face with more corners if it is not farther.
 */
public final class LevelCorner {
    /** How much farther it may be than all corners of a triangle, in inner radii. */
    private static final double FARTHER = 0.1;

    /** How much nearer that of the last tick counts, in inner radii. */
    private static final double STAYS = 0.02;

    /** Its vertex. */
    public int vertex;

    /** The face that it belongs to, and how far it is from the ground, m. */
    int face;

    double separation;

    /** The ground's unit normal towards the polyhedron and its offset, in the latter's frame, m. */
    private double nx, ny, nz, offset;

    private final IncidentPlane plane = new IncidentPlane();

    /** Before any search. */
    public LevelCorner() {}

    /**
     * Looks for it on one of two polyhedra.
     *
     * @param ofB whether it is B
     * @param of its face
     * @param ground the other's face, at which it looks
     * @param last names of the points of the last tick, 0 for none
     * @return whether there is one
     */
    boolean find(Pair p, boolean ofB, int of, int ground, int last) {
        Polyhedron h = ofB ? p.b : p.a;
        if (!h.level.exist(of)) {
            return false;
        }
        plane.forget();
        plane.set(p, ofB, ofB ? p.a : p.b, ground);
        nx = plane.x;
        ny = plane.y;
        nz = plane.z;
        offset = plane.offset;
        return find(h, of, p.inner, ofB ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A, last);
    }

    /**
     * Looks for it.
     *
     * @param of the face that looks at the ground
     * @param x the ground's unit normal towards the polyhedron, in its frame
     * @param offset of the ground along that normal, m
     * @param inner smaller inner radius of the pair, m
     * @param kind of the names of the polyhedron's vertices
     * @param last names of the points of the last tick, 0 for none
     * @return whether there is one
     */
    public boolean find(
            Polyhedron h,
            int of,
            double x,
            double y,
            double z,
            double offset,
            double inner,
            int kind,
            int last) {
        nx = x;
        ny = y;
        nz = z;
        this.offset = offset;
        return h.level.exist(of) && find(h, of, inner, kind, last);
    }

    private boolean find(Polyhedron h, int of, double inner, int kind, int last) {
        double highest = -Double.MAX_VALUE;
        for (int slot = h.faceBegin(of); slot < h.faceBegin(of + 1); slot++) {
            highest = Math.max(highest, above(h, h.slotVertex(slot)));
        }
        boolean triangle = h.faceBegin(of + 1) - h.faceBegin(of) == 3;
        double least = triangle ? highest + FARTHER * inner : highest;
        vertex = -1;
        LevelFaces level = h.level;
        for (int i = level.begin(of); i < level.begin(of + 1); i++) {
            int f = level.face(i);
            for (int slot = h.faceBegin(f); slot < h.faceBegin(f + 1); slot++) {
                int v = h.slotVertex(slot);
                boolean old = last != 0 && FeatureIds.contains(last, kind | v);
                double s = above(h, v) - (old ? STAYS * inner : 0);
                boolean nearer = s < least || (s == least && (vertex < 0 || v < vertex));
                if (nearer && !isCorner(h, of, v)) {
                    least = s;
                    vertex = v;
                }
            }
        }
        if (vertex < 0) {
            return false;
        }
        separation = above(h, vertex);
        chooseFace(h, of);
        return true;
    }

    /** Of the level faces that have the vertex, the one that looks most at the ground. */
    private void chooseFace(Polyhedron h, int of) {
        double most = 2;
        for (int i = h.level.begin(of); i < h.level.begin(of + 1); i++) {
            int f = h.level.face(i);
            double dot = nx * h.normalX(f) + ny * h.normalY(f) + nz * h.normalZ(f);
            if ((dot < most || (dot == most && f < face)) && isCorner(h, f, vertex)) {
                most = dot;
                face = f;
            }
        }
    }

    /** How far a vertex is from the ground, m. */
    private double above(Polyhedron h, int v) {
        return nx * h.vertexX(v) + ny * h.vertexY(v) + nz * h.vertexZ(v) - offset;
    }

    /** Whether a vertex is a corner of a face. */
    public static boolean isCorner(Polyhedron h, int face, int v) {
        int slot = h.faceBegin(face);
        while (slot < h.faceBegin(face + 1) && h.slotVertex(slot) != v) {
            slot++;
        }
        return slot < h.faceBegin(face + 1);
    }
}
