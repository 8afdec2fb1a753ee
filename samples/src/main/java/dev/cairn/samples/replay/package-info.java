/**
 * Runs of scenes that are written down and played again: what was asked for, a digest of every
 * tick, and now and then a sum of each column and of each body, so that a run that comes out
 * otherwise tells from which tick on, and in what.
 */
@NullMarked
package dev.cairn.samples.replay;

import org.jspecify.annotations.NullMarked;
