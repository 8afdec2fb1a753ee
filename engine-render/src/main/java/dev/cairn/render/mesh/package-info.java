/**
 * What is drawn: triangles, pictures, and how an entity wears them.
 *
 * <p><b>Problem.</b> A body's shape, a user's {@code .obj} and {@code .png} have to become
 * something that a graphics processor draws by the thousand, and a mistake in a file has to be told
 * so that its author can mend it.
 *
 * <p><b>Invariants.</b> Nothing here knows OpenGL or a thread: a {@link
 * dev.cairn.render.mesh.Mesh}, a {@link dev.cairn.render.mesh.Texture} and a {@link
 * dev.cairn.render.mesh.Model} are immutable values, made anywhere, read anywhere, also on machines
 * without a display (the points of an {@code .obj} become a convex hull there). Triangles are
 * counter-clockwise seen from outside, normals have unit length, v of a texture coordinate grows
 * upwards. Meshes and textures are compared by identity: sharing one is what makes two models one
 * draw call.
 *
 * <pre>
 *   .obj file --ObjReader--&gt; Mesh --+
 *   Shape -------Meshes----&gt; Mesh --+--&gt; Model (mesh, texture, colour, scale, origin) --&gt; component Visual of an entity
 *   .png file ---Texture.read-------+
 * </pre>
 *
 * <p><b>Source.</b> The {@code .obj} format: Wavefront, "Advanced Visualizer manual", appendix B1;
 * polygons are cut by ear clipping (Meisters, "Polygons have ears", 1975) in the plane of Newell's
 * normal (Tampieri, Graphics Gems III).
 */
@NullMarked
package dev.cairn.render.mesh;

import org.jspecify.annotations.NullMarked;
