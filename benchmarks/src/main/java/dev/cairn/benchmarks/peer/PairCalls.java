package dev.cairn.benchmarks.peer;

import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.List;

/**
 * Another engine's call that collides two shapes which are in no world, one pair after another.
 * Such a call keeps nothing from one tick to the next, so it is always cold, and each crosses from
 * Java to native code once; {@link #cross} is the cost of such a crossing alone.
 */
public interface PairCalls {
    /**
     * The call.
     *
     * @return engine, version and method
     */
    String title();

    /**
     * Adds a pair.
     *
     * @param a first shape: a box, ball, capsule or hull
     * @param turnA its orientation, world from body
     * @param b second shape
     * @param turnB its orientation
     * @param offset centre of B minus centre of A, world axes, m
     */
    void add(Shape a, Quaterniondc turnA, Shape b, Quaterniondc turnB, Vector3dc offset);

    /**
     * Collides all pairs.
     *
     * @return what the calls found: hits, or points
     */
    int run();

    /**
     * As many calls of a native method that does next to nothing.
     *
     * @return a sum of what it returned
     */
    long cross();

    /**
     * The calls of the engines whose libraries load.
     *
     * @param missing receives a line for each that does not
     * @return new, without pairs
     */
    static List<PairCalls> all(List<String> missing) {
        List<PairCalls> calls = new ArrayList<>();
        try {
            calls.add(new JoltPairs());
        } catch (MissingEngineException e) {
            missing.add(String.valueOf(e.getMessage()));
        }
        try {
            calls.add(new BulletPairs());
        } catch (MissingEngineException e) {
            missing.add(String.valueOf(e.getMessage()));
        }
        return calls;
    }
}
