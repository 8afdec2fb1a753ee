package dev.cairn.physics.time;

import dev.cairn.core.state.Frame;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.core.state.WorldState;

import org.jspecify.annotations.Nullable;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * A run that was written down by a {@link Recorder}: the state at its start, and of each tick its
 * length, what was done before it and the digest after it; now and then a keyframe. A {@link
 * Replay} runs it again. Immutable; any thread.
 *
 * <p>As bytes it is the same on every machine, and has a version and sums:
 *
 * <pre>
 *   start     state, digest
 *   ticks     how many; of each: length, inputs (how many, objects), digest,
 *             whether a keyframe follows: its difference from the one before
 * </pre>
 *
 * @param <I> what was done to the world
 */
public final class Recording<I> {
    private static final Frame FRAME = new Frame("CAIRNRC3", "recording");

    /** Least bytes of a tick. */
    private static final int TICK_BYTES = 21;

    /**
     * A tick.
     *
     * @param stepSeconds its length, s
     * @param inputs what was done before it
     * @param digest of the world after it
     * @param key leads from the keyframe before to the state after it; null if it is no keyframe
     */
    record Tick<I>(double stepSeconds, List<I> inputs, long digest, @Nullable StateDelta key) {}

    private final WorldState start;
    private final long startDigest;
    private final List<Tick<I>> ticks;

    Recording(WorldState start, long startDigest, List<Tick<I>> ticks) {
        this.start = start;
        this.startDigest = startDigest;
        this.ticks = ticks;
    }

    /** For tests: what would be otherwise. */
    List<Tick<I>> ticks() {
        return ticks;
    }

    /**
     * How many ticks were recorded.
     *
     * @return the number
     */
    public int tickCount() {
        return ticks.size();
    }

    /**
     * What was done before a tick.
     *
     * @param tick 0 to tickCount - 1, counted from the start of the recording
     * @return inputs, in their order
     */
    public List<I> inputs(int tick) {
        return ticks.get(tick).inputs;
    }

    /**
     * The digest of the world after some ticks.
     *
     * @param ticks 0 (at the start) to tickCount
     * @return as {@code PhysicsWorld.digest}
     */
    public long digest(int ticks) {
        return ticks == 0 ? startDigest : this.ticks.get(ticks - 1).digest;
    }

    /**
     * The length of a tick.
     *
     * @param tick 0 to tickCount - 1
     * @return s
     */
    public double stepSeconds(int tick) {
        return ticks.get(tick).stepSeconds;
    }

    /**
     * The last keyframe up to some ticks; the start is one.
     *
     * @param ticks 0 to tickCount
     * @return ticks after which there is one
     */
    public int keyframe(int ticks) {
        int at = Objects.checkIndex(ticks, tickCount() + 1);
        while (at > 0 && this.ticks.get(at - 1).key == null) {
            at--;
        }
        return at;
    }

    /**
     * The state at a keyframe. Costs the differences of all keyframes before.
     *
     * @param ticks as {@link #keyframe} tells
     * @return a new state
     * @throws IllegalArgumentException if there is no keyframe
     */
    public WorldState state(int ticks) {
        if (keyframe(ticks) != ticks) {
            throw new IllegalArgumentException(
                    "there is no keyframe after "
                            + ticks
                            + " ticks; the last one before is after "
                            + keyframe(ticks));
        }
        WorldState state = new WorldState();
        state.set(start);
        for (Tick<I> tick : this.ticks.subList(0, ticks)) {
            if (tick.key != null) {
                tick.key.apply(state);
            }
        }
        return state;
    }

    /**
     * Writes the recording.
     *
     * @param out where to; stays open
     * @param codecs write the inputs and the objects of the states: {@code
     *     PhysicsWorld.codecs().with(..)}
     * @throws IOException if writing fails
     */
    public void writeTo(OutputStream out, StateCodecs codecs) throws IOException {
        FRAME.write(out, codecs, this::write);
    }

    /**
     * The same to a file, in place of what it held.
     *
     * @param file the file
     * @param codecs the same
     * @throws IOException if writing fails
     */
    public void writeTo(Path file, StateCodecs codecs) throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            writeTo(out, codecs);
        }
    }

    private void write(StateOutput out) {
        out.writeState(start);
        out.writeLong(startDigest);
        out.writeInt(ticks.size());
        for (Tick<I> tick : ticks) {
            out.writeDouble(tick.stepSeconds);
            out.writeInt(tick.inputs.size());
            tick.inputs.forEach(out::writeObject);
            out.writeLong(tick.digest);
            out.writeBoolean(tick.key != null);
            if (tick.key != null) {
                out.writeDelta(tick.key);
            }
        }
    }

    /**
     * Reads what {@link #writeTo(OutputStream, StateCodecs)} wrote, and no more.
     *
     * @param in where from; stays open
     * @param codecs read the inputs and the objects of the states
     * @param type class of the inputs
     * @param <I> the same
     * @return the recording
     * @throws IOException if reading fails
     * @throws dev.cairn.core.state.StateException if the bytes are damaged, incomplete, or of
     *     another version
     */
    public static <I> Recording<I> read(InputStream in, StateCodecs codecs, Class<I> type)
            throws IOException {
        return FRAME.read(in, codecs, input -> parse(input, type));
    }

    /**
     * The same from a file.
     *
     * @param file the file
     * @param codecs the same
     * @param type class of the inputs
     * @param <I> the same
     * @return the recording
     * @throws IOException if reading fails
     */
    public static <I> Recording<I> read(Path file, StateCodecs codecs, Class<I> type)
            throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            return read(in, codecs, type);
        }
    }

    private static <I> Recording<I> parse(StateInput in, Class<I> type) {
        WorldState start = in.readState();
        long startDigest = in.readLong();
        List<Tick<I>> ticks = new ArrayList<>();
        for (int left = in.requireCount(TICK_BYTES, in.readInt()); left > 0; left--) {
            double stepSeconds = in.readDouble();
            List<I> inputs = new ArrayList<>();
            for (int more = in.requireCount(4, in.readInt()); more > 0; more--) {
                inputs.add(in.readObject(type));
            }
            long digest = in.readLong();
            StateDelta key = in.readBoolean() ? in.readDelta() : null;
            ticks.add(new Tick<>(stepSeconds, List.copyOf(inputs), digest, key));
        }
        return new Recording<>(start, startDigest, List.copyOf(ticks));
    }
}
