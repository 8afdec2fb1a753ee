package dev.cairn.physics.query;

/** The nearest points of two shapes. Filled by a query, again and again. */
public final class Closest {
    double distance, normalX, normalY, normalZ, ax, ay, az, bx, by, bz;
    int triangle = -1;
    double weight1, weight2;

    /** Without content. */
    public Closest() {}

    /**
     * Takes over another result.
     *
     * @param other which one
     */
    public void set(Closest other) {
        distance = other.distance;
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        ax = other.ax;
        ay = other.ay;
        az = other.az;
        bx = other.bx;
        by = other.by;
        bz = other.bz;
        triangle = other.triangle;
        weight1 = other.weight1;
        weight2 = other.weight2;
    }

    /** Exchanges the two shapes. */
    void swap() {
        double x = ax;
        double y = ay;
        double z = az;
        ax = bx;
        ay = by;
        az = bz;
        bx = x;
        by = y;
        bz = z;
        normalX = -normalX;
        normalY = -normalY;
        normalZ = -normalZ;
    }

    /**
     * Which triangle of a mesh is nearest.
     *
     * @return the number that the triangle was given with, or -1 when no shape is a mesh
     */
    public int triangle() {
        return triangle;
    }

    /**
     * Where in its triangle the nearest point is: barycentric coordinates, which add up to 1.
     *
     * @param corner 0, 1 or 2, in the order in which they were given
     * @return the share of that corner
     */
    public double weight(int corner) {
        return corner == 1 ? weight1 : corner == 2 ? weight2 : 1 - weight1 - weight2;
    }

    /**
     * How far apart they are; negative, the length of the shortest move that parts them.
     *
     * @return m
     */
    public double distance() {
        return distance;
    }

    /**
     * Unit vector from the first to the second shape, along which the distance is measured.
     *
     * @return x component, world
     */
    public double normalX() {
        return normalX;
    }

    /**
     * See {@link #normalX}.
     *
     * @return y component, world
     */
    public double normalY() {
        return normalY;
    }

    /**
     * See {@link #normalX}.
     *
     * @return z component, world
     */
    public double normalZ() {
        return normalZ;
    }

    /**
     * The nearest point of the first shape; of overlapping shapes, a deepest one. It is on the
     * surface, and distance x normal from {@link #pointBX}.
     *
     * @return world, m
     */
    public double pointAX() {
        return ax;
    }

    /**
     * See {@link #pointAX}.
     *
     * @return world, m
     */
    public double pointAY() {
        return ay;
    }

    /**
     * See {@link #pointAX}.
     *
     * @return world, m
     */
    public double pointAZ() {
        return az;
    }

    /**
     * The nearest point of the second shape, see {@link #pointAX}.
     *
     * @return world, m
     */
    public double pointBX() {
        return bx;
    }

    /**
     * See {@link #pointBX}.
     *
     * @return world, m
     */
    public double pointBY() {
        return by;
    }

    /**
     * See {@link #pointBX}.
     *
     * @return world, m
     */
    public double pointBZ() {
        return bz;
    }
}
