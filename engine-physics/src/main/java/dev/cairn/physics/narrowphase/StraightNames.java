package dev.cairn.physics.narrowphase;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.SECOND_WAYS;

import java.util.Arrays;

/**
 * The names of the four points that one side of a face, or two beside each other, leave of another
 * box's face when each cuts two neighbouring corners off: a table of all pairs of faces and ways of
 * {@link dev.cairn.physics.narrowphase.wide.BoxBatch#STRAIGHT}. Filled by cutting loops of names as
 * {@link Clipper} does.
 */
final class StraightNames {
    /** Ways in which the first side can cut. */
    private static final int FIRST_WAYS = 16;

    private static final int WAYS = 2 * 36 * FIRST_WAYS * SECOND_WAYS;

    /** Four to an entry, ascending as unsigned numbers. */
    private static final int[] NAME = new int[4 * WAYS];

    /** Where each of the four stands in the columns: two bits, the first one lowest. */
    private static final byte[] ORDER = new byte[WAYS];

    /** The four as a word, see {@link Names}. */
    private static final int[] NAMES = new int[WAYS];

    static {
        Loop loop = new Loop();
        for (int faces = 0; faces < 72; faces++) {
            boolean flip = faces >= 36;
            int begin = 4 * (faces / 6 % 6);
            int incident = 4 * (faces % 6);
            for (int first = 0; first < FIRST_WAYS; first++) {
                for (int second = 0; second < SECOND_WAYS; second++) {
                    loop.begin(flip, begin, incident);
                    loop.cut(first & 3, BoxCuts.SIDE_SLOT[begin + (first >> 2)]);
                    if (second > 0) {
                        int other = ((first >> 3) ^ 1) << 1;
                        int low = (second - 1) >> 2;
                        loop.cut((second - 1) & 3, BoxCuts.SIDE_SLOT[begin + other + low]);
                    }
                    fill((faces * FIRST_WAYS + first) * SECOND_WAYS + second, loop.name);
                }
            }
        }
    }

    private StraightNames() {}

    private static void fill(int entry, int[] loop) {
        // In the columns: stays, stays again, leaves, enters.
        long[] sorted = new long[4];
        for (int k = 0; k < 4; k++) {
            int place = k == 0 ? 0 : k == 1 ? 2 : k == 2 ? 3 : 1;
            sorted[k] = (loop[k] & 0xFFFFFFFFL) << 2 | place;
        }
        Arrays.sort(sorted);
        Manifold names = new Manifold();
        names.pointCount = 4;
        for (int k = 0; k < 4; k++) {
            NAME[4 * entry + k] = (int) (sorted[k] >> 2);
            names.feature[k] = NAME[4 * entry + k];
            ORDER[entry] |= (byte) ((sorted[k] & 3) << (2 * k));
        }
        NAMES[entry] = Names.of(names);
    }

    /** The entry of a way to cut a face, with the other box's face. */
    static int entry(boolean flip, int face, int incident, int way) {
        int faces = (flip ? 36 : 0) + 6 * face + incident;
        return faces * (FIRST_WAYS * SECOND_WAYS) + way;
    }

    /** The name of a point, 0 to 3 in order. */
    static int name(int entry, int point) {
        return NAME[4 * entry + point];
    }

    /** Where the points stand in the columns: two bits each, the first one lowest. */
    static int order(int entry) {
        return ORDER[entry];
    }

    /** The four as a word, see {@link Names}. */
    static int names(int entry) {
        return NAMES[entry];
    }

    /** The names of four corners and of what the sides between them came from. */
    private static final class Loop {
        final int[] name = new int[4], side = new int[4];
        boolean flip;
        int begin;

        void begin(boolean flipped, int face, int incident) {
            flip = flipped;
            begin = face;
            int kind = flip ? Clipper.VERTEX_A : Clipper.VERTEX_B;
            for (int k = 0; k < 4; k++) {
                name[k] = kind | BoxCuts.SLOT_VERTEX[incident + k];
                side[k] = BoxCuts.SLOT_EDGE[incident + k];
            }
        }

        /** Cuts off the two corners after one; the loop then begins there. */
        void cut(int stays, int slot) {
            int enters = (stays + 2) & 3;
            int back = (stays + 3) & 3;
            int[] names = {
                name[stays],
                BoxCuts.name(flip, side[stays], slot, begin),
                BoxCuts.name(flip, side[enters], slot, begin),
                name[back]
            };
            int[] sides = {side[stays], ~slot, side[enters], side[back]};
            System.arraycopy(names, 0, name, 0, 4);
            System.arraycopy(sides, 0, side, 0, 4);
        }
    }
}
