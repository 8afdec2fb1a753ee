/** Stub. */
@NullMarked
package dev.cairn.physics.shape;

import org.jspecify.annotations.NullMarked;
