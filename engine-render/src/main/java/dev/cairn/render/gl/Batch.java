package dev.cairn.render.gl;

import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Texture;

import org.jspecify.annotations.Nullable;

/** Instances of one mesh and one texture, which one call draws; they have consecutive slots. */
final class Batch {
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
