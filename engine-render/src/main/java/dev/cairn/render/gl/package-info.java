/**
 * The drawing itself: OpenGL 3.3 core, on the thread that opened the context. Not exported.
 *
 * <p><b>Problem.</b> Thousands of bodies have to be drawn sixty times a second or more while the
 * simulation steps at its own pace on another thread, in a window as well as without a display,
 * near the world's origin as well as a planet's radius away from it.
 *
 * <p><b>Invariants.</b> The renderer reads a {@code PoseSnapshot} and nothing else of the
 * simulation. Work on the CPU per frame does not grow with the number of bodies: each new snapshot
 * is uploaded once, 16 floats per body (position and orientation of the previous and the current
 * tick), and the vertex shader interpolates. Positions are made relative to an <em>anchor</em>, a
 * point near the camera on a grid of 64 m, in double, before they become floats. Entities of one
 * mesh and one texture are one draw call. Steady frames allocate nothing on the heap. Colours are
 * computed in linear light and encoded to sRGB at the very end.
 *
 * <pre>
 *   PoseSnapshot --Instances--&gt; per-tick buffer, per-layout buffer --+
 *   Mesh, Texture --------------&gt; GpuMesh, GpuTexture ---------------+--&gt; shadow pass --&gt; scene pass --&gt; sky --&gt; FrameTarget
 *   Camera, Light ---------------------------------------------------+                                             |
 *                                                                                     window &lt;-- resolve --&gt; Picture
 * </pre>
 *
 * <p><b>Source.</b> Lambert's cosine law with a hemisphere light; shadow maps after Williams (1978)
 * with percentage-closer filtering after Reeves, Salesin and Cook (1987), receivers moved along
 * their normals after Holbert (2011), the map's texels fixed in the world after Valient (2007).
 */
@NullMarked
package dev.cairn.render.gl;

import org.jspecify.annotations.NullMarked;
