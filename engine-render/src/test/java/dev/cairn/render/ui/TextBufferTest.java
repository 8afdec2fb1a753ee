package dev.cairn.render.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import java.util.SplittableRandom;

/** Numbers as {@code String.format} writes them, without garbage. */
class TextBufferTest {
    private final TextBuffer text = new TextBuffer();

    private static double any(SplittableRandom random) {
        return Math.pow(10, random.nextInt(-12, 11)) * random.nextDouble(-10, 10);
    }

    @Test
    void numbersAreWrittenAsFormatWritesThem() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 20_000; i++) {
            double value = any(random);
            for (int decimals = 0; decimals <= 3; decimals++) {
                String format = String.format(Locale.ROOT, "%." + decimals + "f", value);
                // A zero has no sign here.
                String wanted = format.matches("-0(\\.0*)?") ? format.substring(1) : format;
                assertEquals(wanted, text.clear().put(value, decimals).toString(), "" + value);
            }
            assertEquals(
                    String.format(Locale.ROOT, "%.4g", value),
                    text.clear().putDigits(value, 4).toString(),
                    "" + value);
            assertEquals(Long.toString((long) value), text.clear().put((long) value).toString());
        }
    }

    @Test
    void theEndsOfTheRangesAreWritten() {
        assertEquals("" + Long.MIN_VALUE, text.clear().put(Long.MIN_VALUE).toString());
        assertEquals("0.000", text.clear().putDigits(0, 4).toString());
        assertEquals("10.00", text.clear().putDigits(9.9999, 4).toString());
        assertEquals("1.000e+04", text.clear().putDigits(9999.9, 4).toString());
        assertEquals("1.000e-05", text.clear().putDigits(9.9999e-6, 4).toString());
        // 4.94065e-324; format pads the shortest decimal, 4.9e-324, with zeros.
        assertEquals("4.941e-324", text.clear().putDigits(Double.MIN_VALUE, 4).toString());
        assertEquals("1.798e+308", text.clear().putDigits(Double.MAX_VALUE, 4).toString());
        assertEquals("NaN", text.clear().put(Double.NaN, 2).toString());
        assertEquals("-Infinity", text.clear().putDigits(Double.NEGATIVE_INFINITY, 2).toString());
        assertEquals("a7b", text.clear().put("a").put(7).put('b').toString());
        assertThrows(IllegalArgumentException.class, () -> text.put(1.0, 10));
        assertThrows(IllegalArgumentException.class, () -> text.putDigits(1.0, 0));
    }

    @Test
    void writingAllocatesNothing() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 100; i++) {
                text.clear().put("t ").put(i * 0.37, 2).put(i).putDigits(1e-7 * i, 4);
            }
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertEquals(0, least);
    }
}
