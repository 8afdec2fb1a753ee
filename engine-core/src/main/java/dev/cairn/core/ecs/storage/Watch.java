package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Component;

/**
 * Is told of the changes of one component as the store makes them. Each table knows those of its
 * components, so a change that nobody watches costs a look at an empty array.
 */
public abstract class Watch {
    static final Watch[] NONE = {};

    public final Component<?> component;

    /** A watch of a component. */
    protected Watch(Component<?> component) {
        this.component = component;
    }

    /** The value in a row is about to be replaced; {@link #tell} follows. */
    public abstract void keep(Slab slab, int local);

    /** A value has come, was set, or is about to go; it is in the row during the call. */
    public abstract void tell(What what, long entity, Slab slab, int local);

    /** What happened. */
    public enum What {
        ADDED("add"),
        SET("set"),
        REMOVED("remove");

        /** Which call of a world does it. */
        public final String call;

        What(String call) {
            this.call = call;
        }
    }
}
