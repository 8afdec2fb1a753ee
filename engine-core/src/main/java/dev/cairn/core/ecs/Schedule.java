package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.SchedulingException;
import dev.cairn.core.ecs.graph.Edge;
import dev.cairn.core.ecs.graph.Levels;
import dev.cairn.core.ecs.graph.Node;
import dev.cairn.core.ecs.storage.Handle;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Systems, and the graph that follows from what they declare. A system that reads a component with
 * {@code next} runs after the systems that write it, and one that asks with {@link Access#before}
 * or {@link Access#after} as it asked; nothing else orders two systems. Where that leaves open what
 * matters, because both write one component of the same entities, both give commands, or both are a
 * {@link WorldSystem}, the schedule does not build and says what to ask for. So the graph, and
 * every result, is the same in whichever order systems were registered.
 *
 * <pre>{@code
 * Schedule schedule = Schedule.builder()
 *         .stage("forces", new DragSystem(), new BuoyancySystem())
 *         .stage("physics", physics)
 *         .build();
 * schedule.printGraph(System.out);
 * }</pre>
 *
 * <p>Immutable but for the switches of {@link #setEnabled}; one schedule may serve several worlds,
 * if its systems can.
 */
public final class Schedule {
    private final List<Entry> entries;
    private final List<List<Entry>> levels;

    private Schedule(List<Entry> entries, List<List<Entry>> levels) {
        this.entries = entries;
        this.levels = levels;
    }

    /**
     * Begins a schedule.
     *
     * @return an empty builder
     */
    public static Builder builder() {
        return new Builder();
    }

    /** The stages of a tick, in order; each a list of systems in the order of their names. */
    List<List<Entry>> levels() {
        return levels;
    }

    /**
     * Names of all systems, in the order in which their commands are applied.
     *
     * @return the names, immutable
     */
    public List<String> systems() {
        return levels.stream().flatMap(List::stream).map(Entry::name).toList();
    }

    /**
     * Prints the levels of a tick, and why each system is where it is. Any thread.
     *
     * @param out receives the text
     * @throws UncheckedIOException if {@code out} fails
     */
    public void printGraph(Appendable out) {
        Objects.requireNonNull(out, "out must not be null: pass System.out or a StringBuilder");
        try {
            if (levels.isEmpty()) {
                out.append("(no systems)\n");
            }
            for (int depth = 0; depth < levels.size(); depth++) {
                List<Entry> level = levels.get(depth);
                boolean world = level.getFirst().isAlone();
                out.append("level ").append(Integer.toString(depth));
                out.append(world ? ", simulation thread\n" : ", chunks in parallel\n");
                for (Entry entry : level) {
                    print(entry, out);
                }
            }
        } catch (IOException failure) {
            throw new UncheckedIOException("the graph could not be printed", failure);
        }
    }

    private static void print(Entry entry, Appendable out) throws IOException {
        out.append("  ").append(entry.name()).append(" [").append(entry.stage()).append("] ");
        out.append(entry.access().toString());
        String separator = " after ";
        for (Edge edge : entry.after()) {
            out.append(separator).append(edge.writer().name());
            out.append(" (").append(edge.reason()).append(')');
            separator = ", ";
        }
        out.append(entry.isEnabled() ? "\n" : " -- disabled\n");
    }

    /**
     * Takes a system out of the following ticks, or puts it back. What a disabled writer has
     * published stays as it is, and the others run on. Any thread; takes effect with the next tick.
     *
     * @param system name of the system
     * @param enabled whether it runs
     * @throws SchedulingException if there is no such system
     */
    public void setEnabled(String system, boolean enabled) {
        find(system).enabled = enabled;
    }

    /**
     * Whether a system runs. Any thread.
     *
     * @param system name of the system
     * @return whether it takes part in the next tick
     * @throws SchedulingException if there is no such system
     */
    public boolean isEnabled(String system) {
        return find(system).isEnabled();
    }

    private Entry find(String system) {
        Objects.requireNonNull(system, "system must not be null: pass the name of a system");
        // By index: this is asked once a tick, and an iterator would be garbage.
        for (int i = 0; i < entries.size(); i++) {
            if (entries.get(i).name().equals(system)) {
                return entries.get(i);
            }
        }
        throw new SchedulingException(
                "there is no system '" + system + "' in this schedule; it has " + systems());
    }

    /** A system and its place in the graph. */
    static final class Entry extends Node {
        private final EcsSystem system;
        private volatile boolean enabled = true;

        Entry(EcsSystem system, String name, String stage, Access access) {
            super(name, stage, access, system instanceof WorldSystem);
            this.system = system;
        }

        EcsSystem system() {
            return system;
        }

        boolean isEnabled() {
            return enabled;
        }
    }

    /** Collects the systems of a schedule. */
    public static final class Builder {
        private final List<Entry> entries = new ArrayList<>();

        private Builder() {}

        /**
         * Adds systems under a heading. The heading is for the reader of the graph and of messages;
         * it orders nothing.
         *
         * @param name the heading
         * @param systems the systems
         * @return this
         * @throws NullPointerException if an argument is null
         * @throws SchedulingException if a name is blank or taken, or a system contradicts itself
         */
        public Builder stage(String name, EcsSystem... systems) {
            Objects.requireNonNull(name, "name must not be null: it is the heading of the stage");
            Objects.requireNonNull(systems, "systems must not be null");
            List<Entry> added = new ArrayList<>();
            for (EcsSystem system : systems) {
                Objects.requireNonNull(system, "a system must not be null");
                added.add(describe(name, system, added));
            }
            entries.addAll(added);
            return this;
        }

        private Entry describe(String stage, EcsSystem system, List<Entry> added) {
            String name = system.name();
            if (name == null || name.isBlank()) {
                throw new SchedulingException(
                        "a system of class "
                                + system.getClass().getName()
                                + " has a blank name; return a name from name()");
            }
            for (List<Entry> known : List.of(entries, added)) {
                for (Entry other : known) {
                    if (other.name().equals(name)) {
                        throw new SchedulingException(
                                "two systems are named '"
                                        + name
                                        + "'; names are unique, since others ask for order by them,"
                                        + " so return another one from name()");
                    }
                }
            }
            Access access = new Access(name);
            system.describe(access);
            return new Entry(system, name, stage, access.close());
        }

        /**
         * Derives the graph.
         *
         * @return the schedule
         * @throws SchedulingException if the order of two systems is open that write one component,
         *     give commands or are world systems, or systems wait for each other in a circle
         */
        public Schedule build() {
            List<Entry> sorted = new ArrayList<>(entries.size());
            for (Entry entry : entries) {
                sorted.add(new Entry(entry.system, entry.name(), entry.stage(), entry.access()));
            }
            if (sorted.size() > Handle.MAX_SYSTEMS) {
                throw new SchedulingException(
                        "a schedule of "
                                + sorted.size()
                                + " systems is beyond "
                                + Handle.MAX_SYSTEMS);
            }
            return new Schedule(List.copyOf(sorted), Levels.of(sorted));
        }
    }
}
