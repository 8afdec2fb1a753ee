/**
 * Water and wind as systems of the ECS: physics beside the rigid bodies, without a line in them.
 *
 * <p>Problem: a world has more to it than contacts. What acts on bodies is a column, {@code Force},
 * which any system fills in parallel from what the last tick left; the rigid bodies read it.
 *
 * <p>Invariants: two systems write {@code Force} of the same entities, so their order is asked for:
 * {@link dev.cairn.samples.weather.Buoyancy} writes all of it, {@link
 * dev.cairn.samples.weather.Wind} comes after it and adds to what it finds. A third force would ask
 * to come after one of them in the same way.
 */
@NullMarked
package dev.cairn.samples.weather;

import org.jspecify.annotations.NullMarked;
