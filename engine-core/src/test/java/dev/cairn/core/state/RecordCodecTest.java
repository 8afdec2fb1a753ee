package dev.cairn.core.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;

/** Records by their components: there and back, damaged, and of another version. */
class RecordCodecTest {
    private static final Frame FRAME = new Frame("CAIRNRT1", "record");

    enum Season {
        SPRING,
        SUMMER {
            @Override
            public String toString() {
                return "warm";
            }
        },
        AUTUMN
    }

    record Place(double x, float y, Season season) {}

    record Whole(
            boolean flag,
            byte small,
            short medium,
            char letter,
            int number,
            long large,
            float single,
            double exact,
            String text,
            Season season,
            Place place) {}

    record Arrays8(
            boolean[] a, byte[] b, short[] c, char[] d, int[] e, long[] f, float[] g, double[] h) {}

    record Positive(int value) {
        Positive {
            if (value <= 0) {
                throw new IllegalArgumentException("value is " + value + ", but must be above 0");
            }
        }
    }

    /** Of the same name in two versions of a program. */
    static final class One {
        record Leaf(float x, int age, Place at) {}
    }

    static final class Two {
        record Leaf(float x, long age, Place at) {}
    }

    private static final StateCodecs CODECS =
            StateCodecs.STANDARD.derived(Whole.class, Arrays8.class, Positive.class);

    private static byte[] bytes(StateCodecs codecs, Object... values) {
        ByteArrayOutputStream to = new ByteArrayOutputStream();
        try {
            FRAME.write(
                    to,
                    codecs,
                    out -> {
                        for (Object value : values) {
                            out.writeObject(value);
                        }
                    });
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return to.toByteArray();
    }

    private static Object read(StateCodecs codecs, byte[] bytes) {
        try {
            return FRAME.read(
                    new ByteArrayInputStream(bytes), codecs, in -> in.readObject(Object.class));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    private static String text(SplittableRandom random) {
        StringBuilder text = new StringBuilder();
        for (int i = random.nextInt(6); i > 0; i--) {
            int kind = random.nextInt(4);
            text.appendCodePoint(
                    kind == 0
                            ? random.nextInt(128)
                            : kind == 1 ? random.nextInt(0x10000, 0x110000) : 0xC0 + kind * 999);
        }
        return text.toString();
    }

    private static Season season(SplittableRandom random) {
        return Season.values()[random.nextInt(3)];
    }

    private static double any(SplittableRandom random) {
        double[] special = {0, -0.0, Double.NaN, Double.NEGATIVE_INFINITY, Double.MIN_VALUE, 1.5};
        int i = random.nextInt(12);
        return i < special.length ? special[i] : random.nextDouble(-9, 9);
    }

    private static Whole whole(SplittableRandom random) {
        return new Whole(
                random.nextBoolean(),
                (byte) random.nextInt(),
                (short) random.nextInt(),
                (char) random.nextInt(),
                random.nextInt(),
                random.nextLong(),
                (float) any(random),
                any(random),
                random.nextInt(5) == 0 ? null : text(random),
                random.nextInt(5) == 0 ? null : season(random),
                random.nextInt(3) == 0
                        ? null
                        : new Place(any(random), random.nextInt(), season(random)));
    }

    @Test
    void recordsComeBackEqual() {
        long seed = 29_02;
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 2000; i++) {
            Whole whole = whole(random);
            byte[] bytes = bytes(CODECS, whole);
            assertEquals(whole, read(CODECS, bytes), "seed " + seed + " record " + i);
            assertArrayEquals(bytes, bytes(CODECS, read(CODECS, bytes)), "written again");
        }
    }

    private static Arrays8 arrays(SplittableRandom random) {
        int n = random.nextInt(5);
        Arrays8 all =
                new Arrays8(
                        new boolean[n],
                        new byte[n],
                        new short[n],
                        random.nextBoolean() ? null : new char[] {'\uD800', 'x'},
                        random.ints(n).toArray(),
                        random.longs(n).toArray(),
                        new float[n],
                        random.doubles(n).toArray());
        for (int i = 0; i < n; i++) {
            all.a[i] = random.nextBoolean();
            all.b[i] = (byte) random.nextInt();
            all.c[i] = (short) random.nextInt();
            all.g[i] = (float) any(random);
        }
        return all;
    }

    @Test
    void arraysComeBackEqual() {
        long seed = 29_03;
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 1000; i++) {
            Arrays8 sent = arrays(random);
            Arrays8 came = (Arrays8) read(CODECS, bytes(CODECS, sent));
            assertTrue(
                    Arrays.deepEquals(
                            new Object[] {
                                sent.a, sent.b, sent.c, sent.d, sent.e, sent.f, sent.g, sent.h
                            },
                            new Object[] {
                                came.a, came.b, came.c, came.d, came.e, came.f, came.g, came.h
                            }),
                    "seed " + seed + " record " + i);
        }
        StateCodecs more = StateCodecs.STANDARD.derived(long[].class, Season.class);
        assertArrayEquals(
                new long[] {3, -1}, (long[]) read(more, bytes(more, (Object) new long[] {3, -1})));
        assertEquals(Season.SUMMER, read(more, bytes(more, Season.SUMMER)));
    }

    /** Names and types are there once, whatever the number of records. */
    @Test
    void manyRecordsAreShort() {
        Object[] places = new Object[1000];
        Arrays.setAll(places, i -> new Place(i, i, Season.AUTUMN));
        StateCodecs codecs = StateCodecs.STANDARD.derived(Place.class);
        int length = bytes(codecs, places).length;
        String name = Place.class.getName();
        // Of each: its number, length, the codec's name, the version's number, the components.
        int each = 4 + 4 + (4 + name.length()) + 4 + (8 + 4 + 1 + 4 + "AUTUMN".length());
        assertTrue(length < 1000 * each + 500, length + " bytes, " + each + " each");
    }

    static void sign(byte[] bytes) {
        CRC32C castagnoli = new CRC32C();
        castagnoli.update(bytes, 16, bytes.length - 24);
        CRC32 other = new CRC32();
        other.update(bytes, 16, bytes.length - 24);
        ByteBuffer.wrap(bytes)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putLong(8, bytes.length - 24)
                .putLong(bytes.length - 8, castagnoli.getValue() << 32 | other.getValue());
    }

    private static byte[] mutated(byte[] original, SplittableRandom random, boolean forged) {
        int to = original.length - (forged ? 8 : 0);
        int from = forged ? 16 + random.nextInt(2) * Math.max(0, to - 100) : 0; // or the values
        byte[] bytes = original.clone();
        if (random.nextInt(4) == 0) { // cut out
            int a = random.nextInt(from, to);
            int b = random.nextInt(a, to);
            bytes = new byte[original.length - (b - a)];
            System.arraycopy(original, 0, bytes, 0, a);
            System.arraycopy(original, b, bytes, a, original.length - b);
        } else {
            for (int i = random.nextInt(1, 4); i > 0; i--) {
                bytes[random.nextInt(from, to)] = (byte) random.nextInt();
            }
        }
        if (forged) {
            sign(bytes);
        }
        return bytes;
    }

    /**
     * Damaged bytes are refused, or nothing was changed by it. With sums made to fit they are
     * refused with a message or give a record that is written and read as any other; in bounded
     * memory.
     */
    @Test
    void damagedBytesAreRefused() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long seed = 29_04;
        SplittableRandom random = new SplittableRandom(seed);
        int refused = 0;
        int read = 0;
        for (int i = 0; i < 6000; i++) {
            Object sent = i % 2 == 0 ? whole(random) : arrays(random);
            byte[] original = bytes(CODECS, sent);
            boolean forged = i % 3 != 0;
            byte[] bytes = mutated(original, random, forged);
            long before = threads.getCurrentThreadAllocatedBytes();
            try {
                Object came = read(CODECS, bytes);
                if (forged) {
                    byte[] again = bytes(CODECS, came);
                    assertArrayEquals(again, bytes(CODECS, read(CODECS, again)), "seed " + seed);
                    read++;
                } else {
                    assertArrayEquals(original, bytes(CODECS, came));
                }
            } catch (StateException refusal) {
                assertNotNull(refusal.getMessage());
                assertTrue(refusal.getMessage().length() > 20, refusal.getMessage());
                refused++;
            }
            long bytesUsed = threads.getCurrentThreadAllocatedBytes() - before;
            assertTrue(bytesUsed < 1_000_000, "seed " + seed + " took " + bytesUsed + " bytes");
        }
        assertTrue(refused > 3000 && read > 200, refused + " refused, " + read + " read");
    }

    private static StateCodecs named(Class<? extends Record> type, String name) {
        return StateCodecs.STANDARD.with(renamed(StateCodec.ofRecord(type), name));
    }

    private static <T> StateCodec<T> renamed(StateCodec<T> codec, String name) {
        return StateCodec.of(codec.type(), name, codec::write, codec::read);
    }

    @Test
    void anotherVersionIsToldByName() {
        byte[] bytes =
                bytes(
                        named(One.Leaf.class, "Leaf"),
                        new One.Leaf(1, 2, new Place(3, 4, Season.SPRING)));
        refused(bytes, named(Two.Leaf.class, "Leaf"), "Leaf", "'age' (int) is a long now");
        record Short(float x, int age) {}
        refused(bytes, named(Short.class, "Leaf"), "'at'", "is not there any more");
        record Long(float x, int age, Place at, String more) {}
        refused(bytes, named(Long.class, "Leaf"), "'more' (String) is new");
        record Turned(int age, float x, Place at) {}
        refused(bytes, named(Turned.class, "Leaf"), "another order");
        refused(bytes, StateCodecs.STANDARD, "no codec has this name", "Leaf");
    }

    private static void refused(byte[] bytes, StateCodecs codecs, String... words) {
        String message = assertThrows(StateException.class, () -> read(codecs, bytes)).getMessage();
        for (String word : words) {
            assertTrue(message.contains(word), message);
        }
    }

    /** What is wrong is told with component and type. */
    @Test
    void refusalsName() {
        record Loop(int a, Loop next) {}
        record Box(List<String> inside) {}
        record Outer(Box box) {}
        for (var each :
                List.of(
                        List.of(Loop.class, "'next'", "without an end"),
                        List.of(Box.class, "'inside' (java.util.List)", "StateCodec.of"),
                        List.of(Outer.class, "'inside'", "Box"))) {
            Class<? extends Record> type = ((Class<?>) each.get(0)).asSubclass(Record.class);
            String message =
                    assertThrows(IllegalArgumentException.class, () -> StateCodec.ofRecord(type))
                            .getMessage();
            assertTrue(message.contains((String) each.get(1)), message);
            assertTrue(message.contains((String) each.get(2)), message);
        }
        StateException none =
                assertThrows(StateException.class, () -> bytes(CODECS, new Place(1, 2, null)));
        assertTrue(none.getMessage().contains("StateCodec.ofRecord"), none.getMessage());
        byte[] bytes = bytes(CODECS, new Positive(7));
        for (int i = bytes.length - 1; i > 0; i--) {
            if (bytes[i] == 7) {
                bytes[i] = 0;
                break;
            }
        }
        sign(bytes);
        refused(bytes, CODECS, "Positive", "value is 0", "refuses");
        Whole half = new Whole(true, (byte) 1, (short) 2, 'a', 3, 4, 5, 6, "x\uD800", null, null);
        StateException pair =
                assertThrows(StateException.class, () -> bytes(CODECS, half), "half a pair");
        assertTrue(pair.getMessage().contains("component 'text' (String)"), pair.getMessage());
        assertTrue(pair.getMessage().contains("0xd800"), pair.getMessage());
    }
}
