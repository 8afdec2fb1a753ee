package dev.cairn.core.ecs.access;

import dev.cairn.core.ecs.component.Component;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/**
 * What one system reads and writes. A chunk reaches the system when its entities have every
 * component of {@code in}, {@code out}, {@code next} and {@code with}, and none of {@code exclude}.
 *
 * <p>Calls may be repeated and add up. Used during {@link dev.cairn.core.ecs.EcsSystem#describe}
 * only.
 */
public final class Access {
    /** A right as a bit, see {@link #rights}: to read what the last tick left. */
    public static final byte READ = 1;

    /** A right: to write the column of the tick that is being computed. */
    public static final byte WRITE = 2;

    /** A right: to read what this tick wrote. */
    public static final byte NEXT = 4;

    /** With {@link #WRITE}: the system writes every row, so nothing is copied before. */
    public static final byte ALL = 8;

    /** With {@link #WRITE}: to the published column during the tick; nobody else looks. */
    public static final byte IN_PLACE = 16;

    private final String system;
    private final List<Component<?>> in = new ArrayList<>();
    private final List<Component<?>> out = new ArrayList<>();
    private final List<Component<?>> all = new ArrayList<>();
    private final List<Component<?>> inPlace = new ArrayList<>();
    private final List<Component<?>> next = new ArrayList<>();
    private final List<Component<?>> optionalNext = new ArrayList<>();
    private final List<String> before = new ArrayList<>();
    private final List<String> after = new ArrayList<>();
    private final List<Component<?>> with = new ArrayList<>();
    private final List<Component<?>> optional = new ArrayList<>();
    private final List<Component<?>> exclude = new ArrayList<>();
    private boolean commands;
    private boolean closed;

    /**
     * Nothing yet. A schedule makes these; others do who want to know what a system declares.
     *
     * @param system name of the system, for messages
     */
    public Access(String system) {
        this.system = system;
    }

    /**
     * Whose access this is.
     *
     * @return name of the system
     */
    public String system() {
        return system;
    }

    /**
     * The system reads the published columns: what the last tick left. Never conflicts with
     * anything.
     *
     * @param components the components
     * @return this
     */
    public Access in(Component<?>... components) {
        return note(in, "in", components);
    }

    /**
     * The system writes these components. The columns that it asks for hold the published values at
     * first; a chunk whose {@code out} it never asks for stays as it is, at no cost. Includes the
     * right to read the published columns. Two systems may write one component where {@link
     * #before} or {@link #after} says which comes first, or where no entity can match both; the
     * later one then finds in its {@code out} what the earlier one wrote.
     *
     * @param components the components
     * @return this
     */
    public Access out(Component<?>... components) {
        return note(out, "out", components);
    }

    /**
     * As {@link #out}, and the system writes every row of each column that it asks for, so the
     * published values are not copied before. A row that it leaves out holds an old value; checked
     * mode finds it.
     *
     * @param components the components
     * @return this
     */
    public Access writesAll(Component<?>... components) {
        note(out, "writesAll", components);
        return note(all, "writesAll", components);
    }

    /**
     * As {@link #out}, but the arrays are the published ones themselves: no second array, no copy,
     * half the memory traffic. For components that no other system reads with {@code in} or {@code
     * optional} in the same tick, which is checked when the schedule is built; {@code next} is
     * fine. The price: a tick that fails has no way back, so these columns may then be half
     * updated.
     *
     * @param components the components
     * @return this
     */
    public Access inPlace(Component<?>... components) {
        note(out, "inPlace", components);
        return note(inPlace, "inPlace", components);
    }

    /**
     * The system reads what was written earlier in this tick, so it runs after all writers. Where
     * nothing wrote, these are the published columns.
     *
     * @param components the components
     * @return this
     */
    public Access next(Component<?>... components) {
        return note(next, "next", components);
    }

    /**
     * As {@link #next}, in those chunks that {@link dev.cairn.core.ecs.Chunk#has} the components.
     *
     * @param components the components
     * @return this
     */
    public Access optionalNext(Component<?>... components) {
        return note(optionalNext, "optionalNext", components);
    }

    /**
     * The system gives commands, by {@link dev.cairn.core.ecs.Tick#commands}; without this they are
     * refused. Commands of two systems are made in the order of the systems, which decides what an
     * entity is left with and which ids are given. So two systems that give commands need an order,
     * as two writers do: one that follows from {@code next}, or {@link #before} or {@link #after}.
     *
     * @return this
     */
    public Access commands() {
        if (closed) {
            throw changedLate();
        }
        commands = true;
        return this;
    }

    /**
     * Whether {@link #commands} was declared.
     *
     * @return whether the system gives commands
     */
    public boolean givesCommands() {
        return commands;
    }

    private IllegalStateException changedLate() {
        return new IllegalStateException(
                "system '" + system + "' changed its access after describe had returned");
    }

    /**
     * Asks that the system runs before others, where what they read and write leaves it open: both
     * write the same component, say, or are world systems. Which systems run in a tick at all is
     * not changed by it.
     *
     * @param systems names of other systems of the schedule
     * @return this
     */
    public Access before(String... systems) {
        return ask(before, "before", systems);
    }

    /**
     * Asks that the system runs after others, see {@link #before}.
     *
     * @param systems names of other systems of the schedule
     * @return this
     */
    public Access after(String... systems) {
        return ask(after, "after", systems);
    }

    private Access ask(List<String> list, String call, String... systems) {
        if (closed) {
            throw changedLate();
        }
        Objects.requireNonNull(systems, "systems must not be null");
        for (String name : systems) {
            Objects.requireNonNull(name, "a system's name must not be null");
            if (name.equals(system)) {
                throw new SchedulingException(
                        "system '" + system + "' asks to run " + call + " itself; name another");
            }
            list.add(name);
        }
        return this;
    }

    /**
     * The systems that were named in {@link #before}.
     *
     * @return their names, to be read only
     */
    public List<String> runsBefore() {
        return Collections.unmodifiableList(before);
    }

    /**
     * The systems that were named in {@link #after}.
     *
     * @return their names, to be read only
     */
    public List<String> runsAfter() {
        return Collections.unmodifiableList(after);
    }

    /**
     * Only entities that have these components; gives no right to their columns.
     *
     * @param components the components
     * @return this
     */
    public Access with(Component<?>... components) {
        return note(with, "with", components);
    }

    /**
     * The system reads the published columns in those chunks that {@link
     * dev.cairn.core.ecs.Chunk#has} them.
     *
     * @param components the components
     * @return this
     */
    public Access optional(Component<?>... components) {
        return note(optional, "optional", components);
    }

    /**
     * Only entities that have none of these components.
     *
     * @param components the components
     * @return this
     */
    public Access exclude(Component<?>... components) {
        return note(exclude, "exclude", components);
    }

    private Access note(List<Component<?>> list, String call, Component<?>... components) {
        if (closed) {
            throw changedLate();
        }
        Objects.requireNonNull(components, "components must not be null");
        for (Component<?> component : components) {
            if (component == null) {
                throw new NullPointerException(
                        "system '"
                                + system
                                + "' passes a null component to "
                                + call
                                + "; is a constant used before it is initialised?");
            }
            if (!list.contains(component)) {
                list.add(component);
            }
        }
        return this;
    }

    /**
     * Ends the description and checks it for contradictions; what is declared later is refused.
     *
     * @return this
     * @throws SchedulingException if it contradicts itself
     */
    public Access close() {
        closed = true;
        for (Component<?> component : exclude) {
            if (requires(component)) {
                throw new SchedulingException(
                        "system '"
                                + system
                                + "' both requires and excludes "
                                + component
                                + ", so it could never run; drop one of the two");
            }
        }
        for (Component<?> component : inPlace) {
            if (readsPublished(component) || all.contains(component)) {
                throw new SchedulingException(
                        "system '"
                                + system
                                + "' declares "
                                + component
                                + " inPlace, where the array from out is the published one, and"
                                + " in, optional or writesAll as well; keep one of the two");
            }
        }
        for (Component<?> component : awaited()) {
            if (out.contains(component)) {
                throw new SchedulingException(
                        "system '"
                                + system
                                + "' declares both out and next of "
                                + component
                                + ", so it would have to run after itself; the array from out can"
                                + " be read as well as written, so drop next");
            }
        }
        return this;
    }

    /**
     * The same, open for more.
     *
     * @return a new object
     */
    public Access copy() {
        Access copy = new Access(system);
        copy.commands = commands;
        copy.in.addAll(in);
        copy.out.addAll(out);
        copy.all.addAll(all);
        copy.inPlace.addAll(inPlace);
        copy.next.addAll(next);
        copy.optionalNext.addAll(optionalNext);
        copy.before.addAll(before);
        copy.after.addAll(after);
        copy.with.addAll(with);
        copy.optional.addAll(optional);
        copy.exclude.addAll(exclude);
        return copy;
    }

    /**
     * The components that an entity must have.
     *
     * @return those of {@code in}, {@code out}, {@code next} and {@code with}, perhaps repeated
     */
    public List<Component<?>> required() {
        List<Component<?>> all = new ArrayList<>(in);
        all.addAll(out);
        all.addAll(next);
        all.addAll(with);
        return all;
    }

    private boolean requires(Component<?> component) {
        return in.contains(component)
                || out.contains(component)
                || next.contains(component)
                || with.contains(component);
    }

    /**
     * The components that an entity must not have.
     *
     * @return those of {@code exclude}, to be read only
     */
    public List<Component<?>> excluded() {
        return Collections.unmodifiableList(exclude);
    }

    /**
     * The components that the system writes.
     *
     * @return those of {@code out}, {@code writesAll} and {@code inPlace}, to be read only
     */
    public List<Component<?>> written() {
        return Collections.unmodifiableList(out);
    }

    /**
     * The components that the system writes in place.
     *
     * @return those of {@code inPlace}, to be read only
     */
    public List<Component<?>> writtenInPlace() {
        return Collections.unmodifiableList(inPlace);
    }

    /**
     * Whether the system writes every row of a component.
     *
     * @param component the component
     * @return whether it was given to {@code writesAll}
     */
    public boolean writesEveryRow(Component<?> component) {
        return all.contains(component);
    }

    /**
     * Whether the system reads what the last tick left of a component.
     *
     * @param component the component
     * @return whether it was given to {@code in} or {@code optional}
     */
    public boolean readsPublished(Component<?> component) {
        return in.contains(component) || optional.contains(component);
    }

    /**
     * The components whose writers of the same tick come first.
     *
     * @return those of {@code next} and {@code optionalNext}, to be read only
     */
    public List<Component<?>> awaited() {
        if (optionalNext.isEmpty()) {
            return Collections.unmodifiableList(next);
        }
        List<Component<?>> all = new ArrayList<>(next);
        all.addAll(optionalNext);
        return all;
    }

    /**
     * Whether no entity can match both.
     *
     * @param other what another system declared
     * @return whether one excludes what the other requires
     */
    public boolean isDisjoint(Access other) {
        return exclude.stream().anyMatch(other::requires)
                || other.exclude.stream().anyMatch(this::requires);
    }

    /**
     * What the system may do with the columns of a component.
     *
     * @param component the component
     * @return {@link #READ}, {@link #WRITE}, {@link #NEXT}, {@link #ALL}, {@link #IN_PLACE} as bits
     */
    public byte rights(Component<?> component) {
        int rights = readsPublished(component) ? READ : 0;
        rights |= out.contains(component) ? READ | WRITE : 0;
        rights |= all.contains(component) ? ALL : 0;
        rights |= inPlace.contains(component) ? IN_PLACE : 0;
        rights |= next.contains(component) || optionalNext.contains(component) ? NEXT : 0;
        return (byte) rights;
    }

    /** As {@code in{Wind} out{Force}}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        append(text, "in", in);
        append(text, "optional", optional);
        append(text, "out", out);
        append(text, "inPlace", inPlace);
        append(text, "next", next);
        append(text, "optionalNext", optionalNext);
        append(text, "with", with);
        append(text, "exclude", exclude);
        if (commands) {
            text.append(text.isEmpty() ? "" : " ").append("commands");
        }
        return text.toString();
    }

    private static void append(StringBuilder text, String label, List<Component<?>> components) {
        if (!components.isEmpty()) {
            String names = components.toString();
            text.append(text.isEmpty() ? "" : " ").append(label).append('{');
            text.append(names, 1, names.length() - 1).append('}');
        }
    }
}
