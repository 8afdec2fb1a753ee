package dev.cairn.benchmarks.compare;

import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

import org.jspecify.annotations.Nullable;

import java.io.Console;
import java.io.PrintStream;
import java.util.Locale;

/** Shows how far a campaign is: a bar on a terminal, a line now and then elsewhere. */
final class Reporter implements AutoCloseable {
    private static final int BAR_WIDTH = 100;
    private static final double LINE_SECONDS = 10;
    private static final double GUESS_SECONDS = 60;

    private final PrintStream err;
    private final double total;
    private final long start = System.nanoTime();
    private final @Nullable ProgressBar bar;
    private long lastLine = start;
    private double done;

    Reporter(PrintStream err, double totalSeconds) {
        this.err = err;
        this.total = Math.max(1, totalSeconds);
        bar =
                onTerminal()
                        ? new ProgressBarBuilder()
                                .setTaskName("compare")
                                .setInitialMax(Math.round(total))
                                .setStyle(ProgressBarStyle.ASCII)
                                .setConsumer(new ConsoleProgressBarConsumer(err, BAR_WIDTH))
                                .build()
                        : null;
    }

    @SuppressWarnings(
            "SystemConsoleNull") // The JDK promises a console but declares that it may be null.
    private static boolean onTerminal() {
        Console console = System.console();
        return console != null && console.isTerminal();
    }

    /** So many of the estimated seconds are done; this is under way. */
    void done(double seconds, String underWay) {
        done = Math.min(total, done + seconds);
        if (bar != null) {
            bar.stepTo(Math.round(done));
            if (!underWay.isEmpty()) {
                bar.setExtraMessage(underWay);
            }
            return;
        }
        long now = System.nanoTime();
        if ((now - lastLine) / 1e9 > LINE_SECONDS && done > 0 && !underWay.isEmpty()) {
            lastLine = now;
            double spent = (now - start) / 1e9;
            err.printf(
                    Locale.ROOT,
                    "%.0f %%, about %.0f min left, %s%n",
                    100 * done / total,
                    // the guess counts for as much as its first minute, then what was seen
                    Math.ceil(
                            (spent + GUESS_SECONDS) / (done + GUESS_SECONDS) * (total - done) / 60),
                    underWay);
        }
    }

    @Override
    public void close() {
        if (bar != null) {
            bar.close();
        }
    }
}
