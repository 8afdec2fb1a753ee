/**
 * Handles in the picture by which the mouse moves, turns and scales what is selected in the editor.
 *
 * <p>A handle knows how the scene was when it was taken; each move of the mouse makes the scene
 * anew from that, so that nothing drifts and a drag is one step of the history.
 */
@NullMarked
package dev.cairn.samples.editor.gizmo;

import org.jspecify.annotations.NullMarked;
