package dev.cairn.core.ecs;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.ecs.storage.Slab;
import dev.cairn.core.ecs.storage.Store;
import dev.cairn.core.ecs.storage.Watch;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * The observers of one world, in the order of their registration, and what they ask for. Each table
 * knows those of its components, so a change that nobody observes costs a look at an empty array.
 */
final class Observers {
    private final Store store;
    private final List<Observed<?>> observed = new ArrayList<>();
    private @Nullable Commands commands;
    private boolean hasCommands;
    private @Nullable SystemFailure failure;

    /** Whether an observer is being called. */
    boolean calling;

    Observers(Store store) {
        this.store = store;
    }

    /** One observer of one component. */
    private final class Observed<T extends Record> extends Watch {
        private final Component<T> key;
        private final Observer<T> observer;
        private final Change<T> change;

        Observed(World world, Component<T> key, Observer<T> observer) {
            super(key);
            this.key = key;
            this.observer = observer;
            this.change = new Change<>(world, key);
        }

        @Override
        public void keep(Slab slab, int local) {
            change.keep(slab, local);
        }

        @Override
        public void tell(What what, long entity, Slab slab, int local) {
            change.begin(entity, slab, local, what.equals(What.SET));
            calling = true;
            try {
                switch (what) {
                    case ADDED -> observer.added(change);
                    case SET -> observer.set(change);
                    case REMOVED -> observer.removed(change);
                }
            } catch (Throwable thrown) {
                note(thrown, this, what, entity);
            } finally {
                calling = false;
                change.end();
            }
        }

        boolean is(Component<?> otherComponent, Observer<?> otherObserver) {
            return component.equals(otherComponent) && observer.equals(otherObserver);
        }
    }

    /** Whoever resolves the handles of the commands. Once, before the first change. */
    void resolveBy(Commands.Handles handles) {
        commands = new Commands(store, handles, Handle.OBSERVERS, 0, null);
    }

    <T extends Record> void add(World world, Component<T> component, Observer<T> observer) {
        for (Observed<?> known : observed) {
            if (known.is(component, observer)) {
                throw new IllegalStateException(
                        "this object observes "
                                + component
                                + " already, and would be told twice; give another one");
            }
        }
        observed.add(new Observed<>(world, component, observer));
        refresh();
    }

    boolean remove(Component<?> component, Observer<?> observer) {
        boolean known = observed.removeIf(each -> each.is(component, observer));
        refresh();
        return known;
    }

    /** Those of another world, behind the own ones. */
    void addAll(Observers other, World world) {
        for (Observed<?> each : other.observed) {
            addLike(each, world);
        }
    }

    private <T extends Record> void addLike(Observed<T> other, World world) {
        add(world, other.key, other.observer);
    }

    private void refresh() {
        store.watchBy(observed.toArray(Watch[]::new));
    }

    private void note(Throwable thrown, Observed<?> by, Watch.What what, long entity) {
        SystemFailure told =
                new SystemFailure(
                        "observer '"
                                + by.observer.getClass().getName()
                                + "' of "
                                + by.component
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
