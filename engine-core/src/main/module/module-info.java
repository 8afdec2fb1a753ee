/**
 * Entities, double-buffered columns, schedule, job graph, tick loop and snapshots. Knows nothing of
 * physics or drawing.
 */
module dev.cairn.core {
    requires static org.jspecify;
    requires org.jctools.core.jdk11;

    exports dev.cairn.core.ecs;
    exports dev.cairn.core.ecs.access;
    exports dev.cairn.core.ecs.component;
    exports dev.cairn.core.job;
    exports dev.cairn.core.profile;
    exports dev.cairn.core.snapshot;
    exports dev.cairn.core.state;
    exports dev.cairn.core.tick;
}
