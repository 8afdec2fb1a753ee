package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Objects;

/**
 * The difference of two states: leads from the first one to the second one and back. It is as large
 * as what has changed; what sleeps costs nothing.
 *
 * <p>Numbers are kept as the exclusive or of both states, which leads either way; references as the
 * old one and the new one. Columns may have grown or shrunk, and tables of entities may have come
 * or gone.
 *
 * <p>Immutable; any thread.
 */
public final class StateDelta {
    /**
     * What a state must be like, to be one of the two.
     *
     * @param entries columns and single numbers
     * @param size bytes of numbers
     * @param objects references
     */
    record Form(int entries, int size, int objects) {
        static Form of(WorldState s) {
            return new Form(s.entries, s.size, s.objectCount);
        }
    }

    /** Memory of a delta in which nothing has changed, about. */
    private static final int OWN_BYTES = 256;

    final Form before;
    final Form after;

    /** The alignment, packed. */
    private final byte[] layout;

    /** What only one of the states has. */
    final @Nullable PackedEntries onlyBefore;

    final @Nullable PackedEntries onlyAfter;

    final DeltaWords words;
    final References references;

    /** What a {@link StateColumns.Predictor} packs. */
    final int[] predicted;

    final boolean isRead;

    StateDelta(
            Form before,
            Form after,
            Alignment alignment,
            @Nullable PackedEntries onlyBefore,
            @Nullable PackedEntries onlyAfter,
            DeltaWords words,
            References references,
            int[] predicted,
            boolean isRead) {
        this.before = before;
        this.after = after;
        StateOutput packed = new StateOutput(StateCodecs.STANDARD);
        alignment.write(packed);
        layout = packed.toBytes();
        this.onlyBefore = onlyBefore;
        this.onlyAfter = onlyAfter;
        this.words = words;
        this.references = references;
        this.predicted = predicted;
        this.isRead = isRead;
    }

    /**
     * The difference of two states. Takes the time to compare them.
     *
     * @param before the first state
     * @param after the second state
     * @return what leads from one to the other; holds none of them
     */
    public static StateDelta between(WorldState before, WorldState after) {
        Objects.requireNonNull(before, "before must not be null");
        Objects.requireNonNull(after, "after must not be null");
        Alignment alignment = Alignment.of(before, after);
        StateColumns first = StateColumns.copying(before);
        StateColumns second = StateColumns.copying(after);
        int[] predicted = predict(before, first, after, second);
        DeltaWords words = new DeltaWords();
        References references = new References();
        WorldState wideBefore = new WorldState();
        WorldState wideAfter = new WorldState();
        int word = 0;
        int reference = 0;
        int r = 0;
        for (int m = 0; m < alignment.count(); m++) {
            int ea = m < alignment.head() ? m : m + alignment.before();
            int eb = m < alignment.head() ? m : m + alignment.after();
            WorldState a = first.holder(ea);
            WorldState b = second.holder(eb);
            int i = first.place(ea);
            int k = second.place(eb);
            boolean isResized = r < alignment.resized().length && alignment.resized()[r] == m;
            if (isResized && alignment.movesAt(r) != null) {
                wideBefore.clear();
                alignment.widen(a, i, r, true, wideBefore);
                a = wideBefore;
                i = 0;
                wideAfter.clear();
                alignment.widen(b, k, r, false, wideAfter);
                b = wideAfter;
                k = 0;
            }
            r += isResized ? Alignment.NUMBERS : 0;
            byte kind = a.kinds[i];
            if (WorldState.WIDTH[kind] != 0) {
                word += words.add(word, a, i, b, k);
            } else if (kind != WorldState.SECTION) {
                reference += references.add(reference, a, i, b, k);
            }
        }
        references.resize(references.count);
        return new StateDelta(
                Form.of(before),
                Form.of(after),
                alignment,
                PackedEntries.of(first, alignment.head(), alignment.before()),
                PackedEntries.of(second, alignment.head(), alignment.after()),
                words.trimmed(),
                references,
                predicted,
                before.isRead || after.isRead);
    }

    /** Packs both, if they are predicted by the same; what was packed. */
    @SuppressWarnings("ReferenceEquality") // there is one of a kind of world
    private static int[] predict(
            WorldState before, StateColumns first, WorldState after, StateColumns second) {
        StateColumns.Predictor known = StateColumns.predictor(before);
        if (known == null || known != StateColumns.predictor(after)) {
            return new int[0];
        }
        int[] rows = known.rows(first, second);
        known.pack(first, rows, true);
        known.pack(second, rows, false);
        return rows;
    }

    /**
     * Makes the first state the second one. Allocates some kilobytes to read with, and while the
     * state's buffers grow.
     *
     * @param state equal to the first state
     * @throws StateException if it is another one; it stays as it is
     */
    public void apply(WorldState state) {
        lead(state, true);
    }

    /**
     * Makes the second state the first one.
     *
     * @param state equal to the second state
     * @throws StateException if it is another one; it stays as it is
     */
    public void revert(WorldState state) {
        lead(state, false);
    }

    private void lead(WorldState state, boolean forward) {
        Form now = Form.of(Objects.requireNonNull(state, "state must not be null"));
        Form from = forward ? before : after;
        long sum = forward ? words.sumBefore : words.sumAfter;
        if (!now.equals(from)) {
            throw new StateException(
                    "the state is not the one that the delta starts from: it has "
                            + now
                            + " and not "
                            + from
                            + "; apply deltas in the order of their ticks, and revert them in the"
                            + " opposite order");
        }
        StateColumns.Predictor known = predicted.length == 0 ? null : StateColumns.predictor(state);
        if (predicted.length > 0 && known == null) {
            throw new StateException(
                    "the state is not the one that the delta starts from: nobody predicts its"
                            + " numbers, and the delta was made of states of which somebody does");
        }
        if (known == null) {
            packed(state, forward, sum);
        } else {
            boolean isFirst = forward;
            known.pack(StateColumns.inPlace(state), predicted, isFirst);
            try {
                packed(state, forward, sum);
                isFirst = !forward;
            } finally {
                known.unpack(StateColumns.inPlace(state), predicted, isFirst);
            }
        }
        state.isRead |= isRead;
    }

    private void packed(WorldState state, boolean forward, long sum) {
        Alignment alignment = alignment();
        if (alignment.isInPlace()) {
            references.requireFit(state);
            words.apply(state, sum);
            references.apply(state, forward);
        } else {
            laidOut(state, alignment, forward, sum);
        }
    }

    /** By way of the wide layout, in a second buffer: if it is refused, the first one is there. */
    private void laidOut(WorldState state, Alignment alignment, boolean forward, long sum) {
        requireFit(state, alignment, forward);
        WorldState wide = state.spare();
        alignment.widen(state, forward, wide);
        references.requireFit(wide);
        words.apply(wide, sum);
        references.apply(wide, forward);
        boolean wasRead = state.isRead;
        PackedEntries comes = forward ? onlyAfter : onlyBefore;
        alignment.narrow(wide, comes == null ? null : comes.unpack(), !forward, state);
        state.isRead = wasRead;
        wide.clear();
    }

    private void requireFit(WorldState state, Alignment alignment, boolean forward) {
        int[] resized = alignment.resized();
        long size = state.size;
        long objects = state.objectCount;
        for (int r = 0; r < resized.length; r += Alignment.NUMBERS) {
            int m = resized[r];
            int only = forward ? alignment.before() : alignment.after();
            int e = m < alignment.head() ? m : m + only;
            int then = forward ? resized[r + 1] : resized[r + 2];
            int next = forward ? resized[r + 2] : resized[r + 1];
            if (state.counts[e] != then) {
                throw new StateException(
                        "the state is not the one that the delta starts from: "
                                + state.path(e)
                                + " has "
                                + state.counts[e]
                                + " elements and not "
                                + then);
            }
            byte kind = state.kinds[e];
            if (kind < WorldState.INTS && alignment.movesAt(r) != null) {
                throw new StateException(
                        "the delta is damaged: it moves the rows of "
                                + state.path(e)
                                + ", which has none");
            }
            long width = WorldState.WIDTH[kind];
            size += (width * next + 7 & -8L) - (width * then + 7 & -8L);
            objects += width == 0 && kind != WorldState.SECTION ? (long) next - then : 0;
        }
        PackedEntries gone = forward ? onlyBefore : onlyAfter;
        PackedEntries comes = forward ? onlyAfter : onlyBefore;
        size += (comes == null ? 0 : comes.size()) - (gone == null ? 0 : gone.size());
        objects += (comes == null ? 0 : comes.objects().length);
        objects -= (gone == null ? 0 : gone.objects().length);
        Form to = forward ? after : before;
        if (size != to.size || objects != to.objects) {
            throw new StateException(
                    "the delta is damaged: it leads to "
                            + size
                            + " bytes of numbers and "
                            + objects
                            + " references where it tells of "
                            + to);
        }
    }

    /**
     * Whether both states are equal.
     *
     * @return true if nothing changes
     */
    public boolean isEmpty() {
        return predicted.length == 0
                && words.headLength == 0
                && references.count == 0
                && alignment().isInPlace();
    }

    /**
     * How much memory it takes, beside the objects that it refers to.
     *
     * @return bytes, about
     */
    public long byteCount() {
        return OWN_BYTES
                + words.size()
                + layout.length
                + 20L * references.count
                + 4L * predicted.length
                + bytesOf(onlyBefore)
                + bytesOf(onlyAfter);
    }

    Alignment alignment() {
        return Alignment.read(new StateInput(layout, 0, layout.length));
    }

    private static long bytesOf(@Nullable PackedEntries part) {
        return part == null ? 0 : part.byteCount();
    }

    /**
     * Writes the delta as bytes that are the same on every machine, with a version and a sum that
     * tells damage.
     *
     * @param out where to; stays open
     * @param codecs write the objects, for example {@code PhysicsWorld.codecs()}
     * @throws IOException if writing fails
     * @throws StateException if there is an object without a codec
     */
    public void writeTo(OutputStream out, StateCodecs codecs) throws IOException {
        DeltaBytes.write(this, out, codecs);
    }

    /**
     * Reads what {@link #writeTo} wrote, and no more.
     *
     * @param in where from; stays open
     * @param codecs read the objects
     * @return the delta
     * @throws IOException if reading fails
     * @throws StateException if the bytes are damaged, incomplete, or of another version
     */
    public static StateDelta read(InputStream in, StateCodecs codecs) throws IOException {
        return DeltaBytes.read(in, codecs);
    }

    /** The references that differ between two states, by their places in the wide layout. */
    static final class References {
        private static final int[] NOWHERE = {};
        private static final @Nullable Object[] NOTHING = {};

        int[] places = NOWHERE;
        @Nullable Object[] before = NOTHING;
        @Nullable Object[] after = NOTHING;
        int count;

        /**
         * Adds what differs in an entry.
         *
         * @param base its first reference in the wide layout
         * @return references that it takes there
         */
        @SuppressWarnings(
                "ReferenceEquality") // what is kept by reference is the same only if it is it
        int add(int base, WorldState a, int i, WorldState b, int k) {
            int n = Math.max(a.counts[i], b.counts[k]);
            for (int r = 0; r < n; r++) {
                Object x = r < a.counts[i] ? a.objects[a.at[i] + r] : null;
                Object y = r < b.counts[k] ? b.objects[b.at[k] + r] : null;
                if (x != y) {
                    if (count == places.length) {
                        resize(2 * count + 4);
                    }
                    places[count] = base + r;
                    before[count] = x;
                    after[count++] = y;
                }
            }
            return n;
        }

        void resize(int length) {
            places = Arrays.copyOf(places, length);
            before = Arrays.copyOf(before, length);
            after = Arrays.copyOf(after, length);
        }

        /** Refuses places that a state of the wide layout has not. */
        void requireFit(WorldState wide) {
            for (int i = 0; i < count; i++) {
                if (places[i] < 0 || places[i] >= wide.objectCount) {
                    throw new StateException(
                            "the delta is damaged: reference "
                                    + places[i]
                                    + " is to be changed, of "
                                    + wide.objectCount);
                }
            }
        }

        /** Sets them in a state of the wide layout. */
        void apply(WorldState wide, boolean forward) {
            @Nullable Object[] values = forward ? after : before;
            for (int i = 0; i < count; i++) {
                wide.objects[places[i]] = values[i];
            }
        }
    }
}
