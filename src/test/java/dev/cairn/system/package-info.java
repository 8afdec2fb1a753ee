/**
 * Tests that need more than one module: the architecture, the same bits for any number of workers,
 * and the truths that the scenes must meet.
 */
@NullMarked
package dev.cairn.system;

import org.jspecify.annotations.NullMarked;
