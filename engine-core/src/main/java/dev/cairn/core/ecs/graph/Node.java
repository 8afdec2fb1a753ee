package dev.cairn.core.ecs.graph;

import dev.cairn.core.ecs.access.Access;

import java.util.ArrayList;
import java.util.List;

/** A system as the graph sees it: what it declared, and after which others it runs. */
public class Node {
    private final String name;
    private final String stage;
    private final Access access;
    private final boolean alone;
    private final List<Edge> after = new ArrayList<>();

    /** A system that runs alone has a level of its own; the chunks of others share one. */
    protected Node(String name, String stage, Access access, boolean alone) {
        this.name = name;
        this.stage = stage;
        this.access = access;
        this.alone = alone;
    }

    public final String name() {
        return name;
    }

    /** The heading under which it was added. */
    public final String stage() {
        return stage;
    }

    public final Access access() {
        return access;
    }

    /** Whether it may share what it does not declare, so that nothing runs beside it. */
    public final boolean isAlone() {
        return alone;
    }

    /** Who runs before it, and why; filled by {@link Levels#of}. */
    public final List<Edge> after() {
        return after;
    }

    @Override
    public final String toString() {
        return "'" + name + "' (stage '" + stage + "')";
    }
}
