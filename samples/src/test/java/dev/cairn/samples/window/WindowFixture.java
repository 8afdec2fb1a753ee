package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import static java.nio.file.StandardCopyOption.REPLACE_EXISTING;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.Main;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.TestAbortedException;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

import javax.imageio.ImageIO;

/**
 * A real window on a virtual X server, keys and mouse through that server, in a process of its own
 * that tells on its standard output what each frame shows. Every wait is for a condition with a
 * deadline.
 */
public abstract class WindowFixture {
    @TempDir public Path folder;
    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private long deadline;
    private Process server;
    private Process sandbox;
    private String display;
    private String window;
    public String last = "nothing yet";

    /**
     * The program that is started: one line of key=value pairs a frame, the frame's number first.
     */
    public abstract Class<?> program();

    /** What the program finds in its environment beside what it inherits. */
    public Map<String, String> environment() {
        return Map.of();
    }

    /**
     * Whether pixels matter. If not, the driver checks what it is told and draws nothing, in half
     * the time.
     */
    public boolean pixels() {
        return true;
    }

    /** When the window is ready for the test. */
    public abstract boolean ready(Seen seen);

    /**
     * What its JVM is given: a window of a test is closed before the optimising compiler is done.
     */
    public List<String> flags() {
        return List.of("-XX:TieredStopAtLevel=1");
    }

    /** What the program is given on its command line. */
    public List<String> arguments() {
        return List.of();
    }

    /** Whether the program tells of its frames, as a probe does. */
    public boolean tellsFrames() {
        return true;
    }

    /** What the program finds when it starts. */
    public void prepare() throws IOException {}

    /** How long the whole test may take, from its beginning. */
    public long deadlineSeconds() {
        return Long.getLong("window.seconds", 240);
    }

    /** One frame. */
    public record Seen(Map<String, String> values) {
        public static Seen of(String line) {
            Map<String, String> map = new HashMap<>();
            for (String pair : line.split(" ", -1)) {
                int equals = pair.indexOf('=');
                if (equals > 0) {
                    map.put(pair.substring(0, equals), pair.substring(equals + 1));
                }
            }
            return new Seen(map);
        }

        public double number(String key) {
            String value = values.get(key);
            if (value == null) {
                throw new AssertionError("nothing of " + key + " is told by " + values);
            }
            return Double.parseDouble(value);
        }

        public boolean is(String key, String value) {
            return value.equals(values.get(key));
        }

        public boolean flag(String key) {
            return Boolean.parseBoolean(values.get(key));
        }
    }

    @BeforeEach
    public void openWindow() throws IOException, InterruptedException {
        deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(deadlineSeconds());
        require();
        prepare();
        server =
                new ProcessBuilder(
                                "Xvfb",
                                "-displayfd",
                                "1",
                                "-screen",
                                "0",
                                "1100x700x24",
                                "-fbdir",
                                folder.toString(),
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
                        "-Dcairn.keys=" + keys(),
                        "-cp",
                        wholeClassPath(),
                        program().getName());
        builder.command().addAll(1, flags());
        builder.command().addAll(arguments());
        builder.directory(folder.toFile());
        builder.environment().put("DISPLAY", display);
        builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
        builder.environment().remove("WAYLAND_DISPLAY");
        // No desktop: a file dialog of whoever runs the tests would wait for its user.
        builder.environment().remove("DBUS_SESSION_BUS_ADDRESS");
        builder.environment().put("XDG_RUNTIME_DIR", folder.toString());
        if (!pixels() && System.getProperty("window.pictures") == null) {
            builder.environment().put("GALLIUM_NOOP", "1");
        }
        builder.environment().putAll(environment());
        sandbox = builder.redirectError(folder.resolve("sandbox.txt").toFile()).start();
        BufferedReader reader =
                new BufferedReader(
                        new InputStreamReader(sandbox.getInputStream(), StandardCharsets.UTF_8));
        Thread pump = new Thread(() -> pump(reader), "sandbox-output");
        pump.setDaemon(true);
        pump.start();
        if (tellsFrames()) {
            await("the window to be ready", this::ready);
        }
        window =
                type("search", "--sync", "--onlyvisible", "--pid", Long.toString(sandbox.pid()))
                        .lines()
                        .reduce((first, second) -> second)
                        .orElseThrow();
        type("windowfocus", "--sync", window);
    }

    /** Where the program keeps the keys of its user. */
    public Path keys() {
        return folder.resolve("keys.txt");
    }

    /** What the window is called. */
    public String title() throws IOException, InterruptedException {
        return type("getwindowname", window);
    }

    /** Waits until the program has ended by itself; its exit code. */
    public int ended() throws InterruptedException {
        if (!sandbox.waitFor(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)) {
            fail("the window is still open; the last frame was: " + last);
        }
        return sandbox.exitValue();
    }

    private void pump(BufferedReader reader) {
        try {
            reader.lines().forEach(lines::add);
        } catch (UncheckedIOException closed) {
            // The end of the test closes the pipe under the reader; await tells of any other end.
            return;
        }
    }

    @AfterEach
    public void closeWindow() throws InterruptedException {
        for (Process process : new Process[] {sandbox, server}) {
            if (process != null) {
                process.destroy();
                process.waitFor();
            }
        }
    }

    /** The class path of this process, for one that runs in another folder. */
    static String wholeClassPath() {
        List<String> whole = new ArrayList<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            whole.add(Path.of(entry).toAbsolutePath().toString());
        }
        return String.join(File.pathSeparator, whole);
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

    /** For a probe's line: where the middle of a widget is, if it was drawn yet. */
    public static String middle(Ui ui, String label) {
        double[] at = ui.boundsOf(label);
        String key = label.replace(' ', '_');
        return at == null
                ? ""
                : String.format(
                        Locale.ROOT,
                        " %sX=%.1f %sY=%.1f",
                        key,
                        at[0] + at[2] / 2,
                        key,
                        at[1] + at[3] / 2);
    }

    /** The newest frame that has a widget; a slow machine's first frames have not all of them. */
    public Seen seeing(String label) throws IOException, InterruptedException {
        lines.clear();
        String key = label.replace(' ', '_') + "X";
        return await(label + " to be drawn", seen -> seen.values().containsKey(key));
    }

    /** Clicks on a widget whose middle the probe tells. */
    public void click(String label) throws IOException, InterruptedException {
        Seen seen = seeing(label);
        String key = label.replace(' ', '_');
        double scale = Double.parseDouble(seen.values().getOrDefault("uiScale", "1"));
        moveTo(seen.number(key + "X") * scale, seen.number(key + "Y") * scale);
        type("click", "1");
    }

    /** Waits until a change of the panels is drawn, so that the places of widgets are right. */
    public void settle() throws IOException, InterruptedException {
        Seen seen = now();
        await("six frames", later -> later.number("frame") > seen.number("frame") + 5);
    }

    /** Keeps a picture of the screen for the eyes of a person, where a folder is named. */
    public void look(String name) throws IOException {
        String pictures = System.getProperty("window.pictures");
        if (pictures != null) {
            ImageIO.write(screen(), "png", Path.of(pictures, name + ".png").toFile());
        }
    }

    /** Keeps a picture that the program wrote in the same way. */
    public void keep(Path picture, String name) throws IOException {
        String pictures = System.getProperty("window.pictures");
        if (pictures != null) {
            Files.copy(picture, Path.of(pictures, name + ".png"), REPLACE_EXISTING);
        }
    }

    /** What the screen shows: the server keeps it in a file, in the format of xwd. */
    public BufferedImage screen() throws IOException {
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(folder.resolve("Xvfb_screen0")));
        int width = file.getInt(4 * 4);
        int height = file.getInt(5 * 4);
        int rowBytes = file.getInt(12 * 4);
        int begin = file.getInt(0) + 12 * file.getInt(19 * 4); // behind header and colour map
        file.order(ByteOrder.LITTLE_ENDIAN);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, file.getInt(begin + y * rowBytes + 4 * x));
            }
        }
        return image;
    }

    /** What a window manager does to the window; there is none on this server. */
    public WindowManager manager() throws IOException {
        return new WindowManager(display, Integer.parseInt(window));
    }

    /** Waits until the window's thread makes no garbage any more; the first frames make some. */
    public void awaitNoGarbage(String what) throws IOException, InterruptedException {
        int[] quiet = new int[1];
        await(
                "ten frames in a row without a byte: " + what,
                seen -> {
                    quiet[0] = seen.number("bytes") == 0 ? quiet[0] + 1 : 0;
                    return quiet[0] >= 10;
                });
    }

    /** Runs xdotool to its end. */
    public String type(String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("xdotool"));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("DISPLAY", display);
        Process process = builder.start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), command + ": " + output);
        return output.strip();
    }

    /** Has the server's keyboard send the letters of a layout, such as "il" or "us". */
    public void keyboard(String layout) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder("setxkbmap", "-display", display, layout).inheritIO().start();
        assertEquals(0, process.waitFor(), "setxkbmap " + layout);
    }

    /** Press, way and release in one call, so fast that one frame may see all of it. */
    public void dragTo(double x, double y) throws IOException, InterruptedException {
        String[] way = {"mousemove", "--window", window, whole(x), whole(y)};
        type("mousedown", "1", way[0], way[1], way[2], way[3], way[4], "mouseup", "1");
    }

    public void moveTo(double x, double y) throws IOException, InterruptedException {
        type("mousemove", "--window", window, whole(x), whole(y));
    }

    private static String whole(double value) {
        return Long.toString(Math.round(value));
    }

    /** Reads what the window shows, frame by frame, until it is so. */
    public Seen await(String what, Predicate<Seen> condition)
            throws IOException, InterruptedException {
        return await(what, "frame=", condition);
    }

    /**
     * Reads until the program tells that ticks pass without a frame. A slow machine's first frame
     * may take as long, so such a line is none of a frame's.
     */
    public Seen awaitSleep(String what) throws IOException, InterruptedException {
        return await(what, "asleep=", seen -> true);
    }

    private Seen await(String what, String begin, Predicate<Seen> condition)
            throws IOException, InterruptedException {
        while (true) {
            String line = lines.poll(200, TimeUnit.MILLISECONDS);
            if (line != null && line.startsWith(begin)) {
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
    public Seen now() throws IOException, InterruptedException {
        lines.clear();
        return await("a frame", seen -> true);
    }

    /** The hand takes what is in the middle of the window, moves it for half a second, lets go. */
    public final void pullTheMiddle() throws IOException, InterruptedException {
        moveTo(512, 340);
        type("mousedown", "1");
        Seen pulling = await("a body in the hand", seen -> seen.flag("pulling"));
        moveTo(560, 300);
        await("pulls", seen -> seen.number("tick") > pulling.number("tick") + 30);
        type("mouseup", "1");
        await("it to be let go", seen -> !seen.flag("pulling"));
    }

    /** What is played from a file, by other workers and lanes, ends in the world that was seen. */
    public static String plays(Path run, Seen end) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
        String[] arguments = {"--replay", run.toString(), "--workers", "2", "--lanes", "4"};
        assertEquals(0, Main.run(arguments, both, both, false), out::toString);
        String told = out.toString(StandardCharsets.UTF_8);
        assertTrue(told.contains(end.values().get("digest")), end + " against " + told);
        return told;
    }
}
