package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_FLOAT;
import static org.lwjgl.opengl.GL11.GL_TRIANGLES;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_INT;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STATIC_DRAW;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.glBufferData;
import static org.lwjgl.opengl.GL15.glDeleteBuffers;
import static org.lwjgl.opengl.GL15.glGenBuffers;
import static org.lwjgl.opengl.GL20.glEnableVertexAttribArray;
import static org.lwjgl.opengl.GL20.glVertexAttribPointer;
import static org.lwjgl.opengl.GL30.glBindVertexArray;
import static org.lwjgl.opengl.GL30.glDeleteVertexArrays;
import static org.lwjgl.opengl.GL30.glGenVertexArrays;
import static org.lwjgl.opengl.GL31.glDrawElementsInstanced;
import static org.lwjgl.opengl.GL33.glVertexAttribDivisor;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.shape.Shape;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.lwjgl.system.MemoryUtil;

import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The visible entities in graphics memory. Two buffers: the <em>motion</em>, 16 floats per
 * instance, written once per snapshot; the <em>look</em>, 9 floats, written when the list of models
 * changes. Instances are sorted by batch (one mesh and one texture).
 */
final class Instances implements AutoCloseable {
    /** Grid of the anchor: a float keeps a hundredth of a millimetre over this distance. */
    private static final double ANCHOR_GRID = 64;

    private static final int MOTION_FLOATS = 16;
    private static final int LOOK_FLOATS = 9;

    /**
     * Drawn where {@code Visual.model} is nothing that can be drawn, so that the mistake is seen.
     */
    private static final Model PLACEHOLDER = Model.of(Meshes.CUBE).scale(0.5).color(0xFF00FF);

    /** Instances that one call draws. */
    static final class Batch {
        private final Mesh mesh;
        private final Texture texture;
        private int count;
        private int first;
        private int vertexArray;
        private @Nullable GpuMesh gpuMesh;
        private @Nullable GpuTexture gpuTexture;

        private Batch(Mesh mesh, Texture texture) {
            this.mesh = mesh;
            this.texture = texture;
        }

        double tileMetres() {
            return texture.tileMetres();
        }

        void bindTexture() {
            if (gpuTexture != null) {
                gpuTexture.bind();
            }
        }

        void draw() {
            if (gpuMesh != null) {
                glBindVertexArray(vertexArray);
                glDrawElementsInstanced(
                        GL_TRIANGLES, gpuMesh.indexCount(), GL_UNSIGNED_INT, 0, count);
            }
        }
    }

    private record Key(Mesh mesh, Texture texture) {}

    private final Map<Mesh, GpuMesh> meshes = new HashMap<>();
    private final Map<Texture, GpuTexture> textures = new HashMap<>();
    private final int motionBuffer = glGenBuffers();
    private final int lookBuffer = glGenBuffers();
    private final Vector3d anchor = new Vector3d();
    private final Vector3d castersMin = new Vector3d();
    private final Vector3d castersMax = new Vector3d();

    private List<Batch> batches = List.of();
    private @Nullable Object[] layout = new Object[0];
    private int layoutSize;
    private int[] slotOfRow = new int[0];
    private double[] radiusOfRow = new double[0];
    private FloatBuffer staging = MemoryUtil.memAllocFloat(64 * MOTION_FLOATS);

    private @Nullable PoseSnapshot uploaded;
    private long uploadedTick;
    private long uploadedNanos;
    private int uploads;

    /**
     * Brings the buffers up to a snapshot.
     *
     * @param snapshot what to draw
     * @param eye where the camera is, world
     * @param casterLimit models larger than this do not count for {@link #castersMin}, m
     */
    void update(PoseSnapshot snapshot, Vector3d eye, double casterLimit) {
        boolean moved = placeAnchor(eye);
        boolean changed = layoutChanged(snapshot);
        if (changed) {
            arrange(snapshot);
        }
        if (changed
                || moved
                || uploaded != snapshot
                || uploadedTick != snapshot.tick()
                || uploadedNanos != snapshot.publishedNanos()) {
            upload(snapshot, casterLimit);
            uploaded = snapshot;
            uploadedTick = snapshot.tick();
            uploadedNanos = snapshot.publishedNanos();
        }
    }

    List<Batch> batches() {
        return batches;
    }

    /** The world point that all positions in the buffers are relative to. */
    Vector3d anchor() {
        return anchor;
    }

    /**
     * Lower corner of a box around all small models, anchored; above {@link #castersMax} if there
     * are none.
     */
    Vector3d castersMin() {
        return castersMin;
    }

    /** Upper corner of a box around all small models, anchored. */
    Vector3d castersMax() {
        return castersMax;
    }

    /** How often motion was written, for tests. */
    int uploads() {
        return uploads;
    }

    private boolean placeAnchor(Vector3d eye) {
        double x = ANCHOR_GRID * Math.rint(eye.x / ANCHOR_GRID);
        double y = ANCHOR_GRID * Math.rint(eye.y / ANCHOR_GRID);
        double z = ANCHOR_GRID * Math.rint(eye.z / ANCHOR_GRID);
        boolean moved = x != anchor.x || y != anchor.y || z != anchor.z;
        anchor.set(x, y, z);
        return moved;
    }

    @SuppressWarnings(
            "ReferenceEquality") // The same object means the same look; equal ones are drawn alike
    // anyway.
    private boolean layoutChanged(PoseSnapshot snapshot) {
        int size = snapshot.size();
        if (size != layoutSize) {
            return true;
        }
        for (int row = 0; row < size; row++) {
            if (snapshot.model(row) != layout[row]) {
                return true;
            }
        }
        return false;
    }

    private void arrange(PoseSnapshot snapshot) {
        int size = snapshot.size();
        layout = new Object[size];
        layoutSize = size;
        slotOfRow = new int[size];
        radiusOfRow = new double[size];
        Model[] models = new Model[size];
        Batch[] batchOfRow = new Batch[size];
        Map<Key, Batch> found = new LinkedHashMap<>();
        for (int row = 0; row < size; row++) {
            Object look = snapshot.model(row);
            layout[row] = look;
            Model model = modelOf(look);
            models[row] = model;
            radiusOfRow[row] = model.radius();
            batchOfRow[row] =
                    found.computeIfAbsent(
                            new Key(model.mesh(), model.texture()),
                            key -> new Batch(key.mesh(), key.texture()));
            batchOfRow[row].count++;
        }
        int next = 0;
        for (Batch batch : found.values()) {
            batch.first = next;
            next += batch.count;
            batch.count = 0;
        }
        FloatBuffer look = MemoryUtil.memAllocFloat(Math.max(1, size) * LOOK_FLOATS);
        try {
            for (int row = 0; row < size; row++) {
                Batch batch = batchOfRow[row];
                int slot = batch.first + batch.count++;
                slotOfRow[row] = slot;
                putLook(look, slot * LOOK_FLOATS, models[row]);
            }
            glBindBuffer(GL_ARRAY_BUFFER, lookBuffer);
            glBufferData(GL_ARRAY_BUFFER, look, GL_STATIC_DRAW);
        } finally {
            MemoryUtil.memFree(look);
        }
        replaceBatches(List.copyOf(found.values()));
    }

    private static Model modelOf(Object look) {
        return switch (look) {
            case Model model -> model;
            case Mesh mesh -> Model.of(mesh);
            case Shape shape -> Model.of(shape);
            default -> PLACEHOLDER;
        };
    }

    private static void putLook(FloatBuffer buffer, int at, Model model) {
        buffer.put(at, (float) model.scaleX());
        buffer.put(at + 1, (float) model.scaleY());
        buffer.put(at + 2, (float) model.scaleZ());
        buffer.put(at + 3, (float) model.originX());
        buffer.put(at + 4, (float) model.originY());
        buffer.put(at + 5, (float) model.originZ());
        buffer.put(at + 6, (float) Srgb.linear(model.rgb() >> 16));
        buffer.put(at + 7, (float) Srgb.linear(model.rgb() >> 8));
        buffer.put(at + 8, (float) Srgb.linear(model.rgb()));
    }

    private void replaceBatches(List<Batch> wanted) {
        for (Batch batch : batches) {
            glDeleteVertexArrays(batch.vertexArray);
        }
        batches = wanted;
        for (Batch batch : wanted) {
            GpuMesh mesh = meshes.computeIfAbsent(batch.mesh, GpuMesh::new);
            batch.gpuMesh = mesh;
            batch.gpuTexture = textures.computeIfAbsent(batch.texture, GpuTexture::new);
            batch.vertexArray = glGenVertexArrays();
            glBindVertexArray(batch.vertexArray);
            glBindBuffer(GL_ARRAY_BUFFER, mesh.vertexBuffer());
            attribute(0, 3, Mesh.FLOATS_PER_VERTEX, 0, 0);
            attribute(1, 3, Mesh.FLOATS_PER_VERTEX, 3, 0);
            attribute(2, 2, Mesh.FLOATS_PER_VERTEX, 6, 0);
            glBindBuffer(GL_ARRAY_BUFFER, motionBuffer);
            for (int i = 0; i < 4; i++) {
                attribute(3 + i, 4, MOTION_FLOATS, batch.first * (long) MOTION_FLOATS + 4L * i, 1);
            }
            glBindBuffer(GL_ARRAY_BUFFER, lookBuffer);
            for (int i = 0; i < 3; i++) {
                attribute(7 + i, 3, LOOK_FLOATS, batch.first * (long) LOOK_FLOATS + 3L * i, 1);
            }
            mesh.bindIndices();
        }
        glBindVertexArray(0);
        dropUnused(meshes, wanted.stream().map(batch -> batch.mesh).collect(Collectors.toSet()));
        dropUnused(
                textures, wanted.stream().map(batch -> batch.texture).collect(Collectors.toSet()));
    }

    private static void attribute(
            int index, int size, int strideFloats, long offsetFloats, int divisor) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(
                index,
                size,
                GL_FLOAT,
                false,
                strideFloats * Float.BYTES,
                offsetFloats * Float.BYTES);
        glVertexAttribDivisor(index, divisor);
    }

    private static <K, V extends AutoCloseable> void dropUnused(Map<K, V> all, Set<K> used) {
        for (Iterator<Map.Entry<K, V>> each = all.entrySet().iterator(); each.hasNext(); ) {
            Map.Entry<K, V> entry = each.next();
            if (!used.contains(entry.getKey())) {
                closeQuietly(entry.getValue());
                each.remove();
            }
        }
    }

    private static void closeQuietly(AutoCloseable resource) {
        try {
            resource.close();
        } catch (Exception e) {
            throw new IllegalStateException("closing " + resource + " failed", e);
        }
    }

    private void upload(PoseSnapshot snapshot, double casterLimit) {
        int size = snapshot.size();
        int floats = size * MOTION_FLOATS;
        if (staging.capacity() < floats) {
            MemoryUtil.memFree(staging);
            staging = MemoryUtil.memAllocFloat(Math.max(floats, 2 * staging.capacity()));
        }
        castersMin.set(Double.POSITIVE_INFINITY);
        castersMax.set(Double.NEGATIVE_INFINITY);
        double[] previous = snapshot.previous();
        double[] current = snapshot.current();
        for (int row = 0; row < size; row++) {
            int from = row * PoseSnapshot.STRIDE;
            int to = slotOfRow[row] * MOTION_FLOATS;
            putPose(previous, from, to);
            putPose(current, from, to + 8);
            double radius = radiusOfRow[row];
            if (radius <= casterLimit) {
                double x = current[from] - anchor.x;
                double y = current[from + 1] - anchor.y;
                double z = current[from + 2] - anchor.z;
                castersMin.set(
                        Math.min(castersMin.x, x - radius),
                        Math.min(castersMin.y, y - radius),
                        Math.min(castersMin.z, z - radius));
                castersMax.set(
                        Math.max(castersMax.x, x + radius),
                        Math.max(castersMax.y, y + radius),
                        Math.max(castersMax.z, z + radius));
            }
        }
        staging.position(0).limit(floats);
        glBindBuffer(GL_ARRAY_BUFFER, motionBuffer);
        // A whole new store each time: the driver need not wait for frames that still read the old
        // one.
        glBufferData(GL_ARRAY_BUFFER, staging, GL_STREAM_DRAW);
        staging.clear();
        uploads++;
    }

    private void putPose(double[] poses, int from, int to) {
        staging.put(to, (float) (poses[from] - anchor.x));
        staging.put(to + 1, (float) (poses[from + 1] - anchor.y));
        staging.put(to + 2, (float) (poses[from + 2] - anchor.z));
        staging.put(to + 3, 0f);
        staging.put(to + 4, (float) poses[from + 3]);
        staging.put(to + 5, (float) poses[from + 4]);
        staging.put(to + 6, (float) poses[from + 5]);
        staging.put(to + 7, (float) poses[from + 6]);
    }

    @Override
    public void close() {
        replaceBatches(List.of());
        glDeleteBuffers(motionBuffer);
        glDeleteBuffers(lookBuffer);
        MemoryUtil.memFree(staging);
    }
}
