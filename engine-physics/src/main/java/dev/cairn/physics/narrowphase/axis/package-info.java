/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.axis;

import org.jspecify.annotations.NullMarked;
