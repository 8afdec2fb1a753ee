package dev.cairn.physics.solver.row;

import static dev.cairn.physics.solver.row.ConstraintRows.CHUNK;

import dev.cairn.physics.solver.body.SolverBodies;

import java.util.Arrays;

/**
 * Where things lie in the scratch of a worker. The bodies of a chunk of rows are held with one row
 * to a lane, a line to a field; what the kernels hand on to each other for the group in work is
 * packed, a vector to a field.
 */
public final class Scratch {
    /**
     * Doubles from one field to the next: a chunk and a cache line, so that fields are not all at
     * the same place modulo 4096. No gain could be measured.
     */
    public static final int LINE = CHUNK + 8;

    /** The first 8 numbers of A and of B in {@link SolverBodies#state}. */
    public static final int VA = ConstraintRows.START;

    public static final int VB = VA + 8 * LINE;

    /** Movement and weighted turn of A and of B. */
    public static final int PA = VA + 16 * LINE;

    public static final int PB = VA + 24 * LINE;

    /** Marks of lanes: those that land, those that slide, and all. */
    public static final int LANDS = VA + 32 * LINE;

    public static final int SLIDES = VA + 33 * LINE;
    public static final int ONES = VA + 34 * LINE;

    /** By group, at its first lane: 1 if it has nothing to do. */
    public static final int IDLE = VA + 35 * LINE;

    /** What the kernels hand on about the normals of a group, {@link #PACK} vectors a group. */
    public static final int PACKED = VA + 36 * LINE;

    public static final int PACK = 30;

    /** In the pack of a group, by point: gain, goal, speed without the own impulse, change. */
    public static final int GAIN_PACKED = 0;

    public static final int GOAL_PACKED = 4;
    public static final int SPEED_PACKED = 8;
    public static final int CHANGE_PACKED = 12;

    /** Couplings of the points 01, 02, 12, 03, 13, 23. */
    public static final int COUPLING_PACKED = 16;

    /** By point: inverse of the effective mass, and the impulse that the sweeps start with. */
    public static final int OWN_PACKED = 22;

    public static final int FIRST_PACKED = 26;

    /** Scalar, by point: gain, goal, speed, impulse before and change, and 4 x 4 factors. */
    public static final int GAIN = PACKED;

    public static final int GOAL = GAIN + 4;
    public static final int SPEED = GAIN + 8;
    public static final int CHANGE = GAIN + 12;
    public static final int FACTOR = GAIN + 16;
    public static final int OWN = GAIN + 32;

    static final int SIZE = PACKED + PACK * CHUNK;

    /** For rows of doubles. */
    public final double[] doubles = new double[SIZE];

    /** For rows of floats. */
    public final float[] floats = new float[SIZE];

    public Scratch() {
        Arrays.fill(doubles, ONES, ONES + CHUNK, 1.0);
        Arrays.fill(floats, ONES, ONES + CHUNK, 1.0f);
    }
}
