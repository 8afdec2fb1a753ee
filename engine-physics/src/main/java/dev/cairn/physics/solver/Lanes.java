package dev.cairn.physics.solver;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodHandles.Lookup;
import java.util.concurrent.atomic.AtomicBoolean;

/** Chooses the sweeps for a number of lanes; the Vector API is touched only where it is there. */
final class Lanes {
    private static final Logger LOG = System.getLogger("dev.cairn.physics");
    private static final AtomicBoolean TOLD = new AtomicBoolean();
    private static final String MODULE = "jdk.incubator.vector";

    /** Doubles of the largest vector. */
    private static final int LARGEST = 8;

    private static final @Nullable WideSweeps[] MADE = new WideSweeps[LARGEST + 1];

    private Lanes() {}

    /**
     * Sweeps of {@code lanes} rows at once.
     *
     * @param lanes 1 (scalar), 4, 8 or 16: as asked for, ready to use, 16 as two vectors of 8; or 0
     *     for as many doubles as this machine's vectors hold, for use when they are warm
     */
    static Sweeps sweeps(int lanes) {
        if (lanes == 1) {
            return new ScalarSweeps();
        }
        if (ModuleLayer.boot().findModule(MODULE).isEmpty()) {
            if (TOLD.compareAndSet(false, true)) {
                LOG.log(
                        Level.WARNING,
                        "The contact solver runs without vectors, at half its speed, because the"
                                + " JVM was started without the module "
                                + MODULE
                                + ". Add --add-modules="
                                + MODULE
                                + " to its options; the results are the same.");
            }
            return new ScalarSweeps();
        }
        int wanted = Math.min(LARGEST, lanes == 0 ? Preferred.lanes() : lanes);
        if (wanted < 4) { // two lanes are slower than scalar code
            return new ScalarSweeps();
        }
        WideSweeps sweeps = wide(wanted);
        if (lanes != 0) {
            sweeps.finish();
        }
        return sweeps;
    }

    /** A class of its own for each number, so that its species is a constant to the compiler. */
    private static synchronized WideSweeps wide(int lanes) {
        WideSweeps known = MADE[lanes];
        if (known != null) {
            return known;
        }
        try {
            WideSweeps made =
                    new WideSweeps(
                            new LaneSweeps(
                                    lanes,
                                    (RowFiller) make("LanePrepare", lanes),
                                    (LaneKernels.Bodies) make("LaneBodies", lanes),
                                    (LaneKernels.Normals) make("LaneNormals", lanes),
                                    (LaneKernels.Points) make("LaneFour", lanes),
                                    (LaneKernels.Points) make("LaneFew", lanes),
                                    (LaneKernels.Friction) make("LaneFriction", lanes),
                                    (RowStore) make("LaneStore", lanes)));
            MADE[lanes] = made;
            return made;
        } catch (IOException | ReflectiveOperationException failed) {
            throw new IllegalStateException(
                    "the wide sweeps could not be made for " + lanes + " lanes", failed);
        }
    }

    private static Object make(String name, int lanes)
            throws IOException, ReflectiveOperationException {
        try (InputStream in = Lanes.class.getResourceAsStream(name + ".class")) {
            if (in == null) {
                throw new IllegalStateException(name + ".class is missing beside Lanes.class");
            }
            Lookup lookup = MethodHandles.lookup();
            Lookup hidden = lookup.defineHiddenClassWithClassData(in.readAllBytes(), lanes, true);
            return hidden.lookupClass().getDeclaredConstructor().newInstance();
        }
    }

    /** Apart, so that the Vector API is linked only when it is there. */
    private static final class Preferred {
        static int lanes() {
            return jdk.incubator.vector.DoubleVector.SPECIES_PREFERRED.length();
        }
    }
}
