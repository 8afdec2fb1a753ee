/**
 * Pairs of shapes for the narrow phase's benchmarks, and the diagram of its error against its time.
 */
@NullMarked
package dev.cairn.benchmarks.narrowphase;

import org.jspecify.annotations.NullMarked;
