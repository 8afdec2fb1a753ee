package dev.cairn.physics;

import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.shape.Shape;

/**
 * A collider of a body in a world: a shape on it. Compare with {@code ==}: there is one reference
 * to a collider.
 *
 * <p>Simulation thread, between steps; what only reads may also be called in a pair filter.
 */
public final class ColliderRef {
    private final ColliderTable table;
    private final BodyRef body;
    private final int collider;
    private final int generation;

    ColliderRef(ColliderTable table, BodyRef body, int collider, int generation) {
        this.generation = generation;
        this.table = table;
        this.body = body;
        this.collider = collider;
    }

    /**
     * The body that it is on.
     *
     * @return the body, also when it is gone
     */
    public BodyRef body() {
        return body;
    }

    /**
     * Whether the collider, and its body, are in the world.
     *
     * @return false after removal
     */
    public boolean isAlive() {
        return table.colliders.generation[collider] == generation && body.isAlive();
    }

    /**
     * Its geometry, about its centre of mass.
     *
     * @return the shape
     */
    public Shape shape() {
        return table.colliders.shape[alive()];
    }

    /**
     * Whom it collides with.
     *
     * @return the filter
     */
    public Filter filter() {
        return table.colliders.filter[alive()];
    }

    /**
     * Changes whom it collides with. Contacts that the new filter refuses end in the next step, and
     * are told as ended; who rested on it wakes.
     *
     * @param filter the new one
     */
    public void setFilter(Filter filter) {
        int c = alive();
        body.requireBetweenSteps("setFilter");
        table.setFilter(c, filter);
    }

    private int alive() {
        if (!isAlive()) {
            throw new BodyRemovedException(
                    "the collider of " + body + " was removed; ask isAlive() first");
        }
        return collider;
    }

    @Override
    public String toString() {
        return "collider " + collider + " of " + body;
    }
}
