package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.storage.Store;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.LongConsumer;

/**
 * What a world holds, and the immediate changes of it: entities, their components, resources. The
 * part of {@link World} that knows neither systems nor ticks, apart from refusing changes during
 * one.
 */
abstract sealed class WorldContents permits World {
    final Store store = new Store();
    final Observers observers = new Observers(store);
    private final Map<Class<?>, Object> resources = new HashMap<>();

    /** Number of completed ticks. */
    long tickNumber;

    boolean stepping;
    boolean closed;

    /**
     * Makes an entity.
     *
     * @param components its components, each at most once; none is fine
     * @return the entity
     * @throws NullPointerException if a component is null
     * @throws ComponentException if a component is given twice
     * @throws WorldClosedException after {@link World#close}
     * @throws IllegalStateException during a step
     */
    public final long spawn(Record... components) {
        requireChangeable("spawn");
        requireParts(components);
        return settled(components.length == 0 ? store.spawn() : store.spawn(components));
    }

    /**
     * Makes an entity that belongs to something else too: that takes it before what observers asked
     * for is made, and before what one of them threw is thrown.
     *
     * @param owner takes the entity
     * @param components its components, each at most once
     * @return the entity
     * @throws IllegalStateException during a step, and if an observer throws; then the entity is
     *     there and was taken
     */
    public final long spawn(LongConsumer owner, Record... components) {
        requireChangeable("spawn");
        requireParts(components);
        long entity = store.spawn(components);
        owner.accept(entity);
        return settled(entity);
    }

    /**
     * Makes an entity; see {@link #spawn(Record...)}. Allocates only while tables grow.
     *
     * @param a its component
     * @return the entity
     */
    public final long spawn(Record a) {
        requireChangeable("spawn");
        return settled(store.spawn(requirePart(a)));
    }

    /**
     * Makes an entity; see {@link #spawn(Record...)}. Allocates only while tables grow.
     *
     * @param a one component
     * @param b another component
     * @return the entity
     */
    public final long spawn(Record a, Record b) {
        requireChangeable("spawn");
        return settled(store.spawn(requirePart(a), requirePart(b)));
    }

    /**
     * Makes an entity; see {@link #spawn(Record...)}.
     *
     * @param a one component
     * @param b another component
     * @param c another component
     * @return the entity
     */
    public final long spawn(Record a, Record b, Record c) {
        requireChangeable("spawn");
        return settled(store.spawn(new Record[] {requirePart(a), requirePart(b), requirePart(c)}));
    }

    /**
     * Makes an entity; see {@link #spawn(Record...)}.
     *
     * @param a one component
     * @param b another component
     * @param c another component
     * @param d another component
     * @return the entity
     */
    public final long spawn(Record a, Record b, Record c, Record d) {
        requireChangeable("spawn");
        return settled(
                store.spawn(
                        new Record[] {
                            requirePart(a), requirePart(b), requirePart(c), requirePart(d)
                        }));
    }

    /**
     * Makes many entities with the same components; their columns can be filled afterwards through
     * a {@link #query}.
     *
     * @param count number of entities, at least 0
     * @param components their components, each at most once
     * @return the entities
     * @throws IllegalArgumentException if the count is negative
     * @throws NullPointerException if a component is null
     * @throws ComponentException if a component is given twice
     */
    public final long[] spawnMany(int count, Record... components) {
        requireChangeable("spawnMany");
        requireParts(components);
        if (count < 0) {
            throw new IllegalArgumentException("count is " + count + ", but must be at least 0");
        }
        long[] entities = new long[count];
        store.spawnMany(entities, components);
        observers.settle();
        return entities;
    }

    /**
     * Deletes an entity. Its id never names another one.
     *
     * @param entity the entity
     * @throws DeadEntityException if it is not alive
     */
    public final void delete(long entity) {
        requireChangeable("delete");
        store.delete(entity);
        observers.settle();
    }

    /**
     * Whether an entity exists.
     *
     * @param entity any id
     * @return whether it was made by this world and not deleted since
     */
    public final boolean isAlive(long entity) {
        return store.entities.isAlive(entity);
    }

    /**
     * Gives an entity one more component.
     *
     * @param entity the entity
     * @param component the component, which it has not yet
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     * @throws ComponentException if it has such a component; then use {@link #set}
     */
    public final void add(long entity, Record component) {
        requireChangeable("add");
        store.add(entity, requirePart(component));
        observers.settle();
    }

    /**
     * Takes a component from an entity.
     *
     * @param entity the entity
     * @param component the component, which it has
     * @param <T> the record
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     * @throws ComponentException if it has no such component
     */
    public final <T extends Record> void remove(long entity, Component<T> component) {
        requireChangeable("remove");
        requireKey(component);
        store.remove(entity, component);
        observers.settle();
    }

    /**
     * Takes all components from an entity; it stays alive.
     *
     * @param entity the entity
     * @throws DeadEntityException if it is not alive
     */
    public final void clear(long entity) {
        requireChangeable("clear");
        store.clear(entity);
        observers.settle();
    }

    /**
     * A component of an entity, as a new record. During a step this is the published value; of a
     * component that a running system writes {@code inPlace} it is the value of that moment, old or
     * new or half of each, as that system and its thread happen to have come. So read such a
     * component during a step through {@code next} only, which waits for its writer.
     *
     * @param entity the entity
     * @param component the component, which it has
     * @param <T> the record
     * @return its published value
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     * @throws ComponentException if it has no such component
     */
    public final <T extends Record> T get(long entity, Component<T> component) {
        requireKey(component);
        return store.get(entity, component);
    }

    /**
     * Whether an entity has a component.
     *
     * @param entity the entity
     * @param component the component
     * @return whether it has it
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     */
    public final boolean has(long entity, Component<?> component) {
        requireKey(component);
        return store.has(entity, component);
    }

    /**
     * When an entity with a component last went: was deleted, lost a component or got one. A system
     * that keeps something for each entity of a kind, and remembers the number, need not look who
     * is gone while nobody can be. Costs a look at each set of components that there is.
     *
     * @param component the component
     * @return the number of the tick in which, or after which, it was; -1 if none ever went
     * @throws NullPointerException if {@code component} is null
     */
    public final long lastDeparture(Component<?> component) {
        requireKey(component);
        return store.lastDeparture(component);
    }

    /**
     * Replaces a component of an entity.
     *
     * @param entity the entity
     * @param component the new value of a component that it has
     * @throws NullPointerException if {@code component} is null
     * @throws DeadEntityException if the entity is not alive
     * @throws ComponentException if it has no such component; then use {@link #add}
     */
    public final void set(long entity, Record component) {
        requireChangeable("set");
        store.set(entity, requirePart(component));
        observers.settle();
    }

    /**
     * Number of entities that are alive.
     *
     * @return the number of entities
     */
    public final int entityCount() {
        return store.entities.aliveCount();
    }

    /**
     * The chunks of all entities that have some components.
     *
     * @param include components that the entities must have; none gives all chunks
     * @return a query, to be kept and used again
     * @throws NullPointerException if a component is null
     */
    public final Query query(Component<?>... include) {
        return query(new Access("query").in(include));
    }

    final Query query(Access access) {
        return new Query(this, store, access);
    }

    /**
     * Shares an object with all systems, under its own class. Replaces an earlier one.
     *
     * @param resource the object
     * @param <T> its type
     * @throws NullPointerException if it is null
     */
    public final <T> void putResource(T resource) {
        requireChangeable("putResource");
        Objects.requireNonNull(resource, "resource must not be null");
        resources.put(resource.getClass(), resource);
    }

    /**
     * Shares an object with all systems, under a class or interface of your choice. Replaces an
     * earlier one.
     *
     * @param type the key
     * @param resource the object
     * @param <T> its type
     * @throws NullPointerException if an argument is null
     */
    public final <T> void putResource(Class<T> type, T resource) {
        requireChangeable("putResource");
        Objects.requireNonNull(type, "type must not be null: it is the key of the resource");
        Objects.requireNonNull(resource, "resource must not be null");
        resources.put(type, type.cast(resource));
    }

    /**
     * Shares all that another world shares, under the same keys.
     *
     * @param other whose resources these are
     */
    public final void putResourcesOf(World other) {
        requireChangeable("putResourcesOf");
        resources.putAll(((WorldContents) other).resources);
    }

    /**
     * A shared object.
     *
     * @param type the class that it was put under
     * @param <T> its type
     * @return the object
     * @throws NullPointerException if {@code type} is null
     * @throws ComponentException if there is none
     */
    public final <T> T resource(Class<T> type) {
        Objects.requireNonNull(type, "type must not be null: it is the key of the resource");
        Object resource = resources.get(type);
        if (resource == null) {
            throw new ComponentException(
                    "there is no resource of class "
                            + type.getName()
                            + "; put it with putResource before the first step");
        }
        return type.cast(resource);
    }

    /**
     * Remembers from now on which entities have a component set, by {@link #set} or by a command:
     * for a system that keeps a copy of it. One component per world.
     *
     * @param component the component
     * @throws IllegalStateException if another one is watched
     */
    public final void watch(Component<?> component) {
        requireKey(component);
        if (store.watched != null && !store.watched.equals(component)) {
            throw new IllegalStateException(
                    store.watched + " is watched already, and a world watches one component");
        }
        store.watched = component;
    }

    /**
     * How many times the watched component was set since {@link #forgetSet}.
     *
     * @return at least 0
     */
    public final int setCount() {
        return store.toldCount;
    }

    /**
     * An entity whose watched component was set; it may be dead since.
     *
     * @param index 0 to setCount - 1, in the order in which it happened
     * @return the entity
     */
    public final long setEntity(int index) {
        return store.told[Objects.checkIndex(index, store.toldCount)];
    }

    /** Forgets them. */
    public final void forgetSet() {
        store.toldCount = 0;
    }

    /**
     * Tells an observer of each change of a component from now on; see {@link Observer} for when
     * and in which order. Observers are no part of the state: they stay when another one is
     * restored, which they are not told of.
     *
     * @param component the component
     * @param observer is told; as systems, by all worlds that it is given to
     * @param <T> the record
     * @throws NullPointerException if an argument is null
     * @throws IllegalStateException if it observes this component already, or during a step
     */
    public final <T extends Record> void observe(Component<T> component, Observer<T> observer) {
        requireChangeable("observe");
        requireKey(component);
        Objects.requireNonNull(observer, "observer must not be null");
        observers.add((World) this, component, observer);
    }

    /**
     * Tells an observer no longer.
     *
     * @param component the component
     * @param observer what was passed to {@link #observe}
     * @return whether it was told until now
     */
    public final boolean unobserve(Component<?> component, Observer<?> observer) {
        requireChangeable("unobserve");
        return observers.remove(component, observer);
    }

    /**
     * Tells all that another world tells, behind the own ones and in the same order.
     *
     * @param other whose observers these are
     */
    public final void putObserversOf(World other) {
        requireChangeable("putObserversOf");
        observers.addAll(((WorldContents) other).observers, (World) this);
    }

    /** After a direct change: what observers asked for is made. */
    private long settled(long entity) {
        observers.settle();
        return entity;
    }

    final void requireChangeable(String call) {
        if (closed) {
            throw new WorldClosedException(call + " was called on a world that is closed");
        }
        requireBetweenSteps(call);
        store.tick = tickNumber;
    }

    final void requireBetweenSteps(String call) {
        if (observers.calling) {
            throw new IllegalStateException(
                    call
                            + " was called by an observer while a change is being made; an"
                            + " observer reads by its change and by get, and asks for changes by"
                            + " change.commands()");
        }
        if (stepping) {
            throw new IllegalStateException(
                    call
                            + " was called during a step; a system changes the structure through"
                            + " tick.commands(), and its own columns through chunk.out");
        }
    }

    static Record requirePart(@Nullable Record component) {
        if (component == null) {
            throw new NullPointerException(
                    "a component must not be null: leave it out, or take it away with remove");
        }
        return component;
    }

    static void requireParts(@Nullable Record @Nullable [] components) {
        Objects.requireNonNull(components, "components must not be null");
        for (Record component : components) {
            requirePart(component);
        }
    }

    static void requireKey(@Nullable Component<?> component) {
        if (component == null) {
            throw new NullPointerException(
                    "component must not be null: pass the key from Component.of");
        }
    }
}
