/**
 * Entities, components, and systems that declare what they touch.
 *
 * <h2>Problem</h2>
 *
 * <p>Many systems share the state of many things, several threads work on it, and the result must
 * not depend on which came first. Locks would make it safe but neither fast nor repeatable. So the
 * state has two sides, and who may write is settled before the first tick.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   archetype {Pose, Wind}           one table per set of components
 *     chunk 0: 1024 rows or more     one array per field:
 *                  published              next                  spare
 *       Pose.x   [ array a ]  ==read==  [ array b ] &lt;=written    (a after commit)
 *       Wind.x   [ array c ]  ========= [ array c ]              nothing wrote: one array
 *     chunk 1: ...
 *
 *   tick:   level 0 (system, chunk) blocks in parallel -&gt; level 1 ... -&gt; commit
 *   commit: exchange published and next where they differ, then commands in
 *           (system, chunk, sequence) order
 * </pre>
 *
 * <h2>Chapters</h2>
 *
 * <pre>
 *   component   ids, components, fields, codecs           what entities are made of
 *   storage     tables, rows, arrays, changes             where they live         (internal)
 *   access      in, out, next, with, exclude              what systems touch
 *   graph       edges, levels                             the order that follows  (internal)
 *   ecs         world, systems, tick, commands, queries, observers: this package
 * </pre>
 *
 * <p>Each knows those above it in this list, and none below.
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>{@code in} reads the published side: what the last tick left. It conflicts with nothing.
 *   <li>{@code out} writes the other side. Two writers of one component have an order that was
 *       asked for, or entities that {@code exclude} keeps apart; a schedule that breaks this does
 *       not build.
 *   <li>{@code next} reads what was written in this tick, so it orders two systems. The levels of a
 *       tick follow from it and from {@code before} and {@code after}; world systems, which may
 *       share what they do not declare, need an order, and so do two systems that give commands. No
 *       name decides what is computed.
 *   <li>The structure stands during a tick. Systems ask for changes by {@link
 *       dev.cairn.core.ecs.Commands}; between steps the user changes it directly.
 *   <li>Observers are told of changes of structure and values as they are made, in the order in
 *       which they registered, and ask for more by commands of their own, which come last.
 *   <li>Rows are dense: a deleted row is filled by the last one. An id is an index and a
 *       generation, and is never given twice.
 *   <li>Random numbers are a function of seed, tick, entity and stream.
 * </ul>
 *
 * <h2>Invariants</h2>
 *
 * <p>Between ticks published and next are the same arrays. All slabs of an archetype are full but
 * the last used one. A component's place in a result depends on its class name, never on the order
 * of class loading. A tick that fails publishes nothing. A steady tick allocates nothing.
 *
 * <h2>Sources</h2>
 *
 * <p>Playback order by chunk as a sort key as in Unity's parallel command buffers; random streams
 * after Salmon et al. 2011 and Steele et al. 2014. The chapters name theirs.
 */
@NullMarked
package dev.cairn.core.ecs;

import org.jspecify.annotations.NullMarked;
