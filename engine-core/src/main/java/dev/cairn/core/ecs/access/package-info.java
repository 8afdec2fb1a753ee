/**
 * What systems say that they touch.
 *
 * <h2>Problem</h2>
 *
 * <p>Which systems may run at once, which comes first, and which arrays a system is handed, must be
 * known before it runs. So a system declares what it reads and writes, as data, and all of that
 * follows from the declarations alone.
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>{@code in} is what the last tick left, {@code out} what this tick writes, {@code next} what
 *       this tick has written before.
 *   <li>A declaration is closed when the system has described itself, and is checked then: what
 *       contradicts itself never runs.
 *   <li>What was not declared is refused at its first use, with the call that would declare it.
 * </ul>
 *
 * <p>This chapter knows components, and neither systems nor tables.
 *
 * <h2>Sources</h2>
 *
 * <p>Access declarations as in Bevy and flecs.
 */
@NullMarked
package dev.cairn.core.ecs.access;

import org.jspecify.annotations.NullMarked;
