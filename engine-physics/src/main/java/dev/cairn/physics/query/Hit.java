package dev.cairn.physics.query;

/** What a ray or a moving shape met. Filled by a query, again and again. */
public final class Hit {
    double distance, pointX, pointY, pointZ, normalX, normalY, normalZ;
    boolean inside;
    boolean capped;

    /** Without a hit. */
    public Hit() {}

    /**
     * Takes over another hit.
     *
     * @param other which one
     */
    public void set(Hit other) {
        distance = other.distance;
        pointX = other.pointX;
        pointY = other.pointY;
        pointZ = other.pointZ;
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        inside = other.inside;
        capped = other.capped;
    }

    /**
     * How far it went.
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
     * Whether the search ended early, at a grazing touch: the distance is then a little too short.
     *
     * @return true if so
     */
    public boolean capped() {
        return capped;
    }
}
