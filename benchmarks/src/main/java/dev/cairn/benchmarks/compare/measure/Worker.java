package dev.cairn.benchmarks.compare.measure;

import com.google.gson.Gson;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.MissingEngineException;
import dev.cairn.benchmarks.peer.Peer;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.SceneDescription;
import dev.cairn.samples.SceneBuilder;

import org.jspecify.annotations.Nullable;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * The main class of an engine's JVM: answers requests from standard input until it ends. What goes
 * wrong in one request is its answer; the JVM lives on.
 */
public final class Worker {
    /** Warm-up is over when the medians of so many windows in a row agree. */
    private static final int WINDOWS = 3;

    private static final double AGREEMENT = 0.02;
    private static final double WINDOW_SECONDS = 0.15;

    /** Windows in which the JIT compilers took more than this share of the time do not count. */
    private static final double COMPILING = 0.02;

    /** Building may take this many times as long as stepping before a timed run ends. */
    private static final int BUILD_SHARE = 3;

    private final Engine engine;
    private final CpuClock cpu = new CpuClock();
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private long[] nanos = new long[4096];

    public Worker(Engine engine) {
        this.engine = engine;
    }

    /**
     * Serves one engine.
     *
     * @param args the engine's id
     * @throws IOException if standard input breaks
     */
    public static void main(String[] args) throws IOException {
        Gson gson = new Gson();
        Worker worker = new Worker(Engine.of(args[0]));
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        BufferedReader in =
                new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            Protocol.Request request = gson.fromJson(line, Protocol.Request.class);
            out.println(Protocol.MARK + line(gson, worker.answer(request)));
        }
        // Native threads of an engine may still run; they must not keep the JVM.
        System.exit(0);
    }

    /** An answer that JSON cannot hold is our mistake, not the engine's end. */
    public static String line(Gson gson, Protocol.Answer answer) {
        try {
            return gson.toJson(answer);
        } catch (IllegalArgumentException notFinite) {
            return gson.toJson(
                    Protocol.Answer.failed("the measurement gave no number: " + answer, false));
        }
    }

    public Protocol.Answer answer(Protocol.Request request) {
        try {
            Case scene = Case.of(request.scene()).with(request.settings());
            return switch (request.kind()) {
                case JUDGE -> judge(scene, request);
                case WARM -> warm(scene, request);
                case TIME -> time(scene, request, request.seconds(), Long.MAX_VALUE);
                case COLD -> cold(scene, request);
            };
        } catch (MissingEngineException absent) {
            return Protocol.Answer.failed(String.valueOf(absent.getMessage()), true);
        } catch (IllegalArgumentException cannot) {
            // An adapter's word on what its engine has not got.
            return Protocol.Answer.failed(String.valueOf(cannot.getMessage()), false);
        } catch (RuntimeException | Error failure) {
            return Protocol.Answer.failed(failure.toString(), false);
        }
    }

    private Protocol.Answer judge(Case scene, Protocol.Request request) {
        PeerSettings set = request.peer();
        PeerSettings counting =
                new PeerSettings(
                        set.workers(),
                        set.substeps(),
                        true,
                        set.tuning(),
                        set.iterationFactor(),
                        set.collisionsPerTick());
        try (Judge judge = new Judge(scene);
                Peer peer = engine.create(judge.description(), counting)) {
            String failure = null;
            long stepped = 0;
            int tick = 0;
            while (tick < scene.ticks() && failure == null) {
                tick++;
                Judge.turnGravity(judge.built(), peer, tick);
                // One worker: the engine steps on this thread, whatever else the machine does.
                long before = threads.getCurrentThreadCpuTime();
                peer.step();
                stepped += threads.getCurrentThreadCpuTime() - before;
                if (!judge.tick(peer)) {
                    failure = "a pose is not a number, tick " + tick;
                } else if (stepped > request.seconds() * 1e9 && tick < scene.ticks()) {
                    String stop =
                            "stopped after %.0f s at tick %d of %d"
                                    .formatted(stepped / 1e9, tick, scene.ticks());
                    // What has fallen is slow because it fell: more sub-steps may hold it.
                    String fell = failure(scene, judge.error());
                    failure = fell == null ? "too slow: " + stop : fell + "; " + stop;
                }
            }
            int bodies = judge.description().movable();
            double error = judge.error();
            return new Protocol.Answer(
                    failure == null ? failure(scene, error) : failure,
                    false,
                    finite(error),
                    judge.errors(),
                    finite(judge.deepest()),
                    peer.contactPairs(),
                    peer.contactPoints(),
                    bodies,
                    tick,
                    stepped / 1e3 / tick / bodies,
                    null,
                    null,
                    -1,
                    List.of(),
                    peer.notes());
        }
    }

    private static @Nullable String failure(Case scene, double error) {
        if (Double.isNaN(error)) {
            return "left the reach of the closed form";
        }
        return error > scene.failure()
                ? "error %.3g is above the limit of %.3g".formatted(error, scene.failure())
                : null;
    }

    private static @Nullable Double finite(double value) {
        return Double.isFinite(value) ? value : null;
    }

    private Protocol.Answer warm(Case scene, Protocol.Request request) {
        long end = System.nanoTime() + (long) (request.seconds() * 1e9);
        double low = 0;
        double high = 0;
        int agreeing = 0;
        Protocol.Answer last = window(scene, request);
        while (agreeing < WINDOWS && System.nanoTime() < end && last.cpuMicros() != null) {
            double now = last.cpuMicros();
            if (last.compilerShare() > COMPILING) {
                agreeing = 0; // steady, perhaps, but not for long
            } else if (agreeing > 0
                    && now >= high * (1 - AGREEMENT)
                    && now <= low * (1 + AGREEMENT)) {
                low = Math.min(low, now);
                high = Math.max(high, now);
                agreeing++;
            } else {
                low = now;
                high = now;
                agreeing = 1;
            }
            last = window(scene, request);
        }
        return last;
    }

    private Protocol.Answer window(Case scene, Protocol.Request request) {
        return time(scene, request, WINDOW_SECONDS, (long) (4e9 * WINDOW_SECONDS));
    }

    /** Steps through the scene, again and again; the last time to its end, or to a limit. */
    private Protocol.Answer time(
            Case scene, Protocol.Request request, double seconds, long mostNanos) {
        long start = System.nanoTime();
        long wanted = (long) (seconds * 1e9);
        Clock clock = new Clock();
        try (Judge judge = new Judge(scene)) {
            SceneDescription description = judge.description();
            do { // once at least, however long building takes
                try (Peer peer = engine.create(description, request.peer())) {
                    run(scene, judge.built(), peer, clock, mostNanos);
                }
            } while (clock.wall < wanted && System.nanoTime() - start < BUILD_SHARE * wanted);
            long[] sorted = Arrays.copyOf(nanos, clock.ticks);
            Arrays.sort(sorted);
            int bodies = description.movable();
            return Protocol.Answer.timed(
                    bodies,
                    clock.ticks,
                    clock.cpu / 1e3 / clock.ticks / bodies,
                    percentile(sorted, 0.5) / 1e6,
                    percentile(sorted, 0.99) / 1e6,
                    clock.compilers < 0 ? -1 : clock.compilers / (double) clock.cpu);
        }
    }

    private static final class Clock {
        private long wall;
        private long cpu;
        private long compilers;
        private int ticks;
    }

    /** Steps once through the scene, or until the clock has reached a limit. */
    private void run(Case scene, SceneBuilder built, Peer peer, Clock clock, long mostNanos) {
        peer.step();
        if (nanos.length < clock.ticks + scene.ticks()) {
            nanos = Arrays.copyOf(nanos, 2 * (clock.ticks + scene.ticks()));
        }
        cpu.start();
        for (int tick = 2; tick <= scene.ticks() && clock.wall < mostNanos; tick++) {
            Judge.turnGravity(built, peer, tick);
            long before = System.nanoTime();
            peer.step();
            long took = System.nanoTime() - before;
            nanos[clock.ticks++] = took;
            clock.wall += took;
        }
        clock.cpu += cpu.stop();
        clock.compilers = cpu.compilerNanos() < 0 ? -1 : clock.compilers + cpu.compilerNanos();
    }

    /** Steps from the start of the JVM on, over and over through the scene; once at least. */
    private Protocol.Answer cold(Case scene, Protocol.Request request) {
        // The JVM's own start, on the clock of nanoTime.
        long started =
                System.nanoTime()
                        - 1_000_000
                                * (System.currentTimeMillis()
                                        - ManagementFactory.getRuntimeMXBean().getStartTime());
        ColdStart cold = new ColdStart(scene.ticks());
        long end = started + (long) (request.seconds() * 1e9);
        try (Judge judge = new Judge(scene)) {
            long begun = cpu.processNanos();
            boolean goesOn = true;
            while (goesOn) {
                try (Peer peer = engine.create(judge.description(), request.peer())) {
                    for (int tick = 1; tick <= scene.ticks() && goesOn; tick++) {
                        long before = System.nanoTime();
                        peer.step();
                        long now = System.nanoTime();
                        cold.add(
                                (now - started) / 1e6,
                                (now - before) / 1e6,
                                () -> (cpu.processNanos() - begun) / 1e9);
                        goesOn = now < end;
                    }
                }
            }
            return new Protocol.Answer(
                    null,
                    false,
                    null,
                    cold.figures(),
                    null,
                    -1,
                    -1,
                    judge.description().movable(),
                    cold.count(),
                    null,
                    null,
                    null,
                    -1,
                    cold.thinned(),
                    List.of());
        }
    }

    private static double percentile(long[] sorted, double share) {
        if (sorted.length == 0) {
            return Double.NaN;
        }
        int rank = (int) Math.ceil(share * sorted.length);
        return sorted[Math.clamp(rank - 1, 0, sorted.length - 1)];
    }
}
