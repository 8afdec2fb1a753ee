package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.Map;

/** Whatever is done in the window, it goes on, and a scene begins as it does without a window. */
class RandomUserTest extends WindowFixture {
    private static final long SEED = Long.getLong("user.seed", 2);

    @Override
    public Class<?> program() {
        return RandomUserProbe.class;
    }

    @Override
    public Map<String, String> environment() {
        return Map.of("SEED", Long.toString(SEED));
    }

    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public boolean ready(Seen seen) {
        return true;
    }

    private void live(int calms) throws IOException, InterruptedException {
        System.out.println("seed " + SEED);
        Seen seen = await(calms + " calms", calm -> calm.number("calms") >= calms);
        assertTrue(seen.number("threads") < 40, last);
        assertTrue(seen.number("live") < 2000, last);
    }

    @Test
    void whateverIsDoneInTheWindow() throws IOException, InterruptedException {
        live(3);
    }

    @Test
    @Tag("soak")
    void whateverIsDoneForLong() throws IOException, InterruptedException {
        live(Integer.getInteger("soak.calms", 40));
    }
}
