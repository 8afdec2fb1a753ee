package dev.cairn.samples.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.ui.Ui;

import org.junit.jupiter.api.Test;

import java.lang.reflect.Proxy;

/** Numbers while they are typed, letter by letter, without a window. */
class FieldsTest {
    private final Fields fields = new Fields();
    private String text = "";
    private String typed;
    private boolean doubtful;

    /** A field into which is typed what {@link #typed} says. */
    private final Ui ui =
            (Ui)
                    Proxy.newProxyInstance(
                            Ui.class.getClassLoader(),
                            new Class<?>[] {Ui.class},
                            (proxy, method, arguments) -> {
                                assertEquals("textField", method.getName());
                                text = (String) arguments[1];
                                doubtful = (boolean) arguments[2];
                                return typed == null ? text : typed;
                            });

    private double value = 1;

    /** A frame in which the field is made that text; a size that shall be positive. */
    private void type(String now) {
        typed = now;
        double wanted = fields.number(ui, "radius", value);
        value = wanted > 0 ? wanted : value;
        typed = null;
        fields.number(ui, "radius", value);
    }

    @Test
    void aNumberThatIsRefusedOnTheWayCanBeFinished() {
        for (String step : new String[] {"", "0", "0.", "0.2"}) {
            type(step);
            assertEquals(step, text, "what was typed stays");
            assertEquals(step.equals("0.2") ? 0.2 : 1, value);
            assertEquals(!step.equals("0.2"), doubtful, step);
        }
        value = 1; // undone
        type(null);
        assertEquals("1", text, "what is there is shown, not what was typed");
        assertFalse(doubtful);
    }

    @Test
    void whatIsNoNumberChangesNothingAndIsMarked() {
        String[] none = {"NaN", "1e999", "-", "1,2,3", "\u0000", "\u202e1", "\ud83d\ude00", "-5"};
        for (String each : none) {
            type(each);
            assertEquals(1, value, each);
            assertEquals(each, text);
            assertTrue(doubtful, each);
        }
        type("2,5");
        assertEquals(2.5, value);
        assertFalse(doubtful);
        type("9".repeat(1000));
        assertEquals(2.5, value);
        assertEquals("2,5", text, "no number is as long, and no panel shows it");
    }
}
