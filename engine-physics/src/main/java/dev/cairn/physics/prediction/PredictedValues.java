package dev.cairn.physics.prediction;

import dev.cairn.core.state.StateColumns;

/** Numbers that are guessed. */
final class PredictedValues {
    private PredictedValues() {}

    /**
     * Puts in the place of a number how far a guess is off, or finds the number again: by the
     * difference of their bits, small numbers for bits that are near, of either sign.
     *
     * @param column of the number
     * @param i its place there
     * @param guess from numbers that are in their places when it is packed and unpacked
     * @return the number
     */
    static double next(StateColumns state, int column, int i, double guess, boolean packs) {
        long predicted = Double.doubleToRawLongBits(guess);
        long bits = state.bits(column, i);
        if (packs) {
            long d = bits - predicted;
            state.set(column, i, (d << 1) ^ (d >> 63));
            return Double.longBitsToDouble(bits);
        }
        long number = predicted + ((bits >>> 1) ^ -(bits & 1));
        state.set(column, i, number);
        return Double.longBitsToDouble(number);
    }
}
