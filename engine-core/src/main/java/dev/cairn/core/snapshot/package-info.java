/** Stub. */
@NullMarked
package dev.cairn.core.snapshot;

import org.jspecify.annotations.NullMarked;
