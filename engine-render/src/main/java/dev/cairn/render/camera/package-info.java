/** Stub. */
@NullMarked
package dev.cairn.render.camera;

import org.jspecify.annotations.NullMarked;
