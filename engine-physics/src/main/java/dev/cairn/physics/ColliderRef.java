package dev.cairn.physics;

import dev.cairn.core.state.StateCodec;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.shape.Shape;

import org.jspecify.annotations.Nullable;

/**
 * A collider of a body in a world: a shape on it. Compare with {@code ==}: there is one reference
 * to a collider.
 *
 * <p>Simulation thread, between steps; what only reads may also be called in a pair filter.
 */
public final class ColliderRef {
    private final ColliderTable table;
    private final BodyRef body;

    /** Its slot now; -1 when it is gone. */
    private int collider;

    /** In bytes a reference is a body and a place; a world makes its own of it. */
    static final StateCodec<ColliderRef> CODEC =
            StateCodec.of(
                    ColliderRef.class,
                    "collider.reference",
                    (ref, out) -> {
                        out.writeObject(ref.body);
                        out.writeInt(ref.collider);
                    },
                    in -> ofNoWorld(in.readObject(BodyRef.class), in.readInt()));

    @SuppressWarnings("NullAway") // nobody sees it before a world has made its own of it
    private static ColliderRef ofNoWorld(BodyRef body, int collider) {
        return new ColliderRef(null, body, collider);
    }

    ColliderRef(ColliderTable table, BodyRef body, int collider) {
        this.table = table;
        this.body = body;
        this.collider = collider;
    }

    int slot() {
        return collider;
    }

    boolean isOf(ColliderTable owner) {
        return table == owner;
    }

    /** It has another slot, or -1 for none. */
    void move(int slot) {
        collider = slot;
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
     * Whether it only tells who is in it.
     *
     * @return true for a sensor
     */
    public boolean isSensor() {
        return table.spec(alive()).sensor;
    }

    /**
     * Whether the collider, and its body, are in the world.
     *
     * @return false after removal
     */
    public boolean isAlive() {
        return collider >= 0 && body.isAlive();
    }

    /**
     * Its geometry, as it was given, in a frame of its own.
     *
     * @return the shape
     */
    public Shape shape() {
        return table.spec(alive()).shape;
    }

    /**
     * What it was made of: shape, place, material, filter, user data.
     *
     * @return the description, complete
     */
    public Collider description() {
        return table.now(alive());
    }

    /**
     * Friction, restitution and density.
     *
     * @return the material
     */
    public Material material() {
        return table.spec(alive()).material();
    }

    /**
     * Changes friction and restitution, from the next step on; the mass of the body stays as it is.
     * The body wakes.
     *
     * @param material the new one
     */
    public void setMaterial(Material material) {
        int c = alive();
        body.requireBetweenSteps("setMaterial");
        table.setMaterial(c, material);
    }

    /**
     * What the user attached.
     *
     * @return the object, or {@code null}
     */
    public @Nullable Object userData() {
        return table.spec(alive()).userData;
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

    /**
     * Puts another collider in the place of this one; this reference stays, and so do touches that
     * the next step finds too. Mass, centre and inertia of the body follow, its frame stays where
     * it is.
     *
     * @param other what it shall be; material and filter are this one's if it says none
     * @throws IllegalArgumentException if the body would have no finite mass
     */
    public void replace(Collider other) {
        int c = alive();
        body.requireBetweenSteps("replace");
        table.replace(c, Checks.notNull("other", other));
    }

    /**
     * Takes the collider off its body. Its touches end with the next step; mass, centre and inertia
     * of the body follow, its frame stays where it is.
     *
     * @throws IllegalStateException if it is the body's only one
     */
    public void remove() {
        int c = alive();
        body.requireBetweenSteps("remove");
        table.remove(c);
    }

    private int alive() {
        if (!isAlive()) {
            throw new BodyRemovedException(
                    "a collider of " + body + " was removed; ask isAlive() first");
        }
        return collider;
    }

    @Override
    public String toString() {
        return "collider " + collider + " of " + body;
    }
}
