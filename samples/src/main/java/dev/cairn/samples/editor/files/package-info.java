/**
 * Choosing files in a window, without a dialog of the desktop, which not every machine has, and
 * asking before a scene is lost that no file has yet.
 */
@NullMarked
package dev.cairn.samples.editor.files;

import org.jspecify.annotations.NullMarked;
