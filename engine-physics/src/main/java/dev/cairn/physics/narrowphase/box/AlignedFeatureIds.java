package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.WAYS;

import dev.cairn.physics.narrowphase.pair.BoxTopology;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.narrowphase.wide.BoxBatch;

import java.util.Arrays;

/**
 * The feature ids of the four points of a box's face that is clipped to a quadrilateral: by no side
 * of another box's face, or by one that cuts two neighbouring corners off. A table of all
 * {@linkplain BoxBatch#entry pairs of faces and ways}, filled by clipping loops of ids as {@code
 * Clipper} does.
 */
final class AlignedFeatureIds {
    private static final int FACES = 72;

    /** Four to an entry, ascending as unsigned numbers. */
    private static final int[] NAME = new int[4 * FACES * WAYS];

    /** Where each of the four stands in the columns: two bits, the first one lowest. */
    private static final byte[] ORDER = new byte[FACES * WAYS];

    /** The face and the four names, see {@link WarmStartKey}. */
    private static final long[] KEY = new long[FACES * WAYS];

    static {
        Loop loop = new Loop();
        for (int faces = 0; faces < FACES; faces++) {
            boolean flip = faces >= 36;
            int face = faces / 6 % 6;
            int incident = faces % 6;
            for (int way = 0; way < WAYS; way++) {
                loop.begin(flip, 4 * face, 4 * incident);
                if (way > 0) {
                    loop.cut(way - 1);
                }
                fill(BoxBatch.entry(flip, face, incident, way), flip, face, loop);
            }
        }
    }

    private AlignedFeatureIds() {}

    private static void fill(int entry, boolean flip, int face, Loop loop) {
        long[] sorted = new long[4];
        for (int k = 0; k < 4; k++) {
            sorted[k] = (loop.name[k] & 0xFFFFFFFFL) << 2 | loop.place[k];
        }
        Arrays.sort(sorted);
        Manifold names = new Manifold();
        names.pointCount = 4;
        for (int k = 0; k < 4; k++) {
            NAME[4 * entry + k] = (int) (sorted[k] >> 2);
            names.feature[k] = NAME[4 * entry + k];
            ORDER[entry] |= (byte) ((sorted[k] & 3) << (2 * k));
        }
        long kind = flip ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
        KEY[entry] = WarmStartKey.of(kind, face, FeatureIds.of(names));
    }

    /** The name of a point, 0 to 3 in order. */
    static int name(int entry, int point) {
        return NAME[4 * entry + point];
    }

    /** Where the points stand in the columns: two bits each, the first one lowest. */
    static int order(int entry) {
        return ORDER[entry];
    }

    /**
     * Whether the names of the last tick were these four. No other name of a pair of boxes has one
     * of their bytes, so it was none of the corners that were cut off.
     *
     * @param last see {@link FeatureIds}
     */
    static boolean rests(int entry, int last) {
        return (int) KEY[entry] == last;
    }

    /** The face and the four names, see {@link WarmStartKey}. */
    static long key(int entry) {
        return KEY[entry];
    }

    /** The names of four corners, where they stand, and what the sides between them came from. */
    private static final class Loop {
        /** The place of a corner when the side cuts edges along the first axis, or not. */
        private static final int[] ALONG_FIRST = {0, 1, 2, 3}, ALONG_SECOND = {0, 2, 1, 3};

        int[] name = new int[4], side = new int[4], place = new int[4];

        boolean flip;
        int begin;

        void begin(boolean flipped, int face, int incident) {
            flip = flipped;
            begin = face;
            int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
            for (int k = 0; k < 4; k++) {
                name[k] = kind | BoxTopology.slotVertex(incident + k);
                side[k] = BoxTopology.slotEdge(incident + k);
                place[k] = BoxClipper.SLOT_CORNER[incident + k];
            }
        }

        /** See {@link BoxBatch#entry}. */
        void cut(int way) {
            int[] placeOf = (way & 2) == 0 ? ALONG_FIRST : ALONG_SECOND;
            for (int k = 0; k < 4; k++) {
                place[k] = placeOf[place[k]];
            }
            // Low ends are the places 0 and 2.
            cutTwo((way & 1) != 0 ? 0b0101 : 0b1010, way >> 2);
        }

        /** Cuts two neighbours off. */
        private void cutTwo(int places, int sideNumber) {
            int slot = BoxClipper.SIDE_SLOT[begin + sideNumber];
            int stays = 0;
            while ((places >> place[stays] & 1) != 0
                    || (places >> place[(stays + 1) & 3] & 1) == 0) {
                stays++;
            }
            int leaves = (stays + 1) & 3;
            int enters = (stays + 2) & 3;
            int back = (stays + 3) & 3;
            int[] names = {
                name[stays],
                BoxClipper.name(flip, side[stays], slot, begin),
                BoxClipper.name(flip, side[enters], slot, begin),
                name[back]
            };
            place = new int[] {place[stays], place[leaves], place[enters], place[back]};
            name = names;
        }
    }
}
