/**
 * Runs and moments of scenes as files: which scene it is, and the library's own recording of what
 * was done to it. Whoever reads one builds the scene, puts it to the state in the file, and does
 * the same again, so that what comes out otherwise shows from which tick on, and in what.
 */
@NullMarked
package dev.cairn.samples.replay;

import org.jspecify.annotations.NullMarked;
