package dev.cairn.render.app;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Trigger;
import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * A program with a window onto a world. Extend it, fill the scene, start it:
 *
 * <pre>{@code
 * public final class MyDemo extends Application {
 *     @Override protected void initScene(Scene scene) {
 *         scene.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0), Model.ground(Box.ofHalfExtents(50, 1, 50)));
 *         BodyRef ball = scene.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 4, 0));
 *         scene.bindings().onKey(Key.J, "jump", () -> ball.applyImpulse(0, 2000, 0));
 *     }
 *     public static void main(String[] args) { new MyDemo().start(); }
 * }
 * }</pre>
 *
 * <p>Keys from the start, all of which can be rebound: W A S D fly, E and Q rise and sink, Shift is
 * faster, the arrow keys or the mouse with its right button held turn the view, Tab keeps the mouse
 * turning it; P or Space pauses the physics, N does one step, [ and ] slow down and speed up, \
 * returns to real time; F12 saves a picture, F11 fills the screen, F1 lists the keys, Escape quits.
 *
 * <p>Where there is no display, {@link #start} says so and draws a picture. The properties {@code
 * cairn.picture}, {@code cairn.tick} and {@code cairn.size} do what {@link #headless} and {@link
 * #size} do.
 *
 * <p>{@code start} and {@code panels} run on the main thread, what else is called on the
 * simulation's.
 */
public abstract class Application {
    private static final long DEFAULT_TICK = 120;

    private final Camera camera = new Camera();
    private final Bindings bindings = new Bindings();
    private int width = 1280;
    private int height = 720;
    private double stepSeconds = 1.0 / 60.0;
    private @Nullable Path picture;
    private long pictureTick = DEFAULT_TICK;
    private boolean started;
    private volatile @Nullable Scene scene;
    private volatile @Nullable Simulation simulation;
    private final WindowWishes wishes = new WindowWishes();

    /** An application with a window of 1280 x 720 and 60 ticks a second. */
    protected Application() {}

    /**
     * Makes the world that the scene is filled into; called on the simulation thread before each
     * {@link #initScene}. Override to choose gravity, workers, settings or systems.
     *
     * @return a new world; the application closes it
     */
    protected PhysicsWorld createPhysics() {
        return PhysicsWorld.builder().build();
    }

    /**
     * Fills the scene; called on the simulation thread, once, and again after each {@link
     * #restart}.
     *
     * @param newScene an empty scene with the default bindings
     */
    protected abstract void initScene(Scene newScene);

    /**
     * Called before each tick, on the simulation thread; not while the physics is paused, since
     * forces would add up.
     *
     * @param seconds the step, s
     */
    protected void update(double seconds) {}

    /**
     * Called after each tick, on the simulation thread, with the world at its new state and before
     * it is handed to the window; not while the physics is paused.
     *
     * @param seconds the step, s
     */
    protected void updated(double seconds) {}

    /**
     * Draws panels over the picture; called in each frame. Window thread: read the view's snapshot
     * and whatever the application itself hands over, and act on the world by {@link #post} only.
     *
     * @param ui what panels are made of
     * @param view what the frame shows
     */
    protected void panels(Ui ui, View view) {}

    /**
     * Runs an action on the simulation thread before its next tick, also during a pause. Any
     * thread.
     *
     * @param action what to do
     */
    public final void post(Runnable action) {
        running().post(action);
    }

    /**
     * Throws the world away and makes it anew by {@link #createPhysics} and {@link #initScene},
     * between two ticks. Tick numbers begin again, so a scene goes through the same states each
     * time. Any thread.
     */
    public final void restart() {
        running().restart();
    }

    /**
     * Shows or hides a layer of debug drawing. Any thread.
     *
     * @param layer which
     * @param shown whether it is drawn
     */
    public final void debug(DebugLayer layer, boolean shown) {
        running().debug(layer.bit(), shown);
    }

    /**
     * Whether a layer of debug drawing is shown. Any thread.
     *
     * @param layer which
     * @return true while it is drawn
     */
    public final boolean isDebug(DebugLayer layer) {
        return (debugMask() & layer.bit()) != 0;
    }

    /**
     * Fills the screen, or goes back to a window. Any thread.
     *
     * @param value true to fill the screen
     */
    public final void fullscreen(boolean value) {
        wishes.fullscreen = value;
    }

    /**
     * Whether the window fills the screen, or is about to. Any thread.
     *
     * @return true if so
     */
    public final boolean isFullscreen() {
        return wishes.fullscreen;
    }

    /**
     * Waits for the screen with each frame, or draws as fast as it goes. Any thread.
     *
     * @param value true (the default) to wait
     */
    public final void vsync(boolean value) {
        wishes.vsync = value;
    }

    /**
     * Whether frames wait for the screen. Any thread.
     *
     * @return true if so
     */
    public final boolean isVsync() {
        return wishes.vsync;
    }

    /**
     * How fast the scene runs, as people say it.
     *
     * @return such as "1x", "4x" or "1/4x"
     */
    public final String speedText() {
        return Speeds.text(timeScale());
    }

    /**
     * Chooses what is drawn beyond the plain picture. Without a choice it is {@link Effects#ALL} on
     * a graphics processor and in pictures, {@link Effects#PLAIN} in the window of a software
     * rasteriser. Any thread.
     *
     * @param value the effects
     */
    public final void effects(Effects value) {
        wishes.effects = Objects.requireNonNull(value, "value");
    }

    /**
     * What is drawn beyond the plain picture. Any thread.
     *
     * @return the effects
     */
    public final Effects effects() {
        return Objects.requireNonNullElse(wishes.effects, Effects.ALL);
    }

    /**
     * Enlarges panels and lines on top of what the screen's density asks for. Any thread.
     *
     * @param factor 0.5..4; 1 by default, or the system property {@code cairn.ui.scale}
     */
    public final void panelScale(double factor) {
        if (!(factor >= 0.5 && factor <= 4)) {
            throw new IllegalArgumentException("panel scale is " + factor + ", expected 0.5..4");
        }
        wishes.panelScale = factor;
    }

    /**
     * By how much panels are enlarged. Any thread.
     *
     * @return the factor
     */
    public final double panelScale() {
        return wishes.panelScale;
    }

    /**
     * Shows or hides the list of keys. Any thread.
     *
     * @param value true to show it
     */
    public final void showHelp(boolean value) {
        wishes.helpShown = value;
    }

    /**
     * Whether the list of keys is shown. Any thread.
     *
     * @return true while it is
     */
    public final boolean isHelpShown() {
        return wishes.helpShown;
    }

    /**
     * The scene.
     *
     * @return the scene
     * @throws IllegalStateException before {@link #initScene}
     */
    protected final Scene scene() {
        Scene made = scene;
        if (made == null) {
            throw new IllegalStateException(
                    "there is no scene yet; it is made when start() calls initScene");
        }
        return made;
    }

    /**
     * Size of the window or of the picture; before {@link #start}.
     *
     * @param newWidth pixels, 16..8192
     * @param newHeight pixels, 16..8192
     * @return this
     */
    public final Application size(int newWidth, int newHeight) {
        int least = Math.min(newWidth, newHeight);
        int most = Math.max(newWidth, newHeight);
        if (least < 16 || most > Offscreen.MAX_SIZE) {
            throw new IllegalArgumentException(
                    "size is %d x %d, expected 16..%d each"
                            .formatted(newWidth, newHeight, Offscreen.MAX_SIZE));
        }
        width = newWidth;
        height = newHeight;
        return this;
    }

    /**
     * Length of a tick; before {@link #start}.
     *
     * @param seconds &gt; 0; 1/60 by default
     * @return this
     */
    public final Application step(double seconds) {
        if (!(seconds > 0) || Double.isInfinite(seconds)) {
            throw new IllegalArgumentException("step is " + seconds + " s, expected > 0");
        }
        stepSeconds = seconds;
        return this;
    }

    /**
     * Makes {@link #start} draw a picture instead of opening a window; before {@link #start}.
     *
     * @param file where the .png goes
     * @param atTick after how many ticks, &ge; 0
     * @return this
     */
    public final Application headless(Path file, long atTick) {
        if (atTick < 0) {
            throw new IllegalArgumentException("atTick is " + atTick + ", expected >= 0");
        }
        picture = Objects.requireNonNull(file, "file");
        pictureTick = atTick;
        return this;
    }

    /**
     * Runs until the window is closed or the picture is drawn. Main thread; once.
     *
     * @throws IllegalStateException if it was started before, or a picture was asked for and cannot
     *     be drawn here
     * @throws RuntimeException what {@code initScene}, {@code update}, a bound function or the
     *     world threw; the window is closed then
     */
    public final void start() {
        if (started) {
            throw new IllegalStateException("this application was started before; make a new one");
        }
        started = true;
        StartProperties.read(this);
        DefaultKeys.bind(this);
        Launch launch = new Launch(this, width, height);
        Path asked = picture;
        if (asked != null) {
            launch.picture(asked, true);
            return;
        }
        String reason = launch.window();
        if (reason != null) {
            withoutWindow(reason);
        }
    }

    /**
     * What {@link #start} does where no window can be opened: it says so and draws one picture.
     * Override to do something else; main thread, before {@link #initScene}.
     *
     * @param reason why there is no window, a few words
     */
    protected void withoutWindow(String reason) {
        System.err.println(
                "No window can be opened here: " + reason + ". Drawing a picture instead.");
        new Launch(this, width, height)
                .picture(Path.of(getClass().getSimpleName() + ".png"), false);
    }

    /** What {@link #running} is from now on; not started. */
    Simulation newSimulation(long ticks) {
        Simulation made = new Simulation(new ApplicationHost(this), stepSeconds, ticks);
        simulation = made;
        return made;
    }

    void scene(Scene value) {
        scene = value;
    }

    long pictureTick() {
        return pictureTick;
    }

    void pictureTick(long value) {
        pictureTick = value;
    }

    /**
     * Puts away what lies over the picture, such as a question or a dialog. Called on the window's
     * thread when the user presses the key of "quit" (Escape) and the list of keys is not shown.
     *
     * @return true if there was something; else the window is asked to close
     */
    protected boolean dismiss() {
        return false;
    }

    /**
     * Whether the window may be closed, by its button or by the key of "quit". Called on the
     * window's thread; override to ask about what is not saved. {@link #quit} asks nobody.
     *
     * @return true to close it
     */
    protected boolean closing() {
        return true;
    }

    /**
     * Takes the next key, mouse button but the left one, key with Ctrl, or step of the wheel over
     * no panel, in place of what it is bound to: for "press a key" in a dialog. Any thread.
     *
     * @param taker called once on the window's thread; gets null if Escape was pressed; null in its
     *     place ends the wait
     */
    public final void captureTrigger(@Nullable Consumer<@Nullable Trigger> taker) {
        wishes.capture(taker);
    }

    /**
     * Shows a line at the lower edge of the window for some seconds. Any thread.
     *
     * @param text one line
     */
    public final void notice(String text) {
        wishes.notice(Objects.requireNonNull(text, "text"));
    }

    /** Ends the application after the present frame, without asking; any thread. */
    public final void quit() {
        wishes.quitting = true;
    }

    /** Pauses the physics, or resumes it; drawing, camera and bindings go on. Any thread. */
    public final void togglePause() {
        setPaused(!isPaused());
    }

    /**
     * Pauses the physics, or resumes it. Other systems of the world run on. Any thread.
     *
     * @param value true to pause
     */
    public final void setPaused(boolean value) {
        running().setPaused(value);
    }

    /**
     * Whether the physics is paused. Any thread.
     *
     * @return true while it is
     */
    public final boolean isPaused() {
        return running().isPaused();
    }

    /** Pauses, and does one step of the physics. Any thread. */
    public final void singleStep() {
        running().singleStep();
    }

    /**
     * Slow or fast motion: simulated seconds per real second. The steps stay as they are. Any
     * thread.
     *
     * @param value 0..64
     */
    public final void timeScale(double value) {
        running().setTimeScale(value);
    }

    /**
     * Simulated seconds per real second. Any thread.
     *
     * @return the scale, 1 = real time
     */
    public final double timeScale() {
        return running().timeScale();
    }

    /**
     * How many ticks were done since the scene was made. Any thread.
     *
     * @return the count, paused ones included
     */
    public final long ticks() {
        return running().ticks();
    }

    private Simulation running() {
        Simulation known = simulation;
        if (known == null) {
            throw new IllegalStateException(
                    "the application does not run yet; call this from initScene or later");
        }
        return known;
    }

    int debugMask() {
        return running().debugMask();
    }

    WindowWishes wishes() {
        return wishes;
    }

    @Nullable Scene sceneOrNull() {
        return scene;
    }

    Camera camera() {
        return camera;
    }

    Bindings bindings() {
        return bindings;
    }
}
