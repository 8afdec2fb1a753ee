package dev.cairn.samples;

import dev.cairn.core.state.StateException;
import dev.cairn.samples.replay.Recorder;
import dev.cairn.samples.replay.Replay;
import dev.cairn.samples.replay.RunFile;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Writes down a run of a scene, and plays it again. */
final class RunCommand {
    /** What of the options of a run decides its bits; no other is read from a file. */
    private static final Set<String> DECIDING =
            Set.of(
                    "--scene",
                    "--set",
                    "--seed",
                    "--ticks",
                    "--substeps",
                    "--direct-from",
                    "--sleeping",
                    "--precision");

    private final PrintStream out;
    private final PrintStream err;

    RunCommand(PrintStream out, PrintStream err) {
        this.out = out;
        this.err = err;
    }

    /** The exit code. */
    int record(Main typed) {
        if (typed.window || typed.obj != null || typed.sceneFile != null) {
            throw new UsageException(
                    "--record %s: writes down a scene of the list without a window; leave --window,"
                                    .formatted(typed.record)
                            + " --obj and --scene-file out");
        }
        Recorder recorder = new Recorder(deciding(typed));
        String digest = run(typed, "--record " + typed.record, recorder);
        Path file = Path.of(String.valueOf(typed.record));
        try {
            recorder.file().write(file);
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "--record %s: cannot be written: %s".formatted(file, unwritable.getMessage()),
                    unwritable);
        }
        out.printf("Recorded %s, digest %s, in %s%n", typed.scenes, digest, file.toAbsolutePath());
        return Main.DONE;
    }

    /** The exit code: {@link Main#FAILED} if anything differs. */
    int replay(Main typed) {
        if (!typed.scenes.isEmpty() || !typed.settings.isEmpty() || typed.record != null) {
            throw new UsageException(
                    "--replay %s: the file says what runs; leave --scene, --set and --record out"
                            .formatted(typed.replay));
        }
        RunFile file;
        try {
            file = RunFile.read(Path.of(String.valueOf(typed.replay)));
        } catch (StateException told) {
            throw new UsageException("--replay: " + told.getMessage(), told);
        } catch (IOException unreadable) {
            throw new UsageException(
                    "--replay %s: cannot be read (%s)"
                            .formatted(typed.replay, unreadable.getClass().getSimpleName()),
                    unreadable);
        }
        Main recorded = new Main(file.arguments());
        recorded.workers = typed.workers;
        recorded.lanes = typed.lanes;
        Replay replay = new Replay(file);
        run(recorded, "--replay " + typed.replay, replay);
        (replay.isSame() ? out : err).println(typed.replay + ": " + replay.verdict());
        return replay.isSame() ? Main.DONE : Main.FAILED;
    }

    /** The digest at the end. */
    private String run(Main typed, String what, SceneRun.Observer observer) {
        Request request = Request.of(typed);
        if (request.scenes().size() != 1) {
            throw new UsageException(
                    "%s: holds one scene, not %d; add --scene ID"
                            .formatted(what, request.scenes().size()));
        }
        SampleScene scene = request.scenes().get(0);
        int ticks = request.ticks() == null ? scene.ticks() : request.ticks();
        SceneOptions options =
                request.options().getOrDefault(scene.id(), SceneOptions.defaults(scene));
        return new SceneRun(scene, options, ticks, request.workers(), request.substeps())
                .directFrom(request.directFrom())
                .sleeping(request.sleepingOr(false))
                .lanes(request.lanes())
                .precision(request.precision())
                .observer(observer)
                .run(() -> {})
                .digest();
    }

    /** The options of a run that decide its bits, as arguments. */
    private static List<String> deciding(Main typed) {
        List<String> arguments = new ArrayList<>();
        typed.scenes.forEach(scene -> add(arguments, "--scene", scene));
        typed.settings.forEach(setting -> add(arguments, "--set", setting));
        add(arguments, "--seed", typed.seed);
        add(arguments, "--ticks", typed.ticks);
        add(arguments, "--substeps", typed.substeps);
        add(arguments, "--direct-from", typed.directFrom);
        add(arguments, "--sleeping", typed.sleeping);
        add(arguments, "--precision", typed.precision);
        return arguments;
    }

    private static void add(List<String> arguments, String option, @Nullable String value) {
        if (value != null) {
            arguments.add(option);
            arguments.add(value);
        }
    }

    /** Reads what {@link #deciding} wrote into a command line. */
    static void parse(List<String> arguments, Main into) {
        for (int i = 0; i < arguments.size(); i += 2) {
            if (!DECIDING.contains(arguments.get(i)) || i + 1 == arguments.size()) {
                throw new UsageException(
                        "--replay: the file asks for %s, which is no option of a recorded run"
                                .formatted(arguments.get(i)));
            }
        }
        new CommandLine(into).parseArgs(arguments.toArray(new String[0]));
    }
}
