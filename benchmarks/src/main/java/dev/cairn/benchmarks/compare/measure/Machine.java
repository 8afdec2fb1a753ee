package dev.cairn.benchmarks.compare.measure;

import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Scanner;
import java.util.stream.Stream;

/** Describes what a report was measured on, as far as the system tells. */
public final class Machine {
    /** Which word of the first line of /proc/stat is the stolen time (proc(5)). */
    private static final int STEAL_FIELD = 8;

    private final double loadBefore = load();
    private final long stolenBefore = stolenTicks();
    private final long startNanos = System.nanoTime();

    /** Returns names and values; to be called at the end of the measurements. */
    public Map<String, String> describe() {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("processor", processor());
        facts.put(
                "cores seen by the JVM",
                Integer.toString(Runtime.getRuntime().availableProcessors()));
        facts.put("system", System.getProperty("os.name") + " " + System.getProperty("os.version"));
        facts.put("JVM", System.getProperty("java.vm.name") + " " + Runtime.version());
        facts.put("build of Cairn (its class path)", build());
        facts.put("engines' JVM flags", String.join(" ", EngineProcess.FLAGS));
        if (loadBefore >= 0) {
            facts.put(
                    "load average before",
                    String.format(
                            Locale.ROOT,
                            "%.2f%s",
                            loadBefore,
                            loadBefore > 0.3
                                    ? " (the machine was not quiet: times are noisy)"
                                    : ""));
        }
        if (stolenBefore >= 0) {
            double seconds = (System.nanoTime() - startNanos) / 1e9;
            facts.put(
                    "CPU time stolen by the host",
                    String.format(
                            Locale.ROOT,
                            "%.1f s in %.0f s",
                            (stolenTicks() - stolenBefore) / 100.0,
                            seconds));
        }
        return facts;
    }

    private static double load() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }

    /**
     * Returns what tells one build from another: size and newest time of the files on the class
     * path, of one jar or of folders of classes.
     */
    public static String build() {
        long bytes = 0;
        FileTime newest = FileTime.fromMillis(0);
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
            try (Stream<Path> files = Files.walk(Path.of(entry))) {
                for (Path file : (Iterable<Path>) files::iterator) {
                    if (Files.isRegularFile(file)) {
                        bytes += Files.size(file);
                        FileTime time = Files.getLastModifiedTime(file);
                        newest = time.compareTo(newest) > 0 ? time : newest;
                    }
                }
            } catch (IOException | RuntimeException unreadable) {
                bytes++; // what is on the path but not there tells nothing of the build
            }
        }
        return bytes + " bytes of " + newest;
    }

    public static String processor() {
        try {
            for (String line : Files.readAllLines(Path.of("/proc/cpuinfo"))) {
                if (line.startsWith("model name")) {
                    return line.substring(line.indexOf(':') + 1).trim();
                }
            }
        } catch (IOException unreadable) {
            // not Linux
        }
        return System.getProperty("os.arch", "unknown");
    }

    /** Returns hundredths of seconds since boot, or -1 where the system does not tell. */
    private static long stolenTicks() {
        try {
            Scanner fields = new Scanner(Files.readAllLines(Path.of("/proc/stat")).getFirst());
            for (int skipped = 0; skipped < STEAL_FIELD; skipped++) {
                fields.next();
            }
            return fields.nextLong();
        } catch (IOException | RuntimeException unreadable) {
            return -1;
        }
    }
}
