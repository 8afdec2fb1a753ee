package dev.cairn.samples.sandbox;

import dev.cairn.core.profile.SystemProfile;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.samples.SceneBuilder;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/** The last ticks of what is plotted, as rings. One thread at a time. */
final class PlotHistory {
    /** Ticks that are kept: six seconds. */
    static final int LENGTH = 360;

    /** Errors that are plotted at most. */
    static final int ERRORS = 4;

    private static final StepStage[] STAGES = StepStage.values();

    /** Share of the newest tick in the mean time of a stage. */
    private static final double NEW_SHARE = 1.0 / 30;

    private static final int MANY_BODIES = 2000;
    private static final int SPARSE = 10;

    final float[] millis = new float[LENGTH];
    final float[] energy = new float[LENGTH];
    final float[] kinetic = new float[LENGTH];
    final float[] momentum = new float[LENGTH];
    final float[] overlap = new float[LENGTH];
    final float[][] stages = new float[STAGES.length][LENGTH];
    final float[][] errors = new float[ERRORS][LENGTH];
    final String[] errorNames = new String[ERRORS];
    final double[] errorNow = new double[ERRORS];
    double energyNow;
    double kineticNow;
    double momentumNow;
    double overlapNow;
    double millisNow;
    int errorCount;
    int touching;
    int first;
    int count;
    String[] systemNames = {};
    private double[] systemMicros = {};
    private final double[] stageMicros = new double[STAGES.length];
    private long ticks;

    /** Energy and momenta, in the order of {@link dev.cairn.physics.body.Kinetics}. */
    private final double[] sums = new double[7];

    void clear() {
        first = 0;
        count = 0;
        ticks = 0;
        errorCount = 0;
        touching = 0;
        energyNow = 0;
        kineticNow = 0;
        momentumNow = 0;
        overlapNow = 0;
        millisNow = 0;
        Arrays.fill(stageMicros, 0);
        systemNames = new String[0];
        systemMicros = new double[0];
    }

    void add(PhysicsWorld world, @Nullable SceneBuilder scene, double tickMillis) {
        int at = (first + count) % LENGTH;
        if (count == LENGTH) {
            first = (first + 1) % LENGTH;
        } else {
            count++;
        }
        world.kinetics(sums);
        kineticNow = sums[0];
        energyNow = kineticNow + world.potentialEnergy();
        momentumNow = Math.sqrt(sums[1] * sums[1] + sums[2] * sums[2] + sums[3] * sums[3]);
        millisNow = tickMillis;
        contacts(world.contacts());
        readStages(world.profile(), at);
        readSystems(world.profile().systems());
        millis[at] = (float) tickMillis;
        energy[at] = (float) energyNow;
        kinetic[at] = (float) kineticNow;
        momentum[at] = (float) momentumNow;
        overlap[at] = (float) (1000 * overlapNow);
        if (scene != null && (world.bodyCount() < MANY_BODIES || ticks % SPARSE == 0)) {
            readErrors(scene);
        }
        for (int e = 0; e < ERRORS; e++) {
            errors[e][at] = e < errorCount ? (float) errorNow[e] : Float.NaN;
        }
        ticks++;
    }

    private void readStages(StepProfile profile, int at) {
        double share = ticks == 0 ? 1 : NEW_SHARE;
        for (int i = 0; i < STAGES.length; i++) {
            double micros = profile.lastNanos(STAGES[i]) / 1e3;
            stages[i][at] = (float) micros;
            stageMicros[i] += share * (micros - stageMicros[i]);
        }
    }

    /** The first tick of a world makes room for its systems. */
    private void readSystems(SystemProfile profile) {
        double share = ticks == 0 ? 1 : NEW_SHARE;
        if (systemNames.length != profile.count()) {
            systemNames = new String[profile.count()];
            systemMicros = new double[systemNames.length];
            share = 1;
            for (int i = 0; i < systemNames.length; i++) {
                systemNames[i] = profile.name(i) + ", µs";
            }
        }
        for (int i = 0; i < systemNames.length; i++) {
            systemMicros[i] += share * (profile.lastNanos(i) / 1e3 - systemMicros[i]);
        }
    }

    /** Mean time of a system, of all workers together, µs. */
    double systemMicros(int system) {
        return systemMicros[system];
    }

    /** Mean time of a stage, µs. */
    double stageMicros(StepStage stage) {
        for (int i = 0; i < STAGES.length; i++) {
            if (STAGES[i] == stage) {
                return stageMicros[i];
            }
        }
        return 0;
    }

    private void contacts(Contacts contacts) {
        double deepest = 0;
        int touches = 0;
        for (int c = 0; c < contacts.count(); c++) {
            touches += contacts.touching(c) ? 1 : 0;
            for (int p = 0; p < contacts.pointCount(c); p++) {
                deepest = Math.max(deepest, -contacts.separation(c, p));
            }
        }
        overlapNow = deepest;
        touching = touches;
    }

    private void readErrors(SceneBuilder scene) {
        errorCount = scene.readErrors(errorNames, errorNow);
    }

    void copy(PlotHistory from) {
        System.arraycopy(from.millis, 0, millis, 0, LENGTH);
        System.arraycopy(from.energy, 0, energy, 0, LENGTH);
        System.arraycopy(from.kinetic, 0, kinetic, 0, LENGTH);
        System.arraycopy(from.momentum, 0, momentum, 0, LENGTH);
        System.arraycopy(from.overlap, 0, overlap, 0, LENGTH);
        for (int e = 0; e < ERRORS; e++) {
            System.arraycopy(from.errors[e], 0, errors[e], 0, LENGTH);
        }
        for (int i = 0; i < STAGES.length; i++) {
            System.arraycopy(from.stages[i], 0, stages[i], 0, LENGTH);
        }
        System.arraycopy(from.errorNames, 0, errorNames, 0, ERRORS);
        System.arraycopy(from.errorNow, 0, errorNow, 0, ERRORS);
        System.arraycopy(from.stageMicros, 0, stageMicros, 0, STAGES.length);
        systemNames = from.systemNames; // never written again
        if (systemMicros.length != systemNames.length) {
            systemMicros = new double[systemNames.length];
        }
        System.arraycopy(from.systemMicros, 0, systemMicros, 0, systemMicros.length);
        energyNow = from.energyNow;
        kineticNow = from.kineticNow;
        momentumNow = from.momentumNow;
        overlapNow = from.overlapNow;
        millisNow = from.millisNow;
        errorCount = from.errorCount;
        touching = from.touching;
        first = from.first;
        count = from.count;
    }

    @Override
    public String toString() {
        return "PlotHistory" + Arrays.toString(errorNames);
    }
}
