package dev.cairn.core.ecs.graph;

import dev.cairn.core.ecs.component.Component;

import org.jspecify.annotations.Nullable;

/**
 * Why a system runs after another.
 *
 * @param writer the other one, which runs first
 * @param component what the first writes and the second reads, or null where it was asked for
 */
public record Edge(Node writer, @Nullable Component<?> component) {
    /** The component that is read, or that it was asked for. */
    public String reason() {
        return component == null ? "asked for" : component.name();
    }
}
