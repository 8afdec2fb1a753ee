package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.TestAbortedException;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/**
 * The sandbox from end to end: a real window on a virtual X server, keys and mouse through that
 * server, in a process of its own. Every wait is for a condition with a deadline.
 */
class SandboxWindowTest {
    private static final long DEADLINE_SECONDS = 90;

    @TempDir private Path folder;
    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_SECONDS);
    private Process server;
    private Process sandbox;
    private String display;
    private String window;
    private String last = "nothing yet";

    /** One line of {@link SandboxProbe}. */
    private record Seen(Map<String, String> values) {
        static Seen of(String line) {
            Map<String, String> map = new HashMap<>();
            for (String pair : line.split(" ", -1)) {
                int equals = pair.indexOf('=');
                if (equals > 0) {
                    map.put(pair.substring(0, equals), pair.substring(equals + 1));
                }
            }
            return new Seen(map);
        }

        double number(String key) {
            return Double.parseDouble(values.get(key));
        }

        boolean flag(String key) {
            return Boolean.parseBoolean(values.get(key));
        }
    }

    @BeforeEach
    void openWindow() throws IOException, InterruptedException {
        require();
        server =
                new ProcessBuilder(
                                "Xvfb",
                                "-displayfd",
                                "1",
                                "-screen",
                                "0",
                                "1100x700x24",
                                "-nolisten",
                                "tcp")
                        .redirectError(folder.resolve("server.txt").toFile())
                        .start();
        display = ":" + server.inputReader(StandardCharsets.UTF_8).readLine();
        ProcessBuilder builder =
                new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-ea",
                        "--enable-native-access=ALL-UNNAMED",
                        "--sun-misc-unsafe-memory-access=deny",
                        "--add-modules=jdk.incubator.vector",
                        "-cp",
                        System.getProperty("java.class.path"),
                        SandboxProbe.class.getName());
        builder.environment().put("DISPLAY", display);
        builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
        builder.environment().remove("WAYLAND_DISPLAY");
        sandbox = builder.redirectError(folder.resolve("sandbox.txt").toFile()).start();
        BufferedReader reader =
                new BufferedReader(
                        new InputStreamReader(sandbox.getInputStream(), StandardCharsets.UTF_8));
        Thread pump = new Thread(() -> reader.lines().forEach(lines::add), "sandbox-output");
        pump.setDaemon(true);
        pump.start();
        await("a second of the stack falling", seen -> seen.number("tick") >= 60);
        window =
                type("search", "--onlyvisible", "--pid", Long.toString(sandbox.pid()))
                        .lines()
                        .reduce((first, second) -> second)
                        .orElseThrow();
        type("windowfocus", "--sync", window);
    }

    @AfterEach
    void closeWindow() throws InterruptedException {
        for (Process process : new Process[] {sandbox, server}) {
            if (process != null) {
                process.destroy();
                process.waitFor();
            }
        }
    }

    private static void require() {
        String mode = System.getProperty("gl.tests", "auto");
        assumeTrue(!mode.equals("off"), "GL tests are off by -Dgl.tests=off");
        List<String> missing = new ArrayList<>();
        for (String program : new String[] {"Xvfb", "xdotool"}) {
            if (!onPath(program)) {
                missing.add(program);
            }
        }
        if (missing.isEmpty()) {
            return;
        }
        String reason =
                String.join(" and ", missing)
                        + " missing; on Debian or Ubuntu: apt-get install xvfb xdotool libgl1"
                        + " libgl1-mesa-dri";
        if (mode.equals("required")) {
            fail("gl.tests=required, but " + reason);
        }
        System.err.println("NOTICE: the window test is skipped: " + reason);
        throw new TestAbortedException(reason);
    }

    private static boolean onPath(String program) {
        for (String entry : System.getenv().getOrDefault("PATH", "").split(File.pathSeparator)) {
            if (Files.isExecutable(Path.of(entry, program))) {
                return true;
            }
        }
        return false;
    }

    /** Runs xdotool to its end. */
    private String type(String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("xdotool"));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("DISPLAY", display);
        Process process = builder.start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), command + ": " + output);
        return output.strip();
    }

    private void moveTo(double x, double y) throws IOException, InterruptedException {
        type("mousemove", "--window", window, whole(x), whole(y));
    }

    private static String whole(double value) {
        return Long.toString(Math.round(value));
    }

    /** Reads what the window shows, frame by frame, until it is so. */
    private Seen await(String what, Predicate<Seen> condition)
            throws IOException, InterruptedException {
        while (true) {
            String line = lines.poll(200, TimeUnit.MILLISECONDS);
            if (line != null && line.startsWith("frame=")) {
                last = line;
                Seen seen = Seen.of(line);
                if (condition.test(seen)) {
                    return seen;
                }
            }
            if (System.nanoTime() > deadline || (line == null && !sandbox.isAlive())) {
                fail(
                        "waited in vain for "
                                + what
                                + "; the last frame was: "
                                + last
                                + "; the sandbox said: "
                                + Files.readString(folder.resolve("sandbox.txt")));
            }
        }
    }

    /** The newest frame. */
    private Seen now() throws IOException, InterruptedException {
        lines.clear();
        return await("a frame", seen -> true);
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
}
