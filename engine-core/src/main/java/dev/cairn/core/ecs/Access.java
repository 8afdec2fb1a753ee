package dev.cairn.core.ecs;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * What one system reads and writes. A chunk reaches the system when its entities have every
 * component of {@code in}, {@code out}, {@code next} and {@code with}, and none of {@code exclude}.
 *
 * <p>Calls may be repeated and add up. Used during {@link EcsSystem#describe} only.
 */
public final class Access {
    /** What a system may do with a column. */
    static final byte READ = 1;

    static final byte WRITE = 2;
    static final byte NEXT = 4;

    /** The system writes every row, so nothing is copied before. */
    static final byte ALL = 8;

    /** Between ticks: writes go to the published column. */
    static final byte DIRECT = 16;

    /** Writes go to the published column during the tick; nobody else looks. */
    static final byte IN_PLACE = 32;

    final String system;
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

    Access(String system) {
        this.system = system;
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
     * As {@link #next}, in those chunks that {@link Chunk#has} the components.
     *
     * @param components the components
     * @return this
     */
    public Access optionalNext(Component<?>... components) {
        return note(optionalNext, "optionalNext", components);
    }

    /**
     * The system gives commands, by {@link Tick#commands}; without this they are refused. Commands
     * of two systems are made in the order of the systems, which decides what an entity is left
     * with and which ids are given. So two systems that give commands need an order, as two writers
     * do: one that follows from {@code next}, or {@link #before} or {@link #after}.
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

    boolean givesCommands() {
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

    List<String> runsBefore() {
        return before;
    }

    List<String> runsAfter() {
        return after;
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
     * The system reads the published columns in those chunks that {@link Chunk#has} them.
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

    /** Ends the description and checks it for contradictions. */
    Access close() {
        closed = true;
        for (Component<?> component : exclude) {
            if (required().contains(component)) {
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

    /** An open copy. */
    Access copy() {
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

    ComponentSet required() {
        List<Component<?>> all = new ArrayList<>(in);
        all.addAll(out);
        all.addAll(next);
        all.addAll(with);
        return ComponentSet.of(all);
    }

    ComponentSet excluded() {
        return ComponentSet.of(exclude);
    }

    List<Component<?>> written() {
        return out;
    }

    List<Component<?>> writtenInPlace() {
        return inPlace;
    }

    boolean writesEveryRow(Component<?> component) {
        return all.contains(component);
    }

    boolean readsPublished(Component<?> component) {
        return in.contains(component) || optional.contains(component);
    }

    List<Component<?>> awaited() {
        if (optionalNext.isEmpty()) {
            return next;
        }
        List<Component<?>> all = new ArrayList<>(next);
        all.addAll(optionalNext);
        return all;
    }

    /** Whether no entity can match both. */
    boolean isDisjoint(Access other) {
        return excluded().intersects(other.required()) || other.excluded().intersects(required());
    }

    /** The rights by column of an archetype. */
    byte[] rights(Archetype archetype) {
        byte[] rights = new byte[archetype.fields.length];
        grant(rights, archetype, in, READ);
        grant(rights, archetype, optional, READ);
        grant(rights, archetype, out, (byte) (READ | WRITE));
        grant(rights, archetype, all, ALL);
        grant(rights, archetype, inPlace, IN_PLACE);
        grant(rights, archetype, next, NEXT);
        grant(rights, archetype, optionalNext, NEXT);
        return rights;
    }

    private static void grant(
            byte[] rights, Archetype archetype, List<Component<?>> components, byte right) {
        for (Component<?> component : components) {
            int base = archetype.base(component);
            if (base >= 0) {
                for (int slot = base; slot < base + component.fields.length; slot++) {
                    rights[slot] |= right;
                }
            }
        }
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
