/**
 * Water and wind as systems of the ECS: physics beside the rigid bodies, without a line in them.
 *
 * <p>Problem: a world has more to it than contacts. What acts on bodies is a column, {@code Force},
 * which any system fills in parallel from what the last tick left; the rigid bodies read it.
 *
 * <p>Invariants: a system has one writer's right to {@code Force} of its entities, so water and
 * wind write components of their own and {@link dev.cairn.samples.weather.Weather} adds them up,
 * after both because it reads them with {@code next}.
 */
@NullMarked
package dev.cairn.samples.weather;

import org.jspecify.annotations.NullMarked;
