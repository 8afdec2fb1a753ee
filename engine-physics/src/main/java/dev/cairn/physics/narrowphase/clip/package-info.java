/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.clip;

import org.jspecify.annotations.NullMarked;
