package dev.cairn.core.state;

/** Holds something that the next tick depends on, and declares it. */
public interface Stateful {
    /**
     * Hands every such field to the visitor, in a fixed order, and keeps what comes back.
     *
     * @param s saves or restores
     */
    void state(StateVisitor s);
}
