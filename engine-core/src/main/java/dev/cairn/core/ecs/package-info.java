/** Stub. */
@NullMarked
package dev.cairn.core.ecs;

import org.jspecify.annotations.NullMarked;
