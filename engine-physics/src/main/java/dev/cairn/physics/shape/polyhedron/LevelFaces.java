package dev.cairn.physics.shape.polyhedron;

import java.util.Arrays;

/**
 * Which faces of a {@link Polyhedron} lie nearly in the plane of another: as a body sways it rests
 * on corners of all of these. The underside of a stone is often two triangles that are level but
 * for micrometres, and which of them looks more towards the ground changes with each sway.
 */
public final class LevelFaces {
    /** How far below a face's plane the corners of a level face may be, in inner radii. */
    private static final double DROP = 0.5;

    /** Cosine of 0.2 rad, by which the normal of a level face may differ at most. */
    private static final double STEEP = 0.98;

    private final int[] begin, faces;

    LevelFaces(Polyhedron h) {
        int count = h.faceCount();
        begin = new int[count + 1];
        int[] found = new int[count];
        int[] all = new int[0];
        for (int f = 0; f < count; f++) {
            int n = flood(h, f, found);
            begin[f + 1] = begin[f] + n;
            if (n > 0) {
                all = Arrays.copyOf(all, begin[f + 1]);
                System.arraycopy(found, 0, all, begin[f], n);
            }
        }
        faces = all;
    }

    /** Whether a face has any. */
    public boolean exist(int face) {
        return begin[face] < begin[face + 1];
    }

    /** The first place in the list of a face; it ends before {@code begin(face + 1)}. */
    public int begin(int face) {
        return begin[face];
    }

    /** The face at a place. */
    public int face(int at) {
        return faces[at];
    }

    /** Finds the faces that are level with one, from neighbour to neighbour. */
    private static int flood(Polyhedron h, int face, int[] found) {
        int count = level(h, face, face, found, 0);
        for (int i = 0; i < count; i++) {
            count = level(h, face, found[i], found, count);
        }
        return count;
    }

    /** Adds the neighbours of a face that are level with the first one. */
    private static int level(Polyhedron h, int first, int of, int[] found, int before) {
        int count = before;
        for (int slot = h.faceBegin(of); slot < h.faceBegin(of + 1); slot++) {
            int edge = h.slotEdge(slot);
            int other = h.edgeFace(edge, h.edgeFace(edge, true) != of);
            boolean known = other == first;
            for (int i = 0; i < count && !known; i++) {
                known = found[i] == other;
            }
            if (!known && isLevel(h, first, other)) {
                found[count++] = other;
            }
        }
        return count;
    }

    private static boolean isLevel(Polyhedron h, int face, int other) {
        double nx = h.normalX(face);
        double ny = h.normalY(face);
        double nz = h.normalZ(face);
        double cosine = nx * h.normalX(other) + ny * h.normalY(other) + nz * h.normalZ(other);
        double least = h.offset(face) - DROP * h.innerRadius();
        boolean level = cosine > STEEP;
        for (int slot = h.faceBegin(other); level && slot < h.faceBegin(other + 1); slot++) {
            int v = h.slotVertex(slot);
            level = nx * h.vertexX(v) + ny * h.vertexY(v) + nz * h.vertexZ(v) >= least;
        }
        return level;
    }
}
