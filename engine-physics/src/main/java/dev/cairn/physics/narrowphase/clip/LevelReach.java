package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.LevelFaces;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import java.util.Arrays;

/**
 * The faces with which a polyhedron touches a plane beside the one that looks at it: those level
 * with that one that come as near to the plane as it does, see {@link LevelFaces}. A contact with
 * one of two triangles that are level but for micrometres would leave out a corner that bears.
 */
public final class LevelReach {
    /** How much farther than all corners of the face a corner may be, in inner radii. */
    private static final double FARTHER = 0.1;

    /** How many faces there are, and which. */
    int count;

    int[] face = new int[8];

    /** Up to where their corners count, m from the plane. */
    double height;

    /** The plane, in the polyhedron's frame. */
    private double nx, ny, nz, offset;

    private Polyhedron h;
    private int of;

    /** Before any search. */
    public LevelReach() {
        h = Pair.NONE.a;
    }

    /**
     * Looks for them on one of two polyhedra.
     *
     * @param ofB whether it is B
     * @param of its face
     * @param ground the other's face, at which it looks
     * @return whether there are any
     */
    boolean find(Pair p, boolean ofB, int of, int ground) {
        Polyhedron own = ofB ? p.b : p.a;
        if (!own.level.exist(of)) {
            count = 0;
            return false;
        }
        Polyhedron g = ofB ? p.a : p.b;
        double x = g.normalX(ground);
        double y = g.normalY(ground);
        double z = g.normalZ(ground);
        double o = g.offset(ground);
        if (ofB) {
            // v of B is at R v + d
            return find(
                    own,
                    of,
                    p.r00 * x + p.r10 * y + p.r20 * z,
                    p.r01 * x + p.r11 * y + p.r21 * z,
                    p.r02 * x + p.r12 * y + p.r22 * z,
                    o - (x * p.dx + y * p.dy + z * p.dz),
                    p.inner);
        }
        // v of A is at R^T (v - d)
        double ax = p.r00 * x + p.r01 * y + p.r02 * z;
        double ay = p.r10 * x + p.r11 * y + p.r12 * z;
        double az = p.r20 * x + p.r21 * y + p.r22 * z;
        return find(own, of, ax, ay, az, o + ax * p.dx + ay * p.dy + az * p.dz, p.inner);
    }

    /**
     * Looks for them.
     *
     * @param of the face that looks at the plane
     * @param x the plane's unit normal towards the polyhedron, in its frame
     * @param offset of the plane along that normal, m
     * @param inner smaller inner radius of the pair, m
     * @return whether there are any
     */
    public boolean find(
            Polyhedron polyhedron,
            int of,
            double x,
            double y,
            double z,
            double offset,
            double inner) {
        h = polyhedron;
        this.of = of;
        nx = x;
        ny = y;
        nz = z;
        this.offset = offset;
        count = 0;
        LevelFaces level = h.level;
        if (!level.exist(of)) {
            return false;
        }
        height = -Double.MAX_VALUE;
        for (int slot = h.faceBegin(of); slot < h.faceBegin(of + 1); slot++) {
            height = Math.max(height, above(h.slotVertex(slot)));
        }
        height += FARTHER * inner;
        for (int i = level.begin(of); i < level.begin(of + 1); i++) {
            if (reaches(level.face(i))) {
                if (count == face.length) {
                    face = Arrays.copyOf(face, 2 * count);
                }
                face[count++] = level.face(i);
            }
        }
        return count > 0;
    }

    /** Whether a face has a corner in reach. */
    private boolean reaches(int f) {
        for (int slot = h.faceBegin(f); slot < h.faceBegin(f + 1); slot++) {
            if (above(h.slotVertex(slot)) <= height) {
                return true;
            }
        }
        return false;
    }

    /** How far a vertex is from the plane, m. */
    private double above(int v) {
        return nx * h.vertexX(v) + ny * h.vertexY(v) + nz * h.vertexZ(v) - offset;
    }

    /** Whether a vertex is a corner of the face, or one in reach of the others. */
    public boolean has(int v) {
        boolean has = isCorner(of, v);
        if (!has && count > 0 && above(v) <= height) {
            for (int i = 0; i < count && !has; i++) {
                has = isCorner(face[i], v);
            }
        }
        return has;
    }

    private boolean isCorner(int f, int v) {
        int slot = h.faceBegin(f);
        while (slot < h.faceBegin(f + 1) && h.slotVertex(slot) != v) {
            slot++;
        }
        return slot < h.faceBegin(f + 1);
    }

    /** Adds the corners in reach of a polyhedron in the clipper's own frame. */
    void add(Clipper out, int kind) {
        for (int i = 0; i < count; i++) {
            for (int slot = h.faceBegin(face[i]); slot < h.faceBegin(face[i] + 1); slot++) {
                int v = h.slotVertex(slot);
                double apart = above(v);
                if (apart <= height && !out.has(kind | v, out.count)) {
                    out.add(h.vertexX(v), h.vertexY(v), h.vertexZ(v), apart, kind | v);
                }
            }
        }
    }
}
