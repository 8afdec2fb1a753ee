/**
 * Whether the native libraries are there, asked before LWJGL is.
 *
 * <p><b>Problem.</b> A program that forgot an artifact of natives gets a page of LWJGL's advice at
 * the first call, and {@code NoClassDefFoundError} from then on. Both name one library at a time.
 *
 * <p><b>Answer.</b> LWJGL keeps its libraries at known places in jars. Looking whether they are
 * there loads nothing, names all that is missing in one sentence, and says what brings them.
 */
@NullMarked
package dev.cairn.render.natives;

import org.jspecify.annotations.NullMarked;
