package dev.cairn.render.gl;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.DebugData;

import java.util.Arrays;

/**
 * Colours that bodies take in place of their own, to tell what the engine knows of them. Filling
 * again allocates only while the numbers of bodies and rows grow. GL thread.
 */
public final class Tints {
    /** What the colours tell. */
    public enum Kind {
        /** Nothing: all have their own. */
        NONE,
        /** Who sleeps. */
        SLEEP,
        /** Who hangs together by contacts. */
        ISLAND,
        /** How fast the centre of mass is: white at {@link #MIDDLE_SPEED}. */
        SPEED,
        /** How hard contacts push, by the one that is pushed most. */
        LOAD
    }

    /** Half way from the colour of rest to that of great speed, m/s. */
    public static final double MIDDLE_SPEED = 3;

    private static final int ASLEEP = 0x5C6BC0;
    private static final int COLD = 0x3B4CC0;
    private static final int MIDDLE = 0xDDDDDD;
    private static final int HOT = 0xB40426;
    private static final int NONE = -1;

    private int[] colours = new int[64];
    private double[] loads = new double[64];

    /** Entity to body: open addressing, the number of the body plus one. */
    private int[] table = new int[128];

    /** Per row of the snapshot, 0xRRGGBB + 1; 0 where the body keeps its own colour. */
    private float[] rows = new float[64];

    Tints() {}

    /**
     * Finds the colours of a snapshot's rows.
     *
     * @param snapshot with the debug data in its extra; else nothing is tinted
     * @param kind what they tell
     * @return per row, 0xRRGGBB + 1, or 0; valid until the next call
     */
    float[] of(PoseSnapshot snapshot, Kind kind) {
        int size = snapshot.size();
        if (rows.length < size) {
            rows = new float[2 * size];
        }
        Arrays.fill(rows, 0, size, 0);
        if (kind == Kind.NONE || !(snapshot.extra() instanceof DebugData data)) {
            return rows;
        }
        fill(data, kind);
        index(data);
        long[] entities = data.entities();
        for (int row = 0; row < size; row++) {
            int body = find(entities, snapshot.entity(row));
            if (body != NONE && colours[body] != NONE) {
                rows[row] = colours[body] + 1;
            }
        }
        return rows;
    }

    private void fill(DebugData data, Kind kind) {
        int count = data.bodyCount();
        if (colours.length < count) {
            colours = new int[2 * count];
            loads = new double[2 * count];
        }
        double most = kind == Kind.LOAD ? sumLoads(data) : 0;
        for (int i = 0; i < count; i++) {
            boolean moves = data.states()[i] != DebugData.FIXED;
            colours[i] =
                    switch (kind) {
                        case SLEEP -> data.states()[i] == DebugData.ASLEEP ? ASLEEP : NONE;
                        case ISLAND -> {
                            int island = data.islands()[i];
                            yield island == DebugData.NONE ? NONE : distinct(island);
                        }
                        case SPEED -> moves ? ramp(speedShare(data.velocities(), 3 * i)) : NONE;
                        case LOAD -> moves ? ramp(most > 0 ? loads[i] / most : 0) : NONE;
                        default -> NONE;
                    };
        }
    }

    private static double speedShare(double[] v, int at) {
        double speed = Math.sqrt(v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2]);
        return speed / (speed + MIDDLE_SPEED);
    }

    private double sumLoads(DebugData data) {
        Arrays.fill(loads, 0, data.bodyCount(), 0);
        for (int p = 0; p < data.pointCount(); p++) {
            for (int end = 0; end < 2; end++) {
                int body = end == 0 ? data.firstBodies()[p] : data.secondBodies()[p];
                if (body != DebugData.NONE) {
                    loads[body] += data.impulses()[p];
                }
            }
        }
        double most = 0;
        for (int i = 0; i < data.bodyCount(); i++) {
            most = Math.max(most, data.states()[i] == DebugData.FIXED ? 0 : loads[i]);
        }
        return most;
    }

    private void index(DebugData data) {
        int count = data.bodyCount();
        if (table.length < 2 * count) {
            table = new int[Integer.highestOneBit(2 * count) * 2];
        }
        Arrays.fill(table, 0);
        long[] entities = data.entities();
        for (int i = 0; i < count; i++) {
            int at = place(entities[i]);
            while (table[at] != 0) {
                at = (at + 1) & (table.length - 1);
            }
            table[at] = i + 1;
        }
    }

    private int find(long[] entities, long entity) {
        for (int at = place(entity); table[at] != 0; at = (at + 1) & (table.length - 1)) {
            if (entities[table[at] - 1] == entity) {
                return table[at] - 1;
            }
        }
        return NONE;
    }

    private int place(long entity) {
        return (int) ((entity * 0x9E3779B97F4A7C15L) >>> 40) & (table.length - 1);
    }

    /**
     * From cold over white to hot (Moreland, "Diverging color maps", 2009, its ends and middle).
     */
    static int ramp(double share) {
        double t = 2 * Math.clamp(share, 0.0, 1.0);
        return t < 1 ? mix(COLD, MIDDLE, t) : mix(MIDDLE, HOT, t - 1);
    }

    private static int mix(int a, int b, double t) {
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double from = a >> shift & 255;
            rgb |= (int) Math.round(from + t * ((b >> shift & 255) - from)) << shift;
        }
        return rgb;
    }

    /**
     * Colours that differ from their neighbours': hues a golden angle apart.
     *
     * @param index any number at least 0
     * @return 0xRRGGBB in sRGB
     */
    public static int distinct(int index) {
        double hue = 6 * (index * 0.618033988749895 % 1);
        int rgb = 0;
        for (int channel = 0; channel < 3; channel++) {
            // Distance of the hue to the channel's own, round a circle of six.
            double away = Math.abs((hue - 2 * channel + 9) % 6 - 3);
            double share = Math.clamp(2 - away, 0.0, 1.0);
            rgb = rgb << 8 | (int) Math.round(64 + 191 * share);
        }
        return rgb;
    }
}
