/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.curved;

import org.jspecify.annotations.NullMarked;
