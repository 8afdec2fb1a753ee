/**
 * Where the time of a tick goes, system by system.
 *
 * <p>Problem: who adds a system wants to know what it costs beside the others, without a profiler,
 * and a tick that nobody times should pay nothing for the question.
 *
 * <p>Invariants: nothing that is measured here reaches the state of a world; no system can read the
 * clock by it within a tick, since what it tells changes between ticks only.
 */
@NullMarked
package dev.cairn.core.profile;

import org.jspecify.annotations.NullMarked;
