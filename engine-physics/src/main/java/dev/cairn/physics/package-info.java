/** Stub. */
@NullMarked
package dev.cairn.physics;

import org.jspecify.annotations.NullMarked;
