package dev.cairn.samples.sandbox;

import dev.cairn.render.app.Scene;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.samples.SampleScene;

import java.util.List;

/** The keys of the sandbox. Stateless; what they do runs on the simulation thread. */
final class SandboxKeys {
    private static final Key[] NUMBERS = {
        Key.DIGIT_1,
        Key.DIGIT_2,
        Key.DIGIT_3,
        Key.DIGIT_4,
        Key.DIGIT_5,
        Key.DIGIT_6,
        Key.DIGIT_7,
        Key.DIGIT_8,
        Key.DIGIT_9,
        Key.DIGIT_0
    };

    private SandboxKeys() {}

    static void bind(
            Bindings bindings,
            Sandbox sandbox,
            TimeTravel time,
            List<SampleScene> scenes,
            Runnable lookFromStart) {
        for (int i = 0; i < Math.min(NUMBERS.length, scenes.size()); i++) {
            int index = i;
            bindings.onKey(NUMBERS[i], "scene " + scenes.get(i).id(), () -> sandbox.show(index));
        }
        bindings.onKey(Key.PAGE_DOWN, "next scene", () -> sandbox.step(1))
                .onKey(Key.PAGE_UP, "previous scene", () -> sandbox.step(-1))
                .onKey(Key.R, "restart", sandbox::startAgain)
                .onKey(Key.B, "throw a ball", () -> sandbox.act(SandboxKeys::throwBall))
                .onKey(Key.X, "explode", () -> sandbox.act(SandboxKeys::explode))
                .onKey(Key.HOME, "look from the start", lookFromStart)
                .onKey(Key.COMMA, "back in time", time::back)
                .onKey(Key.PERIOD, "forth in time", time::forth)
                .onKey(Key.K, "keep moment", time::keepMoment)
                .onKey(Key.L, "to kept moment", time::backToKept)
                .onKey(Key.M, "save moment", sandbox.files()::saveMoment)
                .onKey(Key.F9, "bug report", sandbox.files()::writeReport);
    }

    static void throwBall(Scene scene, Thrower thrower) {
        thrower.throwBall(scene);
    }

    private static void explode(Scene scene, Thrower thrower) {
        thrower.explode(scene);
    }
}
