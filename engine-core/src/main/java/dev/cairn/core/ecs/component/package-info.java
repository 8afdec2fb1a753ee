/**
 * What entities are made of: ids, components, and the columns of their fields.
 *
 * <h2>Problem</h2>
 *
 * <p>A component should be declared as plain data, in one line, and yet lie in memory as arrays of
 * numbers, without an object for each entity, and without reflection where a row is written.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   record Wind(double x, double y, boolean gusty) {}
 *
 *   Component&lt;Wind&gt;          the key, one per record class and JVM
 *     DoubleField x    -&gt;  double[]
 *     DoubleField y    -&gt;  double[]
 *     IntField gusty   -&gt;  int[]         0 or 1
 *     RecordCodec      -&gt;  code made for this record: Wind &lt;-&gt; row of the arrays
 *
 *   entity = generation (32 bits) | index (32 bits)
 * </pre>
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>A field is a column of one of five kinds: {@code double}, {@code float}, {@code long},
 *       {@code int} (smaller primitives too) or references.
 *   <li>Keys are made once, kept as constants, and compared by identity. Their numbers are dense,
 *       for tables, and depend on class loading: no result may depend on them. What lasts names a
 *       component by its record's class.
 *   <li>A codec is a hidden class beside the record, so that private records work. Where that is
 *       not allowed it is one here, and at last a list of method handles.
 * </ul>
 *
 * <p>This chapter knows nothing of tables, worlds or systems.
 *
 * <h2>Sources</h2>
 *
 * <p>Primitive columns behind records as in japes.
 */
@NullMarked
package dev.cairn.core.ecs.component;

import org.jspecify.annotations.NullMarked;
