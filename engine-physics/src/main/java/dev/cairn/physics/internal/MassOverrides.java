package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;

import java.util.Arrays;

/** {@link MassOverride} by body. Simulation thread; allocates when it grows. */
public final class MassOverrides {
    private static final int STRIDE = 10;

    /** Empty until a body is given something. */
    private double[] numbers = {};

    private int slots;
    private boolean isUsed;

    /** Of no body. */
    public MassOverrides() {}

    /**
     * Makes room.
     *
     * @param wanted slots of bodies
     */
    public void ensureSlots(int wanted) {
        slots = Math.max(slots, wanted);
        if (isUsed && numbers.length < STRIDE * slots) {
            numbers = Arrays.copyOf(numbers, STRIDE * slots);
        }
    }

    /**
     * What was given of a body.
     *
     * @param body its slot
     * @return what was {@link #set}
     */
    public MassOverride get(int body) {
        if (!isUsed) {
            return MassOverride.NONE;
        }
        double[] n = numbers;
        int k = STRIDE * body;
        return new MassOverride(
                n[k], n[k + 1], n[k + 2], n[k + 3], n[k + 4], n[k + 5], n[k + 6], n[k + 7],
                n[k + 8], n[k + 9]);
    }

    /**
     * Gives a body something else.
     *
     * @param body its slot
     * @param m all of it
     */
    public void set(int body, MassOverride m) {
        if (!isUsed) {
            if (m.equals(MassOverride.NONE)) {
                return;
            }
            isUsed = true;
            ensureSlots(slots);
            for (int i = 0; i < slots; i++) {
                set(i, MassOverride.NONE);
            }
        }
        int k = STRIDE * body;
        numbers[k] = m.kilograms();
        numbers[k + 1] = m.xx();
        numbers[k + 2] = m.yy();
        numbers[k + 3] = m.zz();
        numbers[k + 4] = m.xy();
        numbers[k + 5] = m.xz();
        numbers[k + 6] = m.yz();
        numbers[k + 7] = m.x();
        numbers[k + 8] = m.y();
        numbers[k + 9] = m.z();
    }

    /**
     * Saves or restores all.
     *
     * @param s saves or restores
     * @param count slots in use
     */
    public void state(StateVisitor s, int count) {
        s.section("massOverrides", this);
        isUsed = s.value("isUsed", isUsed);
        numbers = s.array("numbers", numbers, isUsed ? STRIDE * count : 0);
        ensureSlots(count);
    }
}
