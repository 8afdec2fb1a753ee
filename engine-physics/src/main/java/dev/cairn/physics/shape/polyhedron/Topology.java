package dev.cairn.physics.shape.polyhedron;

import java.util.Arrays;

/**
 * What hangs together with what in a {@link Polyhedron}, from its face loops alone: slots, edges
 * and spokes. Set-up only.
 */
final class Topology {
    final int[] faceBegin;
    final int[] slotVertex, slotEdge;
    final int[] edgeFrom, edgeTo, edgeLeft, edgeRight;
    final int[] spokeBegin, spokeVertex, spokeEdge, spokeFace;
    final int largestFace;

    Topology(int vertices, int[][] loops) {
        int faces = loops.length;
        faceBegin = new int[faces + 1];
        int widest = 0;
        for (int f = 0; f < faces; f++) {
            faceBegin[f + 1] = faceBegin[f] + loops[f].length;
            widest = Math.max(widest, loops[f].length);
        }
        largestFace = widest;
        int slots = faceBegin[faces];
        slotVertex = new int[slots];
        slotEdge = new int[slots];
        for (int f = 0; f < faces; f++) {
            System.arraycopy(loops[f], 0, slotVertex, faceBegin[f], loops[f].length);
        }
        edgeFrom = new int[slots / 2];
        edgeTo = new int[slots / 2];
        edgeLeft = new int[slots / 2];
        edgeRight = new int[slots / 2];
        spokeBegin = new int[vertices + 1];
        spokeVertex = new int[slots];
        spokeEdge = new int[slots];
        spokeFace = new int[slots];
        edges(vertices);
    }

    /**
     * Numbers the edges in order of their end points and lists the spokes of each vertex in order
     * of edges: a mirror image has the same.
     */
    private void edges(int vertices) {
        int slots = slotVertex.length;
        int[] slotFace = new int[slots];
        for (int f = 0; f + 1 < faceBegin.length; f++) {
            Arrays.fill(slotFace, faceBegin[f], faceBegin[f + 1], f);
        }
        long[] keys = new long[slots];
        for (int s = 0; s < slots; s++) {
            int a = slotVertex[s];
            int b = slotVertex[next(s, slotFace[s])];
            keys[s] = ((long) Math.min(a, b) << 34) | ((long) Math.max(a, b) << 20) | s;
            spokeBegin[a + 1]++;
        }
        Arrays.sort(keys);
        for (int i = 0; i < slots; i += 2) {
            int s = (int) (keys[i] & 0xFFFFF);
            int twin = (int) (keys[i + 1] & 0xFFFFF);
            if (keys[i] >>> 20 != keys[i + 1] >>> 20 || slotVertex[s] == slotVertex[twin]) {
                throw new IllegalStateException("face loops do not close: " + slots + " slots");
            }
            // From the lower end to the higher, in a mirror image too.
            boolean up = slotVertex[s] < slotVertex[twin];
            edgeFrom[i / 2] = slotVertex[up ? s : twin];
            edgeTo[i / 2] = slotVertex[up ? twin : s];
            edgeLeft[i / 2] = slotFace[up ? s : twin];
            edgeRight[i / 2] = slotFace[up ? twin : s];
            slotEdge[s] = i / 2;
            slotEdge[twin] = i / 2;
        }
        for (int v = 0; v < vertices; v++) {
            spokeBegin[v + 1] += spokeBegin[v];
        }
        int[] cursor = Arrays.copyOf(spokeBegin, vertices);
        for (long key : keys) {
            int s = (int) (key & 0xFFFFF);
            int spoke = cursor[slotVertex[s]]++;
            spokeVertex[spoke] = slotVertex[next(s, slotFace[s])];
            spokeEdge[spoke] = slotEdge[s];
            spokeFace[spoke] = slotFace[s];
        }
    }

    private int next(int slot, int face) {
        return slot + 1 == faceBegin[face + 1] ? faceBegin[face] : slot + 1;
    }

    /** The vertices that are lowest and highest along x, y and z. */
    static int[] extremes(double[] x, double[] y, double[] z) {
        int[] extremes = new int[6];
        for (int v = 1; v < x.length; v++) {
            extremes[0] = x[v] < x[extremes[0]] ? v : extremes[0];
            extremes[1] = x[v] > x[extremes[1]] ? v : extremes[1];
            extremes[2] = y[v] < y[extremes[2]] ? v : extremes[2];
            extremes[3] = y[v] > y[extremes[3]] ? v : extremes[3];
            extremes[4] = z[v] < z[extremes[4]] ? v : extremes[4];
            extremes[5] = z[v] > z[extremes[5]] ? v : extremes[5];
        }
        return extremes;
    }
}
