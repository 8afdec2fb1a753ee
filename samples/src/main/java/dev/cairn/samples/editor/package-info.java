/**
 * The scene editor: what it knows and does, and its panels.
 *
 * <p><b>Problem.</b> A person who does not program puts a scene together by mouse, sees it run, and
 * comes back to exactly what was there before it ran.
 *
 * <p><b>Invariants.</b> {@link dev.cairn.samples.editor.Editor} holds nothing but immutable {@link
 * dev.cairn.samples.scenefile.SceneFile} values and is free of window and world: it is told what
 * the user did and tells a {@link dev.cairn.samples.editor.Stage} which scene to show at rest or to
 * run. The world is made from the value each time, so running a scene cannot change it, and what
 * runs here is what runs by {@code --scene-file}. Nothing that the user types throws: mistakes are
 * a line in the panel.
 *
 * <pre>
 *   mouse, keys --&gt; EditorPanels --&gt; Editor --&gt; SceneEdit, SceneHistory
 *   (window thread)      ^             |
 *                        |             +--&gt; Stage: rest(scene) | play(scene)   (simulation thread)
 *                        +-- entities of the world by their place in the file --+
 * </pre>
 */
@NullMarked
package dev.cairn.samples.editor;

import org.jspecify.annotations.NullMarked;
