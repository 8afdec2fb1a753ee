package dev.cairn.physics.query;

/** What a ray or a moving shape met. Filled by a query, again and again. */
public final class Hit {
    double seconds, distance, pointX, pointY, pointZ, normalX, normalY, normalZ;
    boolean inside;
    boolean capped;
    int triangle = -1;
    double weight1, weight2;

    /** Without a hit. */
    public Hit() {}

    /**
     * Takes over another hit.
     *
     * @param other which one
     */
    public void set(Hit other) {
        seconds = other.seconds;
        distance = other.distance;
        pointX = other.pointX;
        pointY = other.pointY;
        pointZ = other.pointZ;
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        inside = other.inside;
        capped = other.capped;
        triangle = other.triangle;
        weight1 = other.weight1;
        weight2 = other.weight2;
    }

    /** From what met the mover to what the mover met, which it had moved away from. */
    void back(double dx, double dy, double dz) {
        pointX += distance * dx;
        pointY += distance * dy;
        pointZ += distance * dz;
        normalX = -normalX;
        normalY = -normalY;
        normalZ = -normalZ;
    }

    /**
     * When shapes that move by a {@link Motion} touch.
     *
     * @return s since the start, at least 0; 0 of rays and of what moves along a direction, which
     *     know no time
     */
    public double seconds() {
        return seconds;
    }

    /**
     * How far it went; of what moves by a {@link Motion}, how far its pivot is from where it
     * started.
     *
     * @return m, at least 0
     */
    public double distance() {
        return distance;
    }

    /**
     * Where it touched.
     *
     * @return world, m
     */
    public double pointX() {
        return pointX;
    }

    /**
     * See {@link #pointX}.
     *
     * @return world, m
     */
    public double pointY() {
        return pointY;
    }

    /**
     * See {@link #pointX}.
     *
     * @return world, m
     */
    public double pointZ() {
        return pointZ;
    }

    /**
     * The outward unit normal of what was met.
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
     * Whether it touched or overlapped before it moved; the distance is then 0 and the normal shows
     * the shortest way out.
     *
     * @return true if so
     */
    public boolean startsInside() {
        return inside;
    }

    /**
     * Which triangle of a mesh it touched.
     *
     * @return the number that the triangle was given with, or -1 when no mesh was met
     */
    public int triangle() {
        return triangle;
    }

    /**
     * Where in its triangle the point is: barycentric coordinates, which add up to 1.
     *
     * @param corner 0, 1 or 2, in the order in which they were given
     * @return the share of that corner
     */
    public double weight(int corner) {
        return corner == 1 ? weight1 : corner == 2 ? weight2 : 1 - weight1 - weight2;
    }

    /**
     * Whether the search ended early, at a grazing touch: the distance is then a little too short.
     *
     * @return true if so
     */
    public boolean capped() {
        return capped;
    }
}
