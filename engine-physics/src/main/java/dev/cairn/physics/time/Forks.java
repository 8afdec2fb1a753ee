package dev.cairn.physics.time;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.Objects;
import java.util.function.Consumer;

/**
 * Many forks of one world that share all that has not changed: each is the moment at which they
 * began, which is there once, and what differs from it, see {@link StateDelta}. A fork in which ten
 * bodies of a thousand move takes some kilobytes, where {@link PhysicsWorld#fork}, which can step
 * beside others at any time, has columns of its own.
 *
 * <pre>
 *   moment ──┬─ δ ─ fork            in(...): one world, put to moment + δ, acted on and stepped;
 *            ├─ δ ─ fork            what it has become is the fork's new δ
 *            └─ δ ─ fork of a fork
 * </pre>
 *
 * <p>All forks are acted on in one world, one after the other: a change of forks costs a copy of
 * the moment and to restore and save it, 0.6 ms for 1000 bodies. One thread at a time; the systems
 * and resources of the world are shared, as by {@link PhysicsWorld#fork}.
 */
public final class Forks implements AutoCloseable {
    private final PhysicsWorld world;
    private final WorldState moment = new WorldState();
    private final WorldState whole = new WorldState();
    private boolean acts;

    /**
     * Forks of the present state of a world, which stays as it is and is not needed any more.
     *
     * @param origin any world, not inside a step
     */
    public Forks(PhysicsWorld origin) {
        world = Objects.requireNonNull(origin, "origin must not be null").fork();
        world.save(moment);
    }

    /**
     * A fork of the moment.
     *
     * @return another one in each call
     */
    public Fork fork() {
        return new Fork(null);
    }

    /**
     * What the forks share, beside the one world that all act in.
     *
     * @return bytes of the moment's numbers
     */
    public long sharedByteCount() {
        return moment.byteCount();
    }

    /** Ends the world in which the forks act; they can still be read. */
    @Override
    public void close() {
        world.close();
    }

    /** A world that waits: it goes on when it is acted on. */
    public final class Fork {
        /** From the moment; null while nothing differs. */
        private @Nullable StateDelta delta;

        private Fork(@Nullable StateDelta delta) {
            this.delta = delta;
        }

        /**
         * Acts on this fork, such as to push a body and to step. If it throws, the fork stays as it
         * was.
         *
         * @param act gets the world in this fork's state, for the time of the call; {@code bodyOf}
         *     finds its bodies
         */
        public void in(Consumer<PhysicsWorld> act) {
            Objects.requireNonNull(act, "act must not be null");
            if (acts) {
                throw new IllegalStateException(
                        "a fork is being acted on, in the world that all forks share; act on this"
                                + " one when that call has returned");
            }
            lead();
            world.restore(whole);
            acts = true;
            try {
                act.accept(world);
            } finally {
                acts = false;
            }
            world.save(whole);
            StateDelta now = StateDelta.between(moment, whole);
            delta = now.isEmpty() ? null : now;
        }

        /**
         * A fork of this one; shares all with it until one of them is acted on.
         *
         * @return another one in each call
         */
        public Fork fork() {
            return new Fork(delta);
        }

        /**
         * The state of this fork as a value of its own, whole.
         *
         * @return for example for {@link PhysicsWorld#restore}
         */
        public WorldState save() {
            lead();
            WorldState own = new WorldState();
            own.set(whole);
            return own;
        }

        /**
         * What this fork takes beside what all share.
         *
         * @return bytes; 0 while it is as at the moment
         */
        public long byteCount() {
            return delta == null ? 0 : delta.byteCount();
        }

        private void lead() {
            whole.set(moment);
            if (delta != null) {
                delta.apply(whole);
            }
        }
    }
}
