package dev.cairn.core.snapshot;

import static dev.cairn.core.snapshot.PoseSnapshot.STRIDE;

import dev.cairn.core.ecs.component.Entities;

import java.util.Arrays;

/**
 * The last two poses by entity, not by row, so that rows may move between chunks. Knows when a pair
 * must not be interpolated: a new entity, a reused index, a teleport, or a pause in being visible.
 */
final class PoseHistory {
    private static final int FIRST_CAPACITY = 64;

    private long[] entities = new long[FIRST_CAPACITY];
    private long[] ticks = new long[FIRST_CAPACITY];
    private int[] jumps = new int[FIRST_CAPACITY];
    private double[] previous = new double[FIRST_CAPACITY * STRIDE];
    private double[] current = new double[FIRST_CAPACITY * STRIDE];

    /**
     * Takes the pose of an entity at a tick from {@code pose[at]}, and puts the one to interpolate
     * from into {@code from[at]}.
     *
     * @param lastTick the tick published before this one
     */
    void advance(
            long entity, int jump, long tick, long lastTick, double[] pose, double[] from, int at) {
        int index = Entities.index(entity);
        if (index >= entities.length) {
            grow(index + 1);
        }
        int own = index * STRIDE;
        boolean known =
                entities[index] == entity && jumps[index] == jump && ticks[index] == lastTick;
        if (!known) {
            System.arraycopy(pose, at, previous, own, STRIDE);
        } else if (tick != lastTick) {
            System.arraycopy(current, own, previous, own, STRIDE);
        }
        System.arraycopy(pose, at, current, own, STRIDE);
        System.arraycopy(previous, own, from, at, STRIDE);
        entities[index] = entity;
        jumps[index] = jump;
        ticks[index] = tick;
    }

    private void grow(int needed) {
        int capacity = Math.max(needed, entities.length * 2);
        entities = Arrays.copyOf(entities, capacity);
        ticks = Arrays.copyOf(ticks, capacity);
        jumps = Arrays.copyOf(jumps, capacity);
        previous = Arrays.copyOf(previous, capacity * STRIDE);
        current = Arrays.copyOf(current, capacity * STRIDE);
    }
}
