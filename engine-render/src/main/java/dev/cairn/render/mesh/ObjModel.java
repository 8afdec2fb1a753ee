package dev.cairn.render.mesh;

/**
 * What an {@code .obj} file holds. Immutable.
 *
 * @param mesh all its triangles, whatever their material; its points are what a hull is made from
 * @param look one model per material that a face uses; where the file names no material, one model
 *     in light grey
 * @param hasMaterials whether the file names materials, so that the colours of {@code look} are its
 *     author's
 */
public record ObjModel(Mesh mesh, ModelGroup look, boolean hasMaterials) {}
