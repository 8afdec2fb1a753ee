package dev.cairn.samples.sandbox;

import dev.cairn.core.state.StateException;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;

/**
 * Writes moments of a scene, and what was done in the last seconds, to files. Simulation thread,
 * between steps.
 *
 * @param folder of the files: the present one, or that of an edited scene
 * @param scene of the list, or as it was edited
 * @param sceneText the edited scene as a scene file; empty for one of the list
 * @param options its parameters
 * @param substeps of the solver now
 * @param settings of the world
 * @param sleeping whether bodies fall asleep
 * @param looks those of the scene as it began
 */
record MomentWriter(
        Path folder,
        SampleScene scene,
        String sceneText,
        SceneOptions options,
        int substeps,
        PhysicsSettings settings,
        boolean sleeping,
        Looks looks) {

    /** Ticks that a report reaches back: five seconds. */
    private static final int REPORT_TICKS = 300;

    /** Ticks from one keyframe of a report to the next. */
    private static final int KEYFRAME_TICKS = 60;

    /** What to tell the user. */
    String save(PhysicsWorld world, long tick) {
        Recorder<Act> moment = new Recorder<>(world, (any, act) -> {}, 1);
        Path file = folder.resolve("moment-" + scene.id() + "-" + tick + ".cairn");
        try {
            RunFile.write(file, arguments(), sceneText, tick, moment.recording(), looks);
        } catch (IOException | StateException failure) {
            return "This moment is not saved: " + failure.getMessage();
        }
        return "This moment is in " + file;
    }

    /**
     * Writes the last seconds as they come again from a moment of the past, with what was done
     * since and the digests that were seen; so little is to be written down while nobody asks.
     *
     * @param timeline knows the moments
     * @param diary knows what was done
     * @param worlds makes a world like the one in the window
     * @param tick the present one
     * @param stepSeconds length of the ticks, s
     * @return what to tell the user
     */
    String report(
            Timeline timeline,
            Diary diary,
            Supplier<PhysicsWorld> worlds,
            long tick,
            double stepSeconds) {
        int key = timeline.momentWithEmptyHand(tick - REPORT_TICKS, diary);
        if (key < 0) {
            return "No report: no moment of the last seconds had an empty hand";
        }
        long begin = timeline.tick(key);
        Path file = folder.resolve("report-" + scene.id() + "-" + tick + ".cairn");
        try {
            long parts = run(file, timeline.state(key), begin, diary, worlds, tick, stepSeconds);
            return parts >= 0
                    ? "The report is in " + file + otherwise(parts)
                    : "The last %d ticks are in %s; samples --replay plays them again"
                            .formatted(tick - begin, file);
        } catch (IOException | StateException failure) {
            return "No report: " + failure.getMessage();
        }
    }

    /** What to tell of a run that does not come again. */
    static String otherwise(long tick) {
        return ", but from tick %d on it comes out otherwise than here: not all that was done is in it"
                .formatted(tick);
    }

    /**
     * Writes a run as it comes again from its first moment, see {@link #report}.
     *
     * @param file where to
     * @param from the world when the run began
     * @param begin the tick of that moment
     * @return the first tick that comes out otherwise, or -1
     * @throws IOException if the file cannot be written
     */
    long run(
            Path file,
            WorldState from,
            long begin,
            Diary diary,
            Supplier<PhysicsWorld> worlds,
            long tick,
            double stepSeconds)
            throws IOException {
        long parts = -1;
        try (PhysicsWorld world = worlds.get()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            world.restore(from);
            built.returnTo(begin);
            Recorder<Act> recorder = new Recorder<>(world, new Player(built), KEYFRAME_TICKS);
            for (long t = begin + 1; t <= tick; t++) {
                if (t > begin + 1) {
                    recorder.input(Act.AFTER);
                }
                diary.before(t).forEach(recorder::input);
                // The digests are those that were seen, where they are still known.
                if (!diary.hasSeen(t)) {
                    recorder.step(stepSeconds);
                } else if (!recorder.step(stepSeconds, diary.digest(t)) && parts < 0) {
                    parts = t;
                }
            }
            RunFile.write(file, arguments(), sceneText, begin, recorder.recording(), looks);
        }
        return parts;
    }

    /** Options that lead to this scene. */
    private List<String> arguments() {
        List<String> arguments = new ArrayList<>();
        if (sceneText.isEmpty()) {
            Collections.addAll(arguments, "--scene", scene.id());
        }
        options.values()
                .forEach((name, value) ->
                        Collections.addAll(arguments, "--set", name + "=" + value));
        Collections.addAll(arguments, "--seed", Long.toString(options.seed()));
        Collections.addAll(arguments, "--substeps", Integer.toString(substeps));
        int direct = settings.tuning().count(Tunable.DIRECT_FROM);
        Collections.addAll(arguments, "--direct-from", Integer.toString(direct));
        Collections.addAll(arguments, "--sleeping", sleeping ? "on" : "off");
        String precision = settings.precision().name().toLowerCase(Locale.ROOT);
        Collections.addAll(arguments, "--precision", precision);
        return arguments;
    }
}
