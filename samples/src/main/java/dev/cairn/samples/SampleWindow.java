package dev.cairn.samples;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.Scene;
import dev.cairn.render.input.Key;

import org.jspecify.annotations.Nullable;

import java.io.PrintStream;
import java.util.List;
import java.util.Map;

/**
 * The window with the scenes: keys 1 to 9 and 0, page up and page down choose one, R starts it
 * again, P pauses the physics.
 *
 * <p>One world serves all scenes in turn: a change of scene removes the bodies of the last and
 * builds the next. All methods but {@link #start} run on the simulation thread.
 */
final class SampleWindow extends Application {
    private static final Key[] NUMBERS = {
        Key.DIGIT_1,
        Key.DIGIT_2,
        Key.DIGIT_3,
        Key.DIGIT_4,
        Key.DIGIT_5,
        Key.DIGIT_6,
        Key.DIGIT_7,
        Key.DIGIT_8,
        Key.DIGIT_9,
        Key.DIGIT_0
    };

    private final List<SampleScene> scenes;
    private final Map<String, SceneOptions> options;
    private final int workers;
    private final int substeps;
    private final PrintStream out;
    private int current;
    private @Nullable SceneBuilder built;
    private boolean inTick;
    private int remarksShown;
    private @Nullable String noWindow;

    /**
     * @param scenes what can be chosen, at least one
     * @param options options by scene id
     * @param workers threads of the physics
     * @param substeps sub-steps of the solver
     * @param out receives the scenes' remarks
     */
    SampleWindow(
            List<SampleScene> scenes,
            Map<String, SceneOptions> options,
            int workers,
            int substeps,
            PrintStream out) {
        this.scenes = scenes;
        this.options = options;
        this.workers = workers;
        this.substeps = substeps;
        this.out = out;
    }

    /** Returns why there was no window, or null if there was one; after {@link #start}. */
    @Nullable String noWindow() {
        return noWindow;
    }

    @Override
    protected void withoutWindow(String reason) {
        noWindow = reason;
    }

    @Override
    protected PhysicsWorld createPhysics() {
        return PhysicsWorld.builder()
                .gravity(0, -SampleScene.GRAVITY, 0)
                .workers(workers)
                .substeps(substeps)
                .build();
    }

    @Override
    protected void initScene(Scene scene) {
        for (int i = 0; i < Math.min(NUMBERS.length, scenes.size()); i++) {
            int index = i;
            scene.bindings().onKey(NUMBERS[i], "scene " + scenes.get(i).id(), () -> show(index));
        }
        scene.bindings()
                .onKey(Key.PAGE_DOWN, "next scene", () -> show(current + 1))
                .onKey(Key.PAGE_UP, "previous scene", () -> show(current - 1))
                .onKey(Key.R, "restart", () -> show(current))
                .onKey(Key.P, "pause", this::togglePause);
        show(0);
    }

    /** Replaces what is in the world by a scene; the index wraps around. */
    private void show(int index) {
        current = Math.floorMod(index, scenes.size());
        Scene screen = scene();
        if (built != null) {
            built.clear();
        }
        SampleScene chosen = scenes.get(current);
        SceneOptions values = options.getOrDefault(chosen.id(), SceneOptions.defaults(chosen));
        SceneBuilder next = chosen.build(new SceneBuilder(screen.physics(), values));
        built = next;
        inTick = false;
        remarksShown = 0;
        next.view().place(screen.camera());
        screen.light(next.light());
        screen.title(
                "Cairn: %s (%d of %d: %s) | 1-9, 0, PageUp/PageDown: scene, R: restart, P: pause"
                        .formatted(chosen.title(), current + 1, scenes.size(), chosen.id()));
    }

    /** Called before each tick: ends the scene's last tick and begins the next. */
    @Override
    protected void update(double seconds) {
        SceneBuilder now = built;
        if (now == null) {
            return;
        }
        if (inTick) {
            now.afterTick();
            for (; remarksShown < now.remarks().size(); remarksShown++) {
                out.println(now.remarks().get(remarksShown));
            }
        }
        now.beforeTick();
        inTick = true;
    }
}
