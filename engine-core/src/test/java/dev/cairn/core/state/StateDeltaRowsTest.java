package dev.cairn.core.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** Rows that keep their order while some leave and others come, and columns of all sorts. */
class StateDeltaRowsTest {
    private static final StateCodecs CODECS = StateCodecs.STANDARD;

    private record Row(int a, int b, double x, double y, byte flag, String name) {}

    /**
     * A table as the stores have them; without rows told if it shall be compared with one that
     * does.
     */
    private static final class Table implements Stateful {
        final List<Row> rows = new ArrayList<>();
        final boolean tells;

        Table(boolean tells) {
            this.tells = tells;
        }

        @Override
        public void state(StateVisitor s) {
            int n = rows.size();
            s.section("table", this);
            if (tells) {
                s.rows(n);
            }
            s.count("count", n);
            int[] a = new int[n];
            int[] b = new int[n];
            double[] xy = new double[2 * n];
            byte[] flag = new byte[n];
            String[] names = new String[n];
            for (int i = 0; i < n; i++) {
                Row row = rows.get(i);
                a[i] = row.a();
                b[i] = row.b();
                xy[2 * i] = row.x();
                xy[2 * i + 1] = row.y();
                flag[i] = row.flag();
                names[i] = row.name();
            }
            s.array("a", a, n);
            s.array("b", b, n);
            s.array("xy", xy, 2 * n);
            s.array("flag", flag, n);
            s.array("names", names, n);
            s.section("end", this);
            s.value("sum", (double) n);
        }

        WorldState save() {
            WorldState state = new WorldState();
            state.save(this);
            return state;
        }
    }

    private static Row row(SplittableRandom random, int keys) {
        return new Row(
                random.nextInt(keys),
                random.nextInt(3),
                random.nextDouble(),
                random.nextInt(5),
                (byte) random.nextInt(),
                "row " + random.nextInt(4));
    }

    private static StateDelta throughBytes(StateDelta delta) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        delta.writeTo(out, CODECS);
        return StateDelta.read(new ByteArrayInputStream(out.toByteArray()), CODECS);
    }

    private static void leads(WorldState before, WorldState after, String what) throws IOException {
        StateDelta delta = StateDelta.between(before, after);
        WorldState moved = new WorldState();
        moved.set(before);
        delta.apply(moved);
        assertNull(moved.difference(after), what + ", forward");
        delta.revert(moved);
        assertNull(moved.difference(before), what + ", back");
        StateDelta read = throughBytes(delta);
        read.apply(moved);
        assertNull(moved.difference(after), what + ", read, forward");
        read.revert(moved);
        assertNull(moved.difference(before), what + ", read, back");
    }

    /**
     * Leave, come at any place, change places, with keys that are alone and keys that several have.
     */
    @Test
    void anyChangeOfRowsLeadsEitherWay() throws IOException {
        for (long seed = 1; seed <= 400; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            int keys = random.nextBoolean() ? 4 : 100_000;
            Table table = new Table(true);
            for (int n = random.nextInt(40); n > 0; n--) {
                table.rows.add(row(random, keys));
            }
            WorldState before = table.save();
            for (int n = random.nextInt(12); n > 0; n--) {
                int size = table.rows.size();
                int at = size == 0 ? 0 : random.nextInt(size);
                switch (size == 0 ? 0 : random.nextInt(5)) {
                    case 0 -> table.rows.add(at, row(random, keys));
                    case 1 -> table.rows.remove(at);
                    case 2 -> table.rows.add(table.rows.remove(at));
                    case 3 -> table.rows.add(row(random, keys));
                    default -> {
                        Row r = table.rows.get(at);
                        table.rows.set(
                                at, new Row(r.a(), r.b(), r.x() + 1, r.y(), r.flag(), r.name()));
                    }
                }
            }
            leads(before, table.save(), "seed " + seed);
        }
    }

    /** Of a thousand rows ten leave and five come: the others cost nothing. */
    @Test
    void rowsThatMoveUpCostNothing() throws IOException {
        long seed = 3;
        long[] bytes = new long[2];
        for (int tells = 0; tells < 2; tells++) {
            SplittableRandom random = new SplittableRandom(seed);
            Table table = new Table(tells == 1);
            for (int i = 0; i < 1000; i++) {
                table.rows.add(row(random, 100_000));
            }
            WorldState before = table.save();
            for (int i = 0; i < 10; i++) {
                table.rows.remove(random.nextInt(table.rows.size()));
            }
            for (int i = 0; i < 5; i++) {
                table.rows.add(row(random, 100_000));
            }
            WorldState after = table.save();
            leads(before, after, "told " + tells);
            bytes[tells] = StateDelta.between(before, after).byteCount();
        }
        // fifteen rows of 26 bytes and a reference of 20, with heads, and where the others went
        assertTrue(bytes[1] < 256 + 15 * 60 + 600, bytes[1] + " bytes");
        assertTrue(bytes[0] > 10 * bytes[1], "without rows told: " + bytes[0]);
    }

    @Test
    void anotherStateIsRefused() {
        Table table = new Table(true);
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < 20; i++) {
            table.rows.add(row(random, 100));
        }
        WorldState before = table.save();
        Row gone = table.rows.remove(4);
        StateDelta delta = StateDelta.between(before, table.save());
        table.rows.add(gone);
        WorldState wrong = table.save();
        WorldState moved = new WorldState();
        moved.set(wrong);
        StateException told = assertThrows(StateException.class, () -> delta.apply(moved));
        assertTrue(told.getMessage().contains("starts from"), told.getMessage());
        assertNull(moved.difference(wrong));
        assertThrows(IllegalStateException.class, () -> new WorldState().save(s -> s.rows(3)));
    }

    /** Columns that grow by steps, repeat, have holes of zeros, come and go; of any length. */
    @Test
    void columnsOfAllSorts() throws IOException {
        for (long seed = 1; seed <= 300; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            int[] lengths = random.ints(12, 0, 60).toArray();
            WorldState before = numbers(random, lengths, random.nextInt(13));
            for (int i = 0; i < lengths.length; i++) {
                lengths[i] += random.nextInt(4) == 0 ? random.nextInt(40) : 0;
            }
            leads(before, numbers(random, lengths, random.nextInt(13)), "seed " + seed);
            leads(numbers(random, lengths, 12), before, "seed " + seed + ", shorter");
        }
    }

    private static WorldState numbers(SplittableRandom random, int[] lengths, int without) {
        WorldState state = new WorldState();
        state.save(s -> {
            for (int c = 0; c < lengths.length; c++) {
                if (c != without) {
                    s.array("column " + c, column(random, lengths[c]), lengths[c]);
                }
            }
        });
        return state;
    }

    private static Object column(SplittableRandom random, int length) {
        long start = random.nextLong();
        long step = random.nextInt(3) == 0 ? 0 : random.nextLong() >>> random.nextInt(64);
        long mask = random.nextLong() & random.nextLong();
        long[] values = new long[length];
        int sort = random.nextInt(4);
        for (int i = 0; i < length; i++) {
            values[i] =
                    switch (sort) {
                        case 0 -> start + i * step;
                        case 1 -> random.nextLong() & mask;
                        case 2 -> random.nextInt(9) == 0 ? random.nextLong() : 0;
                        default -> (byte) i;
                    };
        }
        return switch (random.nextInt(3)) {
            case 0 -> values;
            case 1 -> Arrays.stream(values).mapToInt(v -> (int) v).toArray();
            default -> Arrays.stream(values).mapToDouble(Double::longBitsToDouble).toArray();
        };
    }

    /** A list of slots that goes as a whole: equal numbers, and ones that count up. */
    @Test
    void whatGrowsByTheSameStepIsToldOnce() {
        int[] up = new int[2000];
        int[] same = new int[2000];
        Arrays.setAll(up, i -> 3 * i + 7);
        Arrays.fill(same, -1);
        WorldState full = new WorldState();
        WorldState empty = new WorldState();
        full.save(s -> lists(s, up, same, 2000));
        empty.save(s -> lists(s, up, same, 0));
        StateDelta delta = StateDelta.between(full, empty);
        assertTrue(delta.byteCount() < 400, delta.byteCount() + " bytes");
        WorldState moved = new WorldState();
        moved.set(empty);
        delta.revert(moved);
        assertEquals(0, StateDelta.between(moved, full).words.headLength);
    }

    private static void lists(StateVisitor s, int[] up, int[] same, int count) {
        s.array("up", up, count);
        s.array("same", same, count);
    }
}
