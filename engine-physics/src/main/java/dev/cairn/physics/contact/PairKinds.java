package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.round.RoundContacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The active rows in order of the kind of their pair: a stable counting sort, so that a loop meets
 * one kind only and each kind keeps its rows ascending. Counted and written in blocks; the order
 * depends on the rows alone.
 */
final class PairKinds {
    /** Two boxes: collided in batches. */
    static final int BOXES = 0;

    /** Balls and capsules: a closed form. */
    static final int ROUND = 1;

    /** All the rest: one after another. */
    static final int OTHERS = 2;

    /** Kinds of colliders; a pair of two alike is of the kind with the same number. */
    private static final byte BOX = BOXES, ROUNDED = ROUND, OTHER = OTHERS;

    private static final int KINDS = 3;

    /** Of a pair that is left out. */
    private static final byte FAR = -1;

    /** At most 1023, see {@link #COUNT_BITS}. */
    private static final int ROWS_PER_BLOCK = 512;

    /** Of the rows of each kind in a block; all kinds are counted in one number. */
    private static final int COUNT_BITS = 10;

    private static final int SLOTS_PER_BLOCK = 2048;

    private final BlockJob shapeJob = this::shapeBlock;
    private final BlockJob countJob = this::countBlock;
    private final BlockJob writeJob = this::writeBlock;
    private final int[] begin = new int[KINDS + 1];

    /** Of each collider the shape when it was last looked at, and its kind. */
    private @Nullable Shape[] seen = {};

    private byte[] kindOfCollider = {};

    private byte[] kind = {};
    private int[] sorted = {};
    private int[] cursor = {};
    private int[] order = {};
    private final ColliderStore colliders;
    private final BoundsStage bounds;
    private ContactStore contacts = new ContactStore();
    private double reach;

    /**
     * Of some colliders.
     *
     * @param bounds knows what is far apart
     */
    PairKinds(ColliderStore colliders, BoundsStage bounds) {
        this.colliders = colliders;
        this.bounds = bounds;
    }

    /**
     * Sorts the active rows, without those that have no points and are far apart: nothing can
     * become of them in this tick. Of boxes that lie side by side these are nine of ten.
     *
     * @param ahead time in which relative motion counts, s
     */
    void sort(ContactStore rows, double ahead, Jobs jobs) {
        contacts = rows;
        reach = ahead;
        int blocks = Blocks.count(rows.activeCount, ROWS_PER_BLOCK);
        if (kind.length < rows.active.length) {
            kind = new byte[rows.active.length];
            sorted = new int[rows.active.length];
            cursor = new int[KINDS * Blocks.count(kind.length, ROWS_PER_BLOCK)];
        }
        if (seen.length < colliders.slotCount) {
            seen = Arrays.copyOf(seen, colliders.shape.length);
            kindOfCollider = Arrays.copyOf(kindOfCollider, seen.length);
        }
        Arrays.fill(cursor, 0, KINDS * blocks, 0);
        jobs.run(shapeJob, Blocks.count(colliders.slotCount, SLOTS_PER_BLOCK));
        jobs.run(countJob, blocks);
        int sum = 0;
        boolean mixed = false;
        for (int k = 0; k < KINDS; k++) {
            begin[k] = sum;
            for (int b = 0; b < blocks; b++) {
                int here = cursor[KINDS * b + k];
                cursor[KINDS * b + k] = sum;
                sum += here;
            }
            mixed |= sum > begin[k] && sum < rows.activeCount;
        }
        begin[KINDS] = sum;
        order = rows.active;
        if (mixed || sum < rows.activeCount) {
            jobs.run(writeJob, blocks);
            order = sorted;
        }
    }

    /** Where the rows of a kind begin in {@link #order}; they end where the next kind begins. */
    int begin(int pairKind) {
        return begin[pairKind];
    }

    /** How many rows there are in {@link #order}. */
    int count() {
        return begin[KINDS];
    }

    /** The rows, sorted by kind. */
    int[] order() {
        return order;
    }

    /** A shape that is another one than before gets its kind; the shapes' own memory is far. */
    private void shapeBlock(int block, int worker) {
        int end = Blocks.end(block, SLOTS_PER_BLOCK, colliders.slotCount);
        for (int slot = Blocks.begin(block, SLOTS_PER_BLOCK); slot < end; slot++) {
            Shape shape = colliders.shape[slot];
            if (shape != seen[slot]) {
                seen[slot] = shape;
                kindOfCollider[slot] = kindOf(shape);
            }
        }
    }

    private static byte kindOf(@Nullable Shape shape) {
        if (shape instanceof Box box && BoxContacts.fits(box)) {
            return BOX;
        }
        return shape != null && RoundContacts.fits(shape) ? ROUNDED : OTHER;
    }

    private void countBlock(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        long counts = 0;
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = contacts.active[i];
            int a = contacts.colliderA[row];
            int b = contacts.colliderB[row];
            if (contacts.pointCount[row] == 0 && bounds.isFar(a, b, reach)) {
                kind[i] = FAR;
                continue;
            }
            byte of = kindOfCollider[a] == kindOfCollider[b] ? kindOfCollider[a] : OTHER;
            kind[i] = of;
            counts += 1L << (COUNT_BITS * of);
        }
        for (int k = 0; k < KINDS; k++) {
            cursor[KINDS * block + k] = (int) (counts >>> (COUNT_BITS * k)) & (1 << COUNT_BITS) - 1;
        }
    }

    private void writeBlock(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            if (kind[i] != FAR) {
                sorted[cursor[KINDS * block + kind[i]]++] = contacts.active[i];
            }
        }
    }
}
