package dev.cairn.core.ecs;

/** What one system reads and writes. */
public final class Access {
    Access() {}

    /** Reads the published columns. @param components which @return this */
    public Access in(Component<?>... components) { return this; }
    /** Writes, pre-filled with published values. @param components which @return this */
    public Access out(Component<?>... components) { return this; }
    /** Writes every row of the columns it asks for. @param components which @return this */
    public Access writesAll(Component<?>... components) { return this; }
    /** Reads what was written earlier this tick. @param components which @return this */
    public Access next(Component<?>... components) { return this; }
    /** Filter only. @param components which @return this */
    public Access with(Component<?>... components) { return this; }
    /** Reads where present, no filter. @param components which @return this */
    public Access optional(Component<?>... components) { return this; }
    /** Filter. @param components which @return this */
    public Access exclude(Component<?>... components) { return this; }
}
