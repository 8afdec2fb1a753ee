package dev.cairn.samples.sandbox;

import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenes.ObjDrop;
import dev.cairn.samples.scenes.Pairs;
import dev.cairn.samples.scenes.Shapes;
import dev.cairn.samples.scenes.stack.StackOfBoxes;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The sandbox with all its panels, going through its scenes and in and out of the editor by itself,
 * for {@link RestartTest}. Each time the window shows again what it has shown before, it must hold
 * as many OpenGL objects as it did then; the program waits at a step until it does.
 */
final class RestartProbe extends Sandbox {
    /** Frames after which everything of a new scene is in graphics memory. */
    private static final int SETTLED = 12;

    private static final int STEPS = 8;
    private static final List<SampleScene> SCENES =
            List.of(StackOfBoxes.scene(), Pairs.scene(), ObjDrop.scene(), Shapes.scene());

    private final AtomicInteger worlds = new AtomicInteger();
    private final Map<Integer, Long> liveAt = new HashMap<>();
    private int step;
    private int wantedWorlds = 1;
    private int frames;

    private RestartProbe() {
        super(SCENES, Map.of(), 1, 4, false, System.err);
    }

    /** Runs until the window is closed. */
    public static void main(String[] arguments) {
        new RestartProbe().size(320, 200).start();
    }

    @Override
    protected void initScene(Scene scene) {
        super.initScene(scene);
        worlds.incrementAndGet();
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        long live = GlObjects.live();
        int place = step % (STEPS * SCENES.size());
        Long before = liveAt.get(place);
        boolean there = worlds.get() >= wantedWorlds && ++frames >= (before == null ? SETTLED : 3);
        System.out.printf(
                "frame=%d worlds=%d step=%d place=%d live=%d before=%d mode=%s made=%d"
                        + " waited=%d%n",
                view.frames(),
                worlds.get(),
                step,
                place,
                live,
                before == null ? -1 : before,
                editor().mode(),
                GlObjects.made(GlObjects.Kind.BUFFER),
                frames);
        System.out.flush();
        if (!there || (before != null && before != live)) {
            return;
        }
        liveAt.put(place, live);
        step++;
        frames = 0;
        goOn(editor(), step % STEPS);
    }

    private void goOn(Editor editor, int next) {
        switch (next) {
            case 0 -> anew(() -> post(() -> show(step / STEPS)));
            case 1 -> anew(() -> post(this::startAgain));
            case 2 -> anew(editor::open);
            case 3 -> editor.place(EntitySpec.of("ball", BodyKind.DYNAMIC, new SphereShape(0.4)));
            case 4 -> editor.undo();
            case 5 -> anew(editor::play);
            case 6 -> anew(editor::stop);
            default -> anew(editor::close);
        }
    }

    /** Does what makes a new world. */
    private void anew(Runnable action) {
        wantedWorlds++;
        action.run();
    }
}
