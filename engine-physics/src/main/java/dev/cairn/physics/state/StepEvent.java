package dev.cairn.physics.state;

import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.profile.StepStage;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Enabled;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import jdk.jfr.Timespan;

/**
 * One physics step as an event of the JDK Flight Recorder. One instance is written over and over,
 * so that recording allocates nothing on the heap. Off unless a recording asks for it.
 */
@Name("dev.cairn.PhysicsStep")
@Label("Physics step")
@Category({"Cairn", "Physics"})
@Description("One tick of the physics, with the wall time of each stage")
@Enabled(false)
@StackTrace(false)
final class StepEvent extends Event {
    @Label("Bodies")
    int bodies;

    @Label("Contacts")
    int contacts;

    @Label("BodyRegistry")
    @Timespan
    long registry;

    @Label("Bounds")
    @Timespan
    long bounds;

    @Label("Pairs")
    @Timespan
    long pairs;

    @Label("Rows")
    @Timespan
    long rows;

    @Label("Points")
    @Timespan
    long points;

    @Label("Solve")
    @Timespan
    long solve;

    @Label("Publish")
    @Timespan
    long publish;

    @Label("Touch")
    @Timespan
    long touch;

    private StepEvent() {}

    /** An event; whoever calls this bears that the class may be missing. */
    static StepEvent create() {
        return new StepEvent();
    }

    void write(StepProfile profile, int bodyCount, int contactCount) {
        end();
        if (!shouldCommit()) {
            return;
        }
        bodies = bodyCount;
        contacts = contactCount;
        registry = profile.lastNanos(StepStage.BODIES);
        bounds = profile.lastNanos(StepStage.BOUNDS);
        pairs = profile.lastNanos(StepStage.PAIRS);
        rows = profile.lastNanos(StepStage.ROWS);
        points = profile.lastNanos(StepStage.POINTS);
        solve = profile.lastNanos(StepStage.SOLVE);
        publish = profile.lastNanos(StepStage.PUBLISH);
        touch = profile.lastNanos(StepStage.TOUCH);
        commit();
    }
}
