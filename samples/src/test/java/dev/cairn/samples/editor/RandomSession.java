package dev.cairn.samples.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.WorldFailedException;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.View;
import dev.cairn.render.app.Views;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.Pointer;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.edit.SceneHistory;

import org.joml.Vector3d;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * The editor with its panels, its mouse and a world that shows its scene, but without a window, and
 * a user of it who does anything. What an action is follows from a number of its own, so that
 * actions may be left out in search of a cause.
 */
final class RandomSession implements AutoCloseable, Stage {
    private static final SceneOptions NO_OPTIONS = new SceneOptions(Map.of(), 1, null);

    /** Length of a tick, s. */
    private static final double STEP = 1.0 / 60;

    private static final List<String> FILES =
            List.of(
                    "x.json",
                    "wrong.json",
                    "none.json",
                    "tetra.obj",
                    "wrong.obj",
                    "wrong.png",
                    "?");
    private static final MouseButton[] BUTTONS = {
        MouseButton.LEFT, MouseButton.MIDDLE, MouseButton.RIGHT
    };

    private final Path folder;
    private final Editor editor = new Editor(this);
    private final EditorPanels panels = new EditorPanels(editor);
    private final Bindings bindings = new Bindings();
    private final List<String> chords = new ArrayList<>();
    private final Camera camera = new Camera();
    private final Pointer pointer = new Pointer();
    private final SnapshotExchange exchange = new SnapshotExchange();
    private final View view = Views.of(camera, pointer, exchange.latest());
    private final RandomUi ui;
    private PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
    private SceneLoader.Assets assets = new SceneLoader.Assets();
    private SceneBuilder built = new SceneBuilder(world, NO_OPTIONS);
    private long[] entities = {};
    private String notes = "";
    private long frames;
    private double mouseX = 0.5;
    private double mouseY = 0.5;

    /** What should be at each number of steps. */
    private final List<SceneFile> model = new ArrayList<>();

    private int at;
    private SceneHistory history;

    /** What was done, for messages. */
    final List<String> done = new ArrayList<>();

    RandomSession(Path folder, boolean narrow) {
        this.folder = folder;
        ui = new RandomUi(narrow ? 640 : 1280, 720);
        panels.bind(bindings);
        editor.open(Supply.emptyScene(), null, folder);
        begin();
    }

    private void begin() {
        history = editor.history();
        model.clear();
        at = history.steps();
        for (int i = 0; i < at; i++) {
            model.add(null);
        }
        model.add(editor.scene());
    }

    // The stage: as the window's simulation thread does it -------------------------------------

    @Override
    public void rest(SceneFile scene, Path from, boolean places) {
        assets = places ? new SceneLoader.Assets() : assets;
        show(scene, from);
        if (places) {
            built.view().place(camera);
        }
    }

    private void show(SceneFile scene, Path from) {
        built.clear();
        built = new SceneBuilder(world, NO_OPTIONS);
        entities = new long[scene.entities().size()];
        try {
            SceneLoader.build(scene, from, built, assets, entities);
            notes = String.join("; ", built.remarks());
        } catch (IllegalArgumentException refused) {
            notes = String.valueOf(refused.getMessage());
        }
        exchange.publish(world.ecs(), null);
    }

    @Override
    public void play(SceneFile scene, Path from) {
        show(scene, from);
        try {
            for (int i = 0; i < 3; i++) {
                built.beforeTick();
                world.step(scene.tick().seconds());
                built.afterTick();
                exchange.publish(world.ecs(), null);
            }
        } catch (WorldFailedException failed) {
            // No numbers are too large for a file, and some are for a world: the sandbox stops.
            world.close();
            world = PhysicsWorld.builder().workers(1).build();
            built = new SceneBuilder(world, NO_OPTIONS);
            editor.stop();
        }
    }

    @Override
    public void leave() {
        built.clear();
        built = new SceneBuilder(world, NO_OPTIONS);
        entities = new long[0];
        exchange.publish(world.ecs(), null);
    }

    // The user ---------------------------------------------------------------------------------

    /** One action, and the frames that it takes. */
    void act(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int kind = random.nextInt(100);
        String what;
        if (kind < 50) {
            what = frame(random, true, List.of());
        } else if (kind < 70) {
            what = mouse(random);
        } else if (kind < 90) {
            what = key(random);
        } else if (kind < 93) {
            double steps = random.nextInt(-3, 4);
            panels.raise(steps);
            what = "wheel by " + steps + frame(random, false, List.of());
        } else if (kind < 95) {
            what = "escape " + panels.dismiss() + frame(random, false, List.of());
        } else if (kind < 97) {
            what = drop(random);
        } else {
            what = fly(random);
        }
        done.add(what);
        check(what);
    }

    private String frame(SplittableRandom random, boolean uses, List<Path> dropped) {
        frames++;
        Views.next(view, exchange.latest(), ui.width() / ui.height(), frames, dropped);
        ui.begin(random, uses);
        panels.dropped(view, entities);
        if (editor.mode() == Editor.Mode.CLOSED) {
            editor.open();
        }
        panels.draw(ui, view, entities, notes);
        panels.hear();
        pointer.nextFrame();
        return ui.used();
    }

    private String mouse(SplittableRandom random) {
        MouseButton button = BUTTONS[random.nextInt(8) == 0 ? 1 + random.nextInt(2) : 0];
        boolean shift = random.nextInt(6) == 0;
        boolean control = random.nextInt(10) == 0;
        place(random);
        String what = "press " + button + (shift ? " with shift" : "") + spot();
        frame(random, false, List.of());
        pointer.modifiers(shift, control);
        pointer.button(button, true);
        frame(random, false, List.of());
        for (int i = random.nextInt(4); i > 0; i--) {
            place(random);
            what += ", to" + spot();
            frame(random, false, List.of());
        }
        pointer.button(button, false);
        frame(random, false, List.of());
        return what;
    }

    private void place(SplittableRandom random) {
        boolean wild = random.nextInt(6) == 0;
        mouseX = wild ? random.nextDouble(-3, 4) : random.nextDouble(0.3, 0.7);
        mouseY = wild ? random.nextDouble(-3, 4) : random.nextDouble(0.2, 0.8);
        pointer.place(mouseX, mouseY, false, false);
    }

    private String spot() {
        return " (%.3f, %.3f)".formatted(mouseX, mouseY);
    }

    private String key(SplittableRandom random) {
        List<Bindings.Binding> actions = bindings.actions();
        Bindings.Binding binding = actions.get(random.nextInt(actions.size()));
        if (binding.triggers().isEmpty() || binding.action().contains("save")) {
            return "no key";
        }
        int which = random.nextInt(binding.triggers().size());
        switch (binding.triggers().get(which)) {
            case dev.cairn.render.input.Key key -> {
                bindings.press(key);
                bindings.release(key);
            }
            case dev.cairn.render.input.Chord chord -> bindings.press(chord);
            default -> {}
        }
        bindings.endTick();
        frame(random, false, List.of());
        return "key of " + binding.action();
    }

    private String drop(SplittableRandom random) {
        List<Path> files = new ArrayList<>();
        for (int i = random.nextInt(3); i >= 0; i--) {
            files.add(folder.resolve(FILES.get(random.nextInt(FILES.size()))));
        }
        place(random);
        frame(random, false, files);
        return "drop " + files;
    }

    private String fly(SplittableRandom random) {
        double by = random.nextInt(5) == 0 ? 1e4 : 3;
        camera.fly(
                random.nextDouble(-by, by), random.nextDouble(-by, by), random.nextDouble(-by, by));
        camera.turn(
                random.nextDouble(-1, 1), random.nextInt(4) == 0 ? -9 : random.nextDouble(-1, 1));
        frame(random, false, List.of());
        return "fly";
    }

    // What must hold ---------------------------------------------------------------------------

    private void check(String what) {
        SceneFile scene = editor.scene();
        int count = scene.entities().size();
        for (int each : editor.selection()) {
            assertTrue(each >= 0 && each < count, () -> "selected " + each + " of " + count);
        }
        int[] selected = editor.selection();
        assertEquals(selected.length, Arrays.stream(selected).distinct().count(), "selected twice");
        int joint = editor.joints().selected();
        assertTrue(joint < scene.joints().size(), "joint " + joint);
        assertTrue(joint == Editor.NOTHING || selected.length == 0, "a joint and an entity");
        scene.joints().forEach(j -> assertTrue(j.a() < count && j.b() < count, "a joint's ends"));
        assertTrue(editor.message().lines().count() <= 1, editor.message());
        assertTrue(camera.position(new Vector3d()).isFinite(), "the camera");
        if (history != editor.history()) {
            begin();
            return;
        }
        int steps = history.steps();
        boolean travels = what.matches("(?s).*([Uu]ndo|[Rr]edo).*");
        if (travels && steps < model.size() && Math.abs(steps - at) == 1) {
            SceneFile then = model.get(steps);
            assertTrue(then == null || then.equals(scene), "not what it was at step " + steps);
            model.set(steps, scene);
        } else if (steps != at || !scene.equals(model.get(at))) {
            assertTrue(steps >= at, "steps went from " + at + " to " + steps);
            // An action of several edits tells nothing of the scenes between.
            while (model.size() > Math.min(steps, at + 1)) {
                model.removeLast();
            }
            while (model.size() < steps) {
                model.add(null);
            }
            model.add(scene);
        }
        at = steps;
    }

    /** At the end: all the way back and forth, a file and back, two worlds. */
    void end() throws IOException {
        editor.stop();
        editor.open();
        editor.joints().cancel();
        SceneFile last = editor.scene();
        int top = at;
        int bottom = at;
        while (history.undoLabel() != null) {
            editor.undo();
            bottom--;
            SceneFile then = model.get(bottom);
            assertTrue(then == null || then.equals(editor.scene()), "undone to step " + bottom);
        }
        int way = top - bottom;
        for (int i = 0; i < way; i++) {
            editor.redo();
        }
        assertTrue(last.equals(editor.scene()), "all done again");
        String text = SceneWriter.text(last);
        SceneFile again = SceneReader.parse("saved", text);
        assertTrue(last.equals(again), "saved and loaded");
        assertEquals(text, SceneWriter.text(again), "saved again");
        assertEquals(world(last), world(again), "the worlds of both");
        file(last);
    }

    private void file(SceneFile last) throws IOException {
        Path file = editor.files().folder().resolve("end.json");
        Files.deleteIfExists(file);
        editor.files().save("end.json");
        assertFalse(editor.isWrong(), editor.message());
        assertEquals(SceneWriter.text(last), Files.readString(file));
        editor.files().load("end.json");
        assertFalse(editor.isWrong(), editor.message());
        assertTrue(last.equals(editor.scene()), "loaded from a file");
    }

    private String world(SceneFile scene) {
        try (PhysicsWorld own =
                PhysicsWorld.builder().workers(1).substeps(scene.tick().substeps()).build()) {
            SceneBuilder into = new SceneBuilder(own, NO_OPTIONS);
            try {
                SceneLoader.build(scene, editor.files().folder(), into);
            } catch (IllegalArgumentException refused) {
                return String.valueOf(refused.getMessage());
            }
            try {
                for (int i = 0; i < 30; i++) {
                    into.beforeTick();
                    own.step(STEP);
                    into.afterTick();
                }
            } catch (WorldFailedException failed) {
                return String.valueOf(failed.getMessage());
            }
            return "digest " + own.digest();
        }
    }

    @Override
    public void close() {
        world.close();
    }
}
