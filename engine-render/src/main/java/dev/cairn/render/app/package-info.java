/** Stub. */
@NullMarked
package dev.cairn.render.app;

import org.jspecify.annotations.NullMarked;
