package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * The bytes of a delta, in a {@link Frame}:
 *
 * <pre>
 *   forms      of both states: entries, bytes of numbers, references
 *   alignment  head, entries of one state only, tail; how many lie differently: which, lengths,
 *              moves; how many moves of rows: these
 *   parts      of each state: entries of its own: kinds, names, counts, references, words
 *   references how many; of each: place, number of the object before and after
 *   words      both sums, how many bytes, these
 * </pre>
 */
final class DeltaBytes {
    private static final Frame FRAME = new Frame("CAIRNDL2", "delta");

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
        out.writeInt(d.alignment.head());
        out.writeInt(d.alignment.before());
        out.writeInt(d.alignment.after());
        out.writeInt(d.alignment.tail());
        out.writeInts(d.alignment.resized());
        out.writeInt(d.alignment.moves().size());
        for (RowMoves moves : d.alignment.moves()) {
            out.writeInts(moves.steps());
        }
        part(d.onlyBefore, out);
        part(d.onlyAfter, out);
        out.writeInt(d.references.count);
        for (int i = 0; i < d.references.count; i++) {
            out.writeInt(d.references.places[i]);
            out.writeObject(d.references.before[i]);
            out.writeObject(d.references.after[i]);
        }
        words(d.words, out);
    }

    private static void form(StateDelta.Form form, StateOutput out) {
        out.writeInt(form.entries());
        out.writeInt(form.size());
        out.writeInt(form.objects());
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
        out.writeInt(words.size);
        out.writeBytes(words.bytes, words.size);
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
        DeltaReferences references = new DeltaReferences();
        references.count = in.need(12, in.readInt());
        references.resize(references.count);
        for (int i = 0; i < references.count; i++) {
            references.places[i] = in.readInt();
            references.before[i] = in.readNullable(Object.class);
            references.after[i] = in.readNullable(Object.class);
        }
        DeltaWords words = words(in);
        long growth =
                Math.abs((long) after.size() - before.size())
                        + 8 * Math.abs((long) after.objects() - before.objects());
        if (growth > FREE_GROWTH + GROWTH * words.size + bytes(onlyBefore) + bytes(onlyAfter)) {
            throw new StateException(
                    "the delta is damaged: it changes the state's size by "
                            + growth
                            + " bytes with "
                            + words.size
                            + " bytes of words");
        }
        return new StateDelta(
                before, after, alignment, onlyBefore, onlyAfter, words, references, true);
    }

    private static DeltaWords words(StateInput in) {
        long sumBefore = in.readLong();
        long sumAfter = in.readLong();
        return new DeltaWords(in.readBytes(in.readInt()), sumBefore, sumAfter);
    }

    private static long bytes(@Nullable PackedEntries part) {
        return part == null ? 0 : part.size();
    }

    private static StateDelta.Form form(StateInput in) {
        return new StateDelta.Form(in.readInt(), in.readInt(), in.readInt());
    }

    private static Alignment alignment(
            StateInput in, StateDelta.Form before, StateDelta.Form after) {
        Alignment read =
                new Alignment(
                        in.readInt(),
                        in.readInt(),
                        in.readInt(),
                        in.readInt(),
                        in.readInts(),
                        moves(in));
        long common = (long) read.head() + read.tail();
        boolean fits =
                read.head() >= 0
                        && read.before() >= 0
                        && read.after() >= 0
                        && read.tail() >= 0
                        && common + read.before() == before.entries()
                        && common + read.after() == after.entries();
        int[] resized = read.resized();
        fits &= resized.length % Alignment.NUMBERS == 0;
        int last = -1;
        for (int r = 0; fits && r < resized.length; r += Alignment.NUMBERS) {
            fits = resized[r] > last && resized[r] < common;
            fits &= resized[r + 1] >= 0 && resized[r + 2] >= 0;
            last = resized[r];
            fits &= resized[r + 3] < read.moves().size();
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

    private static List<RowMoves> moves(StateInput in) {
        int count = in.need(4, in.readInt());
        List<RowMoves> all = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            RowMoves moves = new RowMoves(in.readInts());
            boolean fits = moves.steps().length % 3 == 0;
            for (int rows : moves.steps()) {
                fits &= rows >= 0;
            }
            if (!fits) {
                throw new StateException("the delta is damaged: rows move by numbers below 0");
            }
            all.add(moves);
        }
        return all;
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
                || part.size() > FREE_GROWTH + GROWTH * words.size) {
            throw new StateException(
                    "the delta is damaged: entries of one state only are no entries");
        }
        return part;
    }
}
