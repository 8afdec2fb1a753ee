package dev.cairn.samples.sandbox;

import dev.cairn.core.state.StateException;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Map;

/**
 * Writes moments and reports of the present scene when a key asks for them, and its whole run when
 * the window is closed, if that was asked for. Simulation thread, but where it says otherwise.
 */
final class MomentFiles {
    private final Sandbox sandbox;
    private final SceneChoice choice;
    private final EditorStage stage;
    private final BuiltScene built;
    private final TimeTravel time;
    private final PrintStream out;

    /** Where the run goes; window thread. */
    private @Nullable Path recorded;

    private volatile @Nullable String notRecorded;

    MomentFiles(
            Sandbox sandbox,
            SceneChoice choice,
            EditorStage stage,
            BuiltScene built,
            TimeTravel time,
            PrintStream out) {
        this.sandbox = sandbox;
        this.choice = choice;
        this.stage = stage;
        this.built = built;
        this.time = time;
        this.out = out;
    }

    /** Has the run be written when the window is closed; before it opens. */
    void record(Path file) {
        recorded = file.toAbsolutePath().normalize();
        time.keepRuns();
    }

    /** Why the run was not written; null if it was. Any thread. */
    @Nullable String notRecorded() {
        return notRecorded;
    }

    /**
     * Whether there is a run to be written first; then that is begun. Window thread.
     *
     * @param then what to do when it is written
     */
    boolean writesBefore(Runnable then) {
        Path file = recorded;
        if (file == null) {
            return false;
        }
        recorded = null; // once
        sandbox.post(() -> {
            writeRun(file);
            then.run();
        });
        return true;
    }

    private void writeRun(Path file) {
        try {
            MomentWriter writer = writer(file.getParent());
            if (writer == null) {
                throw new IOException("no scene was running when the window was closed");
            }
            out.println(time.writeRun(file, writer, sandbox::createPhysics, sandbox.tickSeconds()));
        } catch (IOException | StateException failure) {
            notRecorded = "--record " + file + ": " + failure.getMessage();
        }
    }

    /** Writes this moment to a file. */
    void saveMoment() {
        MomentWriter writer = writer(null);
        if (writer != null) {
            time.save(writer);
        }
    }

    /** Writes the last seconds to a file that can be played again. */
    void writeReport() {
        MomentWriter writer = writer(null);
        if (writer != null) {
            time.report(writer, sandbox::createPhysics, sandbox.tickSeconds());
        }
    }

    /** For files in a folder, or where the scene is. */
    private @Nullable MomentWriter writer(@Nullable Path target) {
        Looks known = built.looks();
        if (built.now() == null || known == null || stage.rests()) {
            sandbox.notice("Play the scene first: moments and reports are of a scene that runs");
            return null;
        }
        EditorStage.Shown edited = stage.shown();
        if (edited == null) {
            Path folder = Path.of("").toAbsolutePath();
            return sandbox.writer(folder, choice.scene(), "", choice.options(), known);
        }
        SceneFile scene = edited.scene().withState(null); // the file has a state of its own
        Path folder = edited.folder();
        return sandbox.writer(
                folder,
                SceneLoader.sample(scene.name(), scene.name(), folder, scene),
                SceneWriter.text(target == null ? scene : SceneEdit.rebase(scene, folder, target)),
                new SceneOptions(Map.of(), choice.options().seed(), null),
                known);
    }
}
