/** Stub. */
@NullMarked
package dev.cairn.render.input;

import org.jspecify.annotations.NullMarked;
