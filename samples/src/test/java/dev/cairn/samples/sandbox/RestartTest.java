package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;

/**
 * No OpenGL object is left behind by a scene, its panels or the editor; by {@link RestartProbe}.
 */
class RestartTest extends WindowFixture {
    /** Frames in which a scene that was there before must be there again, with nothing else. */
    private static final int MOST_FRAMES = 500;

    @Override
    public Class<?> program() {
        return RestartProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("worlds") >= 1;
    }

    @Override
    public long deadlineSeconds() {
        return 900;
    }

    private void restart(int worlds) throws IOException, InterruptedException {
        Seen seen =
                await(
                        worlds + " worlds",
                        frame -> frame.number("worlds") >= worlds || isStuck(frame));
        assertFalse(isStuck(seen), "objects are left over, live against before: " + last);
        assertTrue(seen.number("made") > worlds, "nothing was made: " + last);
    }

    private static boolean isStuck(Seen frame) {
        return frame.number("waited") > MOST_FRAMES;
    }

    @Test
    void restartsOfScenesPanelsAndTheEditorLeakNoObject() throws IOException, InterruptedException {
        restart(60);
    }

    @Test
    @Tag("soak")
    void aThousandOfThemLeakNoObject() throws IOException, InterruptedException {
        restart(1000);
    }
}
