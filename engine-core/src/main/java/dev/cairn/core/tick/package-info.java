/** Stub. */
@NullMarked
package dev.cairn.core.tick;

import org.jspecify.annotations.NullMarked;
