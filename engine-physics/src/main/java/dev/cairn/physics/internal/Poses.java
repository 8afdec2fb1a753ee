package dev.cairn.physics.internal;

/**
 * Where things are: columns that bodies have, and that kernels of the narrow phase read for
 * colliders.
 */
public class Poses {
    /** No poses. */
    Poses() {}

    /** Centre of mass of the body, or centre of the collider, world, m. */
    public double[] positionX = {}, positionY = {}, positionZ = {};

    /**
     * What the position lacks, m, 3 to a slot: the centre is at position and this together. 0
     * nearer to the origin than {@link BodyStore#FAR}; kept by {@link BodyStore#move}.
     */
    public double[] positionLow = {};

    /** Whether a position has ever lacked something. */
    public boolean isFar;

    /** Unit quaternion world from body, or from collider. */
    public double[] orientationX = {}, orientationY = {}, orientationZ = {}, orientationW = {};

    /** Declares the columns. */
    public void columns(Columns c) {
        positionX = c.column("positionX", positionX);
        positionY = c.column("positionY", positionY);
        positionZ = c.column("positionZ", positionZ);
        positionLow = c.column("positionLow", positionLow, 3);
        orientationX = c.column("orientationX", orientationX);
        orientationY = c.column("orientationY", orientationY);
        orientationZ = c.column("orientationZ", orientationZ);
        orientationW = c.column("orientationW", orientationW);
    }

    /** From one centre to another. */
    public final double apartX(int a, int b) {
        double d = positionX[b] - positionX[a];
        return isFar ? apart(d, 3 * a, 3 * b) : d;
    }

    /** From one centre to another. */
    public final double apartY(int a, int b) {
        double d = positionY[b] - positionY[a];
        return isFar ? apart(d, 3 * a + 1, 3 * b + 1) : d;
    }

    /** From one centre to another. */
    public final double apartZ(int a, int b) {
        double d = positionZ[b] - positionZ[a];
        return isFar ? apart(d, 3 * a + 2, 3 * b + 2) : d;
    }

    private double apart(double d, int i, int j) {
        double low = positionLow[j] - positionLow[i];
        return low == 0 ? d : d + low;
    }
}
