package dev.cairn.core.ecs;

/** Systems and the graph derived from what they declare. */
public final class Schedule {
    private Schedule() {}

    /** @return builder */
    public static Builder builder() { return new Builder(); }
    /** @param out receives the graph */
    public void printGraph(Appendable out) { throw new UnsupportedOperationException(); }
    /** Any thread. @param system name @param enabled whether it runs from the next tick on */
    public void setEnabled(String system, boolean enabled) { throw new UnsupportedOperationException(); }
    /** @param system name @return whether it runs */
    public boolean isEnabled(String system) { throw new UnsupportedOperationException(); }

    /** Collects systems. */
    public static final class Builder {
        private Builder() {}

        /** @param name heading for the reader, no order @param systems systems @return this */
        public Builder stage(String name, EcsSystem... systems) { return this; }
        /** @return schedule */
        public Schedule build() { return new Schedule(); }
    }
}
