package dev.cairn.benchmarks.compare;

import com.google.gson.Gson;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.MissingEngineException;
import dev.cairn.benchmarks.peer.Peer;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.benchmarks.peer.SceneDescription;

import org.jspecify.annotations.Nullable;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * The main class of an engine's JVM: answers requests from standard input until it ends. What goes
 * wrong in one request is its answer; the JVM lives on.
 */
final class Worker {
    /** Warm-up is over when the medians of so many windows in a row agree. */
    private static final int WINDOWS = 3;

    private static final double AGREEMENT = 0.02;
    private static final double WINDOW_SECONDS = 0.15;

    /** Building may take this many times as long as stepping before a timed run ends. */
    private static final int BUILD_SHARE = 3;

    private final Engine engine;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private long[] nanos = new long[4096];

    Worker(Engine engine) {
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
            out.println(Protocol.MARK + gson.toJson(worker.answer(request)));
        }
        // Native threads of an engine may still run; they must not keep the JVM.
        System.exit(0);
    }

    Protocol.Answer answer(Protocol.Request request) {
        try {
            Case scene = Case.of(request.scene()).with(request.settings());
            return switch (request.kind()) {
                case JUDGE -> judge(scene, request);
                case WARM -> warm(scene, request);
                case TIME -> time(scene, request, request.seconds());
            };
        } catch (MissingEngineException absent) {
            return Protocol.Answer.failed(String.valueOf(absent.getMessage()), true);
        } catch (RuntimeException | Error failure) {
            return Protocol.Answer.failed(failure.toString(), false);
        }
    }

    private Protocol.Answer judge(Case scene, Protocol.Request request) {
        PeerSettings settings = new PeerSettings(request.workers(), request.substeps(), true);
        try (Judge judge = new Judge(scene);
                Peer peer = engine.create(judge.description(), settings)) {
            for (int tick = 1; tick <= scene.ticks(); tick++) {
                peer.step();
                if (!judge.tick(peer)) {
                    return Protocol.Answer.failed("a pose is not a number, tick " + tick, false);
                }
            }
            double error = judge.error();
            return new Protocol.Answer(
                    failure(scene, error),
                    false,
                    finite(error),
                    finite(judge.deepest()),
                    peer.contactPairs(),
                    peer.contactPoints(),
                    judge.description().movable(),
                    scene.ticks(),
                    null,
                    null,
                    null,
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
        Protocol.Answer last = time(scene, request, WINDOW_SECONDS);
        while (agreeing < WINDOWS && System.nanoTime() < end && last.cpuMicros() != null) {
            double now = last.cpuMicros();
            if (agreeing > 0 && now >= high * (1 - AGREEMENT) && now <= low * (1 + AGREEMENT)) {
                low = Math.min(low, now);
                high = Math.max(high, now);
                agreeing++;
            } else {
                low = now;
                high = now;
                agreeing = 1;
            }
            last = time(scene, request, WINDOW_SECONDS);
        }
        return last;
    }

    private Protocol.Answer time(Case scene, Protocol.Request request, double seconds) {
        SceneDescription description;
        try (Judge judge = new Judge(scene)) {
            description = judge.description();
        }
        PeerSettings settings = new PeerSettings(request.workers(), request.substeps(), false);
        long start = System.nanoTime();
        long wanted = (long) (seconds * 1e9);
        Clock clock = new Clock();
        while (clock.wall < wanted && System.nanoTime() - start < BUILD_SHARE * wanted) {
            try (Peer peer = engine.create(description, settings)) {
                run(scene, peer, clock, wanted);
            }
        }
        long[] sorted = Arrays.copyOf(nanos, clock.ticks);
        Arrays.sort(sorted);
        return new Protocol.Answer(
                null,
                false,
                null,
                null,
                Peer.UNKNOWN,
                Peer.UNKNOWN,
                description.movable(),
                clock.ticks,
                (clock.cpu + clock.collector) / 1e3 / clock.ticks / description.movable(),
                percentile(sorted, 0.5) / 1e6,
                percentile(sorted, 0.99) / 1e6,
                List.of());
    }

    private static final class Clock {
        private long wall;
        private long cpu;
        private long collector;
        private int ticks;
    }

    /** Steps once through the scene, or until four times the wanted time has gone. */
    private void run(Case scene, Peer peer, Clock clock, long wanted) {
        peer.step();
        if (nanos.length < clock.ticks + scene.ticks()) {
            nanos = Arrays.copyOf(nanos, 2 * (clock.ticks + scene.ticks()));
        }
        long collectedBefore = collectorNanos();
        long cpuBefore = threads.getCurrentThreadCpuTime();
        long stop = clock.wall + 4 * wanted;
        for (int tick = 1; tick < scene.ticks() && clock.wall < stop; tick++) {
            long before = System.nanoTime();
            peer.step();
            long took = System.nanoTime() - before;
            nanos[clock.ticks++] = took;
            clock.wall += took;
        }
        clock.cpu += threads.getCurrentThreadCpuTime() - cpuBefore;
        clock.collector += collectorNanos() - collectedBefore;
    }

    private static long collectorNanos() {
        long millis = 0;
        for (GarbageCollectorMXBean bean : ManagementFactory.getGarbageCollectorMXBeans()) {
            millis += Math.max(0, bean.getCollectionTime());
        }
        return millis * 1_000_000;
    }

    private static double percentile(long[] sorted, double share) {
        if (sorted.length == 0) {
            return Double.NaN;
        }
        int rank = (int) Math.ceil(share * sorted.length);
        return sorted[Math.clamp(rank - 1, 0, sorted.length - 1)];
    }
}
