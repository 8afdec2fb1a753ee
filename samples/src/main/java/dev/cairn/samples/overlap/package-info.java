/**
 * How deep bodies are in each other, found apart from the engine: so that its own narrow phase is
 * not the judge of itself. Each shape becomes a solid of planes, balls and bars, and the depth of
 * two is the least over directions of how far they overlap along each.
 */
@NullMarked
package dev.cairn.samples.overlap;

import org.jspecify.annotations.NullMarked;
