package dev.cairn.benchmarks.peer;

import java.util.List;

/**
 * One scene in one engine. One thread, the one that created it, calls all methods. Closing frees
 * what the engine holds outside the heap.
 */
public interface Peer extends AutoCloseable {
    /** Values per body in {@link #readPoses}: x y z of the centre of mass, then x y z w. */
    int POSE_STRIDE = 7;

    /** Values per body in {@link #readVelocities}. */
    int VELOCITY_STRIDE = 6;

    /** Answer of the counters where an engine does not tell. */
    int UNKNOWN = -1;

    /** Advances by one tick of {@link SceneDescription#stepSeconds}, in the set sub-steps. */
    void step();

    /**
     * Reads where the bodies are, fixed ones included, in the order of the description.
     *
     * @param poses receives {@value #POSE_STRIDE} values per body: centre of mass, world, m, then
     *     the quaternion worldFromBody
     */
    void readPoses(double[] poses);

    /**
     * Reads how the bodies move, in the order of the description; zeros for fixed ones.
     *
     * @param velocities receives {@value #VELOCITY_STRIDE} values per body: of the centre of mass,
     *     world, m/s, then the angular velocity, world, rad/s
     */
    void readVelocities(double[] velocities);

    /**
     * Sets gravity for the ticks to come.
     *
     * @param x world, m/s²
     * @param y world, m/s²
     * @param z world, m/s²
     */
    void setGravity(double x, double y, double z);

    /**
     * The pairs of bodies that the last step had in contact.
     *
     * @return a count, or {@link #UNKNOWN}
     */
    int contactPairs();

    /**
     * The contact points of the last step, so that equal times can be told from unequal work.
     *
     * @return a count, or {@link #UNKNOWN}
     */
    int contactPoints();

    /**
     * What was set away from the engine's defaults, and what could not be set as described.
     *
     * @return lines for the report
     */
    List<String> notes();

    @Override
    void close();
}
