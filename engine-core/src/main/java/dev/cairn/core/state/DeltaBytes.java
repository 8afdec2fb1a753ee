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
 *   alignment  head, entries of one state only, tail; how many changed their length: which, lengths
 *   parts      of each state: whether it has entries of its own; these as a state
 *   references how many; of each: place, number of the object before and after
 *   words      both sums, how many bytes, these
 * </pre>
 */
final class DeltaBytes {
    private static final Frame FRAME = new Frame("CAIRNDL1", "delta");

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
        part(d.onlyBefore, out);
        part(d.onlyAfter, out);
        out.writeInt(d.references.count);
        for (int i = 0; i < d.references.count; i++) {
            out.writeInt(d.references.places[i]);
            out.writeObject(d.references.before[i]);
            out.writeObject(d.references.after[i]);
        }
        out.writeLong(d.words.sumBefore);
        out.writeLong(d.words.sumAfter);
        out.writeInt(d.words.size);
        out.writeBytes(d.words.bytes, d.words.size);
    }

    private static void form(StateDelta.Form form, StateOutput out) {
        out.writeInt(form.entries());
        out.writeInt(form.size());
        out.writeInt(form.objects());
    }

    private static void part(@Nullable WorldState part, StateOutput out) {
        out.writeBoolean(part != null);
        if (part != null) {
            StateBytes.contents(part, out);
        }
    }

    static StateDelta read(InputStream from, StateCodecs codecs) throws IOException {
        return FRAME.read(from, codecs, DeltaBytes::parse);
    }

    static StateDelta parse(StateInput in) {
        StateDelta.Form before = form(in);
        StateDelta.Form after = form(in);
        Alignment alignment = alignment(in, before, after);
        WorldState onlyBefore = part(in, alignment.before());
        WorldState onlyAfter = part(in, alignment.after());
        DeltaReferences references = new DeltaReferences();
        references.count = in.need(12, in.readInt());
        references.resize(references.count);
        for (int i = 0; i < references.count; i++) {
            references.places[i] = in.readInt();
            references.before[i] = in.readNullable(Object.class);
            references.after[i] = in.readNullable(Object.class);
        }
        long sumBefore = in.readLong();
        long sumAfter = in.readLong();
        byte[] words = in.readBytes(in.readInt());
        long growth =
                Math.abs((long) after.size() - before.size())
                        + 8 * Math.abs((long) after.objects() - before.objects());
        if (growth > FREE_GROWTH + GROWTH * words.length + bytes(onlyBefore) + bytes(onlyAfter)) {
            throw new StateException(
                    "the delta is damaged: it changes the state's size by "
                            + growth
                            + " bytes with "
                            + words.length
                            + " bytes of words");
        }
        return new StateDelta(
                before,
                after,
                alignment,
                onlyBefore,
                onlyAfter,
                new DeltaWords(words, sumBefore, sumAfter),
                references,
                true);
    }

    private static long bytes(@Nullable WorldState part) {
        return part == null ? 0 : part.size;
    }

    private static StateDelta.Form form(StateInput in) {
        return new StateDelta.Form(in.readInt(), in.readInt(), in.readInt());
    }

    private static Alignment alignment(
            StateInput in, StateDelta.Form before, StateDelta.Form after) {
        Alignment read =
                new Alignment(
                        in.readInt(), in.readInt(), in.readInt(), in.readInt(), in.readInts());
        long common = (long) read.head() + read.tail();
        boolean fits =
                read.head() >= 0
                        && read.before() >= 0
                        && read.after() >= 0
                        && read.tail() >= 0
                        && common + read.before() == before.entries()
                        && common + read.after() == after.entries();
        int[] resized = read.resized();
        fits &= resized.length % 3 == 0;
        int last = -1;
        for (int r = 0; fits && r < resized.length; r += 3) {
            fits = resized[r] > last && resized[r] < common;
            fits &= resized[r + 1] >= 0 && resized[r + 2] >= 0;
            last = resized[r];
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

    private static @Nullable WorldState part(StateInput in, int entries) {
        WorldState part = in.readBoolean() ? StateBytes.parse(in) : null;
        if ((part == null ? 0 : part.entries) != entries) {
            throw new StateException(
                    "the delta is damaged: the entries of one state only are not " + entries);
        }
        return part;
    }
}
