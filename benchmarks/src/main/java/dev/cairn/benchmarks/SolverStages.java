package dev.cairn.benchmarks;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.samples.SampleScene;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/**
 * The stages of the contact solver: mean microseconds of a step, all sub-steps together, beside the
 * time of the whole step. One worker, so that the stages add up.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class SolverStages {
    private static final double MICROS = 1e6;

    /**
     * A settled scene, or one that bounces. Of all threads, which are one: with a state of the
     * thread JMH gives the step a scene, and its clocks another one.
     */
    @State(Scope.Benchmark)
    public static class Watched {
        /** Which, by the scene's id; only {@code bouncing} has restitution. */
        @Param({"pyramid", "pile-mixed", "bouncing"})
        public String scene = "pyramid";

        /** About so many of them; 0 for as many as the scene has by itself. */
        @Param("0")
        public int bodies;

        /** Sub-steps of a step. */
        @Param("4")
        public int substeps;

        /** Contacts that the solver takes at once; 0 for what fits the machine. */
        @Param({"0", "1"})
        public int lanes;

        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        SolverClock clock = new SolverClock(world);

        /** Builds it, lets it settle, and puts clocks into its solver. */
        @Setup
        public void build() {
            world.close();
            world =
                    SettledScenes.build(
                            scene, scene.equals("bouncing") ? 0 : bodies, substeps, 1, lanes);
            clock = new SolverClock(world);
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** Mean microseconds per step; their names say what is in them. */
    @AuxCounters(AuxCounters.Type.EVENTS)
    @State(Scope.Thread)
    public static class Stages {
        /** Contacts listed and coloured, loads from above, bodies loaded; free bodies fly. */
        public double beginMicros;

        /** Constraint rows between domains filled: levers, masses, last impulses. */
        public double prepareMicros;

        /** Restitution: bounces at their own time within the sub-step. */
        public double impactsMicros;

        /** Warm start with gravity and forces, where something bounces or has lost a load. */
        public double warmStartMicros;

        /** Hard sweeps after a load was taken off, in the first sub-step. */
        public double unloadMicros;

        /** Bias pass between domains: soft normals. */
        public double biasMicros;

        /** Bias pass on what does not move, and integrator: bodies move. */
        public double driftMicros;

        /** Levers of what turns or passes by, anew. */
        public double renewMicros;

        /** Relax pass between domains: hard normals and friction. */
        public double relaxMicros;

        /**
         * Domains of large islands: from prepare to the first bias pass, from each relax pass to
         * the next bias pass, and from the last one to the store.
         */
        public double domainsMicros;

        /** Impulses and offsets between domains written back. */
        public double storeMicros;

        /** Islands that are small enough to stay in the cache, each through all stages at once. */
        public double batchMicros;

        /** The solver as a whole, by the world's own profile. */
        public double solverMicros;

        private PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        private SolverClock clock = new SolverClock(world);

        /**
         * Starts the clocks.
         *
         * @param watched the scene
         */
        @Setup(Level.Iteration)
        public void start(Watched watched) {
            if (world != watched.world) {
                world.close();
            }
            world = watched.world;
            clock = watched.clock;
            world.profile().enable();
            world.profile().reset();
            clock.reset();
        }

        /** Reads the clocks. */
        @TearDown(Level.Iteration)
        public void read() {
            solverMicros = MICROS * world.profile().meanSeconds(StepStage.SOLVE);
            prepareMicros = mean(clock.nanos("prepare"));
            impactsMicros = mean(clock.nanosBefore("kick"));
            warmStartMicros = mean(clock.nanos("kick"));
            unloadMicros = mean(clock.nanosBefore("biasWithin"));
            biasMicros = mean(clock.nanos("bias"));
            driftMicros = mean(clock.nanosBefore("drift") + clock.nanos("drift"));
            // where there are no joints, rows are renewed where they are relaxed
            renewMicros = mean(clock.nanos("findRenewed", "renewRows", "renewWithin"));
            relaxMicros = mean(clock.nanosBefore("relax") + clock.nanos("relax"));
            domainsMicros = mean(clock.nanosBefore("within") + clock.nanos("within", "biasWithin"));
            storeMicros =
                    mean(clock.nanosBefore("storeRows") + clock.nanos("storeRows", "clearRows"));
            batchMicros = mean(clock.nanosBefore("batch") + clock.nanos("batch"));
            // All that is left is serial: before the first job, and after the last one.
            beginMicros =
                    solverMicros
                            - prepareMicros
                            - impactsMicros
                            - warmStartMicros
                            - unloadMicros
                            - biasMicros
                            - driftMicros
                            - renewMicros
                            - relaxMicros
                            - domainsMicros
                            - storeMicros
                            - batchMicros;
            world.profile().disable();
        }

        private double mean(long nanos) {
            return nanos / 1e3 / Math.max(1, world.profile().steps());
        }
    }

    /**
     * One step with the stages of its solver timed.
     *
     * @param watched the scene
     * @param stages receives their means
     * @return the number of contacts
     */
    @Benchmark
    public int step(Watched watched, Stages stages) {
        watched.world.step(SampleScene.STEP_SECONDS);
        return watched.world.contacts().count();
    }
}
