/** Stub. */
@NullMarked
package dev.cairn.core.job;

import org.jspecify.annotations.NullMarked;
