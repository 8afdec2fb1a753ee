package dev.cairn.samples.sandbox;

import dev.cairn.physics.BodyRef;
import dev.cairn.render.app.Scene;
import dev.cairn.render.camera.Camera;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;
import dev.cairn.samples.UsageException;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.RunFile;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.io.PrintStream;

/** The scene that the world holds: one of the list, or what is edited. Simulation thread. */
final class BuiltScene {
    private final SceneChoice choice;
    private final EditorStage stage;
    private final PrintStream out;
    private @Nullable SceneBuilder built;
    private @Nullable Looks looks;
    private @Nullable RunFile from;
    private @Nullable SceneView seenFrom;
    private boolean keepsCamera;
    private boolean refits;
    private boolean rides;
    private int remarksShown;
    private String problem = "";

    BuiltScene(SceneChoice choice, EditorStage stage, PrintStream out) {
        this.choice = choice;
        this.stage = stage;
        this.out = out;
    }

    /** What was built; null if it cannot be. */
    @Nullable SceneBuilder now() {
        return built;
    }

    /** Looks that the scene began with; none of one that is edited and rests. */
    @Nullable Looks looks() {
        return looks;
    }

    /** Number of the last tick; -1 without a scene. */
    long tick() {
        return built == null ? -1 : built.tick();
    }

    /** Why the scene cannot be built or edited; empty if it can. */
    String problem() {
        return problem;
    }

    void problem(UsageException misuse) {
        problem = String.valueOf(misuse.getMessage());
    }

    /** Has the first scene begin with a saved moment. */
    void beginAt(@Nullable RunFile file) {
        from = file;
    }

    /**
     * Says how the next start is seen.
     *
     * @param keeps whether from where the user is
     * @param isOther whether then, if the scene wants to be seen from elsewhere than before, yet
     *     from there
     */
    void seen(boolean keeps, boolean isOther) {
        keepsCamera = keeps;
        refits = isOther;
    }

    /** Builds a scene from its beginning. */
    void begin(Scene scene, int substeps) {
        remarksShown = 0;
        build(scene, substeps);
        seen(false, false);
    }

    /** Puts the edited scene as it is now in place of what the world holds. */
    void rebuild(Scene scene, int substeps) {
        SceneBuilder old = built;
        if (old != null) {
            old.clear();
        }
        boolean kept = keepsCamera;
        keepsCamera = true;
        build(scene, substeps);
        keepsCamera = kept;
    }

    private void build(Scene scene, int substeps) {
        SampleScene chosen = choice.scene();
        EditorStage.Shown edited = stage.shown();
        scene.title("Cairn: " + (edited == null ? chosen.title() : edited.scene().name()));
        problem = "";
        built = null;
        try {
            SceneBuilder next = new SceneBuilder(scene.physics(), choice.options());
            if (edited == null) {
                chosen.build(next);
                looks = new Looks(scene.physics());
                built = next;
                putBack(scene, next, substeps);
            } else {
                // Even if the world refuses an entity: what is there must be cleared some day.
                built = next;
                stage.build(edited, next);
                if (edited.playing()) {
                    looks = new Looks(scene.physics());
                    stage.begin(edited, next);
                }
            }
            scene.light(next.light());
            scene.camera().release();
            if (!keepsCamera || (refits && !next.view().equals(seenFrom))) {
                next.view().place(scene.camera());
            }
            seenFrom = next.view();
        } catch (UsageException misuse) {
            problem(misuse);
            out.println(problem);
        } catch (IllegalArgumentException refused) {
            if (edited == null) {
                throw refused;
            }
            problem = String.valueOf(refused.getMessage());
        }
    }

    /** Only the first time; the scene begins as it does after that. */
    private void putBack(Scene scene, SceneBuilder next, int substeps) {
        RunFile file = from;
        from = null;
        if (file != null) {
            file.putBack(scene.physics(), next);
            scene.physics().setSubsteps(substeps);
        }
    }

    /** Places the camera where the scene wants it. */
    void lookFromStart(Scene scene) {
        if (built != null) {
            scene.camera().release();
            built.view().place(scene.camera());
        }
    }

    /**
     * Has the camera follow a body from where it is; on the same body again, turn with it; after
     * that no more.
     *
     * @return what to tell the user; empty if nothing follows
     */
    String follow(Scene scene, long entity) {
        Camera camera = scene.camera();
        BodyRef body = scene.physics().bodyOf(entity);
        boolean again = camera.followed() == entity;
        if (body == null || body.isFixed() || (again && rides)) {
            camera.release();
            return "";
        }
        Vector3d from = camera.position(new Vector3d());
        from.sub(body.position(new Vector3d()));
        camera.follow(entity, from.x, from.y, from.z, !again);
        camera.turning(again);
        rides = again;
        return again
                ? "The camera turns with it; double click again to stop"
                : "The camera follows; double click again to ride on it";
    }

    /** Runs the scene's hooks; false without a scene. */
    boolean beforeTick() {
        if (built == null) {
            return false;
        }
        built.beforeTick();
        return true;
    }

    /** Runs the scene's hooks, and prints what it has to say. */
    void afterTick() {
        SceneBuilder now = built;
        if (now != null) {
            now.afterTick();
            for (; remarksShown < now.remarks().size(); remarksShown++) {
                out.println(now.remarks().get(remarksShown));
            }
        }
    }
}
