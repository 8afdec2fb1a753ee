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
 * One step of whole scenes of the samples, at 60 Hz, after two seconds of settling; and the mean
 * time of its stages, from the world's own profile. Sleep is off.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class WorldStep {
    private static final double MICROS = 1e6;

    /** A settled scene; of all threads, which are one, see {@link SolverStages.Watched}. */
    @State(Scope.Benchmark)
    public static class Settled {
        /** Which, by the scene's id. */
        @Param({"pyramid", "many-pyramids", "pile-spheres", "pile-boxes", "pile-mixed"})
        public String scene = "pyramid";

        /** About so many of them; 0 for as many as the scene has by itself. */
        @Param("0")
        public int bodies;

        /** Sub-steps: what a tick costs at 1, 2, 4 tells a sub-step from what is done once. */
        @Param("4")
        public int substeps;

        /** Number of workers. */
        @Param({"1", "2"})
        public int workers;

        /** Contacts that the solver takes at once; 0 for what fits the machine. */
        @Param("0")
        public int lanes;

        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();

        /** Builds it and lets it settle. */
        @Setup
        public void build() {
            world.close();
            world = SettledScenes.build(scene, bodies, substeps, workers, lanes);
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** Mean microseconds per step of the stages. */
    @AuxCounters(AuxCounters.Type.EVENTS)
    @State(Scope.Thread)
    public static class Stages {
        /** What was added, removed, changed from outside. */
        public double bodiesMicros;

        /** Bounds of what moves. */
        public double boundsMicros;

        /** Broad phase: pairs. */
        public double pairsMicros;

        /** Contacts that begin, end, go on. */
        public double rowsMicros;

        /** Narrow phase. */
        public double narrowPhaseMicros;

        /** Solver with integrator: all sub-steps. */
        public double solverMicros;

        /** Poses and velocities into the columns. */
        public double publishMicros;

        private PhysicsWorld world = PhysicsWorld.builder().workers(1).build();

        /**
         * Starts the profile.
         *
         * @param settled the scene
         */
        @Setup(Level.Iteration)
        public void start(Settled settled) {
            if (world != settled.world) {
                world.close();
            }
            world = settled.world;
            world.profile().enable();
            world.profile().reset();
        }

        /** Reads the profile. */
        @TearDown(Level.Iteration)
        public void read() {
            bodiesMicros = micros(StepStage.BODIES);
            boundsMicros = micros(StepStage.BOUNDS);
            pairsMicros = micros(StepStage.PAIRS);
            rowsMicros = micros(StepStage.ROWS);
            narrowPhaseMicros = micros(StepStage.POINTS);
            publishMicros = micros(StepStage.PUBLISH);
            solverMicros = micros(StepStage.SOLVE);
            world.profile().disable();
        }

        private double micros(StepStage stage) {
            return MICROS * world.profile().meanSeconds(stage);
        }
    }

    /**
     * One step.
     *
     * @param settled the scene
     * @return the number of contacts
     */
    @Benchmark
    public int step(Settled settled) {
        settled.world.step(SampleScene.STEP_SECONDS);
        return settled.world.contacts().count();
    }

    /**
     * One step with its stages timed.
     *
     * @param settled the scene
     * @param stages receives their means
     * @return the number of contacts
     */
    @Benchmark
    public int stages(Settled settled, Stages stages) {
        settled.world.step(SampleScene.STEP_SECONDS);
        return settled.world.contacts().count();
    }
}
