package dev.cairn.benchmarks.compare.measure;

import com.google.gson.Gson;

import dev.cairn.benchmarks.peer.Engine;

import org.jspecify.annotations.Nullable;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * An engine's JVM. A crash, or silence beyond the time allowed, is the answer to the request that
 * met it; the next request starts a new JVM, unless two have died. One thread.
 */
public final class EngineProcess implements AutoCloseable {
    /** What every engine's JVM is started with. */
    public static final List<String> FLAGS =
            List.of(
                    "-Xms512m",
                    "-Xmx1g",
                    "-XX:+UseSerialGC",
                    "-XX:-UseDynamicNumberOfCompilerThreads",
                    "-XX:-CreateCoredumpOnCrash",
                    "--add-modules=jdk.incubator.vector",
                    "--enable-native-access=ALL-UNNAMED",
                    "--sun-misc-unsafe-memory-access=allow");

    private static final int MAX_DEATHS = 2;
    private static final int MOMENT_MILLIS = 300;

    /** What runs now; ended with this JVM. */
    private static final Set<Process> RUNNING = ConcurrentHashMap.newKeySet();

    private static volatile boolean ending;

    static {
        Runtime.getRuntime()
                .addShutdownHook(
                        new Thread(() -> {
                            ending = true;
                            RUNNING.forEach(Process::destroyForcibly);
                        }));
    }

    private final Engine engine;
    private final Path logs;
    private final List<String> extraFlags;
    private final Gson gson = new Gson();
    private @Nullable Process process;
    private @Nullable BufferedReader answers;
    private @Nullable BufferedWriter requests;
    private int deaths;
    private String lastDeath = "";

    public EngineProcess(Engine engine, Path logs, List<String> extraFlags) {
        this.engine = engine;
        this.logs = logs;
        this.extraFlags = List.copyOf(extraFlags);
    }

    /** How often its JVM has crashed or been silent. */
    public int deaths() {
        return deaths;
    }

    /** Answers all that is still asked with a failure. */
    public void giveUp(String why) {
        deaths = MAX_DEATHS;
        lastDeath = why;
    }

    public Protocol.Answer ask(Protocol.Request request, double limitSeconds) {
        if (deaths >= MAX_DEATHS) {
            return Protocol.Answer.failed("not tried again: " + lastDeath, false);
        }
        try {
            if (process == null) {
                start();
            }
            BufferedWriter to = requests;
            BufferedReader from = answers;
            if (to == null || from == null) {
                throw new IOException("no streams");
            }
            to.write(gson.toJson(request));
            to.newLine();
            to.flush();
            String line = read(from, limitSeconds);
            if (line != null) {
                return gson.fromJson(line, Protocol.Answer.class);
            }
        } catch (IOException broken) {
            return died(request, "its JVM cannot be reached: " + broken.getMessage());
        } catch (TimeoutException late) {
            return died(request, "no answer within %.0f s".formatted(limitSeconds));
        }
        return died(request, "its JVM ended");
    }

    private Protocol.Answer died(Protocol.Request request, String what) {
        deaths++;
        String how = what;
        Process dead = process;
        if (dead != null) {
            try {
                // A JVM that has crashed needs a moment until it has a status.
                if (dead.waitFor(5, TimeUnit.SECONDS)) {
                    how += " with status " + dead.exitValue();
                }
                // Ctrl-C ends the engines' JVMs with this one: that is no failure of theirs.
                Thread.sleep(MOMENT_MILLIS);
                if (ending) {
                    Thread.sleep(Long.MAX_VALUE);
                }
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
            }
        }
        close();
        lastDeath =
                "%s (scene %s, %d sub-steps, %s; see %s)"
                        .formatted(
                                how,
                                request.scene(),
                                request.peer().substeps(),
                                request.kind(),
                                logFile().getFileName());
        return Protocol.Answer.failed(lastDeath, false);
    }

    private Path logFile() {
        return logs.resolve("engine-" + engine.id() + ".log");
    }

    private void start() throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(FLAGS);
        command.add("-XX:ErrorFile=" + logs.resolve("crash-" + engine.id() + "-%p.log"));
        command.addAll(extraFlags);
        System.getProperties()
                .stringPropertyNames()
                .forEach(key -> {
                    if (key.startsWith("cairn.natives.")) {
                        command.add("-D" + key + "=" + System.getProperty(key));
                    }
                });
        command.add("-cp");
        command.add(System.getProperty("java.class.path"));
        command.add(Worker.class.getName());
        command.add(engine.id());
        Files.createDirectories(logs);
        Process started =
                new ProcessBuilder(command)
                        .redirectError(ProcessBuilder.Redirect.appendTo(logFile().toFile()))
                        .start();
        process = started;
        RUNNING.add(started);
        answers =
                new BufferedReader(
                        new InputStreamReader(started.getInputStream(), StandardCharsets.UTF_8));
        requests =
                new BufferedWriter(
                        new OutputStreamWriter(started.getOutputStream(), StandardCharsets.UTF_8));
    }

    /** Returns the text of the next answer, null at the end of the stream. */
    private static @Nullable String read(BufferedReader from, double limitSeconds)
            throws IOException, TimeoutException {
        CompletableFuture<@Nullable String> reading =
                CompletableFuture.supplyAsync(() -> {
                    try {
                        String line = from.readLine();
                        while (line != null && !line.startsWith(Protocol.MARK)) {
                            line = from.readLine();
                        }
                        return line == null ? null : line.substring(Protocol.MARK.length());
                    } catch (IOException broken) {
                        return null;
                    }
                });
        try {
            return reading.get((long) (limitSeconds * 1000), TimeUnit.MILLISECONDS);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", stop);
        } catch (ExecutionException failure) {
            throw new IOException(failure);
        }
    }

    /** Ends the engine's JVM, for tests of what happens then. */
    public void kill() {
        Process running = process;
        if (running != null) {
            running.destroyForcibly();
        }
    }

    @Override
    public void close() {
        Process running = process;
        if (running != null) {
            running.destroyForcibly();
            RUNNING.remove(running);
        }
        process = null;
        answers = null;
        requests = null;
    }
}
