/**
 * Pictures of runs without a window: sheets of scenes, animations, and the file that holds them.
 */
@NullMarked
package dev.cairn.samples.film;

import org.jspecify.annotations.NullMarked;
