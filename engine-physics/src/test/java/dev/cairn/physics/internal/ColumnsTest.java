package dev.cairn.physics.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Every array of a store is declared, once and under its name, and what is done to all columns is
 * done to each element of a row.
 */
final class ColumnsTest {
    private static final int ROWS = 40;

    @Test
    void everyArrayOfAStoreIsDeclared() throws IllegalAccessException {
        assertDeclared(bodies(), bodies -> bodies::columns);
        assertDeclared(contacts(), contacts -> contacts::columns);
        ColliderStore colliders = new ColliderStore(new BodyStore());
        colliders.belts = true;
        colliders.compounds = true;
        assertDeclared(colliders, all -> all::columns);
    }

    @Test
    void growthKeepsEveryElement() {
        ContactStore contacts = contacts();
        Map<String, List<Object>> before = rowsOf(contacts::columns, 0, ROWS);
        contacts.ensureCapacity(5 * ROWS);
        assertRows(before, rowsOf(contacts::columns, 0, ROWS));
        BodyStore bodies = bodies();
        before = rowsOf(bodies::columns, 0, ROWS);
        bodies.ensureCapacity(5 * ROWS);
        assertRows(before, rowsOf(bodies::columns, 0, ROWS));
    }

    @Test
    void aMovedRowIsTheRowInEveryColumn() {
        ContactStore contacts = contacts();
        int[] from = {9, 11, 10};
        int[] to = {3, 1, 7};
        List<Map<String, List<Object>>> before = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            before.add(rowsOf(contacts::columns, row, row + 1));
        }
        contacts.move(from, to, to.length);
        for (int i = 0; i < to.length; i++) {
            before.set(to[i], before.get(from[i]));
        }
        for (int row = 0; row < ROWS; row++) {
            assertRows(before.get(row), rowsOf(contacts::columns, row, row + 1));
        }
    }

    @Test
    void aRowIsAddedEmptyWhateverWasThereBefore() {
        ContactStore contacts = contacts();
        contacts.count = 7;
        contacts.activeCount = 2;
        Map<String, List<Object>> below = rowsOf(contacts::columns, 0, 7);
        Map<String, List<Object>> above = rowsOf(contacts::columns, 10, ROWS);
        contacts.append(3);
        assertEquals(10, contacts.count);
        assertEquals(5, contacts.activeCount);
        assertEquals(7, contacts.active[2]);
        assertEquals(9, contacts.active[4]);
        assertRows(below, rowsOf(contacts::columns, 0, 7));
        assertRows(above, rowsOf(contacts::columns, 10, ROWS));
        assertEmpty(contacts::columns, 7, 10);
        BodyStore bodies = bodies();
        bodies.clear(5);
        assertEmpty(bodies::columns, 5, 6);
    }

    /** Column by column, so that a failure is short. */
    private static void assertRows(
            Map<String, List<Object>> expected, Map<String, List<Object>> rows) {
        assertEquals(expected.keySet(), rows.keySet());
        expected.forEach((name, values) -> assertTrue(values.equals(rows.get(name)), name));
    }

    private static void assertEmpty(Consumer<Columns> store, int begin, int end) {
        rowsOf(store, begin, end)
                .forEach((name, values) -> {
                    for (Object value : values) {
                        boolean isZero =
                                value == null
                                        || value.equals(false)
                                        || (value instanceof Number n && n.doubleValue() == 0);
                        assertTrue(isZero || name.equals("kept"), name + " " + value);
                    }
                });
    }

    private interface Declaration<S> {
        Consumer<Columns> of(S store);
    }

    private static <S> void assertDeclared(S store, Declaration<S> declaration)
            throws IllegalAccessException {
        Recorder declared = new Recorder();
        declaration.of(store).accept(declared);
        List<Field> fields = new ArrayList<>(List.of(store.getClass().getDeclaredFields()));
        fields.addAll(List.of(store.getClass().getSuperclass().getDeclaredFields()));
        // lists of slots, and scratch
        fields.removeIf(field ->
                Set.of("free", "compound", "turned", "ramp", "surges", "palette")
                        .contains(field.getName()));
        for (Field field : fields) {
            if (field.getType().isArray() && !Modifier.isStatic(field.getModifiers())) {
                field.setAccessible(true);
                assertSame(
                        field.get(store),
                        declared.arrays.remove(field.getName()),
                        field.getName() + " is not declared in columns()");
            }
        }
        assertEquals(Map.of(), declared.arrays, "declared, but no field");
    }

    private static BodyStore bodies() {
        BodyStore bodies = new BodyStore();
        bodies.ensureCapacity(ROWS);
        bodies.columns(new Filler());
        return bodies;
    }

    /** With all that a store grows only when it is needed. */
    private static ContactStore contacts() {
        ContactStore contacts = new ContactStore();
        contacts.ensureCapacity(ROWS);
        contacts.beginRolling();
        contacts.beginUneven();
        contacts.beginCompounds();
        contacts.beginBelts();
        contacts.beginHits();
        contacts.beginGroups();
        contacts.beginHooks();
        contacts.beginLeaning();
        contacts.beginMemory(5);
        contacts.columns(new Filler());
        return contacts;
    }

    private static Map<String, List<Object>> rowsOf(Consumer<Columns> store, int begin, int end) {
        Recorder recorder = new Recorder();
        recorder.begin = begin;
        recorder.end = end;
        store.accept(recorder);
        return recorder.values;
    }

    /** Remembers what is declared, and the elements of some rows. */
    private static final class Recorder implements Columns {
        final Map<String, Object> arrays = new LinkedHashMap<>();
        final Map<String, List<Object>> values = new LinkedHashMap<>();
        int begin;
        int end;

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            declare(name, array);
            List<Object> list = new ArrayList<>();
            for (int i = start + stride * begin; i < start + stride * end; i++) {
                list.add(Array.get(array, i));
            }
            values.put(name, list);
            return array;
        }

        @Override
        public int[] room(String name, int[] array) {
            declare(name, array);
            return array;
        }

        private void declare(String name, Object array) {
            assertEquals(null, arrays.put(name, array), name + " is declared twice");
        }
    }

    /** Gives every element a value that differs from its neighbours' in all columns. */
    private static final class Filler implements Columns {
        private int next;

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            for (int i = 0; i < Array.getLength(array); i++) {
                next++;
                switch (array) {
                    case double[] a -> a[i] = next;
                    case long[] a -> a[i] = next;
                    case int[] a -> a[i] = next;
                    case byte[] a -> a[i] = (byte) (1 + next % 101);
                    case boolean[] a -> a[i] = true;
                    default -> {}
                }
            }
            return array;
        }

        @Override
        public int[] room(String name, int[] array) {
            return array;
        }
    }
}
