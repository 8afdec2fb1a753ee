/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.round;

import org.jspecify.annotations.NullMarked;
