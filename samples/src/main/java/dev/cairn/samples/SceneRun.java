package dev.cairn.samples;

import dev.cairn.core.profile.SystemProfile;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.samples.film.Film;
import dev.cairn.samples.overlap.Penetration;
import dev.cairn.samples.replay.RunFile;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Runs one scene without a window, and measures it.
 *
 * <p>Only {@code world.step} is inside the clock and the allocation count; hooks, truths,
 * penetration and pictures are outside. One thread, which becomes the simulation thread of the run.
 */
public final class SceneRun {
    /**
     * Overlaps are measured often enough to see a bounce, and seldom enough to stay cheap for
     * thousands of bodies.
     */
    private static final int BODIES_PER_SKIPPED_TICK = 60;

    private final SampleScene scene;
    private final SceneOptions options;
    private final int ticks;
    private final int workers;
    private final int substeps;
    private int directFrom = PhysicsSettings.DEFAULT.tuning().count(Tunable.DIRECT_FROM);
    private boolean sleeping;
    private int lanes;
    private Precision precision = Precision.AUTO;
    private @Nullable Path picture;
    private int pictureTick;
    private @Nullable Path animation;
    private @Nullable RunFile from;

    /** Hears of each tick. */
    @FunctionalInterface
    public interface Progress {
        /** One more tick is done. */
        void tick();
    }

    /**
     * Describes a run.
     *
     * @param scene what to run
     * @param options values of its parameters
     * @param ticks how many ticks, at least 0
     * @param workers threads, at least 1
     * @param substeps sub-steps of the solver, at least 1
     */
    public SceneRun(SampleScene scene, SceneOptions options, int ticks, int workers, int substeps) {
        this.scene = scene;
        this.options = options;
        this.ticks = ticks;
        this.workers = workers;
        this.substeps = substeps;
    }

    /**
     * Describes a run with the scene's own length, one worker and the engine's sub-steps.
     *
     * @param scene what to run
     * @param options values of its parameters
     */
    public SceneRun(SampleScene scene, SceneOptions options) {
        this(scene, options, scene.ticks(), 1, PhysicsSettings.DEFAULT.substeps());
    }

    /**
     * From which length on slender islands are solved directly.
     *
     * @param bodies from end to end, or 0 for never; by default the engine's
     * @return this
     */
    public SceneRun directFrom(int bodies) {
        this.directFrom = bodies;
        return this;
    }

    /**
     * Says whether bodies at rest fall asleep; they do not by default, so that what is measured is
     * the solver.
     *
     * @param value true for sleep
     * @return this
     */
    public SceneRun sleeping(boolean value) {
        this.sleeping = value;
        return this;
    }

    /**
     * Asks for a number of contacts that are solved at once; the results do not depend on it.
     *
     * @param count 1, 4, 8 or 16, or 0 for what fits this machine
     * @return this
     */
    public SceneRun lanes(int count) {
        this.lanes = count;
        return this;
    }

    /**
     * Asks for contacts that are solved in another precision.
     *
     * @param value double by default
     * @return this
     */
    public SceneRun precision(Precision value) {
        this.precision = value;
        return this;
    }

    /**
     * Asks for a picture; needs GL.
     *
     * @param file where the .png goes
     * @param tick after how many ticks
     * @return this
     */
    public SceneRun picture(Path file, int tick) {
        this.picture = file;
        this.pictureTick = tick;
        return this;
    }

    /**
     * Begins with a saved moment of the same scene.
     *
     * @param file which one, null for the scene's own beginning
     * @return this
     */
    public SceneRun from(@Nullable RunFile file) {
        this.from = file;
        return this;
    }

    /**
     * Asks for an animation: a frame for every third tick, so that it plays in real time at 20
     * frames a second; needs GL.
     *
     * @param file where the animated .png goes
     * @return this
     */
    public SceneRun animation(Path file) {
        this.animation = file;
        return this;
    }

    /**
     * Runs the scene.
     *
     * @param progress called after each tick
     * @return what was found
     * @throws UsageException if the scene refuses its options (a broken mesh file)
     */
    public SceneReport run(Progress progress) {
        AllocationMeter meter = new AllocationMeter();
        try (PhysicsWorld world = world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            if (from != null) {
                from.putBack(world, built);
                world.setSubsteps(substeps); // those of the file, or other ones
            }
            meter.attach();
            Film film = animation == null ? null : new Film(built);
            try (film) {
                return run(world, built, meter, film, progress);
            }
        }
    }

    /**
     * The world of the run, without the scene.
     *
     * @return a new world; close it
     */
    public PhysicsWorld world() {
        return PhysicsWorld.builder()
                .gravity(0, -SampleScene.GRAVITY, 0)
                .workers(workers)
                .settings(
                        PhysicsSettings.DEFAULT
                                .withSubsteps(substeps)
                                .with(Tunable.DIRECT_FROM, directFrom)
                                .withLanes(lanes)
                                .withPrecision(precision))
                .sleeping(sleeping)
                .seed(options.seed())
                .systems(scene.systems(options))
                .build();
    }

    private SceneReport run(
            PhysicsWorld world,
            SceneBuilder built,
            AllocationMeter meter,
            @Nullable Film film,
            Progress progress) {
        Measures measures =
                new Measures(ticks, Math.max(1, built.bodies().size() / BODIES_PER_SKIPPED_TICK));
        SnapshotExchange exchange = picture == null ? null : new SnapshotExchange();
        measures.depth(built);
        world.profile().enable();
        if (exchange != null && pictureTick == 0) {
            exchange.publish(world.ecs());
            draw(exchange, built);
        }
        for (int tick = 1; tick <= ticks; tick++) {
            built.beforeTick();
            measures.step(world, meter, tick, built.stepSeconds());
            built.afterTick();
            if (tick == 1) {
                // the first tick loads classes and grows every store
                world.profile().reset();
            }
            measures.overlap(built, tick);
            if (exchange != null && tick >= pictureTick - 1 && tick <= pictureTick) {
                exchange.publish(world.ecs());
                if (tick == pictureTick) {
                    draw(exchange, built);
                }
            }
            if (film != null) {
                film.shoot(world, tick);
            }
            progress.tick();
        }
        if (film != null && animation != null) {
            film.save(animation);
        }
        return report(world, built, measures);
    }

    private void draw(SnapshotExchange exchange, SceneBuilder built) {
        Camera camera = built.view().place(new Camera());
        CameraMount.attach(built.world().ecs(), camera);
        try (Offscreen screen = Offscreen.open(1280, 720)) {
            screen.draw(exchange.latest(), 1, camera, built.light());
            if (picture != null) {
                screen.savePng(picture);
            }
        }
    }

    private SceneReport report(PhysicsWorld world, SceneBuilder built, Measures measures) {
        Map<String, Object> parameters = new LinkedHashMap<>(options.values());
        parameters.put("seed", options.seed());
        parameters.put("substeps", substeps);
        parameters.put("directFrom", directFrom);
        parameters.put("precision", precision.name().toLowerCase(Locale.ROOT));
        parameters.put("sleeping", sleeping ? "on" : "off");
        if (options.obj() != null) {
            parameters.put("obj", options.obj().toString());
        }
        Contacts contacts = world.contacts();
        int touching = 0;
        for (int c = 0; c < contacts.count(); c++) {
            touching += contacts.touching(c) ? 1 : 0;
        }
        return new SceneReport(
                scene.id(),
                parameters,
                world.bodyCount(),
                ticks,
                workers,
                world.lanes(),
                measures.percentile(0.5),
                measures.percentile(0.99),
                touching,
                world.kineticEnergy(),
                measures.deepest,
                built.errors(),
                String.format(Locale.ROOT, "%016x", world.digest()),
                measures.bytes.perTick(),
                stages(world.profile()),
                systems(world.profile().systems()),
                List.copyOf(built.remarks()));
    }

    private static Map<String, Double> stages(StepProfile profile) {
        Map<String, Double> micros = new LinkedHashMap<>();
        for (StepStage stage : StepStage.values()) {
            micros.put(stage.name().toLowerCase(Locale.ROOT), 1e6 * profile.meanSeconds(stage));
        }
        return micros;
    }

    private static Map<String, Double> systems(SystemProfile profile) {
        Map<String, Double> micros = new LinkedHashMap<>();
        for (int system = 0; system < profile.count(); system++) {
            micros.put(profile.name(system), 1e6 * profile.meanSeconds(system));
        }
        return micros;
    }

    /** What is noted tick by tick, without allocation inside the measured part. */
    private static final class Measures {
        private final long[] nanos;
        private final int stride;
        private final int ticks;
        private double deepest;
        private final SteadyBytes bytes;

        Measures(int ticks, int stride) {
            this.ticks = ticks;
            this.nanos = new long[ticks];
            this.stride = stride;
            this.bytes = new SteadyBytes(ticks);
        }

        void step(PhysicsWorld world, AllocationMeter meter, int tick, double seconds) {
            long allocated = meter.bytes();
            long start = System.nanoTime();
            world.step(seconds);
            nanos[tick - 1] = System.nanoTime() - start;
            bytes.add(meter.bytes() - allocated);
        }

        void overlap(SceneBuilder built, int tick) {
            if (tick % stride == 0 || tick == ticks) {
                depth(built);
            }
        }

        void depth(SceneBuilder built) {
            deepest =
                    Math.max(
                            deepest,
                            Penetration.deepest(built.bodies(), built.world().joints().all()));
        }

        /** Nearest-rank percentile of the ticks after the first, ms; 0 if there are none. */
        double percentile(double share) {
            if (ticks == 0) {
                return 0;
            }
            long[] sorted = Arrays.copyOfRange(nanos, Math.min(1, ticks - 1), ticks);
            Arrays.sort(sorted);
            int rank = (int) Math.ceil(share * sorted.length);
            return sorted[Math.clamp(rank - 1, 0, sorted.length - 1)] / 1e6;
        }
    }
}
