package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.BoxContacts;
import dev.cairn.physics.narrowphase.RoundContacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

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

    /** Numbers for each body in {@link #sizes}. */
    static final int SIZES = 4;

    private static final int KINDS = 3;
    private static final int ROWS_PER_BLOCK = 512;

    private static final int SLOTS_PER_BLOCK = 2048;

    private final BlockJob shapeJob = this::shapeBlock;
    private final BlockJob countJob = this::countBlock;
    private final BlockJob writeJob = this::writeBlock;
    private final int[] begin = new int[KINDS + 1];

    /** Of each body the shape when it was last looked at, and its kind. */
    private @Nullable Shape[] seen = {};

    private byte[] kindOfBody = {};

    /** Of each body of the first two kinds: half extents, or radius and half length, m. */
    private double[] size = {};

    private byte[] kind = {};
    private int[] sorted = {};
    private int[] cursor = {};
    private int[] order = {};
    private BodyStore bodies = new BodyStore();
    private ContactStore contacts = new ContactStore();

    /** Sorts the active rows. */
    void sort(BodyStore bodyStore, ContactStore rows, Jobs jobs) {
        bodies = bodyStore;
        contacts = rows;
        int blocks = Blocks.count(rows.activeCount, ROWS_PER_BLOCK);
        if (kind.length < rows.activeCount) {
            kind = new byte[rows.active.length];
            sorted = new int[rows.active.length];
            cursor = new int[KINDS * Blocks.count(kind.length, ROWS_PER_BLOCK)];
        }
        if (seen.length < bodyStore.slotCount) {
            seen = Arrays.copyOf(seen, bodyStore.shape.length);
            kindOfBody = Arrays.copyOf(kindOfBody, seen.length);
            size = Arrays.copyOf(size, SIZES * seen.length);
        }
        Arrays.fill(cursor, 0, KINDS * blocks, 0);
        jobs.run(shapeJob, Blocks.count(bodyStore.slotCount, SLOTS_PER_BLOCK));
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
        if (mixed) {
            jobs.run(writeJob, blocks);
            order = sorted;
        }
    }

    /** Where the rows of a kind begin in {@link #order}; they end where the next kind begins. */
    int begin(int pairKind) {
        return begin[pairKind];
    }

    /**
     * Sizes of the bodies, {@link #SIZES} numbers each: half extents of a box, radius and half
     * length of a capsule, radius and 0 of a ball, m.
     */
    double[] sizes() {
        return size;
    }

    /** The rows, sorted by kind. */
    int[] order() {
        return order;
    }

    /** A shape that is another one than before gets its kind; the shapes' own memory is far. */
    private void shapeBlock(int block, int worker) {
        int end = Blocks.end(block, SLOTS_PER_BLOCK, bodies.slotCount);
        for (int slot = Blocks.begin(block, SLOTS_PER_BLOCK); slot < end; slot++) {
            Shape shape = bodies.shape[slot];
            if (shape != seen[slot]) {
                seen[slot] = shape;
                kindOfBody[slot] = (byte) kindOf(shape);
                measure(shape, SIZES * slot);
            }
        }
    }

    private void measure(@Nullable Shape shape, int at) {
        if (shape instanceof Box box) {
            size[at] = box.halfX();
            size[at + 1] = box.halfY();
            size[at + 2] = box.halfZ();
        } else if (shape instanceof Capsule capsule) {
            size[at] = capsule.radius();
            size[at + 1] = capsule.halfLength();
        } else if (shape instanceof Sphere ball) {
            size[at] = ball.radius();
            size[at + 1] = 0;
        }
    }

    private static int kindOf(@Nullable Shape shape) {
        if (shape instanceof Box box && BoxContacts.fits(box)) {
            return BOXES;
        }
        return shape != null && RoundContacts.fits(shape) ? ROUND : OTHERS;
    }

    private void countBlock(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        int boxes = 0;
        int round = 0;
        int first = Blocks.begin(block, ROWS_PER_BLOCK);
        for (int i = first; i < end; i++) {
            int row = contacts.active[i];
            byte a = kindOfBody[contacts.bodyA[row]];
            byte b = kindOfBody[contacts.bodyB[row]];
            int of = a == b ? a : OTHERS;
            kind[i] = (byte) of;
            boxes += of == BOXES ? 1 : 0;
            round += of == ROUND ? 1 : 0;
        }
        cursor[KINDS * block + BOXES] = boxes;
        cursor[KINDS * block + ROUND] = round;
        cursor[KINDS * block + OTHERS] = end - first - boxes - round;
    }

    private void writeBlock(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            sorted[cursor[KINDS * block + kind[i]]++] = contacts.active[i];
        }
    }
}
