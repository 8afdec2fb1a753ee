package dev.cairn.core.ecs;

/**
 * Is told when entities get a component, have it replaced, or lose it: {@link World#observe}.
 *
 * <pre>{@code
 * world.observe(WIND, new Observer<Wind>() {
 *     @Override public void added(Change<Wind> change) {
 *         change.commands().add(change.entity(), new Leaf(change.value(WIND_X)));
 *     }
 * });
 * }</pre>
 *
 * <p>Called on the simulation thread between ticks: where commands are made at the end of a step,
 * in their order of (system, chunk, sequence), and within each direct change of a {@link World}.
 * One change is told to all its observers in the order of their registration before the next one is
 * made; that order is part of the contract, and the same for any number of workers. A spawn adds
 * all its components at once, {@code delete} and {@code clear} remove all at once.
 *
 * <p>An observer reads, by {@link Change} and by {@link World#get}; it changes nothing at once.
 * What it asks for by {@link Change#commands} is made after the last command of the tick, or of the
 * direct change, and told in turn. Writes of systems to columns are no {@code set}, and {@link
 * World#restore} calls nobody: the state that comes back has what the observers had asked for
 * already.
 *
 * <p>An observer that throws does not keep the changes, nor the others, from being told; then the
 * step fails with a {@link WorldFailedException} that names it, or the direct change with an {@link
 * IllegalStateException}.
 *
 * @param <T> the record
 */
public interface Observer<T extends Record> {
    /**
     * An entity has got the component: it was spawned with it or it was added.
     *
     * @param change the entity, which has all its new components, and the value
     */
    default void added(Change<T> change) {}

    /**
     * The component of an entity was replaced, by {@code set} or by a command that adds what is
     * there; perhaps by an equal value.
     *
     * @param change the entity, the value and the {@code previous} one
     */
    default void set(Change<T> change) {}

    /**
     * An entity is about to lose the component: it is taken away, or the entity cleared or deleted.
     *
     * @param change the entity, which still has all its components, and the last value
     */
    default void removed(Change<T> change) {}
}
