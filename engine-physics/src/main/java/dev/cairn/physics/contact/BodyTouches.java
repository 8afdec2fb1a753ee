package dev.cairn.physics.contact;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.broadphase.PairSet;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Which pairs of bodies began and ceased to touch in a tick, whatever number of their shapes does:
 * two bodies touch while at least one pair of their shapes touches. What changes within one tick
 * and back is not told. Which of them met at speed, each pair by the strongest hit of its shapes.
 *
 * <p>The number of touching pairs of shapes is counted for each pair of bodies, from the events of
 * {@link TouchEvents} alone. So each end has its begin as theirs have. The order is that of the
 * first event of the pair of bodies in the tick, ends of shapes before begins; that of hits is the
 * order of the pair's first hit of shapes.
 *
 * <p>A table with open addressing, asked for one pair at a time and never iterated. Simulation
 * thread; allocates only when something grows.
 */
public final class BodyTouches implements Stateful {
    private final ColliderStore colliders;

    /** By place: the pair of bodies, or 0; how many pairs of their shapes touch, plus 1. */
    private long[] keys = new long[64];

    private int[] counts = new int[64];

    /** By place: one more than the pair's number in {@link #changed}; 0 between ticks. */
    private int[] change = new int[64];

    private int shift = 64 - 6;
    private int size;

    /** Room for the pairs of a state: lower and higher bodies, counts. */
    private int[] lower = {};

    private int[] higher = {};
    private int[] counted = {};

    /** Pairs of bodies with events in this tick: the last pair of shapes; touched before or not. */
    private long[] changed = new long[16];

    private int[] shapes = new int[32];
    private boolean[] before = new boolean[16];
    private int changes;

    /** By such a pair: one more than the number of its hit in {@link #hits}, or 0. */
    private int[] hitOf = new int[16];

    private int[] hits = new int[16];
    private int hitCount;

    /**
     * The colliders of the last pair of shapes that began to touch, or that ceased, of bodies that
     * did; the one of the lower body at side 0.
     */
    public final PairList began = new PairList(), ended = new PairList();

    /**
     * Without touches.
     *
     * @param colliders whose bodies these are
     */
    public BodyTouches(ColliderStore colliders) {
        this.colliders = colliders;
    }

    /**
     * Takes the events of a tick.
     *
     * @param events after {@link TouchEvents#update}
     * @param rows those that the hits name
     */
    public void update(TouchEvents events, ContactStore rows) {
        changes = 0;
        began.clear();
        ended.clear();
        hitCount = 0;
        for (int i = 0; i < events.ended.count(); i++) {
            count(events.ended.collider(i, 0), events.ended.collider(i, 1), -1);
        }
        for (int i = 0; i < events.began.count(); i++) {
            count(events.began.collider(i, 0), events.began.collider(i, 1), 1);
        }
        for (int i = 0; i < events.hitCount(); i++) {
            hit(rows, events.hit(i));
        }
        for (int i = 0; i < changes; i++) {
            boolean touches = counts[find(changed[i])] > 1;
            if (touches != before[i]) {
                (touches ? began : ended).add(shapes[2 * i], shapes[2 * i + 1]);
            }
        }
        for (int i = 0; i < changes; i++) {
            int at = find(changed[i]);
            change[at] = 0;
            if (counts[at] == 1) {
                remove(at);
            }
        }
    }

    /** Lower body first, so that an end names the two as their begin did. */
    private void count(int a, int b, int step) {
        boolean swap = colliders.body[a] > colliders.body[b];
        long key = PairSet.key(colliders.body[a], colliders.body[b]);
        int at = find(key);
        if (keys[at] == 0) {
            if (2 * (size + 1) > keys.length) {
                grow();
                at = find(key);
            }
            keys[at] = key;
            counts[at] = 1;
            size++;
        }
        if (change[at] == 0) {
            note(key, counts[at] > 1);
            change[at] = changes;
        }
        int i = change[at] - 1;
        shapes[2 * i] = swap ? b : a;
        shapes[2 * i + 1] = swap ? a : b;
        counts[at] += step;
    }

    private void note(long key, boolean touched) {
        if (changes == changed.length) {
            changed = Arrays.copyOf(changed, 2 * changes);
            before = Arrays.copyOf(before, 2 * changes);
            hitOf = Arrays.copyOf(hitOf, 2 * changes);
            shapes = Arrays.copyOf(shapes, 4 * changes);
        }
        changed[changes] = key;
        hitOf[changes] = 0;
        before[changes++] = touched;
    }

    /** A hit of shapes; each is one of a touch that begins, so its pair of bodies is noted. */
    private void hit(ContactStore rows, int row) {
        int pair = change[find(PairSet.key(rows.bodyA[row], rows.bodyB[row]))] - 1;
        if (hitOf[pair] == 0) {
            if (hitCount == hits.length) {
                hits = Arrays.copyOf(hits, 2 * hitCount);
            }
            hits[hitCount++] = row;
            hitOf[pair] = hitCount;
        } else if (rows.normalImpulse(row) > rows.normalImpulse(hits[hitOf[pair] - 1])) {
            hits[hitOf[pair] - 1] = row;
        }
    }

    /** How many pairs of bodies met at speed. */
    public int hitCount() {
        return hitCount;
    }

    /**
     * The row of the strongest hit of a pair of bodies that met at speed, the one of the largest
     * impulse and of equal ones the first; until the next tick.
     *
     * @param hit 0 to hitCount - 1
     */
    public int hit(int hit) {
        return hits[hit];
    }

    // The table ----------------------------------------------------------------------------------

    private int home(long key) {
        return (int) ((key * 0x9E3779B97F4A7C15L) >>> shift);
    }

    /** Where a pair is, or would be. */
    private int find(long key) {
        int at = home(key);
        while (keys[at] != 0 && keys[at] != key) {
            at = (at + 1) & (keys.length - 1);
        }
        return at;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldCounts = counts;
        int[] oldChange = change;
        keys = new long[2 * oldKeys.length];
        shift--;
        counts = new int[keys.length];
        change = new int[keys.length];
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldKeys[i] != 0) {
                int at = find(oldKeys[i]);
                keys[at] = oldKeys[i];
                counts[at] = oldCounts[i];
                change[at] = oldChange[i];
            }
        }
    }

    private void remove(int place) {
        int mask = keys.length - 1;
        int hole = place;
        for (int next = (hole + 1) & mask; keys[next] != 0; next = (next + 1) & mask) {
            // one may fill the hole if its home is not between the hole and its place
            if (((next - home(keys[next])) & mask) >= ((next - hole) & mask)) {
                keys[hole] = keys[next];
                counts[hole] = counts[next];
                change[hole] = change[next];
                hole = next;
            }
        }
        keys[hole] = 0;
        change[hole] = 0;
        size--;
    }

    /** The pairs in the order of the table, as those of a {@link PairSet}. */
    @Override
    public void state(StateVisitor s) {
        s.section("bodyTouches", this);
        s.rows(size);
        int count = s.count("size", size);
        if (lower.length < count) {
            lower = new int[Math.max(count, keys.length / 2)];
            higher = new int[lower.length];
            counted = new int[lower.length];
        }
        if (!s.isRestoring()) {
            list();
        }
        lower = s.array("lower", lower, 0, count, lower.length, false);
        higher = s.array("higher", higher, 0, count, higher.length, false);
        counted = s.array("counted", counted, 0, count, counted.length, false);
        if (s.isRestoring()) {
            put(count);
        }
        s.section("bodyHits", this);
        hitCount = s.count("hitCount", hitCount);
        hits = s.array("hits", hits, hitCount);
        began.state(s);
        ended.state(s);
    }

    private void list() {
        int to = 0;
        for (int at = 0; at < keys.length; at++) {
            if (keys[at] != 0) {
                lower[to] = (int) (keys[at] >>> 32);
                higher[to] = (int) keys[at];
                counted[to++] = counts[at];
            }
        }
    }

    private void put(int count) {
        Arrays.fill(keys, 0);
        Arrays.fill(counts, 0);
        Arrays.fill(change, 0);
        size = 0;
        for (int i = 0; i < count; i++) {
            if (2 * (size + 1) > keys.length) {
                grow();
            }
            int at = find(PairSet.key(lower[i], higher[i]));
            size += keys[at] == 0 ? 1 : 0;
            keys[at] = PairSet.key(lower[i], higher[i]);
            counts[at] = counted[i];
        }
    }
}
