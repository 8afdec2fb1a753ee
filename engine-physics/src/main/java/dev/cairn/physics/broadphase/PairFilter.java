package dev.cairn.physics.broadphase;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.ColliderStore;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Which pairs of colliders whose boxes overlap become pairs: the one place where that is said,
 * before a pair gets a row. While {@link #active} is false all do, without being asked.
 *
 * <p>A pair is refused if it is of one body, or of two sensors, of two bodies that were taken
 * {@link #apart}, if the two filters do not meet, or if the user's test says so. Changes are made
 * between steps on the simulation thread; {@link #admits} from blocks of a stage, {@link #passes}
 * on the simulation thread and in a fixed order. Allocates only when something grows.
 */
public final class PairFilter implements Stateful {
    /** A question of the user about a pair, lower collider first. */
    public interface Test {
        /** Whether the two collide; pure. */
        boolean admits(int colliderA, int colliderB);
    }

    /** Whether any pair may be refused. */
    boolean active;

    final ColliderStore colliders;
    private @Nullable Test test;
    private final PairSet excluded = new PairSet();

    /** The same, an entry for each time that a pair was taken apart. */
    private long[] reasons = {};

    private int reasonCount;

    /**
     * Admits all.
     *
     * @param colliders whose filters these are
     */
    public PairFilter(ColliderStore colliders) {
        this.colliders = colliders;
    }

    /**
     * Whether pairs are asked about.
     *
     * @return false while every pair of two bodies is one
     */
    public boolean isActive() {
        return active;
    }

    /** From now on filters are looked at; never ends. */
    public void begin() {
        active = true;
    }

    /**
     * Chooses the user's test.
     *
     * @param value or {@code null} for none
     */
    public void ask(@Nullable Test value) {
        test = value;
        active |= value != null;
    }

    /**
     * Two bodies shall not collide, for one reason more: a joint, for example.
     *
     * @param bodyA slot
     * @param bodyB slot
     * @return whether they collided before this call, as far as this list is concerned
     */
    public boolean apart(int bodyA, int bodyB) {
        long key = PairSet.key(bodyA, bodyB);
        active = true;
        if (reasonCount == reasons.length) {
            reasons = Arrays.copyOf(reasons, Math.max(16, 2 * reasonCount));
        }
        reasons[reasonCount++] = key;
        return excluded.add(key);
    }

    /**
     * One reason of {@link #apart} is gone.
     *
     * @param bodyA slot
     * @param bodyB slot
     * @return whether it was the last one, so that they collide again
     */
    public boolean together(int bodyA, int bodyB) {
        long key = PairSet.key(bodyA, bodyB);
        int count = 0;
        int last = -1;
        for (int i = 0; i < reasonCount; i++) {
            if (reasons[i] == key) {
                count++;
                last = i;
            }
        }
        if (count == 0) {
            return false;
        }
        reasons[last] = reasons[--reasonCount];
        return count == 1 && excluded.remove(key);
    }

    /**
     * A body leaves: another one in its slot collides with all.
     *
     * @param body slot
     */
    public void leave(int body) {
        int kept = 0;
        for (int i = 0; i < reasonCount; i++) {
            long key = reasons[i];
            if ((int) (key >>> 32) == body || (int) key == body) {
                excluded.remove(key);
            } else {
                reasons[kept++] = key;
            }
        }
        reasonCount = kept;
    }

    /** The user's test is the world's own, and stays. */
    @Override
    public void state(StateVisitor s) {
        s.section("pairFilter", this);
        active = s.value("active", active) || test != null;
        reasonCount = s.value("reasonCount", reasonCount);
        reasons = s.array("reasons", reasons, reasonCount);
        excluded.state(s);
    }

    /** Slot of the body of a collider. */
    int body(int collider) {
        return colliders.body[collider];
    }

    /** What bodies and filters say of a pair; any worker, while nobody changes anything. */
    boolean admits(int a, int b) {
        int i = colliders.body[a];
        int j = colliders.body[b];
        if (i == j || (excluded.size() > 0 && excluded.contains(PairSet.key(i, j)))) {
            return false;
        }
        if (colliders.sensors && colliders.sensor[a] && colliders.sensor[b]) {
            return false;
        }
        if (colliders.wholes && (isApart(a, b) || isApart(b, a))) {
            return false;
        }
        Filter one = colliders.filter[a];
        return one.meets(colliders.filter[b]);
    }

    /** A whole meets other wholes, and what is no part of one; sensors see its parts. */
    private boolean isApart(int whole, int other) {
        return colliders.isWhole(whole)
                && (colliders.isPart(other) || (colliders.sensors && colliders.sensor[other]));
    }

    /** What the user says of a pair that {@link #admits}; of wholes, what of all their parts. */
    boolean passes(int a, int b) {
        if (test == null) {
            return true;
        }
        if (!colliders.isWhole(a) && !colliders.isWhole(b)) {
            return test.admits(Math.min(a, b), Math.max(a, b));
        }
        for (int c = firstPart(a, colliders.bodies.collider[colliders.body[a]]); c >= 0; ) {
            for (int d = firstPart(b, colliders.bodies.collider[colliders.body[b]]); d >= 0; ) {
                if (!test.admits(Math.min(c, d), Math.max(c, d))) {
                    return false;
                }
                d = firstPart(b, colliders.next[d]);
            }
            c = firstPart(a, colliders.next[c]);
        }
        return true;
    }

    /** The first of a body's colliders, from one on, that another one stands for, or is. */
    private int firstPart(int whole, int from) {
        int c = from;
        while (c >= 0 && (colliders.standIn(c) != whole || colliders.isWhole(c))) {
            c = colliders.next[c];
        }
        return c;
    }

    /** Both questions. */
    boolean isPair(int a, int b) {
        return admits(a, b) && passes(a, b);
    }
}
