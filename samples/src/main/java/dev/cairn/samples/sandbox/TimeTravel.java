package dev.cairn.samples.sandbox;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneBuilder;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Supplier;

/**
 * What keys and the bar of time do: back, forth, to a moment that was kept. Whoever comes to a
 * moment has an empty hand there. Simulation thread, between steps.
 */
final class TimeTravel {
    private final Sandbox sandbox;
    private final Diary diary;
    private final MouseHand hand;
    private final Timeline timeline = new Timeline();

    /** The world as it began, if its whole run is to be written down. */
    private @Nullable WorldState first;

    private long firstTick = -1;

    TimeTravel(Sandbox sandbox, Diary diary, MouseHand hand) {
        this.sandbox = sandbox;
        this.diary = diary;
        this.hand = hand;
    }

    Timeline timeline() {
        return timeline;
    }

    /** Another scene begins, or the same one again; null if there is none to remember. */
    void begin(PhysicsWorld world, @Nullable SceneBuilder scene) {
        diary.begin(sandbox.builtTick());
        timeline.begin(world, scene);
        firstTick = scene == null ? -1 : sandbox.builtTick();
        if (first != null && scene != null) {
            world.save(first);
        }
    }

    /** Has whole runs be written down; before the first one. */
    void keepRuns() {
        first = new WorldState();
        diary.keepAll();
    }

    /**
     * Writes the whole run of the present scene to a file.
     *
     * @return what to tell the user
     * @throws IOException if it cannot be written
     */
    String writeRun(
            Path file, MomentWriter writer, Supplier<PhysicsWorld> worlds, double stepSeconds)
            throws IOException {
        WorldState begin = first;
        long tick = sandbox.builtTick();
        if (begin == null || firstTick < 0) {
            throw new IOException("no scene ran");
        }
        long parts = writer.run(file, begin, firstTick, diary, worlds, tick, stepSeconds);
        return "Recorded %d ticks of %s in %s%s"
                .formatted(
                        tick - firstTick,
                        writer.scene().id(),
                        file,
                        parts < 0 ? "" : MomentWriter.otherwise(parts));
    }

    /** After a tick. */
    void ticked() {
        timeline.remember();
        diary.ticked(sandbox.builtTick(), sandbox.physics().digest());
        diary.forgetUpTo(timeline.oldest());
    }

    private void cameBack() {
        diary.came(sandbox.builtTick());
    }

    /** Goes to a moment of the past, or forth again. */
    void goTo(long tick) {
        hand.release();
        timeline.goTo(tick);
        cameBack();
        sandbox.publishState();
    }

    /** Pauses, and goes back by a moment. */
    void back() {
        sandbox.setPaused(true);
        hand.release();
        timeline.back();
        cameBack();
        sandbox.publishState();
    }

    /** Pauses, and goes forth by a moment; beyond the last one by a tick that is computed. */
    void forth() {
        if (!sandbox.isPaused()) {
            sandbox.setPaused(true);
            return;
        }
        hand.release();
        if (timeline.forth()) {
            cameBack();
            sandbox.publishState();
        } else {
            sandbox.singleStep();
        }
    }

    /** Keeps this moment, to come back to it and compare. */
    void keepMoment() {
        hand.release();
        timeline.keep();
        sandbox.publishState();
    }

    /** Goes back to the moment that was kept. */
    void backToKept() {
        hand.release();
        if (timeline.backToKept()) {
            cameBack();
            sandbox.setPaused(true);
        }
        sandbox.publishState();
    }

    /** Writes this moment to a file. */
    void save(MomentWriter writer) {
        hand.release();
        sandbox.notice(writer.save(sandbox.physics(), sandbox.builtTick()));
        sandbox.publishState();
    }

    /** Writes the last seconds to a file that can be played again. */
    void report(MomentWriter writer, Supplier<PhysicsWorld> worlds, double stepSeconds) {
        sandbox.notice(writer.report(timeline, diary, worlds, sandbox.builtTick(), stepSeconds));
    }

    void forgetFutures() {
        timeline.forgetFutures();
        sandbox.publishState();
    }
}
