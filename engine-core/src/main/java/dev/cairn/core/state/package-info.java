/**
 * The world as a value.
 *
 * <p>Problem: what a tick depends on is spread over many arrays in many objects, and each of them
 * is grown, moved and reused in its own way. A copy that forgets one of them is no error that
 * anybody sees: the world goes on from it, a little otherwise.
 *
 * <p>So nobody copies from outside. Each object that outlives a tick declares its fields once, in
 * {@link dev.cairn.core.state.Stateful#state}; saving and restoring are two visitors of this
 * declaration, as growing and moving are two visitors of a store's columns. A test walks over all
 * objects that a world reaches, and fails for a field that is neither declared nor named as room
 * that every tick fills anew.
 *
 * <pre>
 *   Stateful.state ──▶ StateVisitor ──▶ WorldState: bytes, and references to what never changes
 *                 ◀──  (save | restore)
 * </pre>
 *
 * <p>A {@link dev.cairn.core.state.WorldState} is one block of bytes with a table of contents, so
 * that two can be compared, subtracted (a {@link dev.cairn.core.state.StateDelta} leads from one to
 * the other and back, and is as large as what has changed) and written; numbers have their place
 * and their least significant byte first, on every machine. What follows from other numbers of the
 * same state a delta need not tell, if somebody knows it ({@link
 * dev.cairn.core.state.StateColumns.Predictor}).
 *
 * <p>Objects are written by a {@link dev.cairn.core.state.StateCodec}. That of a record follows
 * from its components; their names and types are written with it, once, so that a program whose
 * record has others by then says which, instead of reading one number as another.
 */
@NullMarked
package dev.cairn.core.state;

import org.jspecify.annotations.NullMarked;
