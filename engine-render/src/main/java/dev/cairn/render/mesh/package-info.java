/** Stub. */
@NullMarked
package dev.cairn.render.mesh;

import org.jspecify.annotations.NullMarked;
