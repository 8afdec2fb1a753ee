package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.app.DebugLayer;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;

/** The sandbox from end to end, by {@link SandboxProbe}. */
class SandboxWindowTest extends WindowFixture {
    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    /** After a second of the stack falling. */
    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 60;
    }

    @Test
    void keysMoveSpacePausesTheMousePullsAndASliderChangesTheScene()
            throws IOException, InterruptedException {
        // W flies along the view, which is downwards and towards -z here.
        Seen before = now();
        type("keydown", "w");
        await(
                "the camera to fly",
                seen ->
                        seen.number("eyeZ") < before.number("eyeZ") - 0.5
                                && seen.number("eyeX") < before.number("eyeX") - 0.2);
        type("keyup", "w");
        type("key", "Home");
        await(
                "the camera to be back",
                seen -> Math.abs(seen.number("eyeZ") - before.number("eyeZ")) < 1e-5);

        // Space stops the physics; frames, and the other systems' ticks, go on.
        type("key", "space");
        await("the pause", seen -> seen.flag("paused"));
        Seen asked = now();
        Seen paused =
                await(
                        "two ticks",
                        seen -> seen.number("worldTick") > asked.number("worldTick") + 2);
        Seen later =
                await(
                        "ten frames of the pause",
                        seen ->
                                seen.number("frame") > paused.number("frame") + 10
                                        && seen.number("worldTick")
                                                > paused.number("worldTick") + 10);
        assertEquals(paused.number("tick"), later.number("tick"));
        type("key", "space");
        await("the physics to go on", seen -> seen.number("tick") > later.number("tick") + 5);

        // The camera looks at the seam between the second box and the third: below it is the
        // second.
        moveTo(512, 340);
        type("mousedown", "1");
        Seen grabbed = await("a body in the hand", seen -> seen.flag("pulling"));
        assertEquals("box_1", grabbed.values().get("held"));
        moveTo(620, 330);
        await(
                "the body to follow the hand",
                seen -> Math.abs(seen.number("heldX") - grabbed.number("heldX")) > 0.4);
        type("mouseup", "1");
        await("the hand to let go", seen -> !seen.flag("pulling"));

        // A click at four fifths of the slider of `gap` (0 to 10 m) starts the scene anew.
        Seen slider = now();
        assertEquals(0.25, slider.number("gap"));
        assertTrue(slider.number("sliderWidth") > 50, last);
        moveTo(
                slider.number("sliderX") + 0.8 * slider.number("sliderWidth"),
                slider.number("sliderY") + 0.5 * slider.number("sliderHeight"));
        type("click", "1");
        Seen changed = await("the new gap", seen -> seen.number("gap") > 6);
        assertTrue(changed.number("gap") < 9.5, last);
        assertTrue(changed.number("tick") < slider.number("tick"), "started anew: " + last);
    }

    @Test
    void ballsFlyTheScreenFillsAndASteadyFrameMakesNoGarbage()
            throws IOException, InterruptedException {
        Seen before = now();
        type("key", "b");
        await("a ball", seen -> seen.number("bodies") == before.number("bodies") + 1);
        type("key", "r");
        await("the ball to be gone", seen -> seen.number("bodies") == before.number("bodies"));

        assertEquals(1024, before.number("uiWidth"));
        type("key", "F11");
        await(
                "the window to fill the screen of 1100 x 700",
                seen -> seen.number("uiWidth") == 1100 && seen.number("uiHeight") == 700);
        type("key", "F11");
        await("the window as it was", seen -> seen.number("uiWidth") == 1024);

        // Plots, the list of scenes, sliders: all is drawn anew in each frame, from what is there.
        click("Plots");
        settle();
        awaitNoGarbage("a scene runs");
        type("key", "F1");
        awaitNoGarbage("the list of keys");
        type("key", "F1");
        assertFalse(now().flag("paused"), last);

        // While nothing changes, panels are drawn from what is in graphics memory.
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        long[] known = {-1, 0};
        await(
                "ten frames in a row whose panels are not made anew",
                seen -> {
                    long changes = (long) seen.number("changes");
                    known[1] = changes == known[0] ? known[1] + 1 : 0;
                    known[0] = changes;
                    return known[1] >= 10;
                });
        // A ball flies where the mouse is, into the sky here; in the pause it has not yet fallen.
        moveTo(420, 90);
        Seen sky = await("nothing beneath the mouse", seen -> seen.number("rayOff") > 0.02);
        type("key", "b");
        await("it on the ray", seen -> seen.number("bodies") == sky.number("bodies") + 1);
        await("it to be seen there", seen -> seen.number("rayOff") < 1e-4);
        look("ball-on-the-ray");
        type("key", "p");
        await("them to be made anew", seen -> seen.number("changes") > known[0] + 10);
    }

    @Test
    void everySectionAndLayerCanBeShownWithoutGarbage() throws IOException, InterruptedException {
        // From below, since what opens moves all that is under it.
        for (String section : new String[] {"Keys", "Window", "Ball (key B)", "Solver", "Draw"}) {
            Seen before = now();
            String key = section.replace(' ', '_') + "Y";
            click(section);
            await(section, seen -> seen.number("frame") > before.number("frame") + 2);
            assertEquals(before.number(key), now().number(key), section + " moved");
        }
        int shown = 0;
        for (DebugLayer layer : DebugLayer.values()) {
            click(layer.title());
            int wanted = ++shown;
            await(layer.title(), seen -> seen.number("layers") == wanted);
        }
        awaitNoGarbage("all layers, all sections but two");
        click("Stages of a tick");
        awaitNoGarbage("stages");
        click("Plots");
        settle();
        awaitNoGarbage("plots");
    }
}
