/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.pair;

import org.jspecify.annotations.NullMarked;
