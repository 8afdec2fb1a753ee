package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import java.io.IOException;

/** Place and moves of the mouse reach the simulation thread, from a real window. */
class MouseWindowTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return MouseProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("ticks") >= 2;
    }

    /** The window has 800 x 500 points, and its upper left is a panel. */
    @Test
    void placeAndMovesReachTheSimulation() throws IOException, InterruptedException {
        moveTo(200, 250);
        Seen from = awaitPlace(0.25, 0.5);
        moveTo(600, 375);
        Seen to = awaitPlace(0.75, 0.75);
        assertEquals(400, to.number("right") - from.number("right"), 0.02, last);
        assertEquals(125, to.number("down") - from.number("down"), 0.02, last);
        // what update sums up tick by tick is what the function was told
        await("ticks", seen -> Math.abs(seen.number("ticked") - seen.number("right")) < 0.02);

        type("click", "1");
        Seen pressed = await("the press", seen -> seen.number("pressX") >= 0);
        assertEquals(0.75, pressed.number("pressX"), 2e-3, last);
        assertEquals(0.75, pressed.number("pressY"), 2e-3, last);

        moveTo(50, 60); // over the panel, which it enters within one move
        settle();
        moveTo(60, 70);
        settle();
        Seen over = now();
        moveTo(80, 75);
        settle();
        Seen still = now();
        assertEquals(over.number("right"), still.number("right"), 0, last);
        moveTo(400, 250);
        awaitPlace(0.5, 0.5);
    }

    private Seen awaitPlace(double x, double y) throws IOException, InterruptedException {
        return await(
                "the mouse at " + x + ", " + y,
                seen ->
                        Math.abs(seen.number("x") - x) < 2e-3
                                && Math.abs(seen.number("y") - y) < 2e-3);
    }
}
