package dev.cairn.core.ecs;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** From declarations to levels: one writer per column, edges from next, depth by longest path. */
final class ScheduleGraph {
    private ScheduleGraph() {}

    /**
     * Sorts the entries by name, gives each its edges, and returns the stages of a tick: per depth
     * one of all chunk systems, then one for each world system.
     */
    static List<List<Schedule.Entry>> levels(List<Schedule.Entry> entries) {
        entries.sort(Comparator.comparing(Schedule.Entry::name));
        if (entries.size() > Handle.MAX_SYSTEMS) {
            throw new SchedulingException(
                    "a schedule of " + entries.size() + " systems is beyond " + Handle.MAX_SYSTEMS);
        }
        for (int i = 0; i < entries.size(); i++) {
            for (int j = i + 1; j < entries.size(); j++) {
                checkWriters(entries.get(i), entries.get(j));
            }
        }
        for (Schedule.Entry entry : entries) {
            checkInPlace(entry, entries);
            connect(entry, entries);
            connectAsked(entry, entries);
        }
        return layer(entries);
    }

    private static void checkWriters(Schedule.Entry a, Schedule.Entry b) {
        if (a.access().isDisjoint(b.access())) {
            return;
        }
        for (Component<?> component : a.access().written()) {
            if (b.access().written().contains(component)) {
                throw new SchedulingException(
                        "component "
                                + component
                                + " (columns "
                                + columns(component)
                                + ") is written by both "
                                + a
                                + " and "
                                + b
                                + "; a column has exactly one writer per tick. Let one of them"
                                + " write a component of its own and the other read that with"
                                + " next(..), or keep their entities apart: exclude in one a"
                                + " component that the other requires");
            }
        }
    }

    private static void checkInPlace(Schedule.Entry writer, List<Schedule.Entry> entries) {
        for (Component<?> component : writer.access().writtenInPlace()) {
            for (Schedule.Entry reader : entries) {
                if (reader.access().readsPublished(component)
                        && !reader.access().isDisjoint(writer.access())) {
                    throw new SchedulingException(
                            "component "
                                    + component
                                    + " is written inPlace by "
                                    + writer
                                    + " and read as published by "
                                    + reader
                                    + ", which would see half of the tick; declare out in the"
                                    + " first, or next in the second");
                }
            }
        }
    }

    private static String columns(Component<?> component) {
        List<String> names = new ArrayList<>();
        for (Field field : component.fields) {
            names.add(field.name());
        }
        return String.join(", ", names);
    }

    private static void connect(Schedule.Entry reader, List<Schedule.Entry> entries) {
        for (Component<?> component : reader.access().awaited()) {
            for (Schedule.Entry writer : entries) {
                if (writer.access().written().contains(component)
                        && !writer.access().isDisjoint(reader.access())) {
                    reader.after().add(new Schedule.Edge(writer, component));
                }
            }
        }
    }

    /** Edges that were asked for by name. */
    private static void connectAsked(Schedule.Entry entry, List<Schedule.Entry> entries) {
        for (String name : entry.access().runsAfter()) {
            entry.after().add(new Schedule.Edge(named(name, "after", entry, entries), null));
        }
        for (String name : entry.access().runsBefore()) {
            named(name, "before", entry, entries).after().add(new Schedule.Edge(entry, null));
        }
    }

    private static Schedule.Entry named(
            String name, String call, Schedule.Entry by, List<Schedule.Entry> entries) {
        for (Schedule.Entry entry : entries) {
            if (entry.name().equals(name)) {
                return entry;
            }
        }
        throw new SchedulingException(
                by
                        + " asks to run "
                        + call
                        + " '"
                        + name
                        + "', but there is no such system; there are "
                        + entries);
    }

    private static List<List<Schedule.Entry>> layer(List<Schedule.Entry> entries) {
        List<Schedule.Entry> waiting = new ArrayList<>(entries);
        List<Schedule.Entry> done = new ArrayList<>();
        List<List<Schedule.Entry>> levels = new ArrayList<>();
        while (!waiting.isEmpty()) {
            List<Schedule.Entry> ready = new ArrayList<>();
            for (Schedule.Entry entry : waiting) {
                if (entry.after().stream().allMatch(edge -> done.contains(edge.writer()))) {
                    ready.add(entry);
                }
            }
            if (ready.isEmpty()) {
                throw circle(waiting, done);
            }
            List<Schedule.Entry> parallel = new ArrayList<>();
            for (Schedule.Entry entry : ready) {
                if (entry.system() instanceof ChunkSystem) {
                    parallel.add(entry);
                }
            }
            if (!parallel.isEmpty()) {
                levels.add(List.copyOf(parallel));
            }
            for (Schedule.Entry entry : ready) {
                if (entry.system() instanceof WorldSystem) {
                    levels.add(List.of(entry));
                }
            }
            done.addAll(ready);
            waiting.removeAll(ready);
        }
        return List.copyOf(levels);
    }

    /** Each waiting system waits for another one that waits, so walking on finds the circle. */
    private static SchedulingException circle(
            List<Schedule.Entry> waiting, List<Schedule.Entry> done) {
        List<Schedule.Edge> path = new ArrayList<>();
        List<Schedule.Entry> seen = new ArrayList<>();
        Schedule.Entry at = waiting.getFirst();
        while (!seen.contains(at)) {
            seen.add(at);
            Schedule.Edge edge =
                    at.after().stream()
                            .filter(e -> !done.contains(e.writer()))
                            .findFirst()
                            .orElseThrow();
            path.add(edge);
            at = edge.writer();
        }
        int start = seen.indexOf(at);
        StringBuilder text = new StringBuilder("systems wait for each other in a circle: ");
        for (int i = start; i < seen.size(); i++) {
            Component<?> component = path.get(i).component();
            text.append(seen.get(i));
            if (component == null) {
                text.append(" asked to run after ");
            } else {
                text.append(" reads next(").append(component).append(") of ");
            }
        }
        text.append(at).append("; read one of these with in, which is the state before the tick");
        return new SchedulingException(text.toString());
    }
}
