/**
 * From where a scene is seen, and in which light.
 *
 * <p><b>Problem.</b> A picture needs a place, a heading, a lens and lamps; keys move the camera on
 * one thread while the user's code places it on another.
 *
 * <p><b>Invariants.</b> World frame, metres, y up, right-handed; positions are double, so a camera
 * a planet's radius away from the origin sees as sharply as one at it. The camera has no roll: yaw
 * about y, then pitch. {@link dev.cairn.render.camera.Light} is an immutable value; {@link
 * dev.cairn.render.camera.Camera} is safe on any thread.
 *
 * <pre>
 *            y                 yaw 0 looks along -z,
 *            |  -z             yaw grows towards +x,
 *            | /               pitch grows towards +y
 *            |/____ x
 * </pre>
 */
@NullMarked
package dev.cairn.render.camera;

import org.jspecify.annotations.NullMarked;
