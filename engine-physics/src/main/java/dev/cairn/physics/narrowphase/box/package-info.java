/** A chapter of the narrow phase. */
@NullMarked
package dev.cairn.physics.narrowphase.box;

import org.jspecify.annotations.NullMarked;
