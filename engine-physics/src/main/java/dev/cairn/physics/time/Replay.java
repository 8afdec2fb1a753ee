package dev.cairn.physics.time;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Runs a {@link Recording} again, and tells the first tick that comes out otherwise, and in what.
 *
 * <p>Simulation thread, between steps.
 *
 * @param <I> what was done to the world
 */
public final class Replay<I> {
    /**
     * Where a run differs from what was recorded.
     *
     * @param tick the first one after which the digest is another one, counted from the start of
     *     the recording: 0 is the start, 1 follows the first step
     * @param seenAt the keyframe that tells in what, as ticks from the start; -1 if none follows
     * @param body the first body that moves otherwise there, null if none does
     * @param contact the first column of contacts that differs there and its values, null if none
     *     does
     * @param column the first column of bodies, or of anything else, that differs and its values:
     *     {@code bodies.velocityX[3]: 1.0 and 2.0}; null if none does
     */
    public record Mismatch(
            int tick,
            int seenAt,
            @Nullable String body,
            @Nullable String contact,
            @Nullable String column) {
        @Override
        public String toString() {
            String first = "tick " + tick + " is the first that differs";
            if (seenAt < 0) {
                return first + "; no keyframe follows that tells in what";
            }
            // Lanes are a setting that may differ.
            if (body == null && (column == null || column.startsWith("physicsWorld.settings"))) {
                return first
                        + "; the keyframe of tick "
                        + seenAt
                        + " is as here, so the digests are those of another run than the keyframes";
            }
            return first
                    + "; at tick "
                    + seenAt
                    + " "
                    + (body == null ? "no body" : body)
                    + " is the first that moves otherwise, and the first column is "
                    + column
                    + (contact == null ? "" : ", of contacts " + contact);
        }
    }

    private final Recording<I> recording;
    private final PhysicsWorld world;
    private final BiConsumer<PhysicsWorld, I> acts;
    private int done;
    private int differs = -1;
    private @Nullable Mismatch mismatch;

    /**
     * Puts the world to the start of a recording.
     *
     * @param recording what is run again
     * @param world with the systems and settings of the one that was recorded
     * @param acts applies an input, as it did then
     * @throws dev.cairn.core.state.StateException if the world is of another kind
     */
    public Replay(Recording<I> recording, PhysicsWorld world, BiConsumer<PhysicsWorld, I> acts) {
        if (recording == null || world == null || acts == null) {
            throw new IllegalArgumentException(
                    "a replay needs a recording, a world and a function, and one of them is null");
        }
        this.recording = recording;
        this.world = world;
        this.acts = acts;
        seek(0);
    }

    /**
     * Runs the next tick. After one that differs it goes on to the next keyframe, and no further.
     *
     * @return false at the end of the recording, or if it is known in what it differs
     */
    public boolean step() {
        if (done == recording.tickCount() || mismatch != null) {
            return false;
        }
        for (I input : recording.inputs(done)) {
            acts.accept(world, input);
        }
        world.step(recording.stepSeconds(done));
        done++;
        compare();
        return true;
    }

    /**
     * Runs all ticks that are left.
     *
     * @return where it differs, or null if all is as it was
     */
    public @Nullable Mismatch run() {
        while (step()) {
            // on
        }
        return mismatch();
    }

    /**
     * Puts the world to a tick: by the keyframe before, and steps from there. With keyframes every
     * tick nothing is stepped.
     *
     * @param ticks 0 to {@code recording.tickCount()}, from the start of the recording
     */
    public void seek(int ticks) {
        int key = recording.keyframe(ticks);
        world.restore(recording.state(key));
        done = key;
        differs = -1;
        mismatch = null;
        if (key == 0) {
            compare();
        }
        while (done < ticks && step()) {
            // on
        }
    }

    /**
     * Ticks since the start of the recording.
     *
     * @return 0 to {@code recording.tickCount()}
     */
    public int tick() {
        return done;
    }

    /**
     * Where it differs from what was recorded, so far.
     *
     * @return null if it does not
     */
    public @Nullable Mismatch mismatch() {
        boolean isUnseen = differs >= 0 && mismatch == null && done == recording.tickCount();
        return isUnseen ? new Mismatch(differs, -1, null, null, null) : mismatch;
    }

    private void compare() {
        if (differs < 0 && recording.digest(done) != world.digest()) {
            differs = done;
        }
        if (differs >= 0 && recording.keyframe(done) == done) {
            WorldState then = recording.state(done);
            WorldState now = world.save();
            String column = then.difference(now, "bodies");
            mismatch =
                    new Mismatch(
                            differs,
                            done,
                            body(then),
                            then.difference(now, "contacts"),
                            column == null ? then.difference(now) : column);
        }
    }

    /** The first body that differs from that of a state. */
    private @Nullable String body(WorldState then) {
        try (PhysicsWorld other = world.fork()) {
            other.restore(then);
            List<BodyRef> recorded = other.bodies();
            List<BodyRef> bodies = world.bodies();
            for (int i = 0; i < Math.max(recorded.size(), bodies.size()); i++) {
                if (i >= bodies.size()) {
                    return recorded.get(i) + ", which is not there now,";
                }
                if (i >= recorded.size() || !same(recorded.get(i), bodies.get(i))) {
                    return bodies.get(i).toString();
                }
            }
            return null;
        }
    }

    private static boolean same(BodyRef a, BodyRef b) {
        Vector3d x = new Vector3d();
        Vector3d y = new Vector3d();
        return a.entity() == b.entity()
                && a.position(x).equals(b.position(y))
                && a.velocity(x).equals(b.velocity(y))
                && a.angularVelocity(x).equals(b.angularVelocity(y))
                && a.orientation(new Quaterniond()).equals(b.orientation(new Quaterniond()));
    }
}
