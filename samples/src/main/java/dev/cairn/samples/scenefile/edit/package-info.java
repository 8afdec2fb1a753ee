/**
 * Changes of a scene, as an editor makes them: each gives another scene, and the way back.
 *
 * <p><b>Problem.</b> What a person does to a scene must be undone in the order in which it was
 * done, and may never leave a scene that its own file cannot say.
 *
 * <pre>
 *   SceneFile --SceneEdit (entities), JointEdit (joints)--&gt; SceneFile
 *       +---------------- SceneHistory (undo, redo) ------------+
 * </pre>
 *
 * <p><b>Invariants.</b> Scenes are immutable: an edit makes a new one or throws, and then nothing
 * has changed. A joint goes with the body that it hangs on, and is gone with it. Knows neither a
 * window nor a world that runs.
 */
@NullMarked
package dev.cairn.samples.scenefile.edit;

import org.jspecify.annotations.NullMarked;
