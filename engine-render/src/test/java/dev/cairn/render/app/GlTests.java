package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.opentest4j.TestAbortedException;

/**
 * Whether tests that draw run: property {@code gl.tests} = auto (skip without EGL, with a notice),
 * required (fail), off.
 */
final class GlTests {
    private GlTests() {}

    static void require() {
        String mode = System.getProperty("gl.tests", "auto");
        assumeTrue(!mode.equals("off"), "GL tests are off by -Dgl.tests=off");
        String reason = Offscreen.unavailableReason();
        if (reason == null) {
            return;
        }
        if (mode.equals("required")) {
            fail("gl.tests=required, but " + reason);
        }
        System.err.println("NOTICE: GL tests are skipped: " + reason);
        throw new TestAbortedException(reason);
    }
}
