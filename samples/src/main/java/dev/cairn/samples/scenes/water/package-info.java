/** Scenes on water, whose systems are those of {@link dev.cairn.samples.weather}. */
@NullMarked
package dev.cairn.samples.scenes.water;

import org.jspecify.annotations.NullMarked;
