package dev.cairn.physics.solver.wide;

import dev.cairn.physics.internal.Vectors;
import dev.cairn.physics.solver.kernel.RowFiller;
import dev.cairn.physics.solver.kernel.RowStore;
import dev.cairn.physics.solver.kernel.RowSweeps;
import dev.cairn.physics.solver.kernel.Sweeps;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodHandles.Lookup;
import java.util.concurrent.atomic.AtomicBoolean;

/** Chooses the sweeps for a number of lanes; the Vector API is touched only where it is there. */
public final class Lanes {
    private static final AtomicBoolean TOLD = new AtomicBoolean();

    /** Doubles of the largest vector. */
    private static final int LARGEST = 8;

    /** By lanes, those in double, then those in single precision. */
    private static final @Nullable WideSweeps[] MADE = new WideSweeps[2 * (LARGEST + 1)];

    private Lanes() {}

    /**
     * Sweeps of {@code lanes} rows at once.
     *
     * @param lanes 1 (scalar), 4, 8 or 16: as asked for, ready to use, 16 as two vectors of 8; or 0
     *     for as many numbers as this machine's vectors hold, for use when they are warm; where no
     *     compiler makes vectors, one row at once, with the same bits
     * @param isSingle whether the numbers are floats
     * @param isUrgent whether those that were asked for are made ready at once, which takes a
     *     second, or by their user
     */
    public static Sweeps sweeps(int lanes, boolean isSingle, boolean isUrgent) {
        if (lanes == 1) {
            return RowSweeps.scalar(isSingle);
        }
        if (!Vectors.areThere()) {
            if (TOLD.compareAndSet(false, true)) {
                warn(
                        "The contact solver runs without vectors, at half its speed, because the"
                                + " JVM was started without the module "
                                + Vectors.MODULE
                                + ". Add --add-modules="
                                + Vectors.MODULE
                                + " to its options; the results are the same.");
            }
            return RowSweeps.scalar(isSingle);
        }
        if (!Vectors.areCompiled()) {
            return RowSweeps.scalar(isSingle);
        }
        int wanted = Math.min(LARGEST, lanes == 0 ? Preferred.lanes(isSingle) : lanes);
        if (wanted < 4) { // two lanes are slower than scalar code
            return RowSweeps.scalar(isSingle);
        }
        WideSweeps sweeps = wide(wanted, isSingle);
        if (lanes != 0 && isUrgent) {
            sweeps.finish();
        }
        return sweeps;
    }

    /**
     * Waits until the sweeps of {@code lanes} rows are compiled, or known not to pay off; some five
     * seconds. Any thread.
     *
     * @param lanes as for {@link #sweeps}
     * @param isSingle whether the numbers are floats
     */
    public static void await(int lanes, boolean isSingle) {
        if (sweeps(lanes, isSingle, false) instanceof WideSweeps wide) {
            wide.await();
        }
    }

    /** A class of its own for each number, so that its species is a constant to the compiler. */
    private static synchronized WideSweeps wide(int lanes, boolean isSingle) {
        int known = isSingle ? LARGEST + 1 + lanes : lanes;
        WideSweeps made = MADE[known];
        if (made == null) {
            try {
                made = new WideSweeps(isSingle ? inSingle(lanes) : inDouble(lanes), isSingle);
            } catch (IOException | ReflectiveOperationException failed) {
                throw new IllegalStateException(
                        "the wide sweeps could not be made for " + lanes + " lanes", failed);
            }
            MADE[known] = made;
        }
        return made;
    }

    /** A logger is looked up where something is to be told: that takes as long as a tick. */
    static void warn(String message) {
        System.getLogger("dev.cairn.physics").log(Level.WARNING, message);
    }

    private static Sweeps inDouble(int lanes) throws IOException, ReflectiveOperationException {
        LaneKernels.Bodies bodies = (LaneKernels.Bodies) make("LaneBodies", lanes);
        return new RowSweeps(
                lanes,
                (RowFiller) make("LanePrepare", lanes),
                new LaneSweep(
                        lanes,
                        bodies,
                        (LaneKernels.Normals) make("LaneNormals", lanes),
                        (LaneKernels.Points) make("LaneFour", lanes),
                        (LaneKernels.Points) make("LaneFew", lanes),
                        (LaneKernels.Friction) make("LaneFriction", lanes)),
                (RowStore) make("LaneStore", lanes, LaneKernels.Bodies.class, bodies));
    }

    private static Sweeps inSingle(int lanes) throws IOException, ReflectiveOperationException {
        SingleLaneKernels.Bodies bodies =
                (SingleLaneKernels.Bodies) make("SingleLaneBodies", lanes);
        return new RowSweeps(
                lanes,
                (RowFiller) make("SingleLanePrepare", lanes),
                new SingleLaneSweep(
                        lanes,
                        bodies,
                        (SingleLaneKernels.Normals) make("SingleLaneNormals", lanes),
                        (SingleLaneKernels.Points) make("SingleLaneFour", lanes),
                        (SingleLaneKernels.Points) make("SingleLaneFew", lanes),
                        (SingleLaneKernels.Friction) make("SingleLaneFriction", lanes)),
                (RowStore) make("SingleLaneStore", lanes, SingleLaneKernels.Bodies.class, bodies));
    }

    private static Object make(String name, int lanes)
            throws IOException, ReflectiveOperationException {
        return define(name, lanes).getDeclaredConstructor().newInstance();
    }

    private static <T> Object make(String name, int lanes, Class<T> type, T argument)
            throws IOException, ReflectiveOperationException {
        return define(name, lanes).getDeclaredConstructor(type).newInstance(argument);
    }

    private static Class<?> define(String name, int lanes)
            throws IOException, ReflectiveOperationException {
        try (InputStream in = Lanes.class.getResourceAsStream(name + ".class")) {
            if (in == null) {
                throw new IllegalStateException(name + ".class is missing beside Lanes.class");
            }
            Lookup lookup = MethodHandles.lookup();
            Lookup hidden = lookup.defineHiddenClassWithClassData(in.readAllBytes(), lanes, true);
            return hidden.lookupClass();
        }
    }

    /** Apart, so that the Vector API is linked only when it is there. */
    private static final class Preferred {
        static int lanes(boolean isSingle) {
            return isSingle
                    ? jdk.incubator.vector.FloatVector.SPECIES_PREFERRED.length()
                    : jdk.incubator.vector.DoubleVector.SPECIES_PREFERRED.length();
        }
    }
}
