/**
 * What a user can touch: panels with buttons, sliders and plots, behind one small interface.
 *
 * <p><b>Problem.</b> A window that shows what the engine knows needs widgets, but no part of the
 * engine should depend on a particular library of them, and none may hold the simulation up.
 *
 * <p><b>Shape.</b> {@link dev.cairn.render.ui.Ui} is immediate: an application draws its panels
 * anew in each frame, on the window's thread, from what it has read of a snapshot, and hands what
 * the user did to the simulation thread by {@code Application.post}. The package {@code nuklear}
 * implements it by the library of that name (public domain) through LWJGL; nothing outside of it
 * knows.
 *
 * <pre>
 *   GLFW events --&gt; [ panels first ] --what they do not want--&gt; camera, bindings
 *                        |
 *                     Ui calls --post--&gt; simulation thread
 * </pre>
 */
@NullMarked
package dev.cairn.render.ui;

import org.jspecify.annotations.NullMarked;
