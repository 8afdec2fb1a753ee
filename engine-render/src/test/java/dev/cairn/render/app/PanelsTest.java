package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/** Panels are where they were asked for, at any scale; letters stand upright. */
class PanelsTest extends Drawing {
    private static Picture panels(NuklearUi ui, Consumer<Ui> content) {
        try (Stage stage = new Stage()) {
            // Twice: Nuklear lays out a new panel in its first frame.
            for (int frame = 0; frame < 2; frame++) {
                ui.input().begin();
                ui.input().end();
                ui.begin(WIDTH, HEIGHT, 0);
                content.accept(ui);
                draw(stage.publish(), 1, new Camera(), FLAT);
                view.paint(ui);
            }
        }
        return view.picture();
    }

    private static int[] boundsOfChange(Picture picture) {
        int[] box = {WIDTH, HEIGHT, -1, -1};
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (Blocks.difference(SKY, picture.at(x, y)) > 2) {
                    box[0] = Math.min(box[0], x);
                    box[1] = Math.min(box[1], y);
                    box[2] = Math.max(box[2], x);
                    box[3] = Math.max(box[3], y);
                }
            }
        }
        return box;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 2})
    void aPanelCoversTheRectangleThatItWasGiven(double scale) {
        try (NuklearUi ui = new NuklearUi(scale)) {
            Picture picture =
                    panels(
                            ui,
                            to -> {
                                to.panel("A", 12, 8, 128, 72);
                                to.columns(2);
                                to.button("left");
                                to.button("right");
                                to.endPanel();
                            });
            assertEquals(WIDTH / scale, ui.width());
            int[] box = boundsOfChange(picture);
            double[] wanted = {12 * scale, 8 * scale, 140 * scale - 1, 80 * scale - 1};
            for (int i = 0; i < 4; i++) {
                assertEquals(wanted[i], box[i], 1.01, "side " + i);
            }
            // Glass of 0xEC over the sky, in the colours of the screen.
            int expected = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                int over = 0x181C23 >> shift & 255;
                expected |=
                        (int)
                                        Math.round(
                                                (0xEC * over + (255 - 0xEC) * (SKY >> shift & 255))
                                                        / 255.0)
                                << shift;
            }
            int inside = picture.at((int) (70 * scale), (int) (70 * scale));
            assertTrue(
                    Blocks.difference(expected, inside) <= 2,
                    "inside %06x, expected %06x".formatted(inside & 0xFFFFFF, expected));
            double[] left = ui.boundsOf("left");
            double[] right = ui.boundsOf("right");
            assertNotNull(left);
            assertNotNull(right);
            assertTrue(left[0] > 12 && left[0] + left[2] <= right[0], "beside each other");
            assertTrue(right[0] + right[2] < 140 && right[1] == left[1]);
            // A button is a rectangle of its own colour: its lower corner, where no letter is.
            int face =
                    picture.at(
                            (int) ((right[0] + right[2] - 6) * scale),
                            (int) ((right[1] + right[3] - 3) * scale));
            assertTrue(Blocks.difference(0x34506B, face) <= 8, "face %06x".formatted(face));
        }
    }

    @Test
    void theCrossHasFourStrokesAtEachScale() {
        for (double scale : new double[] {1, 1.5, 2}) {
            try (NuklearUi ui = new NuklearUi(scale)) {
                double x = WIDTH / 2 / scale;
                double y = HEIGHT / 2 / scale;
                Picture picture = panels(ui, to -> to.cross(x, y, 0xFFFFFF));
                int arm = (int) (5 * scale);
                for (int[] way : new int[][] {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    int there = picture.at(WIDTH / 2 + way[0] * arm, HEIGHT / 2 + way[1] * arm);
                    assertTrue((there & 255) > 180, "%06x at scale %s".formatted(there, scale));
                }
            }
        }
    }

    @Test
    void whatDoesNotFitEndsInDotsAndIsCounted() {
        try (NuklearUi ui = new NuklearUi(1.5)) {
            Consumer<Ui> fits = to -> text(to, "some words");
            panels(ui, fits);
            panels(ui, fits);
            assertEquals(0, ui.shortened());
            Consumer<Ui> wide = to -> text(to, "some words that are far too many for the panel");
            panels(ui, wide);
            panels(ui, wide);
            assertEquals(2, ui.shortened());
        }
    }

    private static void text(Ui to, String words) {
        to.panel("A", 5, 5, 150, 100);
        to.label(words);
        to.button(words);
        to.endPanel();
    }

    /** Roboto has the alphabets of Europe; what it has not is a question mark for each letter. */
    @Test
    void lettersOfEuropeAreDrawnAndOthersAreQuestionMarks() {
        try (NuklearUi ui = new NuklearUi(1)) {
            int[] unknown = panels(ui, to -> text(to, "????")).argb();
            for (String word : new String[] {"žluť", "мост", "ґЁђЯ", "Άρης", "łőțı", "–“…€"}) {
                int[] seen = panels(ui, to -> text(to, word)).argb();
                assertFalse(Arrays.equals(unknown, seen), word);
                int[] half = panels(ui, to -> text(to, word.substring(0, 2) + "??")).argb();
                assertFalse(Arrays.equals(half, seen), "the end of " + word);
            }
            for (String word : new String[] {"שלום", "場面です", "🎲🎲🎲🎲"}) {
                assertArrayEquals(unknown, panels(ui, to -> text(to, word)).argb(), word);
            }
        }
    }

    @Test
    void lettersStandUpright() {
        try (NuklearUi ui = new NuklearUi(2)) {
            Picture picture =
                    panels(
                            ui,
                            to -> {
                                to.panel(" ", 5, 5, 140, 80);
                                to.label("L", 0xFFFFFF);
                                to.endPanel();
                            });
            int[] rows = new int[HEIGHT];
            int[] columns = new int[WIDTH];
            for (int y = 80; y < 160; y++) {
                for (int x = 14; x < 200; x++) {
                    if ((picture.at(x, y) & 255) > 150) {
                        rows[y]++;
                        columns[x]++;
                    }
                }
            }
            int top = first(rows, 1);
            int bottom = last(rows, 1);
            int left = first(columns, 1);
            int right = last(columns, 1);
            int high = bottom - top + 1;
            int wide = right - left + 1;
            assertTrue(high >= 18 && high <= 26, "height of a letter of 30 pixels: " + high);
            assertTrue(wide >= 8 && wide < high, "width " + wide);
            // An L: a stem on the left, a foot below, nothing in the upper right.
            assertTrue(columns[left + 1] >= high - 2, "stem " + columns[left + 1] + " of " + high);
            assertTrue(rows[bottom] >= wide - 2, "foot " + rows[bottom] + " of " + wide);
            assertTrue(rows[top + high / 2] <= 5, "middle " + rows[top + high / 2]);
        }
    }

    private static int first(int[] counts, int least) {
        int i = 0;
        while (i < counts.length - 1 && counts[i] < least) {
            i++;
        }
        return i;
    }

    private static int last(int[] counts, int least) {
        int i = counts.length - 1;
        while (i > 0 && counts[i] < least) {
            i--;
        }
        return i;
    }

    /** A frame may be so slow that the cursor is elsewhere when it sees the click. */
    @Test
    void aClickActsWhereItWasMade() {
        try (NuklearUi ui = new NuklearUi(1)) {
            double[] value = {1, 1};
            Consumer<Ui> sliders =
                    to -> {
                        to.panel("A", 5, 5, 300, 170);
                        value[0] = to.slider("upper", value[0], 0, 2, 0, "");
                        value[1] = to.slider("lower", value[1], 0, 2, 0, "");
                        to.endPanel();
                    };
            panels(ui, sliders);
            double[] upper = ui.boundsOf("upper");
            double[] lower = ui.boundsOf("lower");
            double y = upper[1] + upper[3] / 2;
            double right = upper[0] + upper[2];
            ui.input().begin();
            ui.input().moved(right, y);
            ui.input().button(MouseButton.LEFT, right, y, true);
            ui.input().button(MouseButton.LEFT, right, y, false);
            ui.input().moved(lower[0], lower[1] + lower[3] / 2);
            ui.input().end();
            ui.begin(WIDTH, HEIGHT, 0);
            sliders.accept(ui);
            view.paint(ui);
            panels(ui, sliders);
            assertArrayEquals(new double[] {2, 1}, value);
        }
    }

    @Test
    void panelsMadeAnewLeakNoObject() {
        long before = GlObjects.live();
        long made = GlObjects.made(GlObjects.Kind.BUFFER);
        for (int i = 0; i < 20; i++) {
            try (NuklearUi ui = new NuklearUi(1 + 0.05 * i)) {
                panels(
                        ui,
                        to -> {
                            to.panel("A", 12, 8, 128, 72);
                            to.endPanel();
                        });
            }
            assertEquals(before, GlObjects.live(), "objects after panels " + i);
        }
        assertTrue(GlObjects.made(GlObjects.Kind.BUFFER) >= made + 40, "nothing was made");
    }

    @Test
    void whatPanelsDrawLeavesTheSceneAsItWas() {
        Camera camera = new Camera().lookAt(2, 2, 5, 0, 0, 0);
        try (Stage stage = new Stage();
                NuklearUi ui = new NuklearUi(1)) {
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.CUBE));
            int[] before = draw(stage.publish(), 1, camera, SUNNY).argb();
            panels(
                    ui,
                    to -> {
                        to.panel("A", 12, 8, 128, 72);
                        to.endPanel();
                    });
            assertArrayEquals(before, draw(stage.publish(), 1, camera, SUNNY).argb());
        }
    }

    /** Triangles are made and sent for what differs from the frame before, and for nothing else. */
    @Test
    void aFrameLikeTheOneBeforeIsNotMadeAnew() {
        try (Stage stage = new Stage();
                NuklearUi ui = new NuklearUi(1)) {
            var snapshot = stage.publish();
            String[] texts = {"one", "one", "one", "two", "two", "one"};
            long[] changes = new long[texts.length];
            int[][] seen = new int[texts.length][];
            for (int i = 0; i < texts.length; i++) {
                for (int frame = 0; frame < 3; frame++) { // a new panel takes two to settle
                    ui.input().begin();
                    ui.input().end();
                    ui.begin(WIDTH, HEIGHT, 0);
                    ui.panel("A", 10, 10, 120, 60);
                    ui.label(texts[i]);
                    ui.endPanel();
                    ui.panel("B", 150, 10, 120, 60);
                    ui.button("below");
                    ui.endPanel();
                    draw(snapshot, 1, new Camera(), FLAT);
                    view.paint(ui);
                }
                changes[i] = ui.changes();
                seen[i] = view.picture().argb();
            }
            long first = changes[0];
            assertTrue(first >= 1 && first <= 3, Arrays.toString(changes));
            assertArrayEquals(
                    new long[] {first, first, first, first + 1, first + 1, first + 2}, changes);
            assertArrayEquals(seen[0], seen[1]);
            assertArrayEquals(seen[0], seen[5]);
            assertFalse(Arrays.equals(seen[0], seen[3]), "the other text is seen");
        }
    }

    /** What lies over what is no command of its own, and still a change. */
    @Test
    void thePanelThatIsClickedComesToTheFront() {
        try (Stage stage = new Stage();
                NuklearUi ui = new NuklearUi(1)) {
            var snapshot = stage.publish();
            int[] atCorner = new int[2];
            for (int i = 0; i < 2; i++) {
                for (int frame = 0; frame < 6; frame++) {
                    ui.input().begin();
                    if (i == 1 && frame < 2) {
                        ui.input().button(MouseButton.LEFT, 20, 20, frame == 0);
                    }
                    ui.input().moved(300, 150); // away, so that nothing is lit
                    ui.input().end();
                    ui.begin(WIDTH, HEIGHT, 0);
                    ui.panel("A", 10, 10, 120, 60);
                    ui.endPanel();
                    ui.panel("B", 100, 40, 120, 60);
                    ui.endPanel();
                    draw(snapshot, 1, new Camera(), FLAT);
                    view.paint(ui);
                }
                // the title of B, where A hides it once A is in front
                atCorner[i] = view.picture().at(110, 50);
            }
            assertTrue(Blocks.difference(atCorner[0], atCorner[1]) > 2, "A is in front now");
        }
    }

    /** Every kind of widget, with numbers that change; after the JIT has seen it. */
    @Test
    void aSteadyFrameOfPanelsMakesNoGarbage() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        TextBuffer text = new TextBuffer();
        float[] curve = new float[100];
        List<String> options = List.of("one", "two");
        Camera camera = new Camera();
        int quiet = 0;
        long last = 0;
        try (Stage stage = new Stage();
                NuklearUi ui = new NuklearUi(1)) {
            var snapshot = stage.publish();
            for (int frame = 0; frame < 4000 && quiet < 20; frame++) {
                curve[frame % 100] = frame;
                long before = threads.getCurrentThreadAllocatedBytes();
                ui.input().begin();
                ui.input().end();
                ui.begin(WIDTH, HEIGHT, 0);
                ui.panel("All widgets", 5, 5, 300, 170);
                ui.label("label");
                ui.value("value, µs", text.clear().put(frame * 0.37, 2));
                ui.heading("heading");
                ui.text("some text that is as long as to be wrapped once or twice");
                ui.columns(2);
                ui.button("button");
                ui.checkbox("box", frame % 2 == 0);
                ui.slider("slider", 1, 0, 2, 0, "hint");
                ui.choice("choice", options, frame / 50 % 2);
                ui.item("item", true, "");
                if (ui.section("section", true)) {
                    ui.plot("plot", text.clear().putDigits(frame, 4), curve, 0, 100, 0xFF8000);
                    ui.endSection();
                }
                ui.textField("field", "text");
                ui.endPanel();
                ui.cross(200, 100, 0xFFFFFF);
                view.draw(snapshot, 1, camera, FLAT);
                view.paint(ui);
                last = threads.getCurrentThreadAllocatedBytes() - before;
                quiet = last == 0 ? quiet + 1 : 0;
            }
        }
        assertEquals(20, quiet, "frames in a row without a byte; the last made " + last);
    }
}
