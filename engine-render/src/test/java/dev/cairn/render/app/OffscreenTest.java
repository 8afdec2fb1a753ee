package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.concurrent.atomic.AtomicReference;

class OffscreenTest {
    @BeforeAll
    static void gl() {
        GlTests.require();
    }

    @Test
    void opensAgainAndAgainButOneAtATime() {
        for (int i = 0; i < 3; i++) {
            try (Offscreen view = Offscreen.open(40 + i, 30)) {
                assertNull(Offscreen.unavailableReason());
                IllegalStateException e =
                        assertThrows(IllegalStateException.class, () -> Offscreen.open(8, 8));
                assertTrue(e.getMessage().contains("close it"), e.getMessage());
                try (Stage stage = new Stage()) {
                    view.draw(stage.publish(), 0, new Camera(), Light.DAYLIGHT);
                }
                assertEquals(40 + i, view.picture().width());
            }
        }
    }

    @Test
    void badUseIsRefused() throws InterruptedException {
        assertThrows(IllegalArgumentException.class, () -> Offscreen.open(0, 10));
        assertThrows(
                IllegalArgumentException.class, () -> Offscreen.open(10, Offscreen.MAX_SIZE + 1));
        Offscreen view = Offscreen.open(16, 16);
        try (Stage stage = new Stage()) {
            assertThrows(IllegalStateException.class, view::picture);
            assertThrows(
                    IllegalArgumentException.class,
                    () -> view.draw(stage.publish(), 1.5, new Camera(), Light.DAYLIGHT));
            AtomicReference<Throwable> thrown = new AtomicReference<>();
            Thread other =
                    new Thread(() ->
                            thrown.set(
                                    assertThrows(
                                            IllegalStateException.class,
                                            () ->
                                                    view.draw(
                                                            stage.publish(),
                                                            0,
                                                            new Camera(),
                                                            Light.DAYLIGHT))));
            other.start();
            other.join();
            assertTrue(
                    thrown.get().getMessage().contains("belongs to the thread"),
                    () -> "" + thrown.get());
            view.close();
            view.close();
            assertThrows(
                    IllegalStateException.class,
                    () -> view.draw(stage.publish(), 0, new Camera(), Light.DAYLIGHT));
        }
    }
}
