/**
 * Scenes of joints: pendulums, a chain, mechanisms and a car, each with its truth or with the
 * largest gap that a joint ever had.
 */
@NullMarked
package dev.cairn.samples.scenes.joint;

import org.jspecify.annotations.NullMarked;
