package dev.cairn.core.ecs;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * The observers of one world, in the order of their registration, and what they ask for. Each table
 * knows those of its components, so a change that nobody observes costs a look at an empty array.
 */
final class Observers {
    private final Store store;
    private final List<Watch<?>> watches = new ArrayList<>();
    private @Nullable Commands commands;
    private boolean hasCommands;
    private @Nullable SystemFailure failure;

    /** Whether an observer is being called. */
    boolean calling;

    Observers(Store store) {
        this.store = store;
    }

    /** One observer of one component. */
    static final class Watch<T extends Record> {
        static final Watch<?>[] NONE = {};

        final Component<T> component;
        final Observer<T> observer;
        final Change<T> change;

        Watch(World world, Component<T> component, Observer<T> observer) {
            this.component = component;
            this.observer = observer;
            this.change = new Change<>(world, component);
        }

        void tell(What what) {
            switch (what) {
                case ADDED -> observer.added(change);
                case SET -> observer.set(change);
                case REMOVED -> observer.removed(change);
            }
        }

        Watch<T> in(World other) {
            return new Watch<>(other, component, observer);
        }

        boolean is(Component<?> otherComponent, Observer<?> otherObserver) {
            return component.equals(otherComponent) && observer.equals(otherObserver);
        }
    }

    /** What happened. */
    enum What {
        ADDED("add"),
        SET("set"),
        REMOVED("remove");

        final String call;

        What(String call) {
            this.call = call;
        }
    }

    /** Whoever resolves the handles of the commands. Once, before the first change. */
    void resolveBy(Commands.Handles handles) {
        commands = new Commands(store, handles, Handle.OBSERVERS, 0, null);
    }

    void add(Watch<?> added) {
        for (Watch<?> watch : watches) {
            if (watch.is(added.component, added.observer)) {
                throw new IllegalStateException(
                        "this object observes "
                                + added.component
                                + " already, and would be told twice; give another one");
            }
        }
        watches.add(added);
        refresh();
    }

    boolean remove(Component<?> component, Observer<?> observer) {
        boolean known = watches.removeIf(watch -> watch.is(component, observer));
        refresh();
        return known;
    }

    /** Those of another world, behind the own ones. */
    void addAll(Observers other, World world) {
        for (Watch<?> watch : other.watches) {
            add(watch.in(world));
        }
    }

    private void refresh() {
        for (Archetype archetype : store.archetypes) {
            archetype.watches = of(archetype);
        }
    }

    /** The observers of the components of a table. */
    Watch<?>[] of(Archetype archetype) {
        List<Watch<?>> found = new ArrayList<>();
        for (Watch<?> watch : watches) {
            if (archetype.has(watch.component)) {
                found.add(watch);
            }
        }
        return found.isEmpty() ? Watch.NONE : found.toArray(Watch<?>[]::new);
    }

    /** All components of a row have come, or are about to go. */
    void tellAll(What what, long entity, Archetype archetype, int row) {
        for (Watch<?> watch : archetype.watches) {
            tell(watch, what, entity, archetype, row);
        }
    }

    /** One component of a row has come, was set, or is about to go. */
    void tell(What what, long entity, Archetype archetype, int row, Component<?> component) {
        for (Watch<?> watch : archetype.watches) {
            if (watch.component.equals(component)) {
                tell(watch, what, entity, archetype, row);
            }
        }
    }

    /** One component of a row is about to be replaced. */
    void keep(Archetype archetype, int row, Component<?> component) {
        for (Watch<?> watch : archetype.watches) {
            if (watch.component.equals(component)) {
                watch.change.keep(archetype.slab(row), ChunkSizes.local(row));
            }
        }
    }

    private void tell(Watch<?> watch, What what, long entity, Archetype archetype, int row) {
        watch.change.begin(
                entity, archetype.slab(row), ChunkSizes.local(row), what.equals(What.SET));
        calling = true;
        try {
            watch.tell(what);
        } catch (Throwable thrown) {
            note(thrown, watch, what, entity);
        } finally {
            calling = false;
            watch.change.end();
        }
    }

    private void note(Throwable thrown, Watch<?> watch, What what, long entity) {
        SystemFailure told =
                new SystemFailure(
                        "observer '"
                                + watch.observer.getClass().getName()
                                + "' of "
                                + watch.component
                                + " ("
                                + what.call
                                + ", entity "
                                + Entities.toString(entity)
                                + ")",
                        true,
                        thrown);
        if (failure == null) {
            failure = told;
        } else {
            failure.addSuppressed(told);
        }
    }

    /** The recorder of what observers ask for. */
    Commands commands() {
        if (commands == null) {
            throw new IllegalStateException("no world yet");
        }
        hasCommands = true;
        return commands.begin(store.tick);
    }

    /** Makes what was asked for until now, and what that brings; returns how many were skipped. */
    int applyCommands() {
        if (!hasCommands || commands == null) {
            return 0;
        }
        try {
            return commands.apply(store.tick);
        } finally {
            hasCommands = false;
            commands.drop();
        }
    }

    /** What an observer threw since the last call, or null. */
    @Nullable SystemFailure takeFailure() {
        SystemFailure taken = failure;
        failure = null;
        return taken;
    }

    /** The end of a direct change. */
    void settle() {
        SystemFailure taken;
        try {
            applyCommands();
        } finally {
            taken = takeFailure();
        }
        if (taken != null) {
            throw new IllegalStateException(
                    taken.place
                            + " threw: "
                            + taken.failure
                            + "; the change that it was told of is made",
                    taken.failure);
        }
    }

    long entityOf(long handle) {
        return commands == null ? Entities.NONE : commands.entityOf(handle);
    }

    /** The world has another state. */
    void forget() {
        failure = null;
        hasCommands = false;
        if (commands != null) {
            commands.forget();
        }
    }
}
