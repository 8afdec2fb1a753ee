package dev.cairn.samples;

import dev.cairn.samples.accuracy.AccuracyCommand;
import dev.cairn.samples.decompose.DecomposeCommand;
import dev.cairn.samples.film.GalleryCommand;
import dev.cairn.samples.film.PicturesCommand;
import dev.cairn.samples.fuzz.FuzzCommand;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenefile.SceneFile;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Option;

import java.io.Console;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The command line of the samples. Numbers stay text until {@link Request} has checked them, so
 * that every refusal names option, value and bound in one line.
 */
@Command(
        name = "samples",
        mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class,
        sortOptions = false,
        usageHelpWidth = 100,
        description = {
            "The scenes of Cairn. Without options: a window with all scenes where there is a"
                    + " display;",
            "otherwise the scenes of the report of 2020 without a window, a table of results, and a"
                    + " picture of each in ./pictures."
        },
        footer = {
            "",
            "Examples:",
            "  samples --list",
            "  samples --headless --scene all",
            "  samples --scene slope-box --set friction=0.2",
            "  samples --headless --scene pyramid --set base=100 --workers 2 --json -",
            "  samples --headless --obj rock.obj --picture rock.png --at 120",
            "  samples --headless --scene pile --ticks 300 --animation pile.png",
            "  samples --scene pyramid --set base=5 --export-scene five.json",
            "  samples --headless --scene-file five.json --picture five.png",
            "  samples --scene pyramid --record run.cairn",
            "  samples --replay run.cairn --workers 1 --lanes 4",
            "  samples --from moment.cairn   (a moment that was saved in the window by key M)",
            "  samples --scene room,pyramid,obj-drop --contact-sheet scenes.png",
            "  samples --decompose mug.obj --out mug.json   (convex parts; --decompose --help)",
            "  samples accuracy --quick      (compares with closed forms; accuracy --help)",
            "  samples fuzz --worlds 1000    (random worlds against laws; fuzz --help)",
            "  samples gallery               (the animations of docs/gallery.md)",
            "  samples pictures              (the pictures without and with effects)",
            "",
            "Exit codes: 0 done; 1 a scene failed; 2 the options make no sense (one line says why)."
        })
public final class Main {
    /** Everything went well. */
    static final int DONE = 0;

    /** A scene failed while it ran. */
    static final int FAILED = 1;

    /** The options make no sense. */
    static final int MISUSED = 2;

    @Option(names = "--list", description = "Print the scenes and their parameters.")
    boolean list;

    @Option(
            names = "--headless",
            description = "Run without a window; implied by --ticks, --json and --picture.")
    boolean headless;

    @Option(names = "--window", description = "Open a window, and fail where that is impossible.")
    boolean window;

    @Option(
            names = "--scene",
            paramLabel = "ID",
            description =
                    "Scene to run; repeat it, or separate by commas; all for all of them, report"
                            + " for those that run if none is named.")
    List<String> scenes = new ArrayList<>();

    @Option(
            names = "--scene-file",
            paramLabel = "FILE.json",
            description =
                    "Run a scene file instead of a scene of the list; see docs/scene-files.md.")
    @Nullable String sceneFile;

    @Option(
            names = "--export-scene",
            paramLabel = "FILE.json",
            description = "Write the only scene of the run as a scene file, and run nothing.")
    @Nullable String exportScene;

    @Option(names = "--obj", paramLabel = "FILE", description = "Mesh for scene obj-drop.")
    @Nullable String obj;

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description = "Set a parameter of the scene; may be repeated.")
    List<String> settings = new ArrayList<>();

    @Option(
            names = "--ticks",
            paramLabel = "N",
            description = "Length of the run in ticks of 1/60 s.")
    @Nullable String ticks;

    @Option(
            names = "--workers",
            paramLabel = "W",
            description = "Threads; the results do not depend on it.")
    @Nullable String workers;

    @Option(
            names = "--substeps",
            paramLabel = "N",
            description = "Sub-steps of the solver per tick.")
    @Nullable String substeps;

    @Option(
            names = "--direct-from",
            paramLabel = "N",
            description =
                    "Bodies from end to end of a slender island at rest from which on it is solved"
                            + " directly, 0 for never; 24 by default.")
    @Nullable String directFrom;

    @Option(
            names = "--sleeping",
            paramLabel = "on|off",
            description = "Whether bodies at rest fall asleep: on in a window, else off.")
    @Nullable String sleeping;

    @Option(
            names = "--lanes",
            paramLabel = "auto|1|4|8|16",
            description = "Contacts that are solved at once; the results do not depend on it.")
    @Nullable String lanes;

    @Option(
            names = "--precision",
            paramLabel = "auto|double|single",
            description =
                    "Numbers that contacts are solved in: single is faster, with errors of some"
                        + " 1e-7 of what changes; auto, the default, takes it for islands of more"
                        + " than 1024 contacts.")
    @Nullable String precision;

    @Option(
            names = "--seed",
            paramLabel = "S",
            description = "Seed of all that is random in a scene.")
    @Nullable String seed;

    @Option(
            names = "--json",
            paramLabel = "FILE",
            description = "Write the results as JSON; - is standard output.")
    @Nullable String json;

    @Option(
            names = "--picture",
            paramLabel = "FILE.png",
            description = "Draw the scene into a file.")
    @Nullable String picture;

    @Option(
            names = "--at",
            paramLabel = "TICK",
            description = "Tick of that picture; the last by default.")
    @Nullable String at;

    @Option(
            names = "--animation",
            paramLabel = "FILE.png",
            description = "Draw the only scene of the run into an animated .png, 480 x 270.")
    @Nullable String animation;

    @Option(
            names = "--record",
            paramLabel = "FILE.cairn",
            description =
                    "Write down the only scene of the run, tick by tick; with --window the one that"
                            + " is shown when it is closed, from its last beginning on.")
    @Nullable String record;

    @Option(
            names = "--replay",
            paramLabel = "FILE.cairn",
            description =
                    "Run again what was written down, and tell the first tick that differs; goes"
                            + " with --workers and --lanes.")
    @Nullable String replay;

    @Option(
            names = "--from",
            paramLabel = "FILE.cairn",
            description =
                    "Begin with a saved moment, or with the beginning of a recorded run, instead of"
                            + " the scene's own; the file says which scene it is.")
    @Nullable String from;

    /** The scene that a recorded run or a moment holds, and the file that it would be. */
    @Nullable SceneFile held;

    @Nullable Path heldFile;

    @Option(
            names = "--contact-sheet",
            paramLabel = "FILE.png",
            description = "Draw all scenes of the run side by side into one file.")
    @Nullable String contactSheet;

    private Main() {}

    /** The options of a run that was recorded. */
    Main(List<String> recorded) {
        RunCommand.parse(recorded, this);
    }

    /**
     * Runs the samples, and ends the process if they fail. What went well returns: NVIDIA's library
     * of EGL (driver 580) crashes when a process that has drawn is ended by {@link System#exit}.
     *
     * @param arguments the options; {@code --help} lists them
     */
    public static void main(String[] arguments) {
        Launched.endWithLauncher();
        int code = run(arguments, System.out, System.err, hasDisplay(System.getenv()));
        if (code != 0) {
            System.exit(code);
        }
    }

    /**
     * Runs the samples.
     *
     * @param arguments the options
     * @param out standard output
     * @param err standard error
     * @param display true if a window may be tried
     * @return the exit code
     */
    public static int run(String[] arguments, PrintStream out, PrintStream err, boolean display) {
        String first = arguments.length > 0 ? arguments[0] : "";
        if (first.equals("accuracy") || first.equals("fuzz")) {
            String[] rest = Arrays.copyOfRange(arguments, 1, arguments.length);
            try {
                return first.equals("fuzz")
                        ? FuzzCommand.run(rest, out, err, onTerminal())
                        : AccuracyCommand.run(rest, out, err, onTerminal());
            } catch (UncheckedIOException unwritable) {
                err.println(oneLine(unwritable));
                return FAILED;
            }
        }
        if (first.equals("gallery") || first.equals("pictures")) {
            String[] rest = Arrays.copyOfRange(arguments, 1, arguments.length);
            try {
                return first.equals("gallery")
                        ? GalleryCommand.run(rest, out, err)
                        : PicturesCommand.run(rest, out, err);
            } catch (UncheckedIOException unwritable) {
                err.println(oneLine(unwritable));
                return FAILED;
            }
        }
        if (Arrays.asList(arguments).contains("--decompose")) {
            try {
                return DecomposeCommand.run(
                        arguments, out, err, onTerminal(), more -> run(more, out, err, display));
            } catch (UncheckedIOException unwritable) {
                err.println(oneLine(unwritable));
                return FAILED;
            }
        }
        Main typed = new Main();
        CommandLine line = new CommandLine(typed);
        try {
            CommandLine.ParseResult parsed = line.parseArgs(arguments);
            if (parsed.isUsageHelpRequested()) {
                line.usage(out);
                return DONE;
            }
            if (parsed.isVersionHelpRequested()) {
                line.printVersionHelp(out);
                return DONE;
            }
            if (typed.replay != null && typed.from == null) {
                return new RunCommand(out, err).replay(typed);
            }
            RunCommand.requireRecordable(typed);
            if (typed.record != null && typed.from == null && !typed.window) {
                return new RunCommand(out, err).record(typed);
            }
            RunFile begun = typed.from == null ? null : RunCommand.begin(typed, typed.from);
            Runner runner = new Runner(Request.of(typed), begun, out, err, display);
            return typed.record == null ? runner.run() : runner.record(Path.of(typed.record)).run();
        } catch (CommandLine.UnmatchedArgumentException unknown) {
            String word = unknown.getUnmatched().get(0);
            if (!word.startsWith("-")) {
                err.println(
                        "%s: options begin with --%s; --help lists them"
                                .formatted(
                                        word,
                                        SceneRegistry.ids().contains(word)
                                                ? " (did you mean --scene " + word + "?)"
                                                : ""));
                return MISUSED;
            }
            List<String> near = unknown.getSuggestions();
            err.println(
                    "%s%s; --help lists the options"
                            .formatted(
                                    oneLine(unknown),
                                    near.isEmpty() ? "" : " (did you mean " + near.get(0) + "?)"));
            return MISUSED;
        } catch (CommandLine.ParameterException wrong) {
            err.println(oneLine(wrong) + "; --help lists the options");
            return MISUSED;
        } catch (UsageException misuse) {
            err.println(oneLine(misuse));
            return MISUSED;
        } catch (UncheckedIOException unwritable) {
            err.println(oneLine(unwritable));
            return FAILED;
        } catch (OutOfMemoryError full) {
            return outOfMemory("the command", err);
        }
    }

    /** Says that something asks for too much; returns the exit code. */
    static int outOfMemory(String what, PrintStream err) {
        err.printf(
                "%s needs more than the %d MB that the JVM may use: take fewer bodies, put fewer of"
                        + " them in one place, or raise -Xmx%n",
                what, Runtime.getRuntime().maxMemory() >> 20);
        return MISUSED;
    }

    /** A message as one line that a terminal takes for text, whatever a name in it holds. */
    private static String oneLine(Exception failure) {
        return String.valueOf(failure.getMessage())
                .strip()
                .replaceAll("\\s*\\R\\s*", " ")
                .replaceAll("\\p{Cntrl}", "?");
    }

    /**
     * Says whether a window may be tried: X11 and Wayland name their display, macOS and Windows
     * have one.
     */
    static boolean hasDisplay(Map<String, String> environment) {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        if (system.contains("windows") || system.contains("mac")) {
            return true;
        }
        return !environment.getOrDefault("DISPLAY", "").isEmpty()
                || !environment.getOrDefault("WAYLAND_DISPLAY", "").isEmpty();
    }

    /** Says whether a person watches: standard input and output are a terminal. */
    @SuppressWarnings(
            "SystemConsoleNull") // The JDK promises a console but declares that it may be null.
    static boolean onTerminal() {
        Console console = System.console();
        return console != null && console.isTerminal();
    }

    /** The answer to {@code --version}. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {
                "Cairn samples " + (version == null ? "(development build)" : version),
                "Java "
                        + Runtime.version()
                        + ", "
                        + System.getProperty("os.name")
                        + " "
                        + System.getProperty("os.arch")
            };
        }
    }
}
