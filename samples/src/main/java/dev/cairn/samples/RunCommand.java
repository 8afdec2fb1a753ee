package dev.cairn.samples;

import dev.cairn.core.state.StateException;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.physics.time.Recording;
import dev.cairn.physics.time.Replay;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFileException;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
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

    /** Worlds of so many bodies have a keyframe each tick; larger ones now and then. */
    private static final int SMALL = 100;

    private static final int SELDOM = 60;

    private final PrintStream out;
    private final PrintStream err;

    RunCommand(PrintStream out, PrintStream err) {
        this.out = out;
        this.err = err;
    }

    /** Refuses what no file can hold. */
    static void requireRecordable(Main typed) {
        if (typed.record != null && typed.obj != null) {
            throw new UsageException(
                    "--record %s: writes down a scene of the list or a scene file; leave --obj out"
                            .formatted(typed.record));
        }
    }

    /** The exit code. */
    int record(Main typed) {
        Path file = Path.of(String.valueOf(typed.record));
        Request request = Request.of(typed);
        SampleScene scene = only(request, "--record " + file);
        int ticks = request.ticks() == null ? scene.ticks() : request.ticks();
        try (PhysicsWorld world = prepared(request, scene, ticks).world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options(request, scene)));
            Looks looks = new Looks(world);
            long begin = built.tick();
            Recorder<Act> recorder =
                    new Recorder<>(
                            world, new Player(built), world.bodyCount() <= SMALL ? 1 : SELDOM);
            for (int tick = 0; tick < ticks; tick++) {
                if (tick > 0) {
                    recorder.input(Act.AFTER);
                }
                recorder.input(Act.BEFORE);
                recorder.step(built.stepSeconds());
            }
            RunFile.write(
                    file, deciding(typed), text(request, file), begin, recorder.recording(), looks);
            out.printf(
                    "Recorded %s, digest %016x, in %s%n",
                    scene.id(), world.digest(), file.toAbsolutePath());
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "--record %s: cannot be written: %s".formatted(file, unwritable.getMessage()),
                    unwritable);
        }
        return Main.DONE;
    }

    /** The scene, if it is none of the list, for a file that may lie elsewhere. */
    private static String text(Request request, Path file) {
        SceneFile described = request.described();
        Path from = request.sceneFile();
        if (described == null || from == null) {
            return "";
        }
        // the moment that it begins with is the recording's first state
        SceneFile begun = described.withState(null);
        return SceneWriter.text(SceneEdit.rebase(begun, folder(from), folder(file)));
    }

    private static Path folder(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().getParent(), "a file is in a folder");
    }

    /** The exit code: {@link Main#FAILED} if anything differs. */
    int replay(Main typed) {
        if (!typed.scenes.isEmpty() || !typed.settings.isEmpty() || typed.record != null) {
            throw new UsageException(
                    "--replay %s: the file says what runs; leave --scene, --set and --record out"
                            .formatted(typed.replay));
        }
        RunFile file = open("--replay", String.valueOf(typed.replay));
        Main recorded = new Main(file.arguments());
        recorded.workers = typed.workers;
        recorded.lanes = typed.lanes;
        takeScene(file, Path.of(String.valueOf(typed.replay)), recorded);
        Request request = Request.of(recorded);
        SampleScene scene = only(request, "--replay " + typed.replay);
        try (PhysicsWorld world = prepared(request, scene, 0).world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options(request, scene)));
            built.returnTo(file.tick());
            Recording<Act> recording = file.recording(new Looks(world));
            Replay.Mismatch differs = new Replay<>(recording, world, new Player(built)).run();
            if (differs != null) {
                err.println(typed.replay + ": " + differs);
                return Main.FAILED;
            }
            out.printf(
                    "%s: %d ticks from tick %d on, all with the same digests, the last %016x%n",
                    typed.replay, recording.tickCount(), file.tick(), world.digest());
            return Main.DONE;
        } catch (StateException told) {
            throw new UsageException("--replay " + told.getMessage(), told);
        }
    }

    /** Has a command line begin with a saved moment: the scene and its settings are the file's. */
    static RunFile begin(Main typed, String from) {
        if (!typed.scenes.isEmpty()
                || !typed.settings.isEmpty()
                || typed.seed != null
                || typed.sceneFile != null
                || typed.obj != null
                || typed.exportScene != null
                || typed.record != null
                || typed.replay != null) {
            throw new UsageException(
                    "--from %s: the file says which scene it is; leave --scene, --set, --seed,"
                                    .formatted(from)
                            + " --scene-file, --obj, --export-scene, --record and --replay out");
        }
        RunFile file = open("--from", from);
        Main recorded = new Main(file.arguments());
        typed.scenes = recorded.scenes;
        typed.settings = recorded.settings;
        typed.seed = recorded.seed;
        takeScene(file, Path.of(from), typed);
        typed.substeps = typed.substeps == null ? recorded.substeps : typed.substeps;
        typed.directFrom = typed.directFrom == null ? recorded.directFrom : typed.directFrom;
        typed.sleeping = typed.sleeping == null ? recorded.sleeping : typed.sleeping;
        typed.precision = typed.precision == null ? recorded.precision : typed.precision;
        return file;
    }

    /** A scene that is none of the list is in the file; what it names is beside that. */
    private static void takeScene(RunFile file, Path path, Main into) {
        if (!file.sceneText().isEmpty()) {
            String name = String.valueOf(path.getFileName()).replaceAll("\\.cairn$", "");
            into.heldFile = path.toAbsolutePath().resolveSibling(name + ".json");
            try {
                into.held = SceneReader.parse("the scene in " + path, file.sceneText());
            } catch (SceneFileException broken) {
                throw new UsageException(String.valueOf(broken.getMessage()), broken);
            }
        }
    }

    private static RunFile open(String option, String name) {
        try {
            return RunFile.open(Path.of(name));
        } catch (StateException told) {
            throw new UsageException(option + " " + told.getMessage(), told);
        } catch (InvalidPathException malformed) {
            throw new UsageException(
                    "%s %s: this is no file name".formatted(option, name), malformed);
        } catch (IOException unreadable) {
            throw new UsageException(
                    "%s %s: cannot be read (%s)"
                            .formatted(option, name, unreadable.getClass().getSimpleName()),
                    unreadable);
        }
    }

    private static SampleScene only(Request request, String what) {
        if (request.scenes().size() != 1) {
            throw new UsageException(
                    "%s: holds one scene, not %d; add --scene ID"
                            .formatted(what, request.scenes().size()));
        }
        return request.scenes().get(0);
    }

    private static SceneOptions options(Request request, SampleScene scene) {
        return request.options().getOrDefault(scene.id(), SceneOptions.defaults(scene));
    }

    private static SceneRun prepared(Request request, SampleScene scene, int ticks) {
        return new SceneRun(
                        scene,
                        options(request, scene),
                        ticks,
                        request.workers(),
                        request.substeps())
                .directFrom(request.directFrom())
                .sleeping(request.sleepingOr(false))
                .lanes(request.lanes())
                .precision(request.precision());
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
                        "the file asks for %s, which is no option of a recorded run"
                                .formatted(arguments.get(i)));
            }
        }
        new CommandLine(into).parseArgs(arguments.toArray(new String[0]));
    }
}
