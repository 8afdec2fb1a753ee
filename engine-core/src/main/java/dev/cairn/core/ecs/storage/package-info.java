/**
 * Where entities live: the ids, the tables, and the changes of structure.
 *
 * <h2>Problem</h2>
 *
 * <p>A system wants all values of a field in one array; a user adds and takes away components at
 * will. So entities with the same set of components share a table, and a change of the set moves a
 * row from one table to another.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   EntityTable        index -&gt; generation, place           Store: all of this, for one world
 *                                     |
 *                                     v
 *   Archetype {Pose, Wind}    row 0 .. 1023 | 1024 .. 2047 | ...
 *                                 Slab           Slab
 *     each slab:  published[column], next[column], spare[column], versions[column]
 * </pre>
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>Rows are dense: a deleted row is filled by the last one. All slabs of an archetype are full
 *       but the last used one, and where a slab ends follows from the row's number alone.
 *   <li>Between ticks published and next are the same arrays. The first write of a tick takes the
 *       spare array, and commit exchanges the two.
 *   <li>Each call is checked first and made afterwards: a refused one leaves nothing half done.
 *   <li>A {@link dev.cairn.core.ecs.storage.Watch} is told of each change as it is made; what it
 *       does with that is not known here.
 *   <li>The digest names components by their classes and walks tables in the order in which they
 *       came to be, which is part of the state.
 * </ul>
 *
 * <p>Internal: no other module sees this package, so its members are as public as the worlds and
 * systems above them need.
 *
 * <h2>Sources</h2>
 *
 * <p>Archetype chunks and per-chunk change versions as in Unity's entity component system; digest
 * after Collet's xxHash64.
 */
@NullMarked
package dev.cairn.core.ecs.storage;

import org.jspecify.annotations.NullMarked;
