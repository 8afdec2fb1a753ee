/**
 * Convex parts of meshes as a tool: an .obj file goes in, a scene file with a body of its parts
 * comes out. The work is {@link dev.cairn.physics.shape.decomposition.Decomposer}'s.
 */
@NullMarked
package dev.cairn.samples.decompose;

import org.jspecify.annotations.NullMarked;
