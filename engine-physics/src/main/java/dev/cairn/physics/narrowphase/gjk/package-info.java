/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.gjk;

import org.jspecify.annotations.NullMarked;
