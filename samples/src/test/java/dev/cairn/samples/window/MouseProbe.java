package dev.cairn.samples.window;

import dev.cairn.physics.Body;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.input.Mouse;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.ui.Ui;

import java.util.Locale;

/**
 * An application that tells what its simulation knows of the mouse, for {@link MouseWindowTest}.
 */
final class MouseProbe extends Application {
    private double right;
    private double down;
    private double ticked;
    private double pressX = -1;
    private double pressY = -1;
    private volatile String seen = "ticks=0";

    private MouseProbe() {}

    /** Runs until the window is closed. */
    public static void main(String[] arguments) {
        new MouseProbe().size(800, 500).start();
    }

    @Override
    protected void initScene(Scene scene) {
        scene.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)));
        Mouse mouse = scene.bindings().mouse();
        mouse.onMove(
                "sum up",
                (dx, dy) -> {
                    right += dx;
                    down += dy;
                });
        scene.bindings()
                .onButton(
                        MouseButton.LEFT,
                        "note",
                        () -> {
                            pressX = mouse.x();
                            pressY = mouse.y();
                        });
    }

    @Override
    protected void update(double seconds) {
        ticked += scene().bindings().mouse().movedRight();
    }

    @Override
    protected void updated(double seconds) {
        Mouse mouse = scene().bindings().mouse();
        seen =
                String.format(
                        Locale.ROOT,
                        "ticks=%d x=%.4f y=%.4f right=%.2f down=%.2f ticked=%.2f pressX=%.4f"
                                + " pressY=%.4f",
                        ticks(),
                        mouse.x(),
                        mouse.y(),
                        right,
                        down,
                        ticked,
                        pressX,
                        pressY);
    }

    @Override
    protected void panels(Ui ui, View view) {
        if (ui.panel("Panel", 0, 0, 150, 100)) {
            ui.label("what is here is the panel's");
        }
        ui.endPanel();
        System.out.printf(Locale.ROOT, "frame=%d %s%n", view.frames(), seen);
        System.out.flush();
    }
}
