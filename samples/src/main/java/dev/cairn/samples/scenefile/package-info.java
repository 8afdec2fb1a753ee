/**
 * Scenes as JSON files: what is in a world at tick 0, from where it is seen and in which light.
 *
 * <p><b>Problem.</b> A person who does not program wants to make a scene, keep it, send it to
 * somebody, and get the same bits there. A mistake in the file has to be told so that its author
 * finds the place.
 *
 * <p><b>Invariants.</b> {@link dev.cairn.samples.scenefile.SceneFile} and all in it are immutable
 * values; they know neither a world nor a window. Writing and reading is the identity, bit for bit:
 * a number is written as the shortest decimal that reads back as the same double. The order of
 * fields is fixed, so equal scenes are equal files. Nothing is passed over: an unknown field is an
 * error. Relative paths in a file are relative to its folder. A mesh or a picture that cannot be
 * used is told and drawn as a placeholder; the scene goes on.
 *
 * <pre>
 *   FILE.json --JsonNode--&gt; SceneReader --&gt; SceneFile --SceneLoader--&gt; SceneBuilder (world, camera, light)
 *       ^                                     |   ^                        |
 *       +-------------- SceneWriter ----------+   +----- SceneExport ------+
 * </pre>
 *
 * <p><b>Source.</b> The shortest decimal of a double: R. Giulietti, "The Schubfach way to render
 * doubles" (2020), which is what {@code Double.toString} does since JDK 19. The format itself is
 * described in {@code docs/scene-files.md}.
 */
@NullMarked
package dev.cairn.samples.scenefile;

import org.jspecify.annotations.NullMarked;
