/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.hull;

import org.jspecify.annotations.NullMarked;
