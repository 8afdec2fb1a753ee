package dev.cairn.samples;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFileException;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneReader;

import org.jspecify.annotations.Nullable;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;

/**
 * A checked command line: what to run and how. Everything that can be wrong with it has been said
 * before the first scene starts. Immutable.
 *
 * @param mode what to do
 * @param scenes the scenes, in order
 * @param options options by scene id
 * @param ticks length of each run, or null for each scene's own
 * @param workers threads of the physics
 * @param substeps sub-steps of the solver
 * @param directFrom bodies from end to end from which on a slender island is solved directly
 * @param sleeping whether bodies at rest fall asleep, or null for what suits the mode
 * @param lanes contacts that are solved at once, 0 for what fits the machine
 * @param precision of the numbers that contacts are solved in
 * @param json where the JSON goes, {@code -} for standard output, or null
 * @param picture where the picture of the only scene goes, or null
 * @param at tick of that picture, or null for the last
 * @param gallery true if every scene gets a picture in a folder
 * @param contactSheet where these pictures also go side by side, or null
 * @param animation where the animation of the only scene goes, or null
 * @param stepSeconds length of a tick in a window, s
 * @param export where the only scene is written as a scene file, or null
 * @param sceneFile the scene file that the only scene came from, or null
 * @param described what is in that file, or null
 */
record Request(
        Mode mode,
        List<SampleScene> scenes,
        Map<String, SceneOptions> options,
        @Nullable Integer ticks,
        int workers,
        int substeps,
        int directFrom,
        @Nullable Boolean sleeping,
        int lanes,
        Precision precision,
        @Nullable String json,
        @Nullable Path picture,
        @Nullable Integer at,
        boolean gallery,
        @Nullable Path contactSheet,
        @Nullable Path animation,
        double stepSeconds,
        @Nullable Path export,
        @Nullable Path sceneFile,
        @Nullable SceneFile described) {

    /** What to do. */
    enum Mode {
        /** Print what there is. */
        LIST,
        /** Write a scene file. */
        EXPORT,
        /** Run without a window. */
        HEADLESS,
        /** Open a window, or complain. */
        WINDOW,
        /** Open a window if that is possible, else run without. */
        EITHER
    }

    static final int MOST_TICKS = 10_000_000;

    /** A minute; its frames are kept in memory until they are written. */
    private static final int LONGEST_FILM = 3600;

    private static final String OBJ_SCENE = "obj-drop";

    /** Copies the collections. */
    Request {
        scenes = List.copyOf(scenes);
        options = Map.copyOf(options);
    }

    /**
     * Returns what the options ask for, or throws a {@link UsageException} that says what is wrong
     * with them.
     */
    static Request of(Main typed) {
        rejectContradictions(typed);
        Integer ticks = whole("--ticks", typed.ticks, 0, MOST_TICKS);
        Integer workers = whole("--workers", typed.workers, 1, Jobs.MAX_WORKERS);
        Integer substeps = whole("--substeps", typed.substeps, 1, 64);
        Integer directFrom = whole("--direct-from", typed.directFrom, 0, 1024);
        Integer at = whole("--at", typed.at, 0, MOST_TICKS);
        Path obj = path("--obj", typed.obj);
        if (obj != null && !Files.isRegularFile(obj)) {
            throw new UsageException(
                    "--obj %s: %s; name a Wavefront .obj file"
                            .formatted(
                                    typed.obj,
                                    Files.isDirectory(obj)
                                            ? "this is a folder"
                                            : "there is no such file"));
        }
        SceneFile held = typed.held;
        Path file = held == null ? path("--scene-file", typed.sceneFile) : typed.heldFile;
        SceneFile described = held != null || file == null ? held : read(file);
        List<SampleScene> scenes =
                file == null || described == null
                        ? scenes(typed.scenes, obj, mode(typed))
                        : List.of(SceneLoader.sample(file, described));
        Map<String, SceneOptions> options =
                options(scenes, settings(typed.settings), seed(typed.seed), obj);
        Path picture = path("--picture", typed.picture);
        if (picture != null) {
            checkPicture(picture, scenes, at, ticks);
        }
        Path export = path("--export-scene", typed.exportScene);
        if (export != null) {
            checkExport(export, scenes);
        }
        Path sheet = path("--contact-sheet", typed.contactSheet);
        if (sheet != null) {
            OutputFile.checkPng("--contact-sheet", sheet);
        }
        Path animation = path("--animation", typed.animation);
        if (animation != null) {
            checkAnimation(animation, scenes, ticks);
        }
        if (typed.json != null && !typed.json.equals("-")) {
            Path json = path("--json", typed.json);
            if (json != null) {
                OutputFile.checkFolder("--json", json);
                OutputFile.checkWritable("--json", json);
            }
        }
        return new Request(
                mode(typed),
                scenes,
                options,
                ticks,
                workers == null ? Jobs.defaultWorkers() : workers,
                substeps == null ? substeps(described) : substeps,
                directFrom == null
                        ? PhysicsSettings.DEFAULT.tuning().count(Tunable.DIRECT_FROM)
                        : directFrom,
                onOff("--sleeping", typed.sleeping),
                lanes(typed.lanes),
                precision(typed.precision),
                typed.json,
                picture,
                at,
                sheet != null
                        || (isGroup(typed.scenes)
                                && file == null
                                && obj == null
                                && typed.json == null),
                sheet,
                animation,
                described == null ? SampleScene.STEP_SECONDS : described.tick().seconds(),
                export,
                file,
                described);
    }

    /** Whether no scene was named, but all or those of the report. */
    private static boolean isGroup(List<String> typed) {
        return typed.stream()
                .allMatch(t -> t.equals(SceneRegistry.ALL) || t.equals(SceneRegistry.REPORT));
    }

    private static int lanes(@Nullable String text) {
        return switch (text == null ? "auto" : text.trim()) {
            case "auto" -> 0;
            case "1" -> 1;
            case "4" -> 4;
            case "8" -> 8;
            case "16" -> 16;
            default ->
                    throw new UsageException(
                            "--lanes %s: want auto, 1, 4, 8 or 16; the results are the same"
                                    .formatted(text));
        };
    }

    private static Precision precision(@Nullable String text) {
        return switch (text == null ? "auto" : text.trim()) {
            case "auto" -> Precision.AUTO;
            case "double" -> Precision.DOUBLE;
            case "single" -> Precision.SINGLE;
            default ->
                    throw new UsageException(
                            "--precision %s: want auto, double or single".formatted(text));
        };
    }

    private static int substeps(@Nullable SceneFile described) {
        return described == null ? PhysicsSettings.DEFAULT.substeps() : described.tick().substeps();
    }

    private static SceneFile read(Path file) {
        try {
            return SceneReader.read(file);
        } catch (SceneFileException broken) {
            throw new UsageException("--scene-file " + broken.getMessage(), broken);
        }
    }

    private static void checkExport(Path export, List<SampleScene> scenes) {
        if (scenes.size() != 1) {
            throw new UsageException(
                    "--export-scene %s: holds one scene, not %d; add --scene ID"
                            .formatted(export, scenes.size()));
        }
        if (!export.toString().endsWith(".json")) {
            throw new UsageException(
                    "--export-scene %s: the name must end in .json".formatted(export));
        }
        OutputFile.checkFolder("--export-scene", export);
        OutputFile.checkWritable("--export-scene", export);
    }

    boolean sleepingOr(boolean otherwise) {
        return sleeping == null ? otherwise : sleeping;
    }

    private static @Nullable Boolean onOff(String option, @Nullable String text) {
        if (text == null) {
            return null;
        }
        if (text.equals("on") || text.equals("off")) {
            return text.equals("on");
        }
        throw new UsageException("%s %s: want on or off".formatted(option, text));
    }

    private static Mode mode(Main typed) {
        if (typed.list) {
            return Mode.LIST;
        }
        if (typed.exportScene != null) {
            return Mode.EXPORT;
        }
        if (typed.window) {
            return Mode.WINDOW;
        }
        boolean measured =
                typed.json != null
                        || typed.picture != null
                        || typed.contactSheet != null
                        || typed.animation != null
                        || typed.ticks != null;
        return typed.headless || measured ? Mode.HEADLESS : Mode.EITHER;
    }

    private static void rejectContradictions(Main typed) {
        if (typed.list
                && (typed.headless
                        || typed.window
                        || !typed.scenes.isEmpty()
                        || typed.json != null)) {
            throw new UsageException("--list only prints the scenes; leave the other options out");
        }
        if (typed.sceneFile != null && (!typed.scenes.isEmpty() || typed.obj != null)) {
            throw new UsageException(
                    "--scene-file %s: is the scene; leave --scene and --obj out"
                            .formatted(typed.sceneFile));
        }
        if (typed.exportScene != null
                && (typed.window
                        || typed.sceneFile != null
                        || typed.json != null
                        || typed.picture != null
                        || typed.contactSheet != null)) {
            throw new UsageException(
                    "--export-scene %s: only writes the file; it goes with --scene, --set, --seed"
                            .formatted(typed.exportScene));
        }
        if (!typed.settings.isEmpty()
                && typed.scenes.isEmpty()
                && typed.sceneFile == null
                && typed.obj == null) {
            throw new UsageException(
                    "--set %s: of which scene? Add --scene ID; --list shows all"
                            .formatted(typed.settings.get(0)));
        }
        if (typed.window && typed.headless) {
            throw new UsageException(
                    "--window and --headless contradict each other; give one of them");
        }
        if (typed.window && (typed.json != null || typed.picture != null || typed.ticks != null)) {
            throw new UsageException(
                    "--window runs until it is closed; --ticks, --json and --picture go with"
                            + " --headless");
        }
        if (typed.contactSheet != null && (typed.window || typed.picture != null)) {
            throw new UsageException(
                    "--contact-sheet %s: goes with --headless, and without --picture"
                            .formatted(typed.contactSheet));
        }
        if (typed.animation != null
                && (typed.window || typed.picture != null || typed.contactSheet != null)) {
            throw new UsageException(
                    "--animation %s: goes with --headless, and without --picture and --contact-sheet"
                            .formatted(typed.animation));
        }
        if (typed.at != null && typed.picture == null) {
            throw new UsageException(
                    "--at %s: says when to draw, so it needs --picture FILE.png"
                            .formatted(typed.at));
        }
    }

    private static void checkPicture(
            Path picture, List<SampleScene> scenes, @Nullable Integer at, @Nullable Integer ticks) {
        if (scenes.size() != 1) {
            throw new UsageException(
                    "--picture %s: shows one scene, not %d; add --scene ID"
                            .formatted(picture, scenes.size()));
        }
        int last = ticks == null ? scenes.get(0).ticks() : ticks;
        if (at != null && at > last) {
            throw new UsageException(
                    "--at %d: the run ends after %d ticks; add --ticks %d".formatted(at, last, at));
        }
        OutputFile.checkPng("--picture", picture);
    }

    private static void checkAnimation(
            Path animation, List<SampleScene> scenes, @Nullable Integer ticks) {
        if (scenes.size() != 1) {
            throw new UsageException(
                    "--animation %s: shows one scene, not %d; add --scene ID"
                            .formatted(animation, scenes.size()));
        }
        int length = ticks == null ? scenes.get(0).ticks() : ticks;
        if (length < 1 || length > LONGEST_FILM) {
            throw new UsageException(
                    "--animation %s: of %d ticks, want 1 to %d; add --ticks N"
                            .formatted(animation, length, LONGEST_FILM));
        }
        OutputFile.checkPng("--animation", animation);
    }

    private static List<SampleScene> scenes(List<String> typed, @Nullable Path obj, Mode mode) {
        if (typed.isEmpty()) {
            if (obj != null) {
                return List.of(SceneRegistry.get(OBJ_SCENE));
            }
            boolean runs = mode == Mode.HEADLESS || mode == Mode.EITHER;
            return runs ? SceneRegistry.report() : SceneRegistry.all();
        }
        LinkedHashSet<String> ids = new LinkedHashSet<>();
        for (String text : typed) {
            Collections.addAll(ids, text.split(",", -1));
        }
        LinkedHashSet<SampleScene> scenes = new LinkedHashSet<>();
        for (String id : ids) {
            if (id.isBlank()) {
                throw new UsageException(
                        "--scene: a name is empty; want --scene ID or --scene ID,ID; --list shows"
                                + " all");
            }
            switch (id.trim()) {
                case SceneRegistry.ALL -> scenes.addAll(SceneRegistry.all());
                case SceneRegistry.REPORT -> scenes.addAll(SceneRegistry.report());
                default -> scenes.add(SceneRegistry.get(id.trim()));
            }
        }
        if (obj != null && scenes.stream().noneMatch(scene -> scene.id().equals(OBJ_SCENE))) {
            throw new UsageException(
                    "--obj %s: only scene %s takes a mesh; add --scene %s"
                            .formatted(obj, OBJ_SCENE, OBJ_SCENE));
        }
        return List.copyOf(scenes);
    }

    private static Map<String, String> settings(List<String> typed) {
        Map<String, String> settings = new LinkedHashMap<>();
        for (String text : typed) {
            int equals = text.indexOf('=');
            if (equals < 1) {
                throw new UsageException(
                        "--set %s: want name=value, for example --set friction=0.4"
                                .formatted(text));
            }
            String name = text.substring(0, equals).trim();
            String other = settings.put(name, text.substring(equals + 1));
            if (other != null) {
                throw new UsageException(
                        "--set %s: %s was set to %s before; set it once"
                                .formatted(text, name, other));
            }
        }
        return settings;
    }

    /** Gives each scene those settings that it knows; one that no scene knows is refused. */
    private static Map<String, SceneOptions> options(
            List<SampleScene> scenes, Map<String, String> settings, long seed, @Nullable Path obj) {
        LinkedHashSet<String> known = new LinkedHashSet<>();
        Map<String, SceneOptions> options = new LinkedHashMap<>();
        for (SampleScene scene : scenes) {
            Map<String, String> own = new LinkedHashMap<>();
            for (Parameter parameter : scene.parameters()) {
                known.add(parameter.name());
                String text = settings.get(parameter.name());
                if (text != null) {
                    own.put(parameter.name(), text);
                }
            }
            options.put(
                    scene.id(),
                    SceneOptions.of(
                            scene,
                            scenes.size() == 1 ? settings : own,
                            seed,
                            scene.id().equals(OBJ_SCENE) ? obj : null));
        }
        for (String name : settings.keySet()) {
            if (!known.contains(name)) {
                throw new UsageException(
                        "--set %s: none of the scenes has a parameter of this name%s; --list shows all"
                                .formatted(name, Nearest.hint(name, List.copyOf(known))));
            }
        }
        return options;
    }

    private static long seed(@Nullable String text) {
        if (text == null) {
            return SceneOptions.DEFAULT_SEED;
        }
        try {
            return Long.parseLong(text.trim());
        } catch (NumberFormatException notANumber) {
            throw new UsageException(
                    "--seed %s: want a whole number of 64 bits".formatted(text), notANumber);
        }
    }

    private static @Nullable Integer whole(String option, @Nullable String text, int min, int max) {
        if (text == null) {
            return null;
        }
        try {
            int value = Integer.parseInt(text.trim());
            if (value >= min && value <= max) {
                return value;
            }
        } catch (NumberFormatException notANumber) {
            // Refused below, with the same words.
        }
        throw new UsageException(
                "%s %s: want a whole number from %d to %d".formatted(option, text, min, max));
    }

    private static @Nullable Path path(String option, @Nullable String text) {
        if (text == null) {
            return null;
        }
        try {
            return Path.of(text);
        } catch (InvalidPathException malformed) {
            throw new UsageException(
                    "%s %s: this is no file name".formatted(option, text), malformed);
        }
    }
}
