package dev.cairn.render.ui;

import java.util.Arrays;
import java.util.Objects;

/**
 * Text that is made anew in each frame without garbage: numbers are written into characters that
 * stay. One thread; {@link Ui} has read it when its call returns.
 *
 * <pre>{@code
 * ui.value("time", text.clear().put(seconds, 2).put(" s, tick ").put(tick));
 * }</pre>
 */
public final class TextBuffer implements CharSequence {
    private static final int MOST_DECIMALS = 9;
    private static final long[] TEN = new long[19];

    static {
        TEN[0] = 1;
        for (int i = 1; i < TEN.length; i++) {
            TEN[i] = 10 * TEN[i - 1];
        }
    }

    private char[] letters = new char[64];
    private int length;

    /** No text. */
    public TextBuffer() {}

    /**
     * Forgets the text.
     *
     * @return this
     */
    public TextBuffer clear() {
        length = 0;
        return this;
    }

    /**
     * Adds text.
     *
     * @param text letters
     * @return this
     */
    public TextBuffer put(CharSequence text) {
        for (int i = 0; i < text.length(); i++) {
            put(text.charAt(i));
        }
        return this;
    }

    /**
     * Adds a letter.
     *
     * @param letter which
     * @return this
     */
    public TextBuffer put(char letter) {
        if (length == letters.length) {
            letters = Arrays.copyOf(letters, 2 * length);
        }
        letters[length++] = letter;
        return this;
    }

    /**
     * Adds a whole number.
     *
     * @param value any
     * @return this
     */
    public TextBuffer put(long value) {
        if (value < 0) {
            put('-');
        }
        int digits = 1;
        for (long rest = value / 10; rest != 0; rest /= 10) {
            digits++;
        }
        long rest = value;
        for (int i = 0; i < digits; i++) {
            put('0');
        }
        for (int i = 1; i <= digits; i++) {
            letters[length - i] = (char) ('0' + Math.abs(rest % 10));
            rest /= 10;
        }
        return this;
    }

    /**
     * Adds a number with a fixed count of decimals, as {@code %.2f} does; where its digits do not
     * fit into a {@code long}, with a power of ten.
     *
     * @param value any; NaN and infinities in words
     * @param decimals 0..9
     * @return this
     */
    public TextBuffer put(double value, int decimals) {
        if (decimals < 0 || decimals > MOST_DECIMALS) {
            throw new IllegalArgumentException(
                    "decimals is " + decimals + ", expected 0.." + MOST_DECIMALS);
        }
        if (!Double.isFinite(value)) {
            return notFinite(value);
        }
        double size = Math.abs(value) * TEN[decimals];
        if (size >= 1e15) {
            return putPower(value, 4);
        }
        long scaled = Math.round(size);
        if (value < 0 && scaled > 0) {
            put('-');
        }
        put(scaled / TEN[decimals]);
        if (decimals > 0) {
            put('.');
            long fraction = scaled % TEN[decimals];
            for (int i = decimals - 1; i >= 0; i--) {
                put((char) ('0' + fraction / TEN[i] % 10));
            }
        }
        return this;
    }

    /**
     * Adds a number with so many significant digits, as {@code %.4g} does: with a power of ten from
     * {@code 10^digits} up and below 1e-4.
     *
     * @param value any; NaN and infinities in words
     * @param digits 1..9
     * @return this
     */
    public TextBuffer putDigits(double value, int digits) {
        if (digits < 1 || digits > MOST_DECIMALS) {
            throw new IllegalArgumentException(
                    "digits is " + digits + ", expected 1.." + MOST_DECIMALS);
        }
        if (!Double.isFinite(value)) {
            return notFinite(value);
        }
        double size = Math.abs(value);
        if (size == 0) {
            return put(0.0, digits - 1);
        }
        if (size < 1e-4 || size >= TEN[digits]) {
            return putPower(value, digits);
        }
        int exponent = (int) Math.floor(Math.log10(size));
        int decimals = digits - 1 - exponent;
        if (Math.round(size * TEN[Math.clamp(decimals, 0, 18)]) >= TEN[digits]) {
            decimals--; // 9.9996 is 10.00
        }
        if (decimals < 0) {
            return putPower(value, digits);
        }
        return decimals > MOST_DECIMALS ? putPower(value, digits) : put(value, decimals);
    }

    private TextBuffer putPower(double value, int digits) {
        double size = Math.abs(value);
        int exponent = (int) Math.floor(Math.log10(size));
        double mantissa = size / Math.pow(10, exponent);
        if (Double.isInfinite(mantissa)) {
            // 10^-324 is no double.
            mantissa = size * 1e300 / Math.pow(10, exponent + 300);
        }
        if (Math.round(mantissa * TEN[digits - 1]) >= TEN[digits]) {
            mantissa /= 10;
            exponent++;
        }
        put(value < 0 ? -mantissa : mantissa, digits - 1);
        put('e').put(exponent < 0 ? '-' : '+');
        int power = Math.abs(exponent);
        if (power < 10) {
            put('0');
        }
        return put(power);
    }

    private TextBuffer notFinite(double value) {
        return put(Double.isNaN(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity");
    }

    @Override
    public int length() {
        return length;
    }

    @Override
    public char charAt(int index) {
        return letters[Objects.checkIndex(index, length)];
    }

    @Override
    public CharSequence subSequence(int start, int end) {
        return toString().subSequence(start, end);
    }

    @Override
    public String toString() {
        return new String(letters, 0, length);
    }
}
