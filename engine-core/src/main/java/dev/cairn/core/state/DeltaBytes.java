package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * The bytes of a delta, in a {@link Frame}:
 *
 * <pre>
 *   forms      of both states: entries, bytes of numbers, references
 *   alignment  head, entries of one state only, tail; moves of rows; lengths that differ, each
 *              once; how many entries lie differently: which, and the number of their lengths
 *   parts      of each state: entries of its own: kinds, names, counts, references, words
 *   references how many; of each: place, number of the object before and after
 *   predicted   how many rows are packed; which, by steps
 *   words      both sums, bytes of heads, how many these are packed, these, how many others, these
 * </pre>
 *
 * Numbers are short ones, see {@link StateOutput#writeShort}; places are told by their steps.
 */
final class DeltaBytes {
    private static final Frame FRAME = new Frame("CAIRNDL4", "delta");

    /** Zeros that a delta may add without a byte for them, and those for each byte of it. */
    private static final long FREE_GROWTH = 64L << 20;

    private static final long GROWTH = 256;

    private DeltaBytes() {}

    static void write(StateDelta d, OutputStream to, StateCodecs codecs) throws IOException {
        FRAME.write(to, codecs, out -> contents(d, out));
    }

    static void contents(StateDelta d, StateOutput out) {
        form(d.before, out);
        form(d.after, out);
        d.alignment().write(out);
        part(d.onlyBefore, out);
        part(d.onlyAfter, out);
        out.writeShort(d.references.count);
        for (int i = 0; i < d.references.count; i++) {
            out.writeShort(d.references.places[i] - (i == 0 ? 0 : d.references.places[i - 1]));
            out.writeObjectShort(d.references.before[i]);
            out.writeObjectShort(d.references.after[i]);
        }
        out.writeShort(d.predicted.length);
        for (int i = 0; i < d.predicted.length; i++) {
            out.writeShort(d.predicted[i] - (i == 0 ? 0 : d.predicted[i - 1]));
        }
        words(d.words, out);
    }

    private static void form(StateDelta.Form form, StateOutput out) {
        out.writeShort(form.entries());
        out.writeShort(form.size());
        out.writeShort(form.objects());
    }

    private static void part(@Nullable PackedEntries part, StateOutput out) {
        if (part == null) {
            return;
        }
        out.writeBytes(part.kinds(), part.kinds().length);
        for (String name : part.names()) {
            out.writeString(name);
        }
        out.writeInts(part.counts());
        out.writeInt(part.objects().length);
        for (Object object : part.objects()) {
            out.writeObject(object);
        }
        words(part.words(), out);
    }

    private static void words(DeltaWords words, StateOutput out) {
        out.writeLong(words.sumBefore);
        out.writeLong(words.sumAfter);
        out.writeShort(words.headLength);
        out.writeShort(words.heads.length);
        out.writeBytes(words.heads, words.heads.length);
        out.writeShort(words.bytes.length);
        out.writeBytes(words.bytes, words.bytes.length);
    }

    static StateDelta read(InputStream from, StateCodecs codecs) throws IOException {
        return FRAME.read(from, codecs, DeltaBytes::parse);
    }

    static StateDelta parse(StateInput in) {
        StateDelta.Form before = form(in);
        StateDelta.Form after = form(in);
        Alignment alignment = alignment(in, before, after);
        PackedEntries onlyBefore = part(in, alignment.before());
        PackedEntries onlyAfter = part(in, alignment.after());
        StateDelta.References references = new StateDelta.References();
        references.count = in.need(3, in.readShort());
        references.resize(references.count);
        for (int i = 0; i < references.count; i++) {
            references.places[i] = in.readShort() + (i == 0 ? 0 : references.places[i - 1]);
            references.before[i] = in.readShortObject();
            references.after[i] = in.readShortObject();
        }
        int[] predicted = new int[in.need(1, in.readShort())];
        for (int i = 0; i < predicted.length; i++) {
            predicted[i] = in.readShort() + (i == 0 ? 0 : predicted[i - 1]);
            if (predicted[i] < 0) {
                throw new StateException(
                        "the delta is damaged: row " + predicted[i] + " is packed");
            }
        }
        DeltaWords words = words(in);
        long growth =
                Math.abs((long) after.size() - before.size())
                        + 8 * Math.abs((long) after.objects() - before.objects());
        if (growth > FREE_GROWTH + GROWTH * words.size() + bytes(onlyBefore) + bytes(onlyAfter)) {
            throw new StateException(
                    "the delta is damaged: it changes the state's size by "
                            + growth
                            + " bytes with "
                            + words.size()
                            + " bytes of words");
        }
        return new StateDelta(
                before,
                after,
                alignment,
                onlyBefore,
                onlyAfter,
                words,
                references,
                predicted,
                true);
    }

    private static DeltaWords words(StateInput in) {
        long sumBefore = in.readLong();
        long sumAfter = in.readLong();
        int headLength = in.readShort();
        byte[] heads = in.readBytes(in.readShort());
        byte[] bytes = in.readBytes(in.readShort());
        return new DeltaWords(heads, headLength, bytes, sumBefore, sumAfter);
    }

    private static long bytes(@Nullable PackedEntries part) {
        return part == null ? 0 : part.size();
    }

    private static StateDelta.Form form(StateInput in) {
        return new StateDelta.Form(in.readShort(), in.readShort(), in.readShort());
    }

    private static Alignment alignment(
            StateInput in, StateDelta.Form before, StateDelta.Form after) {
        Alignment read = Alignment.read(in);
        long common = (long) read.head() + read.tail();
        boolean fits =
                read.head() >= 0
                        && read.before() >= 0
                        && read.after() >= 0
                        && read.tail() >= 0
                        && common + read.before() == before.entries()
                        && common + read.after() == after.entries();
        for (RowMoves moves : read.moves()) {
            fits &= !isBelow(moves);
        }
        int[] resized = read.resized();
        fits &= resized.length % Alignment.NUMBERS == 0;
        int last = -1;
        for (int r = 0; fits && r < resized.length; r += Alignment.NUMBERS) {
            fits = resized[r] > last && resized[r] < common;
            fits &= resized[r + 1] >= 0 && resized[r + 2] >= 0;
            last = resized[r];
            fits &= resized[r + 3] >= -1 && resized[r + 3] < read.moves().size();
            RowMoves moved = fits ? read.movesAt(r) : null;
            if (moved != null) {
                int width = Alignment.width(moved, resized[r + 1], resized[r + 2]);
                fits &= width > 0 && width * moved.rows(true, true) <= Integer.MAX_VALUE;
            }
        }
        if (!fits) {
            throw new StateException(
                    "the delta is damaged: its entries do not fit states of "
                            + before.entries()
                            + " and "
                            + after.entries());
        }
        return read;
    }

    private static boolean isBelow(RowMoves moves) {
        boolean isBelow = moves.steps().length % 3 != 0;
        for (int rows : moves.steps()) {
            isBelow |= rows < 0;
        }
        return isBelow;
    }

    private static @Nullable PackedEntries part(StateInput in, int entries) {
        if (entries == 0) {
            return null;
        }
        byte[] kinds = in.readBytes(in.need(5, entries));
        String[] names = new String[entries];
        for (int e = 0; e < entries; e++) {
            names[e] = in.readString();
        }
        int[] counts = in.readInts();
        @Nullable Object[] objects = new Object[in.need(4, in.readInt())];
        for (int i = 0; i < objects.length; i++) {
            objects[i] = in.readNullable(Object.class);
        }
        DeltaWords words = words(in);
        boolean fits = counts.length == entries;
        long references = 0;
        for (int e = 0; fits && e < entries; e++) {
            byte kind = kinds[e];
            fits = kind >= 0 && kind < WorldState.WIDTH.length && counts[e] >= 0;
            boolean isOne = kind > WorldState.SECTION && kind <= WorldState.REFERENCE;
            fits &= !isOne || counts[e] == 1;
            boolean isObject = fits && kind != WorldState.SECTION && WorldState.WIDTH[kind] == 0;
            references += isObject ? counts[e] : 0;
        }
        PackedEntries part = new PackedEntries(names, kinds, counts, words, objects);
        if (!fits
                || references != objects.length
                || part.size() > FREE_GROWTH + GROWTH * words.size()) {
            throw new StateException(
                    "the delta is damaged: entries of one state only are no entries");
        }
        return part;
    }
}
