/**
 * What the drawing costs the processor.
 *
 * <p><b>Problem.</b> On a machine without a graphics processor the software rasteriser does its
 * vertices on the calling thread, so the time of a frame says nothing about our own code.
 *
 * <p><b>Invariants.</b> {@link dev.cairn.benchmarks.render.RenderFrame} counts the CPU time of the
 * drawing thread alone, and is meant to be run with Mesa's driver that draws nothing ({@code
 * GALLIUM_NOOP=1}): then what remains is our update, upload and submission, and Mesa's front end.
 */
@NullMarked
package dev.cairn.benchmarks.render;

import org.jspecify.annotations.NullMarked;
