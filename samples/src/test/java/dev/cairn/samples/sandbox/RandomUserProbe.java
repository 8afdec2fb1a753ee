package dev.cairn.samples.sandbox;

import static org.lwjgl.glfw.GLFW.GLFW_MOD_CONTROL;
import static org.lwjgl.glfw.GLFW.GLFW_MOD_SHIFT;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;
import static org.lwjgl.glfw.GLFW.glfwGetCurrentContext;
import static org.lwjgl.glfw.GLFW.glfwSetCharCallback;
import static org.lwjgl.glfw.GLFW.glfwSetCursorPosCallback;
import static org.lwjgl.glfw.GLFW.glfwSetKeyCallback;
import static org.lwjgl.glfw.GLFW.glfwSetMouseButtonCallback;
import static org.lwjgl.glfw.GLFW.glfwSetScrollCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowFocusCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowSize;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.DebugLayer;
import dev.cairn.render.app.View;
import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.editor.Editor;

import org.joml.Vector3d;
import org.lwjgl.glfw.GLFWCharCallback;
import org.lwjgl.glfw.GLFWCursorPosCallback;
import org.lwjgl.glfw.GLFWKeyCallback;
import org.lwjgl.glfw.GLFWMouseButtonCallback;
import org.lwjgl.glfw.GLFWScrollCallback;
import org.lwjgl.glfw.GLFWWindowFocusCallback;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * The sandbox in the hands of somebody who presses keys and buttons, drags, turns the wheel and
 * resizes at random, through the functions that GLFW calls. From time to time all is let go and the
 * scene restarted: it must go as it does without a window. Tells of each such calm, for {@link
 * RandomUserTest}.
 */
final class RandomUserProbe extends Sandbox {
    private static final List<SampleScene> SCENES =
            List.of(
                    SceneRegistry.get("stack"),
                    SceneRegistry.get("ragdolls"),
                    SceneRegistry.get("car"),
                    SceneRegistry.get("one-way"),
                    SceneRegistry.get("shapes"),
                    SceneRegistry.get("static-100"));
    private static final int FRAMES = 150;
    private static final int CALM_TICKS = 20;
    private static final int WIDTH = 900;
    private static final int HEIGHT = 600;

    /** Of GLFW: the keys that most keyboards have. */
    private static final int[] KEYS = new int[128];

    static {
        int n = 0;
        for (int key = 32; key < 97; key++) {
            KEYS[n++] = key;
        }
        for (int key = 256; key < 302; key++) {
            KEYS[n++] = key;
        }
        while (n < KEYS.length) {
            KEYS[n++] = new int[] {82, 66, 88, 291, 294, 44, 46, 75, 76, 266, 267}[n % 11];
        }
    }

    private final long seed;
    private final SplittableRandom random;
    private final Deque<String> done = new ArrayDeque<>();
    private final Vector3d eye = new Vector3d();
    private int frames;
    private int calms;
    private boolean calming;
    private int waited;
    private long since;
    private volatile long calmDigest;
    private volatile boolean listens;
    private final long[] digests = new long[CALM_TICKS + 1];

    private RandomUserProbe(long seed) {
        super(SCENES, Map.of(), 2, 4, false, System.err);
        this.seed = seed;
        random = new SplittableRandom(seed);
    }

    /** Runs until the window is closed. */
    public static void main(String[] arguments) {
        long seed = Long.parseLong(System.getenv().getOrDefault("SEED", "1"));
        RandomUserProbe probe = new RandomUserProbe(seed);
        try {
            probe.size(WIDTH, HEIGHT).start();
            System.out.println("ended seed=" + seed);
        } catch (RuntimeException | Error failed) {
            System.out.println("failed seed=" + seed + " after " + probe.done);
            failed.printStackTrace(System.out);
            System.exit(3);
        }
    }

    @Override
    protected boolean closing() {
        super.closing(); // asks what is not saved, and must not fail
        return false;
    }

    @Override
    protected void updated(double seconds) {
        super.updated(seconds);
        if (listens && builtTick() <= CALM_TICKS) {
            digests[(int) builtTick()] = physics().digest();
            if (builtTick() == CALM_TICKS) {
                calmDigest = physics().digest();
                listens = false;
            }
        }
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        view.camera().position(eye);
        if (!eye.isFinite() || !Double.isFinite(view.camera().yaw() + view.camera().pitch())) {
            throw new AssertionError("the camera is at " + eye);
        }
        if (calming) {
            calm(state);
        } else if (++frames % FRAMES == 0) {
            beginCalm();
        } else {
            for (int i = random.nextInt(4); i > 0; i--) {
                done.addLast(act());
                if (done.size() > 40) {
                    done.removeFirst();
                }
            }
        }
    }

    // Calm -------------------------------------------------------------------------------------

    private void beginCalm() {
        long window = glfwGetCurrentContext();
        focus(window, false);
        focus(window, true);
        glfwSetWindowSize(window, WIDTH, HEIGHT);
        for (DebugLayer layer : DebugLayer.values()) {
            debug(layer, false);
        }
        fullscreen(false);
        showHelp(false);
        captureTrigger(null);
        timeScale(1);
        editor().close();
        calming = true;
        waited = 0;
        since = System.nanoTime();
    }

    private void calm(SandboxState state) {
        waited++;
        if (editor().mode() != Editor.Mode.CLOSED) { // a key that was pressed before
            editor().close();
            waited = 0;
        }
        if (waited == 8) {
            calmDigest = 0;
            post(() -> { // after what is asked for already
                setPaused(false);
                listens = true;
                startAgain();
            });
        }
        boolean cannotBe = !state.problem.isEmpty();
        if (waited > 8 && (calmDigest != 0 || cannotBe) && state.tick > CALM_TICKS) {
            long found = calmDigest;
            long wanted = cannotBe ? found : alone(state);
            System.out.printf(
                    Locale.ROOT,
                    "frame=%d calms=%d seed=%d scene=%s same=%b live=%d threads=%d%n",
                    frames,
                    ++calms,
                    seed,
                    state.id,
                    found == wanted,
                    GlObjects.live(),
                    Thread.getAllStackTraces().size());
            System.out.flush();
            if (found != wanted) {
                throw new AssertionError(
                        "%s with %s and %d sub-steps began otherwise than alone"
                                .formatted(state.id, state.options, state.substeps));
            }
            calming = false;
        } else if (System.nanoTime() - since > 60_000_000_000L) {
            throw new AssertionError(
                    "no calm: tick %d, paused %b, editor %s, problem %s"
                            .formatted(state.tick, isPaused(), editor().mode(), state.problem));
        }
    }

    /** The scene without a window. */
    private long alone(SandboxState state) {
        SampleScene scene = SCENES.get(state.scene);
        SceneOptions options = state.options;
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .substeps(state.substeps)
                        .sleeping(false)
                        .seed(options.seed())
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            for (int i = 0; i < CALM_TICKS; i++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                if (world.digest() != digests[i + 1]) {
                    System.out.printf("otherwise from tick %d on%n", i + 1);
                    break;
                }
            }
            return world.digest();
        }
    }

    // Acts -------------------------------------------------------------------------------------

    private String act() {
        long window = glfwGetCurrentContext();
        switch (random.nextInt(20)) {
            case 0, 1, 2, 3, 4 -> {
                int key = KEYS[random.nextInt(KEYS.length)];
                int mods =
                        (random.nextInt(6) == 0 ? GLFW_MOD_CONTROL : 0)
                                | (random.nextInt(8) == 0 ? GLFW_MOD_SHIFT : 0);
                boolean up = random.nextInt(3) > 0;
                key(window, key, GLFW_PRESS, mods);
                if (up) {
                    key(window, key, GLFW_RELEASE, mods);
                }
                return "key " + key + " with " + mods + (up ? "" : " held");
            }
            case 5, 6, 7, 8, 9 -> {
                int button = random.nextInt(5) == 0 ? random.nextInt(8) : 0;
                int action = random.nextInt(5) < 3 ? GLFW_PRESS : GLFW_RELEASE;
                button(window, button, action, random.nextInt(8) == 0 ? GLFW_MOD_SHIFT : 0);
                return (action == GLFW_PRESS ? "press " : "release ") + button;
            }
            case 10, 11, 12, 13, 14, 15 -> {
                boolean wild = random.nextInt(8) == 0;
                double x = wild ? random.nextDouble(-9e3, 9e3) : random.nextDouble(0, WIDTH);
                double y = wild ? random.nextDouble(-9e3, 9e3) : random.nextDouble(0, HEIGHT);
                cursor(window, x, y);
                return "to %.0f, %.0f".formatted(x, y);
            }
            case 16 -> {
                double steps = random.nextInt(8) == 0 ? 1e3 : random.nextInt(-5, 6);
                wheel(window, steps);
                return "wheel " + steps;
            }
            case 17 -> {
                int letter =
                        random.nextInt(5) == 0
                                ? random.nextInt(0x10FFFF)
                                : '0' + random.nextInt(10);
                letter(window, letter);
                return "letter " + letter;
            }
            case 18 -> {
                boolean has = random.nextBoolean();
                focus(window, has);
                return "focus " + has;
            }
            default -> {
                int[] sizes = {1, 2, 17, 100, 333, 900, 1400};
                int w = sizes[random.nextInt(sizes.length)];
                int h = sizes[random.nextInt(sizes.length)];
                glfwSetWindowSize(window, w, h);
                return "size " + w + " x " + h;
            }
        }
    }

    // The functions that GLFW calls are lent for a moment: it alone keeps them.

    @SuppressWarnings("resource")
    private static void key(long window, int key, int action, int mods) {
        GLFWKeyCallback known = glfwSetKeyCallback(window, null);
        glfwSetKeyCallback(window, known);
        if (known != null) {
            known.invoke(window, key, 0, action, mods);
        }
    }

    @SuppressWarnings("resource")
    private static void button(long window, int button, int action, int mods) {
        GLFWMouseButtonCallback known = glfwSetMouseButtonCallback(window, null);
        glfwSetMouseButtonCallback(window, known);
        if (known != null) {
            known.invoke(window, button, action, mods);
        }
    }

    @SuppressWarnings("resource")
    private static void cursor(long window, double x, double y) {
        GLFWCursorPosCallback known = glfwSetCursorPosCallback(window, null);
        glfwSetCursorPosCallback(window, known);
        if (known != null) {
            known.invoke(window, x, y);
        }
    }

    @SuppressWarnings("resource")
    private static void wheel(long window, double steps) {
        GLFWScrollCallback known = glfwSetScrollCallback(window, null);
        glfwSetScrollCallback(window, known);
        if (known != null) {
            known.invoke(window, 0, steps);
        }
    }

    @SuppressWarnings("resource")
    private static void letter(long window, int letter) {
        GLFWCharCallback known = glfwSetCharCallback(window, null);
        glfwSetCharCallback(window, known);
        if (known != null) {
            known.invoke(window, letter);
        }
    }

    @SuppressWarnings("resource")
    private static void focus(long window, boolean has) {
        GLFWWindowFocusCallback known = glfwSetWindowFocusCallback(window, null);
        glfwSetWindowFocusCallback(window, known);
        if (known != null) {
            known.invoke(window, has);
        }
    }
}
