package dev.cairn.physics;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.shape.Shape;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

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

    /**
     * The body that it is on.
     *
     * @return the body, also when it is gone
     */
    public BodyRef body() {
        return body;
    }

    /**
     * Whether it only tells what is in it.
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
     * What it collides with.
     *
     * @return the filter
     */
    public Filter filter() {
        return table.colliders.filter[alive()];
    }

    /**
     * Changes what it collides with. Contacts that the new filter refuses end in the next step, and
     * are told as ended; bodies that rested on it wake.
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

    /** Those of a world, by slot; that of a collider that is gone stays until another one comes. */
    static final class All {
        private final ColliderTable table;
        private ColliderRef[] refs = {};

        /** Room to restore: those of the state, and those that there were. */
        private ColliderRef[] saved = {}, before = {};

        /** Where they say that their colliders are; room to save that. */
        private int[] places = {};

        All(ColliderTable table) {
            this.table = table;
        }

        void ensureSlots(int slots) {
            refs = Arrays.copyOf(refs, slots);
        }

        ColliderRef get(int collider) {
            return refs[collider];
        }

        boolean has(int collider) {
            return refs[collider] != null;
        }

        void begin(int collider, BodyRef body) {
            refs[collider] = new ColliderRef(table, body, collider);
        }

        /** It stays here, for the events of its end. */
        void end(int collider) {
            refs[collider].collider = -1;
        }

        void move(ColliderRef ref, int collider) {
            ref.collider = collider;
            refs[collider] = ref;
        }

        void state(StateVisitor s, int slots, BodyRef[] bodies) {
            s.section("colliderRefs", this);
            if (places.length < slots) {
                places = new int[refs.length];
            }
            for (int c = 0; c < slots && !s.isRestoring(); c++) {
                places[c] = refs[c] == null ? -1 : refs[c].collider;
            }
            ColliderRef[] of = s.array("refs", s.isRestoring() ? saved : refs, slots);
            places = s.array("places", places, slots);
            if (s.isRestoring()) {
                saved = of;
                own(slots, bodies);
            }
        }

        /**
         * A reference that the world has given stays; for those of another one it makes its own.
         */
        private void own(int slots, BodyRef[] bodies) {
            if (before.length < refs.length) {
                before = new ColliderRef[refs.length];
            }
            System.arraycopy(refs, 0, before, 0, refs.length);
            for (ColliderRef ref : refs) {
                if (ref != null) {
                    ref.collider = -1;
                }
            }
            Arrays.fill(refs, null);
            for (int c = 0; c < slots; c++) {
                ColliderRef ref = saved[c];
                if (ref == null) {
                    continue;
                }
                if (ref.table != table) {
                    BodyRef body = bodies[ref.body.slot()];
                    ref = before[c] != null && before[c].body == body ? before[c] : null;
                    ref = ref == null ? new ColliderRef(table, body, places[c]) : ref;
                }
                refs[c] = ref;
            }
            for (int c = 0; c < slots; c++) {
                if (refs[c] != null) {
                    refs[c].collider = places[c];
                }
            }
        }
    }
}
