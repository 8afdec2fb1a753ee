package dev.cairn.benchmarks.peer;

import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.TriangleMesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A surface as the other engines take it: floats and corners. All get the same triangles, also
 * where an engine has a height field of its own.
 *
 * @param xyz corners, about the origin of the body, m; that is where peers put the body, too
 * @param indices three of each triangle, counter-clockwise from outside
 */
@SuppressWarnings("ArrayRecordComponent") // handed on at once, never compared
record Triangles(float[] xyz, int[] indices) {
    /** Bytes of three floats, or of three indices. */
    static final int STRIDE = 12;

    /** Reads a mesh or a height field. */
    static Triangles of(Shape surface) {
        TriangleMesh mesh =
                switch (surface) {
                    case TriangleMesh triangles -> triangles;
                    case HeightField field -> field.toMesh();
                    default -> throw new IllegalArgumentException("no surface: " + surface);
                };
        double[] from = mesh.vertices();
        float[] xyz = new float[from.length];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = (float) from[i];
        }
        return new Triangles(xyz, mesh.indices());
    }

    /** The number of corners. */
    int corners() {
        return xyz.length / 3;
    }

    /** The number of triangles. */
    int count() {
        return indices.length / 3;
    }

    /** The corners in memory that native code reads. */
    ByteBuffer xyzBuffer() {
        ByteBuffer to = ByteBuffer.allocateDirect(4 * xyz.length).order(ByteOrder.nativeOrder());
        to.asFloatBuffer().put(xyz);
        return to;
    }

    /** The indices in memory that native code reads. */
    ByteBuffer indexBuffer() {
        ByteBuffer to =
                ByteBuffer.allocateDirect(4 * indices.length).order(ByteOrder.nativeOrder());
        to.asIntBuffer().put(indices);
        return to;
    }
}
