package dev.cairn.samples;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.render.app.Offscreen;
import dev.cairn.samples.film.ContactSheet;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.sandbox.Sandbox;
import dev.cairn.samples.scenefile.SceneExport;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneWriter;

import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Does what a {@link Request} asks for. Main thread. */
final class Runner {
    /** Where the pictures of a run of all scenes go. */
    static final Path GALLERY = Path.of("pictures");

    private static final int BAR_WIDTH = 100;

    private final Request request;
    private final @Nullable RunFile from;
    private final PrintStream out;
    private final PrintStream err;
    private final boolean display;
    private @Nullable Path record;

    /** Begins with a saved moment, if there is one. */
    Runner(
            Request request,
            @Nullable RunFile from,
            PrintStream out,
            PrintStream err,
            boolean display) {
        this.request = request;
        this.from = from;
        this.out = out;
        this.err = err;
        this.display = display;
    }

    /** Has the run in the window be written to a file. */
    Runner record(Path file) {
        record = file;
        return this;
    }

    /** Returns the exit code. */
    int run() {
        return switch (request.mode()) {
            case LIST -> list();
            case EXPORT -> export();
            case HEADLESS -> headless();
            case WINDOW -> {
                if (!display) {
                    throw new UsageException(
                            "--window: there is no display; set DISPLAY, or leave --window out to"
                                    + " run without one");
                }
                yield window();
            }
            case EITHER -> display ? window() : headless();
        };
    }

    private int list() {
        String group = "";
        for (SampleScene scene :
                request.scenes().stream()
                        .sorted(Comparator.comparing(SampleScene::group))
                        .toList()) {
            if (!scene.group().equals(group)) {
                group = scene.group();
                out.println(group);
            }
            out.printf("  %-11s %s%n", scene.id(), scene.description());
            for (Parameter parameter : scene.parameters()) {
                out.printf(
                        "    %-12s %s; default %s, %s to %s%n",
                        parameter.name(),
                        parameter.meaning(),
                        Parameter.show(parameter.defaultValue()),
                        Parameter.show(parameter.min()),
                        Parameter.show(parameter.max()));
            }
        }
        return Main.DONE;
    }

    private int export() {
        Path file = request.export();
        SampleScene scene = request.scenes().get(0);
        if (file == null) {
            throw new IllegalStateException("no file to export to");
        }
        Path folder = file.toAbsolutePath().getParent();
        SceneWriter.write(
                SceneExport.of(
                        scene,
                        request.options().getOrDefault(scene.id(), SceneOptions.defaults(scene)),
                        request.substeps(),
                        folder == null ? file : folder),
                file);
        out.println("Scene " + scene.id() + " is in " + file.toAbsolutePath());
        return Main.DONE;
    }

    private int window() {
        Sandbox window =
                Sandbox.of(
                        request.sceneFile() == null ? SceneRegistry.all() : request.scenes(),
                        request.options(),
                        request.workers(),
                        request.substeps(),
                        request.sleepingOr(true),
                        out);
        // Nothing was chosen: begin with a spectacle.
        boolean any =
                request.scenes().equals(SceneRegistry.all())
                        || request.scenes().equals(SceneRegistry.report());
        window.beginWith(any ? SceneRegistry.get("junkyard") : request.scenes().get(0));
        window.step(request.stepSeconds());
        window.settings(
                PhysicsSettings.DEFAULT
                        .with(Tunable.DIRECT_FROM, request.directFrom())
                        .withLanes(request.lanes())
                        .withPrecision(request.precision()));
        window.beginAt(from);
        if (record != null) {
            window.record(record);
        }
        Path file = request.sceneFile();
        SceneFile described = request.described();
        if (file != null && described != null && from == null) {
            window.edit(file, described);
        }
        try {
            window.start();
        } catch (UsageException misuse) {
            throw misuse;
        } catch (RuntimeException | LinkageError failure) {
            return failed("the window", failure);
        }
        String reason = window.noWindow();
        if (reason == null) {
            String lost = window.notRecorded();
            if (lost != null) {
                err.println(lost);
            }
            return lost == null ? Main.DONE : Main.FAILED;
        }
        if (request.mode() == Request.Mode.WINDOW) {
            err.println("--window: no window can be opened: " + reason);
            return Main.FAILED;
        }
        err.println("No window can be opened (" + reason + "); running without one.");
        return headless();
    }

    private int headless() {
        String noPictures =
                request.gallery() || request.picture() != null || request.animation() != null
                        ? Offscreen.unavailableReason()
                        : null;
        boolean asked =
                request.picture() != null
                        || request.contactSheet() != null
                        || request.animation() != null;
        if (noPictures != null && asked) {
            err.println(
                    (request.picture() != null
                                    ? "--picture: "
                                    : request.animation() != null
                                            ? "--animation: "
                                            : "--contact-sheet: ")
                            + noPictures);
            return Main.FAILED;
        }
        boolean draw = request.gallery() && noPictures == null;
        List<SceneReport> reports = new ArrayList<>();
        int code = Main.DONE;
        try (ProgressBar bar = progress()) {
            for (SampleScene scene : request.scenes()) {
                try {
                    reports.add(run(scene, draw, bar));
                } catch (UsageException misuse) {
                    throw misuse;
                } catch (UncheckedIOException unwritable) {
                    err.println("scene " + scene.id() + ": " + unwritable.getMessage());
                    code = Main.FAILED;
                } catch (RuntimeException | Error failure) {
                    code = failed("scene " + scene.id(), failure);
                }
            }
        }
        write(reports);
        if (request.contactSheet() != null) {
            ContactSheet.write(
                    reports.stream().map(report -> galleryFile(report.scene())).toList(),
                    request.contactSheet());
        }
        if (!"-".equals(request.json())) {
            if (draw) {
                out.println("Pictures: " + GALLERY.toAbsolutePath());
            } else if (noPictures != null) {
                out.println("No pictures: " + noPictures);
            }
        }
        return code;
    }

    private static Path galleryFile(String scene) {
        return GALLERY.resolve(scene + ".png");
    }

    private SceneReport run(SampleScene scene, boolean draw, @Nullable ProgressBar bar) {
        int ticks = request.ticks() == null ? scene.ticks() : request.ticks();
        SceneOptions options =
                request.options().getOrDefault(scene.id(), SceneOptions.defaults(scene));
        SceneRun run =
                new SceneRun(scene, options, ticks, request.workers(), request.substeps())
                        .directFrom(request.directFrom())
                        .sleeping(request.sleepingOr(false))
                        .lanes(request.lanes())
                        .precision(request.precision())
                        .from(from);
        if (request.animation() != null) {
            run.animation(request.animation());
        }
        if (request.picture() != null) {
            run.picture(request.picture(), request.at() == null ? ticks : request.at());
        } else if (draw) {
            run.picture(galleryFile(scene.id()), Math.min(scene.pictureTick(), ticks));
        }
        if (bar == null) {
            return run.run(() -> {});
        }
        bar.setExtraMessage(" " + scene.id());
        return run.run(bar::step);
    }

    private @Nullable ProgressBar progress() {
        if (!Main.onTerminal()) {
            return null;
        }
        long total = 0;
        for (SampleScene scene : request.scenes()) {
            total += request.ticks() == null ? scene.ticks() : request.ticks();
        }
        return new ProgressBarBuilder()
                .setTaskName("ticks")
                .setInitialMax(total)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(100)
                .setConsumer(new ConsoleProgressBarConsumer(err, BAR_WIDTH))
                .build();
    }

    private void write(List<SceneReport> reports) {
        String json = request.json();
        if ("-".equals(json)) {
            out.print(ReportText.json(reports));
            out.flush();
            return;
        }
        out.print(ReportText.table(reports));
        for (SceneReport report : reports) {
            report.remarks().forEach(line -> out.println(report.scene() + ": " + line));
        }
        if (json != null) {
            try {
                Files.writeString(Path.of(json), ReportText.json(reports));
            } catch (IOException unwritable) {
                throw new UncheckedIOException(
                        "--json %s: the results could not be written: %s"
                                .formatted(json, unwritable.getMessage()),
                        unwritable);
            }
        }
    }

    private int failed(String what, Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof OutOfMemoryError) {
                return Main.outOfMemory(what, err);
            }
        }
        err.println(what + " failed: " + failure);
        failure.printStackTrace(err);
        return Main.FAILED;
    }
}
