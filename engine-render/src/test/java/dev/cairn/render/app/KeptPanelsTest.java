package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.ui.Ui;
import dev.cairn.render.ui.nuklear.NuklearInput;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;

/** Panels that stay as they are drawn look, and answer, as if each frame laid them out. */
class KeptPanelsTest extends Drawing {
    private static final long FRAME_NANOS = 16_666_667;

    /** Panels whose content changes by what the user does only, and how often it was laid out. */
    private static final class Desk implements AutoCloseable {
        private final NuklearUi ui = new NuklearUi(1);
        private final boolean keeps;
        private final float[] curve = {1, 3, 2, 5, 4};
        private String label = "some words";
        private String name = "name";
        private double value = 1;
        private boolean checked;
        private int chosen;
        private int clicks;
        private int layouts;
        private long nanos = 7;

        private Desk(boolean keeps) {
            this.keeps = keeps;
        }

        /** One frame by the given events; what is seen. */
        private int[] frame(PoseSnapshot scene, Consumer<NuklearInput> events) {
            nanos += FRAME_NANOS;
            ui.input().begin();
            events.accept(ui.input());
            ui.input().end();
            ui.begin(WIDTH, HEIGHT, nanos);
            if (keeps) {
                ui.keep();
            }
            if (ui.panel("A", 5, 5, 150, 170)) {
                layouts++;
                ui.label(label);
                name = ui.textField("field", name);
                clicks += ui.button("button") ? 1 : 0;
                checked = ui.checkbox("checked", checked);
                value = ui.slider("slider", value, 0, 2, 0, "a hint");
                chosen = ui.choice("choice", List.of("one", "two"), chosen);
                if (ui.section("section", false)) {
                    ui.plot("plot", "4", curve, 0, curve.length, 0xFFFFFF);
                    ui.endSection();
                }
            }
            ui.endPanel();
            if (ui.panel("B", 170, 5, 120, 80)) {
                ui.item("item", clicks % 2 == 1, "another hint");
                ui.text("clicked " + clicks);
            }
            ui.endPanel();
            ui.cross(250, 120, 0xFFFFFF);
            draw(scene, 1, new Camera(), FLAT);
            view.paint(ui);
            return view.picture().argb();
        }

        @Override
        public void close() {
            ui.close();
        }
    }

    private static final List<String> WIDGETS =
            List.of("button", "checked", "slider", "field", "choice", "section", "item");

    private static final Consumer<NuklearInput> NOTHING = input -> {};

    /** Something of what a user does: as a rule nothing, else all kinds of events. */
    private static Consumer<NuklearInput> any(Random random) {
        double x = random.nextInt(WIDTH);
        double y = random.nextInt(HEIGHT);
        return switch (random.nextInt(12)) {
            case 0, 1 -> input -> input.moved(x, y);
            case 2 -> input -> input.button(MouseButton.LEFT, x, y, true);
            case 3 -> input -> input.button(MouseButton.LEFT, x, y, false);
            case 4 ->
                    input -> {
                        input.moved(x, y);
                        input.button(MouseButton.LEFT, x, y, true);
                        input.button(MouseButton.LEFT, x, y, false);
                        input.moved(y, x);
                    };
            case 5 -> input -> input.scrolled(x > y ? 1 : -1);
            case 6 -> input -> input.key(Key.BACKSPACE, true, false);
            case 7 -> input -> input.key(Key.BACKSPACE, false, false);
            default -> NOTHING;
        };
    }

    /** A click on a widget in three frames, and letters, which a field takes. */
    private static Consumer<NuklearInput> click(double[] at, int frame) {
        double x = at[0] + at[2] - 6;
        double y = at[1] + at[3] / 2;
        return switch (frame) {
            case 0 -> input -> input.moved(x, y);
            case 1 -> input -> input.button(MouseButton.LEFT, x, y, true);
            case 2 -> input -> input.button(MouseButton.LEFT, x, y, false);
            case 3 -> input -> "a long word, ß and more".codePoints().forEach(input::typed);
            default -> NOTHING;
        };
    }

    @Test
    void theyLookInEachFrameAsIfLaidOut() {
        long seed = Long.getLong("seed", 20_261_127);
        System.out.println("seed " + seed);
        Random random = new Random(seed);
        try (Stage stage = new Stage();
                Desk kept = new Desk(true);
                Desk each = new Desk(false)) {
            PoseSnapshot scene = stage.publish();
            int frames = 30 * 2 * WIDGETS.size();
            for (int frame = 0; frame < frames; frame++) {
                double[] at = each.ui.boundsOf(WIDGETS.get(frame / 60));
                int step = frame % 60 - 2;
                Consumer<NuklearInput> events = NOTHING;
                if (at != null && step < 6) {
                    events = click(at, step);
                } else if (step < 28) {
                    events = any(random);
                }
                int[] expected = each.frame(scene, events);
                assertArrayEquals(expected, kept.frame(scene, events), "frame " + frame);
            }
            assertEquals(frames, each.layouts);
            assertTrue(kept.layouts < frames - 80, kept.layouts + " of " + frames + " laid out");
            assertTrue(each.clicks > 0, "the button was hit");
            assertNotEquals(1, each.value, "the slider was moved");
            assertNotEquals("name", each.name, "something was typed");
            assertEquals(each.clicks, kept.clicks);
            assertEquals(each.name, kept.name);
            assertEquals(each.value, kept.value);
        }
    }

    /** Half a second in which nobody does anything. */
    private PoseSnapshot settled(Stage stage, Desk desk) {
        PoseSnapshot scene = stage.publish();
        for (int frame = 0; frame < 30; frame++) {
            desk.frame(scene, NOTHING);
        }
        return scene;
    }

    @Test
    void whatChangesByItselfIsSeenWithinATenthOfASecond() {
        try (Stage stage = new Stage();
                Desk kept = new Desk(true)) {
            PoseSnapshot scene = settled(stage, kept);
            int layouts = kept.layouts;
            long changes = kept.ui.changes();
            int[] before = kept.frame(scene, NOTHING);
            for (int frame = 1; frame < 120; frame++) {
                assertArrayEquals(before, kept.frame(scene, NOTHING));
            }
            assertEquals(20, kept.layouts - layouts, 1, "in two seconds");
            assertEquals(changes, kept.ui.changes(), "nothing was sent to graphics memory");
            kept.label = "other words";
            int frames = 0;
            int[] seen = before;
            for (; Arrays.equals(seen, before); frames++) {
                assertTrue(frames <= 6, "other words after " + frames + " frames");
                seen = kept.frame(scene, NOTHING);
            }
        }
    }

    @Test
    void theMouseElsewhereLeavesThemAndOverThemIsSeenAtOnce() {
        try (Stage stage = new Stage();
                Desk kept = new Desk(true)) {
            PoseSnapshot scene = settled(stage, kept);
            int layouts = kept.layouts;
            int[] before = kept.frame(scene, NOTHING);
            for (int frame = 0; frame < 30; frame++) {
                int x = 200 + frame;
                assertArrayEquals(before, kept.frame(scene, input -> input.moved(x, 150)));
            }
            assertEquals(5, kept.layouts - layouts, 1, "in half a second");
            double[] at = kept.ui.boundsOf("button");
            int[] over = kept.frame(scene, input -> input.moved(at[0] + 4, at[1] + 4));
            assertFalse(Arrays.equals(before, over), "the button shows the mouse");
            assertArrayEquals(before, kept.frame(scene, input -> input.moved(250, 150)), "and not");
        }
    }

    @Test
    void whatIsBegunBeforeTheQuestionIsDrawn() {
        try (Stage stage = new Stage();
                Desk kept = new Desk(true)) {
            PoseSnapshot scene = settled(stage, kept);
            kept.frame(scene, NOTHING);
            Ui ui = kept.ui;
            kept.ui.begin(WIDTH, HEIGHT, kept.nanos + 1);
            assertTrue(ui.panel("A", 5, 5, 150, 170));
            ui.endPanel();
            assertFalse(ui.keep(), "a frame is made as a whole");
            assertTrue(ui.panel("B", 170, 5, 120, 80));
            ui.endPanel();
            view.paint(kept.ui);
            kept.ui.begin(WIDTH, HEIGHT, kept.nanos + 2);
            assertTrue(ui.keep());
            assertFalse(ui.panel("A", 5, 5, 150, 170));
            ui.label("outside of any panel");
            assertFalse(ui.button("nowhere"));
            ui.endPanel();
            view.paint(kept.ui);
            kept.ui.begin(WIDTH + 1, HEIGHT, kept.nanos + 3);
            assertFalse(ui.keep(), "another size");
        }
    }
}
