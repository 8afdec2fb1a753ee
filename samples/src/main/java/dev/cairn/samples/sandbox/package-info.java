/**
 * The window with the scenes.
 *
 * <p>The simulation thread owns the world, the scene and what the hand holds; the window's thread
 * owns panels and the editor. Panels post what they want done, and show what {@link
 * dev.cairn.samples.sandbox.SandboxState} brought with the last tick.
 */
@NullMarked
package dev.cairn.samples.sandbox;

import org.jspecify.annotations.NullMarked;
