/**
 * Many bodies thrown together: piles, a pit, a drum, a room. No closed form holds for where they
 * end; what is held against a truth is that nothing overlaps, sinks or goes on shaking.
 */
@NullMarked
package dev.cairn.samples.scenes.heap;

import org.jspecify.annotations.NullMarked;
