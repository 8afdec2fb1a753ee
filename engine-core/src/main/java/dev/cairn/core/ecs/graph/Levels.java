package dev.cairn.core.ecs.graph;

import dev.cairn.core.ecs.access.SchedulingException;
import dev.cairn.core.ecs.component.Component;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Objects;

/**
 * From declarations to levels: edges from next and from what was asked for, depth by longest path.
 * Two systems whose order is open although it matters are an error; their names never settle it.
 */
public final class Levels {
    private Levels() {}

    /**
     * Sorts the entries by name, gives each its edges, and returns the stages of a tick: per depth
     * one of all that share a level, then one for each that runs alone.
     */
    public static <N extends Node> List<List<N>> of(List<N> entries) {
        entries.sort(Comparator.comparing(Node::name));
        for (Node entry : entries) {
            checkInPlace(entry, entries);
            connect(entry, entries);
            connectAsked(entry, entries);
        }
        List<List<N>> levels = layer(entries);
        List<N> sorted = levels.stream().flatMap(List::stream).toList();
        BitSet[] earlier = earlier(sorted);
        for (int second = 0; second < sorted.size(); second++) {
            for (int first = 0; first < second; first++) {
                boolean ordered = earlier[second].get(first);
                checkOrder(sorted.get(first), sorted.get(second), ordered);
            }
        }
        return levels;
    }

    /** For each entry, which run before it in every order that the edges allow. */
    private static BitSet[] earlier(List<? extends Node> sorted) {
        IdentityHashMap<Node, Integer> places = new IdentityHashMap<>();
        BitSet[] earlier = new BitSet[sorted.size()];
        for (int i = 0; i < earlier.length; i++) {
            places.put(sorted.get(i), i);
            earlier[i] = new BitSet();
            for (Edge edge : sorted.get(i).after()) {
                int before = Objects.requireNonNull(places.get(edge.writer()), "sorted");
                earlier[i].set(before);
                earlier[i].or(earlier[before]);
            }
        }
        return earlier;
    }

    /** Two systems that write the same, or of which nobody knows what they share, need an order. */
    private static void checkOrder(Node a, Node b, boolean ordered) {
        if (!ordered && a.isAlone() && b.isAlone()) {
            throw new SchedulingException(
                    a
                            + " and "
                            + b
                            + " are world systems, and nothing says which of them runs first, which"
                            + " decides what they do to objects that both can reach. Ask for it in"
                            + " the describe method of one of them: "
                            + remedy(a, b));
        }
        if (!ordered && a.access().givesCommands() && b.access().givesCommands()) {
            throw new SchedulingException(
                    a
                            + " and "
                            + b
                            + " both give commands, and nothing says whose are made first, which"
                            + " decides what an entity is left with and which ids are given. Ask"
                            + " for it in the describe method of one of them: "
                            + remedy(a, b));
        }
        if (a.access().isDisjoint(b.access())) {
            return;
        }
        for (Component<?> component : a.access().written()) {
            if (b.access().written().contains(component)) {
                if (!ordered) {
                    throw unordered(component, a, b);
                }
                checkLater(component, a, b);
            }
        }
    }

    private static SchedulingException unordered(Component<?> component, Node a, Node b) {
        return new SchedulingException(
                "component "
                        + component
                        + " (columns "
                        + columns(component)
                        + ") is written by both "
                        + a
                        + " and "
                        + b
                        + ", and nothing says which of them comes first. Ask for it in the describe"
                        + " method of one of them: "
                        + remedy(a, b)
                        + "; the later one finds in its out what the earlier one wrote. Or let one"
                        + " write a component of its own and the other read that with next(..), or"
                        + " keep their entities apart: exclude in one a component that the other"
                        + " requires");
    }

    private static String remedy(Node a, Node b) {
        return "access.before(\""
                + b.name()
                + "\") or access.after(\""
                + b.name()
                + "\") in '"
                + a.name()
                + "'";
    }

    /** The later of two writers goes on from what the earlier one wrote. */
    private static void checkLater(Component<?> component, Node first, Node second) {
        if (first.access().writtenInPlace().contains(component)
                || second.access().writtenInPlace().contains(component)) {
            throw new SchedulingException(
                    "component "
                            + component
                            + " is written by "
                            + first
                            + " and then by "
                            + second
                            + ", one of them inPlace, which is for the only writer of a component;"
                            + " declare out in both");
        }
        if (second.access().writesEveryRow(component)) {
            throw new SchedulingException(
                    "component "
                            + component
                            + " is written by "
                            + first
                            + " and then by "
                            + second
                            + ", which declares writesAll, so that what the first one wrote would"
                            + " be lost; declare out in the second and go on from what is there, or"
                            + " take the component from the first");
        }
    }

    private static void checkInPlace(Node writer, List<? extends Node> entries) {
        for (Component<?> component : writer.access().writtenInPlace()) {
            for (Node reader : entries) {
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
        for (int i = 0; i < component.fieldCount(); i++) {
            names.add(component.field(i).name());
        }
        return String.join(", ", names);
    }

    private static void connect(Node reader, List<? extends Node> entries) {
        for (Component<?> component : reader.access().awaited()) {
            for (Node writer : entries) {
                if (writer.access().written().contains(component)
                        && !writer.access().isDisjoint(reader.access())) {
                    reader.after().add(new Edge(writer, component));
                }
            }
        }
    }

    /** Edges that were asked for by name. */
    private static void connectAsked(Node entry, List<? extends Node> entries) {
        for (String name : entry.access().runsAfter()) {
            entry.after().add(new Edge(named(name, "after", entry, entries), null));
        }
        for (String name : entry.access().runsBefore()) {
            named(name, "before", entry, entries).after().add(new Edge(entry, null));
        }
    }

    private static Node named(String name, String call, Node by, List<? extends Node> entries) {
        for (Node entry : entries) {
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

    private static <N extends Node> List<List<N>> layer(List<N> entries) {
        List<N> waiting = new ArrayList<>(entries);
        List<N> done = new ArrayList<>();
        List<List<N>> levels = new ArrayList<>();
        while (!waiting.isEmpty()) {
            List<N> ready = new ArrayList<>();
            for (N entry : waiting) {
                if (entry.after().stream().allMatch(edge -> done.contains(edge.writer()))) {
                    ready.add(entry);
                }
            }
            if (ready.isEmpty()) {
                throw circle(waiting, done);
            }
            List<N> parallel = new ArrayList<>();
            for (N entry : ready) {
                if (!entry.isAlone()) {
                    parallel.add(entry);
                }
            }
            if (!parallel.isEmpty()) {
                levels.add(List.copyOf(parallel));
            }
            for (N entry : ready) {
                if (entry.isAlone()) {
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
            List<? extends Node> waiting, List<? extends Node> done) {
        List<Edge> path = new ArrayList<>();
        List<Node> seen = new ArrayList<>();
        Node at = waiting.getFirst();
        while (!seen.contains(at)) {
            seen.add(at);
            Edge edge =
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
        text.append(at)
                .append(
                        "; read one of these with in, which is the state before the tick,"
                                + " or drop one of the orders that were asked for");
        return new SchedulingException(text.toString());
    }
}
