/**
 * Scenes of what contacts must not do: trip at the seams of a floor, deflect what passes by, let
 * through what is fast.
 */
@NullMarked
package dev.cairn.samples.scenes.seam;

import org.jspecify.annotations.NullMarked;
