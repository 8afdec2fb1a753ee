/**
 * What keys and mouse buttons do.
 *
 * <p><b>Problem.</b> Any key or button can start any function of the user, be rebound while the
 * program runs, and its function has to be free to change the world, which belongs to the
 * simulation thread, although the press happens on the window's thread.
 *
 * <p><b>Invariants.</b> A trigger (key or button) fires one action; an action may have several
 * triggers. Functions run on the simulation thread between two ticks, in the order of the presses,
 * once per press. Nothing here knows the window, so scripts and tests press keys by a call.
 *
 * <pre>
 *   Key.P ----+
 *             +--&gt; "pause" --&gt; togglePause()
 *   Key.SPACE +
 * </pre>
 */
@NullMarked
package dev.cairn.render.input;

import org.jspecify.annotations.NullMarked;
