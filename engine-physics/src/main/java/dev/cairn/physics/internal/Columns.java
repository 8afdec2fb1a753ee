package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Array;
import java.util.Arrays;

/**
 * Something that is done to all columns of a store. A store declares each of its arrays in one
 * place, a method that hands them to one of these and keeps what comes back: so no column can be
 * grown and not moved, or saved and not restored.
 */
public interface Columns {
    /**
     * One column.
     *
     * @param name of the field
     * @param array the column
     * @param start index of row 0
     * @param stride elements to a row
     * @param <A> type of the array
     * @return what the field shall hold
     */
    <A> A column(String name, A array, int start, int stride);

    /**
     * A column with rows that begin at index 0.
     *
     * @param name of the field
     * @param array the column
     * @param stride elements to a row
     * @param <A> type of the array
     * @return what the field shall hold
     */
    default <A> A column(String name, A array, int stride) {
        return column(name, array, 0, stride);
    }

    /**
     * A column of one element to a row.
     *
     * @param name of the field
     * @param array the column
     * @param <A> type of the array
     * @return what the field shall hold
     */
    default <A> A column(String name, A array) {
        return column(name, array, 0, 1);
    }

    /**
     * Room for one element to a row that is no row's own: it is written anew in each tick.
     *
     * @param name of the field
     * @param array the room
     * @return what the field shall hold
     */
    int[] room(String name, int[] array);

    /** Makes room for rows; allocates. */
    final class Growth implements Columns {
        private final int rows;

        /**
         * To a number of rows.
         *
         * @param rows that must fit
         */
        public Growth(int rows) {
            this.rows = rows;
        }

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            return longer(array, start + stride * rows);
        }

        @Override
        public int[] room(String name, int[] array) {
            return longer(array, rows);
        }

        @SuppressWarnings("unchecked")
        private static <A> A longer(A array, int length) {
            int old = Array.getLength(array);
            if (old >= length) {
                return array;
            }
            Object grown = Array.newInstance(array.getClass().getComponentType(), length);
            System.arraycopy(array, 0, grown, 0, old);
            return (A) grown;
        }
    }

    /** Saves or restores rows, the first ones of a store. Reused. */
    final class Kept implements Columns {
        private @Nullable StateVisitor visitor;
        private int rows;
        private int capacity;
        private boolean clears;

        /** Nothing chosen yet. */
        public Kept() {}

        /**
         * Chooses what is done to which rows.
         *
         * @param s saves or restores
         * @param count rows from 0 on
         * @param room rows that fit without growing
         * @param clearing whether the rows behind them are emptied when they are restored; not
         *     needed where a row is emptied when it is taken
         * @return this
         */
        public Kept of(StateVisitor s, int count, int room, boolean clearing) {
            visitor = s;
            clears = clearing;
            rows = count;
            capacity = room;
            return this;
        }

        private StateVisitor visitor() {
            if (visitor == null) {
                throw new IllegalStateException("of(..) has chosen nothing yet");
            }
            return visitor;
        }

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            return visitor()
                    .array(name, array, start, stride * rows, start + stride * capacity, clears);
        }

        @Override
        public int[] room(String name, int[] array) {
            return array.length < capacity ? new int[capacity] : array;
        }
    }

    /** Moves single rows to places of rows that are not needed. Reused. */
    final class Move implements Columns {
        private int[] from = {};
        private int[] to = {};
        private int count;

        /** Chooses the rows; the arrays are read until the columns are moved. */
        Move rows(int[] sources, int[] targets, int number) {
            from = sources;
            to = targets;
            count = number;
            return this;
        }

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            for (int i = 0; i < count; i++) {
                System.arraycopy(
                        array, start + stride * from[i], array, start + stride * to[i], stride);
            }
            return array;
        }

        @Override
        public int[] room(String name, int[] array) {
            return array;
        }
    }

    /** Sets rows to 0, false or null. Reused. */
    final class Clear implements Columns {
        private int begin;
        private int end;

        /** Chooses the rows. */
        public Clear rows(int first, int last) {
            begin = first;
            end = last;
            return this;
        }

        @Override
        public <A> A column(String name, A array, int start, int stride) {
            int first = start + stride * begin;
            int last = start + stride * end;
            switch (array) {
                case double[] a -> Arrays.fill(a, first, last, 0);
                case long[] a -> Arrays.fill(a, first, last, 0);
                case int[] a -> Arrays.fill(a, first, last, 0);
                case byte[] a -> Arrays.fill(a, first, last, (byte) 0);
                case boolean[] a -> Arrays.fill(a, first, last, false);
                default -> Arrays.fill((Object[]) array, first, last, null);
            }
            return array;
        }

        @Override
        public int[] room(String name, int[] array) {
            return array;
        }
    }
}
