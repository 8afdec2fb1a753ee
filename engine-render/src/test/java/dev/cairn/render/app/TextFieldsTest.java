package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.ui.nuklear.NuklearInput;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.util.function.Consumer;

/** What is typed and pasted into a field is in it, whatever it is and however fast it comes. */
class TextFieldsTest extends Drawing {
    private NuklearUi ui;
    private String content = "";
    private String clipboard = "";

    @BeforeEach
    void clickIntoTheField() {
        ui = new NuklearUi(1);
        ui.clipboard(() -> clipboard, text -> clipboard = text);
        frame(input -> {});
        frame(input -> {});
        double[] at = ui.boundsOf("field");
        double x = at[0] + at[2] - 8;
        double y = at[1] + at[3] / 2;
        frame(input -> input.moved(x, y));
        frame(input -> input.button(MouseButton.LEFT, x, y, true));
        frame(input -> input.button(MouseButton.LEFT, x, y, false));
        assertTrue(ui.wantsKeys(), "the field is edited");
    }

    @AfterEach
    void closeField() {
        ui.close();
    }

    private void frame(Consumer<NuklearInput> events) {
        ui.input().begin();
        events.accept(ui.input());
        ui.input().end();
        ui.begin(WIDTH, HEIGHT, 0);
        ui.panel("A", 5, 5, 300, 170);
        content = ui.textField("field", content);
        ui.endPanel();
        view.paint(ui);
    }

    /** All that waits is taken: a key a frame, and 15 bytes of letters. */
    private void frames(int count) {
        for (int i = 0; i < count; i++) {
            frame(input -> {});
        }
    }

    private static void type(NuklearInput input, String text) {
        text.codePoints().forEach(input::typed);
    }

    private static void press(NuklearInput input, Key key, boolean control) {
        input.key(key, true, control);
        input.key(key, false, control);
    }

    @Test
    void aSlowFrameLosesNoLetterAndNoneOvertakes() {
        String all = "the quick brown fox jumps over the lazy dog ".repeat(3);
        frame(input -> {
            type(input, all);
            press(input, Key.BACKSPACE, false);
            type(input, "!");
            press(input, Key.HOME, false);
            type(input, ">");
        });
        frames(20);
        assertEquals(">" + all.substring(0, all.length() - 1) + "!", content);
    }

    @Test
    void lettersOfAllAlphabetsAreKeptAndControlCharactersAreNone() {
        String all =
                "Größe 1\u00a0m³, \u05e9\u05dc\u05d5\u05dd, \u0645\u0631\u062d\u0628\u0627,"
                        + " \u202eback\u202c, \ud83d\ude00\ud83d\udc69\u200d\ud83d\ude80";
        frame(input -> type(input, "\u0000\u0007\t\n" + all + "\u001b\u007f"));
        frames(20);
        assertEquals(all, content);
        frame(input -> press(input, Key.BACKSPACE, false));
        frames(2);
        assertEquals(all.substring(0, all.length() - 2), content, "a whole letter, two chars");
    }

    @Test
    void aHeldKeyRepeats() {
        frame(input -> type(input, "abcdef"));
        frame(input -> input.key(Key.BACKSPACE, true, false));
        frame(input -> input.key(Key.BACKSPACE, true, false));
        frame(input -> input.key(Key.BACKSPACE, true, false));
        frame(input -> input.key(Key.BACKSPACE, false, false));
        assertEquals("abc", content);
    }

    /** Letters of two bytes, with one of one byte before them: none ends where a room ends. */
    @Test
    void whatIsTooLongToBeEditedStaysBehindWhatIs() {
        content = "a" + "ü".repeat(20_000);
        frames(2);
        assertEquals(20_001, content.length(), "nothing was typed");
        frame(input -> {
            press(input, Key.HOME, false);
            type(input, "xy");
        });
        frames(5);
        assertEquals("xya" + "ü".repeat(20_000), content);
        frame(input -> press(input, Key.A, true));
        frame(input -> press(input, Key.DELETE, false));
        frames(3);
        String left = content;
        assertTrue(left.length() > 19_000 && left.length() < 20_000, left.length() + " left");
        assertEquals("ü".repeat(left.length()), left, "whole letters");
    }

    @Test
    void cutCopyAndPaste() {
        frame(input -> type(input, "höhe"));
        frame(input -> press(input, Key.A, true));
        frame(input -> press(input, Key.C, true));
        assertEquals("höhe", clipboard);
        frame(input -> press(input, Key.X, true));
        frames(2);
        assertEquals("", content);
        frame(input -> press(input, Key.V, true));
        frame(input -> press(input, Key.V, true));
        frames(2);
        assertEquals("höhehöhe", content);
    }

    @Test
    void whatIsPastedIsOneLineOfText() {
        clipboard = "\n one\ttwo\r\nthree\u0000four " + "x".repeat(100_000);
        frame(input -> press(input, Key.V, true));
        frames(2);
        assertTrue(content.startsWith("one two  three four xxx"), content.substring(0, 40));
        assertTrue(content.chars().noneMatch(Character::isISOControl), "no control character");
        assertFalse(content.length() > 1024, "no more than is edited");
    }

    @Test
    void enterEndsTheFieldAfterWhatWasTypedBefore() {
        frame(input -> {
            type(input, "x".repeat(40));
            ui.endEditing();
        });
        frames(5);
        assertEquals("x".repeat(40), content);
        assertFalse(ui.wantsKeys(), "the field is done");
    }
}
