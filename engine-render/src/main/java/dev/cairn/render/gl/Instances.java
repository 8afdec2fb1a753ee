package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL13.GL_TEXTURE2;
import static org.lwjgl.opengl.GL13.GL_TEXTURE3;
import static org.lwjgl.opengl.GL15.GL_STATIC_DRAW;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.shape.Shape;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.render.mesh.Texture;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.lwjgl.system.MemoryUtil;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The visible entities in graphics memory, as two lists that the vertex shader reads by number. The
 * <em>motion</em> has four texels per row of the snapshot and is written once per snapshot. The
 * <em>look</em> has three texels per <em>slot</em> and is written when the list of models changes;
 * a slot is one model of one row, and slots are sorted by batch.
 */
final class Instances implements AutoCloseable {
    /** Grid of the anchor: a float keeps a hundredth of a millimetre over this distance. */
    private static final double ANCHOR_GRID = 64;

    private static final int MOTION_FLOATS = 16;
    private static final int LOOK_FLOATS = 12;

    /** Half the side of a floor from which on its end is not what the picture is about, m. */
    private static final double WIDE = 15;

    /**
     * Drawn where {@code Visual.model} is nothing that can be drawn, so that the mistake is seen.
     */
    private static final List<Model> PLACEHOLDER = List.of(Model.placeholder().scale(0.5));

    private final Map<Mesh, GpuMesh> meshes = new HashMap<>();
    private final Map<Texture, GpuTexture> textures = new HashMap<>();
    private final BufferTexture motion = new BufferTexture("the poses", GL_TEXTURE2);
    private final BufferTexture look = new BufferTexture("the looks", GL_TEXTURE3);
    private final Vector3d anchor = new Vector3d();
    private final Vector3d castersMin = new Vector3d();
    private final Vector3d castersMax = new Vector3d();

    private List<Batch> batches = List.of();
    private @Nullable Object[] layout = new Object[0];
    private int layoutSize;
    private int arrangements;

    /** Per slot: its row, and how far its model reaches from the entity's position. */
    private int[] rowOfSlot = new int[0];

    private double[] reachOfSlot = new double[0];

    /** Per row, four numbers: a sphere around the way of the entity's position in this tick. */
    private double[] wayOfRow = new double[0];

    private FloatBuffer staging = MemoryUtil.memAllocFloat(64 * MOTION_FLOATS);

    /** By address, since LWJGL wraps the buffer for each upload. */
    private long stagingAddress = MemoryUtil.memAddress(staging);

    private @Nullable PoseSnapshot uploaded;
    private long uploadedTick;
    private long uploadedNanos;
    private int uploads;
    private final Tints tints = new Tints();
    private Tints.Kind tinted = Tints.Kind.NONE;

    /**
     * Brings the lists up to a snapshot.
     *
     * @param snapshot what to draw
     * @param eye where the camera is, world
     * @param casterLimit models larger than this do not count for {@link #castersMin}, m
     * @param tint what the colours of bodies tell
     */
    void update(PoseSnapshot snapshot, Vector3d eye, double casterLimit, Tints.Kind tint) {
        boolean moved = placeAnchor(eye);
        boolean fresh =
                uploaded != snapshot
                        || uploadedTick != snapshot.tick()
                        || uploadedNanos != snapshot.publishedNanos();
        if (fresh && layoutChanged(snapshot)) {
            arrange(snapshot);
        }
        if (fresh || moved || tint != tinted) {
            tinted = tint;
            upload(snapshot, casterLimit);
            uploaded = snapshot;
            uploadedTick = snapshot.tick();
            uploadedNanos = snapshot.publishedNanos();
        }
    }

    /** Makes the lists readable for shaders. */
    void bind() {
        motion.bind();
        look.bind();
    }

    int batchCount() {
        return batches.size();
    }

    Batch batch(int b) {
        return batches.get(b);
    }

    /** How many slots there are. */
    int slots() {
        return rowOfSlot.length;
    }

    /** How often slots were given out anew. */
    int arrangements() {
        return arrangements;
    }

    /** The world point that all positions in the lists are relative to. */
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

    /** How often motion was written. */
    int uploads() {
        return uploads;
    }

    /**
     * Writes the slots of a range that touch a frustum, from the range's first place on.
     *
     * @return how many
     */
    int visible(Frustum frustum, int first, int count, IntBuffer into) {
        int written = first;
        for (int slot = first; slot < first + count; slot++) {
            int at = 4 * rowOfSlot[slot];
            if (frustum.touches(
                    wayOfRow[at],
                    wayOfRow[at + 1],
                    wayOfRow[at + 2],
                    wayOfRow[at + 3] + reachOfSlot[slot])) {
                into.put(written++, slot);
            }
        }
        return written - first;
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
        wayOfRow = new double[4 * size];
        List<Model> parts = new ArrayList<>();
        List<Integer> rows = new ArrayList<>();
        List<Batch> owners = new ArrayList<>();
        Map<Batch.Key, Batch> found = new LinkedHashMap<>();
        for (int row = 0; row < size; row++) {
            layout[row] = snapshot.model(row);
            for (Model part : modelsOf(layout[row])) {
                Batch batch =
                        found.computeIfAbsent(
                                new Batch.Key(part.mesh(), part.texture()),
                                key -> new Batch(key.mesh(), key.texture()));
                batch.count++;
                parts.add(part);
                rows.add(row);
                owners.add(batch);
            }
        }
        int next = 0;
        for (Batch batch : found.values()) {
            batch.first = next;
            next += batch.count;
            batch.count = 0;
        }
        rowOfSlot = new int[next];
        reachOfSlot = new double[next];
        FloatBuffer looks = MemoryUtil.memAllocFloat(Math.max(1, next) * LOOK_FLOATS);
        try {
            for (int i = 0; i < next; i++) {
                Batch batch = owners.get(i);
                int slot = batch.first + batch.count++;
                rowOfSlot[slot] = rows.get(i);
                reachOfSlot[slot] = parts.get(i).radius();
                putLook(looks, slot * LOOK_FLOATS, parts.get(i), rows.get(i));
            }
            look.write(MemoryUtil.memAddress(looks), looks.capacity(), GL_STATIC_DRAW);
        } finally {
            MemoryUtil.memFree(looks);
        }
        replaceBatches(List.copyOf(found.values()));
        arrangements++;
    }

    private static List<Model> modelsOf(@Nullable Object visual) {
        return switch (visual) {
            case Model model -> List.of(model);
            case ModelGroup group -> group.parts();
            case Mesh mesh -> List.of(Model.of(mesh));
            case Shape shape -> List.of(Model.of(shape));
            case null, default -> PLACEHOLDER;
        };
    }

    /** Three texels: scale and row, origin, colour. A float holds every row up to 2^24. */
    private static void putLook(FloatBuffer buffer, int at, Model model, int row) {
        buffer.put(at, (float) model.scaleX());
        buffer.put(at + 1, (float) model.scaleY());
        buffer.put(at + 2, (float) model.scaleZ());
        buffer.put(at + 3, row);
        buffer.put(at + 4, (float) model.originX());
        buffer.put(at + 5, (float) model.originY());
        buffer.put(at + 6, (float) model.originZ());
        buffer.put(at + 7, (float) fadeMetres(model));
        buffer.put(at + 8, (float) Srgb.linear(model.rgb() >> 16));
        buffer.put(at + 9, (float) Srgb.linear(model.rgb() >> 8));
        buffer.put(at + 10, (float) Srgb.linear(model.rgb()));
        buffer.put(at + 11, 0f);
    }

    /** The radius at which a wide flat floor has dissolved, m; 0 for what is none. */
    @SuppressWarnings("ReferenceEquality") // These two meshes are shared by all floors.
    private static double fadeMetres(Model model) {
        boolean isFlat =
                model.mesh() == Meshes.GROUND
                        || (model.mesh() == Meshes.CUBE
                                && model.scaleY() < 0.2 * Math.min(model.scaleX(), model.scaleZ()));
        double half =
                model.mesh().radius() / Math.sqrt(3) * Math.min(model.scaleX(), model.scaleZ());
        return isFlat && model.texture().tileMetres() > 0 && half >= WIDE ? half : 0;
    }

    private void replaceBatches(List<Batch> wanted) {
        batches = wanted;
        for (Batch batch : wanted) {
            batch.gpuMesh = meshes.computeIfAbsent(batch.mesh, GpuMesh::new);
            batch.gpuTexture = textures.computeIfAbsent(batch.texture, GpuTexture::new);
        }
        dropUnused(meshes, wanted.stream().map(batch -> batch.mesh).collect(Collectors.toSet()));
        dropUnused(
                textures, wanted.stream().map(batch -> batch.texture).collect(Collectors.toSet()));
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
            stagingAddress = MemoryUtil.memAddress(staging);
        }
        float[] tint = tints.of(snapshot, tinted);
        double[] previous = snapshot.previous();
        double[] current = snapshot.current();
        double ax = anchor.x;
        double ay = anchor.y;
        double az = anchor.z;
        for (int row = 0; row < size; row++) {
            int from = row * PoseSnapshot.STRIDE;
            double px = previous[from] - ax;
            double py = previous[from + 1] - ay;
            double pz = previous[from + 2] - az;
            double cx = current[from] - ax;
            double cy = current[from + 1] - ay;
            double cz = current[from + 2] - az;
            putPose(row * MOTION_FLOATS, px, py, pz, previous, from);
            staging.put(row * MOTION_FLOATS + 3, tint[row]);
            putPose(row * MOTION_FLOATS + 8, cx, cy, cz, current, from);
            double dx = 0.5 * (cx - px);
            double dy = 0.5 * (cy - py);
            double dz = 0.5 * (cz - pz);
            wayOfRow[4 * row] = px + dx;
            wayOfRow[4 * row + 1] = py + dy;
            wayOfRow[4 * row + 2] = pz + dz;
            wayOfRow[4 * row + 3] = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        boundCasters(casterLimit);
        motion.write(stagingAddress, floats, GL_STREAM_DRAW);
        uploads++;
    }

    private void putPose(int to, double x, double y, double z, double[] poses, int from) {
        staging.put(to, (float) x);
        staging.put(to + 1, (float) y);
        staging.put(to + 2, (float) z);
        staging.put(to + 3, 0f);
        staging.put(to + 4, (float) poses[from + 3]);
        staging.put(to + 5, (float) poses[from + 4]);
        staging.put(to + 6, (float) poses[from + 5]);
        staging.put(to + 7, (float) poses[from + 6]);
    }

    private void boundCasters(double casterLimit) {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double minZ = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        double maxZ = Double.NEGATIVE_INFINITY;
        for (int slot = 0; slot < rowOfSlot.length; slot++) {
            double reach = reachOfSlot[slot];
            if (reach <= casterLimit) {
                int at = 4 * rowOfSlot[slot];
                double r = reach + wayOfRow[at + 3];
                minX = Math.min(minX, wayOfRow[at] - r);
                minY = Math.min(minY, wayOfRow[at + 1] - r);
                minZ = Math.min(minZ, wayOfRow[at + 2] - r);
                maxX = Math.max(maxX, wayOfRow[at] + r);
                maxY = Math.max(maxY, wayOfRow[at + 1] + r);
                maxZ = Math.max(maxZ, wayOfRow[at + 2] + r);
            }
        }
        castersMin.set(minX, minY, minZ);
        castersMax.set(maxX, maxY, maxZ);
    }

    @Override
    public void close() {
        replaceBatches(List.of());
        motion.close();
        look.close();
        MemoryUtil.memFree(staging);
    }

    /** Instances of one mesh and one texture, which one call draws; they have consecutive slots. */
    static final class Batch {
        final Mesh mesh;
        final Texture texture;

        /** First slot, and how many. */
        int first;

        int count;

        @Nullable GpuMesh gpuMesh;
        @Nullable GpuTexture gpuTexture;

        Batch(Mesh mesh, Texture texture) {
            this.mesh = mesh;
            this.texture = texture;
        }

        /** What makes two instances one batch. */
        record Key(Mesh mesh, Texture texture) {}
    }
}
