/**
 * Things that stand on each other: stacks, pyramids, an arch, a house of cards. What holds them up
 * is told by statics: a reaction is a weight, a centre of mass lies over a foot.
 */
@NullMarked
package dev.cairn.samples.scenes.stack;

import org.jspecify.annotations.NullMarked;
