package dev.cairn.physics.state;

import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.union.ConvexUnion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The wholes of bodies with several colliders: the convex shapes that parts make which are of one
 * material and meet the same others, see {@link ColliderStore#whole}. Found anew whenever a body's
 * parts change; one whose parts and shape are as before stays, with all its contacts remember.
 *
 * <p>Simulation thread, between steps.
 */
public final class Wholes {
    private final BodyRegistry registry;
    private final ColliderStore colliders;
    private final PairRules rules;

    private int body;
    private final List<Shape> shapes = new ArrayList<>();
    private final List<double[]> poses = new ArrayList<>();
    private final List<Integer> slots = new ArrayList<>();

    /** Of a registry's bodies. */
    public Wholes(BodyRegistry registry, PairRules rules) {
        this.registry = registry;
        colliders = registry.colliders;
        this.rules = rules;
    }

    /**
     * Whether a body has a whole, or two parts that could be of one; makes no garbage.
     *
     * @param slot of a body with several colliders
     * @return false if there is nothing to find
     */
    public boolean mayMake(int slot) {
        ColliderStore k = colliders;
        for (int c = k.bodies.collider[slot]; c != ColliderStore.NONE; c = k.next[c]) {
            if (k.isWhole(c)) {
                return true;
            }
            for (int d = k.next[c]; d != ColliderStore.NONE; d = k.next[d]) {
                if (ConvexUnion.isSolid(k.shape[c])
                        && ConvexUnion.isSolid(k.shape[d])
                        && !k.sensor[c]
                        && !k.sensor[d]
                        && isLike(c, d)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether all colliders of a body have one filter. */
    public boolean meetAlike(int slot) {
        ColliderStore k = colliders;
        int first = k.bodies.collider[slot];
        for (int c = first; c != ColliderStore.NONE; c = k.next[c]) {
            if (!k.filter[c].equals(k.filter[first])) {
                return false;
            }
        }
        return true;
    }

    /** The parts of a body follow. */
    public void begin(int slot) {
        body = slot;
        shapes.clear();
        poses.clear();
        slots.clear();
    }

    /**
     * One of them.
     *
     * @param pose from the body's centre of mass, as {@link ColliderStore#local}
     */
    public void part(int collider, Shape solid, double[] pose) {
        slots.add(collider);
        shapes.add(solid);
        poses.add(pose);
    }

    /**
     * Finds what they make.
     *
     * @param isNew whether the body is about to be born
     */
    public void end(boolean isNew) {
        List<ConvexUnion> found = ConvexUnion.of(shapes, poses, likeness());
        if (found.isEmpty() && !colliders.wholes) {
            return;
        }
        int[] old = olds();
        int[] taken = new int[found.size()];
        for (int u = 0; u < taken.length; u++) {
            taken[u] = same(old, found.get(u));
        }
        for (int w : old) {
            if (Arrays.stream(taken).noneMatch(t -> t == w)) {
                leave(w);
            }
        }
        for (int c : slots) {
            colliders.whole[c] = 0;
        }
        colliders.sole[body] = 0;
        boolean isChanged = false;
        for (int u = 0; u < taken.length; u++) {
            isChanged |= taken[u] < 0;
            int w = taken[u] < 0 ? make(found.get(u)) : taken[u];
            setShape(w, found.get(u));
        }
        if (isChanged && !isNew) {
            registry.changed(body);
        }
    }

    /** A part goes; so does its whole. */
    public void leave(int slot, int part) {
        body = slot;
        if (colliders.isPart(part)) {
            int w = colliders.standIn(part);
            for (int c = colliders.bodies.collider[slot];
                    c != ColliderStore.NONE;
                    c = colliders.next[c]) {
                if (c != w && colliders.standIn(c) == w) {
                    colliders.whole[c] = 0;
                }
            }
            colliders.sole[slot] = 0;
            leave(w);
        }
    }

    private void leave(int w) {
        colliders.remove(body, w);
        registry.leaveChild(w);
    }

    /** By part: the first part that is as it but for its shape and place; -1 for a sensor. */
    private int[] likeness() {
        int[] like = new int[slots.size()];
        for (int i = 0; i < like.length; i++) {
            int c = slots.get(i);
            int j = 0;
            while (j < i && (like[j] != j || !isLike(slots.get(j), c))) {
                j++;
            }
            like[i] = colliders.sensor[c] ? -1 : j;
        }
        return like;
    }

    private boolean isLike(int a, int b) {
        ColliderStore k = colliders;
        return k.friction[a] == k.friction[b]
                && k.restitution[a] == k.restitution[b]
                && k.rollingArm[a] == k.rollingArm[b]
                && k.mixing[a] == k.mixing[b]
                && k.filter[a].equals(k.filter[b])
                && (!k.belts || Arrays.equals(k.belt, 3 * a, 3 * a + 3, k.belt, 3 * b, 3 * b + 3));
    }

    private int[] olds() {
        int[] found = new int[slots.size()];
        int count = 0;
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            if (colliders.isWhole(c)) {
                found[count++] = c;
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** The whole of before that is one of now, or -1. */
    private int same(int[] old, ConvexUnion now) {
        for (int w : old) {
            int count = 0;
            for (int c : slots) {
                count += colliders.standIn(c) == w ? 1 : 0;
            }
            boolean all = count == now.members().length;
            for (int i : now.members()) {
                all &= colliders.standIn(slots.get(i)) == w;
            }
            if (all && now.isOf(colliders.shape[w])) {
                return w;
            }
        }
        return -1;
    }

    private int make(ConvexUnion union) {
        int w = registry.takeChild();
        colliders.append(body, w, union.shape(), union.pose());
        colliders.wholes = true;
        colliders.whole[w] = w + 1;
        return w;
    }

    /** Gives a whole what its parts have, and its parts the whole. */
    private void setShape(int w, ConvexUnion union) {
        ColliderStore k = colliders;
        System.arraycopy(union.pose(), 0, k.local, ColliderStore.LOCAL * w, ColliderStore.LOCAL);
        int like = slots.get(union.members()[0]);
        k.friction[w] = k.friction[like];
        k.restitution[w] = k.restitution[like];
        k.rollingArm[w] = k.rollingArm[like];
        k.mixing[w] = k.mixing[like];
        k.sensor[w] = false;
        k.userData[w] = null;
        k.palettes.set(w, new double[0]);
        if (k.belts) {
            System.arraycopy(k.belt, 3 * like, k.belt, 3 * w, 3);
        }
        rules.setFilter(w, k.filter[like]);
        int solved = 0;
        for (int c : slots) {
            solved += k.sensor[c] ? 0 : 1;
        }
        for (int i : union.members()) {
            k.whole[slots.get(i)] = w + 1;
        }
        if (union.members().length == solved) {
            k.sole[body] = w + 1;
        }
    }
}
